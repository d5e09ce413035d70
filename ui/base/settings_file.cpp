#include "ui/base/settings_file.h"

#include "core/io/file_writer.h"

#include <QCoreApplication>
#include <QFileDevice>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace rasterlens
{
namespace
{

const QString kBytesKey = QStringLiteral("base64"); // JSON knows no bytes

QString lastProblem;

QJsonValue toJson(const QVariant& value)
{
    switch (value.typeId()) {
    case QMetaType::QByteArray: return QJsonObject{{kBytesKey, QString::fromLatin1(value.toByteArray().toBase64())}};
    case QMetaType::QStringList: return QJsonArray::fromStringList(value.toStringList());
    case QMetaType::Bool:
    case QMetaType::Int:
    case QMetaType::Double: return QJsonValue::fromVariant(value);
    default: return value.toString();
    }
}

QVariant fromJson(const QJsonValue& value)
{
    if (value.isObject())
        return QByteArray::fromBase64(value.toObject()[kBytesKey].toString().toLatin1());
    if (!value.isArray())
        return value.toVariant();
    QStringList texts;
    for (const QJsonValue& text : value.toArray())
        texts << text.toString();
    return texts;
}

bool readSettings(QIODevice& device, QSettings::SettingsMap& map)
{
    const QJsonDocument document = QJsonDocument::fromJson(device.readAll());
    const QJsonObject json = document.object();
    for (auto it = json.begin(); it != json.end(); ++it)
        map.insert(it.key(), fromJson(it.value()));
    return document.isObject();
}

bool writeSettings(QIODevice& device, const QSettings::SettingsMap& map)
{
    QJsonObject json;
    for (auto it = map.begin(); it != map.end(); ++it)
        json[it.key()] = toJson(it.value());
    const QByteArray bytes = QJsonDocument(json).toJson();
    lastProblem.clear();
    if (device.write(bytes) != bytes.size())
        lastProblem = device.errorString();
    auto* file = qobject_cast<QFileDevice*>(&device);
    if (const auto problem = file && lastProblem.isEmpty() ? bringToDisk(*file) : std::nullopt)
        lastProblem = textOf(*problem);
    return lastProblem.isEmpty();
}

} // namespace

QSettings::Format settingsFormat()
{
    static const QSettings::Format format =
        QSettings::registerFormat(QStringLiteral("json"), readSettings, writeSettings);
    return format;
}

void useSettingsFormat()
{
    QSettings::setDefaultFormat(settingsFormat());
    QSettings settings;
    const QSettings earlier(QSettings::NativeFormat, QSettings::UserScope, QCoreApplication::organizationName(),
                            QCoreApplication::applicationName());
    if (!settings.allKeys().isEmpty())
        return;
    for (const QString& key : earlier.allKeys())
        settings.setValue(key, earlier.value(key));
}

QString settingsProblem()
{
    QSettings settings; // shares what is still to be written with all others
    settings.sync();
    if (settings.status() == QSettings::NoError)
        return {};
    return lastProblem.isEmpty() ? settings.fileName() : QStringLiteral("%1: %2").arg(settings.fileName(), lastProblem);
}

} // namespace rasterlens
