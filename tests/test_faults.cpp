// The programs on a system that fails: no file that they write is ever half there, whatever it holds and wherever the
// disk gives out, the message names it, and what was there before stays.
#include "cli_support.h"
#include "seed.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

#include <csignal>
#include <map>
#include <memory>
#include <random>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace rasterlens::test;

namespace
{

constexpr int kPatienceMs = 60000;

/// What lies in a folder: names and contents.
using Content = std::map<QString, QByteArray>;

Content contentOf(const QString& folder)
{
    Content content;
    for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden | QDir::System))
        content[name] = readFile(QDir(folder).filePath(name));
    return content;
}

} // namespace

class TestFaults : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    [[nodiscard]] QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }

    [[nodiscard]] std::unique_ptr<QProcess> start(const QString& words, qint64 largestFile = -1) const
    {
        auto process = std::make_unique<QProcess>();
        process->setWorkingDirectory(m_folder->path());
        process->setChildProcessModifier([largestFile] {
            if (largestFile < 0)
                return;
            const rlimit limit{rlim_t(largestFile), rlim_t(largestFile)};
            ::setrlimit(RLIMIT_FSIZE, &limit);
        });
        process->start(QStringLiteral(RASTERLENS_CLI), words.split(QLatin1Char(' ')));
        return process;
    }

    struct Ended {
        int exitCode = -1;
        bool bySignal = false;
        QString err;
    };

    [[nodiscard]] Ended end(QProcess& process) const
    {
        if (process.state() != QProcess::NotRunning && !process.waitForFinished(kPatienceMs))
            return {-1, false, QStringLiteral("it did not end")};
        return {process.exitCode(), process.exitStatus() == QProcess::CrashExit,
                QString::fromUtf8(process.readAllStandardError())};
    }

    [[nodiscard]] Ended call(const QString& words, qint64 largestFile = -1) const
    {
        return end(*start(words, largestFile));
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        writeFile(path("a.case"), "size 16 16\ntri -1 -1 0 1 1 0 0  1 -1 0 1 0 1 0  -1 1 0 1 0 0 1\n");
        QVERIFY(filled(16, 16, qRgb(1, 2, 3)).save(path("a.png")));
    }

    void fullDiskKeepsEveryKindOfFile_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QStringList>("outputs");
        const auto row = [](const char* words, const char* outputs) {
            QTest::newRow(words) << QString::fromLatin1(words) << QString::fromLatin1(outputs).split(QLatin1Char(' '));
        };
        row("render a.case -o o.png --stats o.json", "o.png o.json");
        row("render a.case -o o.ppm --depth d.npy --ids i.npy --coverage c.npy", "o.ppm d.npy i.npy c.npy");
        row("render a.case -o o.bmp", "o.bmp");
        row("render a.case -o o.jpg", "o.jpg");
        row("steps a.case --json o.json", "o.json");
        row("why a.case --pixel 2,13 --json o.json", "o.json");
        row("derive a.case --face 0 --topic edge-function --pixel 2,13 --json o.json", "o.json");
        row("diff a.png a.png -o o.png --json o.json", "o.png o.json");
        row("lesson --list --json o.json", "o.json");
        row("bench a.case --variants as-given --frames 1 --csv o.csv --json o.json --plot o.svg", "o.csv o.json o.svg");
        row("bench a.case --variants as-given --frames 1 --plot o.png", "o.png");
        row("figure a.case -o o.png", "o.png");
        row("figure a.case -o o.svg", "o.svg");
        row("figure a.case -o o.pdf", "o.pdf");
        row("figure a.case --steps 0-2 -o o.gif", "o.gif");
        row("page a.case -o o.html", "o.html");
    }

    /// The disk is full after so many bytes: none, or all of the largest file but one.
    void fullDiskKeepsEveryKindOfFile()
    {
        QFETCH(QString, words);
        QFETCH(QStringList, outputs);
        const Ended good = call(words);
        QVERIFY2(good.exitCode <= 1 && !good.bySignal, qPrintable(good.err));
        qint64 largest = 0;
        for (const QString& name : outputs) {
            const QString file = m_folder->filePath(name);
            QVERIFY2(QFileInfo(file).size() > 1, qPrintable(name));
            largest = std::max(largest, QFileInfo(file).size());
            writeFile(file, "old " + name.toUtf8());
        }
        const Content before = contentOf(m_folder->path());
        const bool hasOthers = words.startsWith(QLatin1String("figure")) || words.startsWith(QLatin1String("page"));
        // What is measured is not as long the next time.
        const bool isMeasured = words.startsWith(QLatin1String("bench")) || words.contains(QLatin1String("--stats"));
        for (const qint64 bytes : {qint64(0), isMeasured ? largest / 2 : largest - 1}) {
            const Ended full = call(words, bytes);
            QVERIFY2(!full.bySignal, qPrintable(full.err));
            QCOMPARE(full.exitCode, 3);
            QVERIFY2(full.err.contains(QLatin1String("be written: ")), qPrintable(full.err));
            const bool named = std::any_of(outputs.begin(), outputs.end(),
                                           [&](const QString& name) { return full.err.contains(name); });
            // Programs with a window get their scene by a file, which may be the first that does not fit.
            QVERIFY2(named || (hasOthers && full.err.contains(QLatin1String("figure.json"))), qPrintable(full.err));
            QVERIFY2(contentOf(m_folder->path()) == before, qPrintable(words));
        }
        QCOMPARE(call(words).exitCode, good.exitCode);
    }

    void foldersThatCannotBeWrittenAreNamed()
    {
        for (const char* name : {"none/o.png", "a.case/o.png", "/sys/o.png", "."}) {
            const Ended bad = call(QStringLiteral("render a.case -o ") + QLatin1String(name));
            QCOMPARE(bad.exitCode, name[0] == '.' ? bad.exitCode : 3);
            QVERIFY2(bad.exitCode == 3 && bad.err.startsWith(QLatin1String(name) + QLatin1String(": ")),
                     qPrintable(bad.err));
        }
    }

    /// The folder goes while the program writes more into a pipe than that holds: the picture is complete by then, but
    /// not in its place.
    void aFolderThatVanishesIsNamed()
    {
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("gone")));
        QCOMPARE(::mkfifo(QFile::encodeName(path("pipe")).constData(), 0600), 0);
        const auto process = start(QStringLiteral("render a.case --size 256x256 -o gone/o.png --depth pipe"));
        QFile pipe(path("pipe"));
        QVERIFY(pipe.open(QIODevice::ReadOnly | QIODevice::Unbuffered)); // waits for the program
        QVERIFY(QDir(path("gone")).removeRecursively());
        pipe.readAll();
        const Ended gone = end(*process);
        QCOMPARE(gone.exitCode, 3);
        QVERIFY2(gone.err.startsWith(QLatin1String("gone/o.png: cannot be written: ")), qPrintable(gone.err));
    }

    void endSignalsLeaveNoHalfFile_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<int>("signal");
        const QString render = QStringLiteral("render builtin:cube --size 512x512 -o o.bmp --depth d.npy --ids i.npy");
        const QString bench =
            QStringLiteral("bench a.case --variants as-given --frames 10 --csv o.csv --json o.json --plot o.svg");
        QTest::newRow("render, interrupted") << render << SIGINT;
        QTest::newRow("render, ended") << render << SIGTERM;
        QTest::newRow("bench, interrupted") << bench << SIGINT;
        QTest::newRow("bench, hung up") << bench << SIGHUP;
    }

    /// At moments from the start to beyond the end, and so also while files are written.
    void endSignalsLeaveNoHalfFile()
    {
        QFETCH(QString, words);
        QFETCH(int, signal);
        QElapsedTimer clock;
        clock.start();
        const Ended good = call(words);
        QVERIFY2(good.exitCode == 0, qPrintable(good.err));
        const auto whole = static_cast<int>(clock.elapsed());
        Content complete = contentOf(m_folder->path());
        const Content files = complete;
        for (const auto& [name, bytes] : files)
            if (!name.startsWith(QLatin1String("a.")))
                writeFile(m_folder->filePath(name), "old");
        const Content before = contentOf(m_folder->path());
        std::mt19937 random(seedOfRun());
        constexpr int kMoments = 5;
        for (int i = 0; i < kMoments; ++i) {
            const auto process = start(words);
            QVERIFY(process->waitForStarted(kPatienceMs));
            const int moment = whole * i / (kMoments - 2) + int(random() % 8);
            process->waitForFinished(moment);
            if (process->state() != QProcess::NotRunning)
                ::kill(static_cast<pid_t>(process->processId()), signal);
            const Ended ended = end(*process);
            QVERIFY2(ended.exitCode != -1, qPrintable(ended.err));
            const Content now = contentOf(m_folder->path());
            QCOMPARE(now.size(), before.size()); // nothing is left beside them
            if (now == before)
                continue;
            for (const auto& [name, bytes] : now) // measurements differ from run to run, in their length, too
                QVERIFY2(bytes == complete[name] || (words.startsWith(QLatin1String("bench")) && bytes.size() > 50),
                         qPrintable(name));
            for (const auto& [name, bytes] : before)
                writeFile(m_folder->filePath(name), bytes);
        }
    }
};

QTEST_GUILESS_MAIN(TestFaults)
#include "test_faults.moc"
