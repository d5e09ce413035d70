// The window's program in odd surroundings: without fonts, without a home or with one that cannot be written.
#include <QFile>
#include <QFileInfo>
#include <QImage>
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
    }

    void whatLeadsOutIsAskedAbout_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("session") << QStringLiteral("s.json")
                                 << QByteArray(R"({"rasterlens": 1, "scene": "/nowhere/a.case"})");
        QTest::newRow("lesson") << QStringLiteral("l.json")
                                << QByteArray(R"({"rasterlens-lesson": 1, "id": "a", "title": {"en": "A", "zh": "A"},
            "steps": [{"scene": "/nowhere/a.case", "caption": {"en": "One.", "zh": "One."}}]})");
    }

    /// A window that is started with a file that names others outside its folder stays and asks. One that only writes a
    /// picture ends.
    void whatLeadsOutIsAskedAbout()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, text);
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        file.close();
        const auto window = start({name}, usual());
        QByteArray said;
        while (!said.contains("(--allow-outside)") && window->waitForReadyRead(kPatienceMs))
            said += window->readAll();
        QVERIFY2(said.contains("(--allow-outside)"), said.constData());
        window->terminate();
        QVERIFY(window->waitForFinished(kPatienceMs));
        QCOMPARE(window->exitCode(), 128 + SIGTERM);
        const auto picture = start({QStringLiteral("--screenshot"), QStringLiteral("w.png"), name}, usual());
        QVERIFY(picture->waitForFinished(kPatienceMs));
        QCOMPARE(picture->exitCode(), 3);
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
        QVERIFY(piped->readAll().contains("\x89PNG"));
        QVERIFY(!QFile::exists(path(QStringLiteral("-"))));
    }
};

QTEST_GUILESS_MAIN(TestSurroundings)
#include "test_surroundings.moc"
