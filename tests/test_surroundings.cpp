// The window's program in odd surroundings: without fonts, without a home, with settings that are damaged or of a newer
// version, and twice at once.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <memory>
#include <vector>

namespace
{

constexpr int kPatienceMs = 60000;

using Changes = QList<QPair<QByteArray, QByteArray>>; ///< names and values; null: the variable is not set

struct Change {
    const char* name;
    const char* value; ///< null: the variable is not set
};

} // namespace

class TestSurroundings : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    [[nodiscard]] QString path(const QString& name) const { return m_folder->filePath(name); }

    [[nodiscard]] QProcessEnvironment usual() const
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        environment.insert(QStringLiteral("HOME"), m_folder->path());
        for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
            environment.insert(QLatin1String(name), path(QLatin1String(name)));
        return environment;
    }

    [[nodiscard]] std::unique_ptr<QProcess> start(const QStringList& words,
                                                  const QProcessEnvironment& environment) const
    {
        auto process = std::make_unique<QProcess>();
        process->setProcessEnvironment(environment);
        process->setWorkingDirectory(m_folder->path());
        process->setProcessChannelMode(QProcess::MergedChannels);
        process->start(QStringLiteral(RASTERLENS), words);
        return process;
    }

    /// Whether the program has come so far that it ends in order when it is told to.
    static bool hearsSignals(const QProcess& process)
    {
        QFile status(QStringLiteral("/proc/%1/status").arg(process.processId()));
        if (!status.open(QIODevice::ReadOnly))
            return false;
        for (const QByteArray& line : status.readAll().split('\n'))
            if (line.startsWith("SigCgt:"))
                return ((line.mid(7).trimmed().toULongLong(nullptr, 16) >> (SIGTERM - 1)) & 1U) != 0;
        return false;
    }

    /// Runs a window until it hears signals, ends it, and says what went wrong.
    static QString ended(QProcess& process)
    {
        if (!QTest::qWaitFor([&] { return process.state() == QProcess::NotRunning || hearsSignals(process); },
                             kPatienceMs))
            return QStringLiteral("it did not start");
        if (process.state() == QProcess::NotRunning)
            return QStringLiteral("it ended by itself: ") + QString::fromUtf8(process.readAll());
        QTest::qWait(100); // signals are held for a moment while it looks whether files can be written
        if (!QTest::qWaitFor([&] { return hearsSignals(process); }, kPatienceMs))
            return QStringLiteral("it does not hear signals");
        ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
        if (!process.waitForFinished(kPatienceMs))
            return QStringLiteral("it did not end");
        if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 128 + SIGTERM)
            return QStringLiteral("exit code %1: ").arg(process.exitCode()) + QString::fromUtf8(process.readAll());
        return {};
    }

    [[nodiscard]] QString settingsFile() const
    {
        return path(QStringLiteral("XDG_CONFIG_HOME/RasterLens/RasterLens.json"));
    }

    void writeSettings(const QByteArray& bytes) const
    {
        QDir().mkpath(QFileInfo(settingsFile()).path());
        QFile file(settingsFile());
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("the settings cannot be written");
    }

    [[nodiscard]] QJsonObject settings() const
    {
        QFile file(settingsFile());
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        QFile fonts(path(QStringLiteral("no-fonts.conf")));
        QVERIFY(fonts.open(QIODevice::WriteOnly));
        fonts.write("<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig></fontconfig>\n");
    }

    void oddEnvironments_data()
    {
        QTest::addColumn<Changes>("changes");
        const auto row = [](const char* name, const std::vector<Change>& changes) {
            Changes list;
            for (const Change& change : changes)
                list.append({QByteArray(change.name), QByteArray(change.value)});
            QTest::newRow(name) << list;
        };
        const std::vector<Change> noHome{{"HOME", nullptr},
                                         {"XDG_CONFIG_HOME", nullptr},
                                         {"XDG_DATA_HOME", nullptr},
                                         {"XDG_CACHE_HOME", nullptr},
                                         {"XDG_RUNTIME_DIR", nullptr}};
        row("no fonts", {{"FONTCONFIG_FILE", "no-fonts.conf"}});
        row("no home", noHome);
        const char* const nowhere = "/sys/nowhere";
        row("a home that cannot be written",
            {{"HOME", nowhere}, {"XDG_CONFIG_HOME", nowhere}, {"XDG_DATA_HOME", nowhere}, {"XDG_CACHE_HOME", nowhere}});
        row("a home that is a file", {{"HOME", "no-fonts.conf"},
                                      {"XDG_CONFIG_HOME", "no-fonts.conf"},
                                      {"XDG_DATA_HOME", "no-fonts.conf"},
                                      {"XDG_CACHE_HOME", "no-fonts.conf"}});
        row("no folder for temporary files", {{"TMPDIR", nowhere}});
        row("an unknown language", {{"LANG", "xx_YY.UTF-8"}, {"LC_ALL", "xx_YY.UTF-8"}, {"LANGUAGE", "xx"}});
        row("bytes as language", {{"LANG", "C"}, {"LC_ALL", "C"}});
    }

    void oddEnvironments()
    {
        QFETCH(Changes, changes);
        QProcessEnvironment environment = usual();
        for (const auto& [name, value] : changes)
            if (value.isNull())
                environment.remove(QString::fromLatin1(name));
            else if (value.startsWith('/') || name.startsWith('L'))
                environment.insert(QString::fromLatin1(name), QString::fromLatin1(value));
            else
                environment.insert(QString::fromLatin1(name), path(QString::fromLatin1(value)));
        const auto picture = start(
            {QStringLiteral("--screenshot"), QStringLiteral("w.png"), QStringLiteral("builtin:cube")}, environment);
        QVERIFY(picture->waitForFinished(kPatienceMs));
        const QByteArray said = picture->readAll();
        QVERIFY2(picture->exitStatus() == QProcess::NormalExit && picture->exitCode() == 0, said.constData());
        QCOMPARE(QImage(path(QStringLiteral("w.png"))).size(), QSize(1440, 900));
        const auto window = start({QStringLiteral("builtin:cube")}, environment);
        QCOMPARE(ended(*window), QString());
    }

    void damagedSettingsAreLikeNone_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("empty") << QByteArray("");
        QTest::newRow("cut off") << QByteArray("{\"window/dark\": tr");
        QTest::newRow("no JSON") << QByteArray("\0\xff\x80 garbage\n", 12);
        QTest::newRow("a list") << QByteArray("[1, 2]");
        QTest::newRow("deep") << QByteArray(100000, '[');
    }

    void damagedSettingsAreLikeNone()
    {
        QFETCH(QByteArray, text);
        writeSettings(text);
        const auto window = start({QStringLiteral("builtin:cube")}, usual());
        QCOMPARE(ended(*window), QString());
        QVERIFY2(!settings().isEmpty(), "they are written anew");
    }

    void settingsOfOtherKinds_data()
    {
        QTest::addColumn<QJsonValue>("value");
        QTest::newRow("null") << QJsonValue();
        QTest::newRow("number") << QJsonValue(-1e300);
        QTest::newRow("text") << QJsonValue(QString(5000, QLatin1Char('x')));
        QTest::newRow("list") << QJsonValue(QJsonArray{1, QJsonObject{}, QStringLiteral("builtin:none")});
        QTest::newRow("bytes") << QJsonValue(QJsonObject{{QStringLiteral("base64"), QStringLiteral("AAAA////")}});
        QTest::newRow("object") << QJsonValue(QJsonObject{{QStringLiteral("a"), QJsonArray{}}});
    }

    /// As a newer version might keep them: every key with a value of another kind, and one that this version lacks,
    /// which stays.
    void settingsOfOtherKinds()
    {
        QFETCH(QJsonValue, value);
        const auto first = start({QStringLiteral("builtin:cube")}, usual());
        QCOMPARE(ended(*first), QString());
        QJsonObject kept = settings();
        QVERIFY(kept.size() >= 3);
        const QStringList keys = kept.keys();
        for (const QString& key : keys)
            kept[key] = value;
        kept[QStringLiteral("window/of-a-newer-version")] = QStringLiteral("stays");
        writeSettings(QJsonDocument(kept).toJson());
        const auto second = start({}, usual());
        QCOMPARE(ended(*second), QString());
        QCOMPARE(settings()[QStringLiteral("window/of-a-newer-version")].toString(), QStringLiteral("stays"));
    }

    void screenshotsLeaveDevicesAlone()
    {
        const QString full = QStringLiteral("/dev/full");
        if (!QFile::exists(full))
            QSKIP("this system has no /dev/full");
        const auto refused = start({QStringLiteral("--screenshot"), full, QStringLiteral("builtin:cube")}, usual());
        QVERIFY(refused->waitForFinished(kPatienceMs));
        QCOMPARE(refused->exitCode(), 3);
        QVERIFY(refused->readAll().contains("/dev/full "));
        QVERIFY2(!QFileInfo(full).isFile(), "the device is still a device");
        const auto piped =
            start({QStringLiteral("--screenshot"), QStringLiteral("-"), QStringLiteral("builtin:cube")}, usual());
        QVERIFY(piped->waitForFinished(kPatienceMs));
        QVERIFY(piped->readAll().startsWith("\x89PNG"));
        QVERIFY(!QFile::exists(path(QStringLiteral("-"))));
    }

    /// Both write the same settings when they end.
    void twoAtOnce()
    {
        const auto one = start({QStringLiteral("builtin:cube")}, usual());
        const auto two = start({QStringLiteral("builtin:tile-square")}, usual());
        QCOMPARE(ended(*one), QString());
        QCOMPARE(ended(*two), QString());
        QVERIFY(!settings().isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestSurroundings)
#include "test_surroundings.moc"
