// What the window remembers between runs survives a full disk, and what earlier versions remembered is taken over.
#include "scene_files.h"
#include "ui/base/settings_file.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <csignal>

#ifdef Q_OS_UNIX
#include <sys/resource.h>
#endif

using namespace rasterlens;
using namespace rasterlens::test;

class TestSettingsFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void valuesComeBack();
    void failureAfterEachByteKeepsTheOldFile();
    void earlierVersionsAreTakenOver();
    void damagedFileIsLikeNone();

private:
    static QByteArray contentOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
    }
};

void TestSettingsFile::valuesComeBack()
{
    const Folder folder;
    const QString path = folder.path(QStringLiteral("s.json"));
    const QByteArray bytes("\0\xff\x80layout", 9);
    const QStringList files{QStringLiteral("/a b/\u6a21.obj"), QStringLiteral("c.case")};
    {
        QSettings settings(path, settingsFormat());
        settings.setValue(QStringLiteral("window/geometry"), bytes);
        settings.setValue(QStringLiteral("window/dark"), true);
        settings.setValue(QStringLiteral("window/language"), QStringLiteral("zh_CN"));
        settings.setValue(QStringLiteral("recentFiles"), files);
        settings.setValue(QStringLiteral("none"), QStringList());
        settings.setValue(QStringLiteral("number"), 7);
    }
    QVERIFY(QFile::rename(path, folder.path(QStringLiteral("t.json")))); // another name is read anew
    const QSettings settings(folder.path(QStringLiteral("t.json")), settingsFormat());
    QCOMPARE(settings.value(QStringLiteral("window/geometry")).toByteArray(), bytes);
    QCOMPARE(settings.value(QStringLiteral("window/dark")).toBool(), true);
    QCOMPARE(settings.value(QStringLiteral("window/language")).toString(), QStringLiteral("zh_CN"));
    QCOMPARE(settings.value(QStringLiteral("recentFiles")).toStringList(), files);
    QVERIFY(settings.value(QStringLiteral("none")).toStringList().isEmpty());
    QCOMPARE(settings.value(QStringLiteral("number")).toInt(), 7);
}

void TestSettingsFile::failureAfterEachByteKeepsTheOldFile()
{
#ifdef Q_OS_UNIX
    const Folder folder;
    const QString path = folder.path(QStringLiteral("s.json"));
    {
        QSettings settings(path, settingsFormat());
        settings.setValue(QStringLiteral("old"), QStringLiteral("kept"));
    }
    const QByteArray old = contentOf(path);
    QVERIFY(old.contains("kept"));
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    for (int bytes = 0; bytes < 100; ++bytes) {
        rlimit limit = before;
        limit.rlim_cur = static_cast<rlim_t>(bytes);
        setrlimit(RLIMIT_FSIZE, &limit);
        {
            QSettings settings(path, settingsFormat());
            settings.setValue(QStringLiteral("new"), QString(100, QLatin1Char('n')) + QString::number(bytes));
            settings.sync();
            setrlimit(RLIMIT_FSIZE, &before); // the messages of this test may go to a file
            QCOMPARE(settings.status(), QSettings::AccessError);
            setrlimit(RLIMIT_FSIZE, &limit); // it writes once more when it ends
        }
        setrlimit(RLIMIT_FSIZE, &before);
        QVERIFY2(contentOf(path) == old, contentOf(path).constData());
        QFile::remove(path + QStringLiteral(".lock"));
    }
    QSettings settings(path, settingsFormat());
    settings.sync();
    QCOMPARE(settings.status(), QSettings::NoError);
    QVERIFY(contentOf(path).contains("nnn"));
#else
    QSKIP("no such limit on this system");
#endif
}

void TestSettingsFile::earlierVersionsAreTakenOver()
{
    const Folder folder;
    QCoreApplication::setOrganizationName(QStringLiteral("RasterLensTest"));
    QCoreApplication::setApplicationName(QStringLiteral("Earlier"));
    for (const QSettings::Format format : {QSettings::NativeFormat, settingsFormat()})
        QSettings::setPath(format, QSettings::UserScope, folder.path());
    {
        QSettings earlier(QSettings::NativeFormat, QSettings::UserScope, QStringLiteral("RasterLensTest"),
                          QStringLiteral("Earlier"));
        earlier.setValue(QStringLiteral("window/dark"), true);
    }
    useSettingsFormat();
    QVERIFY(QSettings().value(QStringLiteral("window/dark")).toBool());
    QVERIFY(settingsProblem().isEmpty());
    QVERIFY(QFileInfo(QSettings().fileName()).fileName().endsWith(QLatin1String(".json")));
    QSettings().setValue(QStringLiteral("window/dark"), false);
    useSettingsFormat(); // once
    QVERIFY(!QSettings().value(QStringLiteral("window/dark")).toBool());
}

void TestSettingsFile::damagedFileIsLikeNone()
{
    const Folder folder;
    for (const char* text : {"", "{", "[1]", "[General]\nold=1\n", "{\"a\": {\"b\": 1}, \"c\": null}"}) {
        const QString path = folder.write(QStringLiteral("d%1.json").arg(qHash(QByteArray(text))), text);
        QSettings settings(path, settingsFormat());
        QVERIFY(settings.value(QStringLiteral("a")).toByteArray().isEmpty());
        settings.setValue(QStringLiteral("new"), 1);
        settings.sync();
        QVERIFY(contentOf(path).contains("\"new\""));
    }
}

QTEST_GUILESS_MAIN(TestSettingsFile)
#include "test_settings_file.moc"
