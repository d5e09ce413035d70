// The one function that writes files: on full disks, through a writer that fails after any number of bytes, onto
// devices and pipes. What was there before stays.
#include "core/io/file_writer.h"
#include "core/io/picture_file.h"
#include "core/io/session.h"
#include "scene_files.h"

#include <QDir>
#include <QFileInfo>

#include <array>
#include <csignal>
#include <thread>

#ifdef Q_OS_UNIX
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif
#ifdef Q_OS_LINUX
#include <sys/mount.h>
#endif

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
}

QStringList entriesOf(const QString& folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::System | QDir::Hidden | QDir::NoDotAndDotDot);
}

QString wordsOf(const std::optional<Reason>& reason) { return reason ? textOf(*reason) : QStringLiteral("written"); }

#ifdef Q_OS_UNIX
/// While it lives, no file of this process grows beyond that many bytes: a disk that is full after them.
class LargestFile
{
public:
    explicit LargestFile(std::size_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_before);
        rlimit limit = m_before;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~LargestFile() { setrlimit(RLIMIT_FSIZE, &m_before); }
    Q_DISABLE_COPY_MOVE(LargestFile)

private:
    rlimit m_before{};
};
#endif

#ifdef Q_OS_LINUX
/// A file system of a few pages in memory.
class SmallDisk
{
public:
    explicit SmallDisk(const QString& folder) : m_folder(QFile::encodeName(folder))
    {
        m_mounted = QDir().mkpath(folder) && mount("tmpfs", m_folder.constData(), "tmpfs", 0, "size=128k") == 0;
    }
    ~SmallDisk()
    {
        if (m_mounted)
            umount2(m_folder.constData(), MNT_DETACH);
    }
    Q_DISABLE_COPY_MOVE(SmallDisk)

    [[nodiscard]] bool isMounted() const { return m_mounted; }

    /// Takes all the space but that many bytes.
    void fill(qint64 spare) const
    {
        QFile rest(QFile::decodeName(m_folder) + QStringLiteral("/rest"));
        QVERIFY(rest.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
        while (rest.write(QByteArray(512, 'x')) == 512) {
        }
        QVERIFY(rest.resize(rest.size() - spare));
    }

private:
    QByteArray m_folder;
    bool m_mounted = false;
};
#endif

} // namespace

class TestFileWriter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fullDiskKeepsTheOldFile_data();
    void fullDiskKeepsTheOldFile();
    void failureAfterEachByteKeepsTheOldFile();
    void everyKindOfFileSurvivesAFailure();
    void allFilesOrNone();
    void devicesStayDevices();
    void pipesAreWrittenInto();
    void linksAndPermissionsStay();
    void whatCannotBeWrittenIsSaidBefore();
    void sameFiles();
    void inputsAreNotOverwritten();
    void formatsBySuffix();
};

void TestFileWriter::fullDiskKeepsTheOldFile_data()
{
    // Below and above the 16 KiB that a file is buffered by, with no space left, a page, or all but one.
    QTest::addColumn<int>("size");
    QTest::addColumn<int>("spare");
    for (const int size : {5000, 40000})
        for (const int spare : {0, 4096, size / 4096 * 4096})
            QTest::addRow("%d bytes, %d free", size, spare) << size << spare;
}

void TestFileWriter::fullDiskKeepsTheOldFile()
{
#ifdef Q_OS_LINUX
    QFETCH(int, size);
    QFETCH(int, spare);
    const Folder folder;
    const SmallDisk disk(folder.path(QStringLiteral("disk")));
    if (!disk.isMounted())
        QSKIP("only root can mount a small file system in memory");
    const QString path = folder.path(QStringLiteral("disk/old"));
    const QByteArray old(size, 'o');
    QCOMPARE(wordsOf(writeFile(path, old)), QStringLiteral("written"));
    disk.fill(spare);
    const QStringList before = entriesOf(folder.path(QStringLiteral("disk")));
    const auto problem = writeFile(path, QByteArray(size, 'n'));
    QCOMPARE(wordsOf(problem), qt_error_string(ENOSPC));
    QVERIFY(contentOf(path) == old);
    QCOMPARE(entriesOf(folder.path(QStringLiteral("disk"))), before);
    QVERIFY(QFile::remove(folder.path(QStringLiteral("disk/rest"))));
    QCOMPARE(wordsOf(writeFile(path, QByteArray(size, 'n'))), QStringLiteral("written"));
    QVERIFY(contentOf(path) == QByteArray(size, 'n'));
#else
    QSKIP("a small file system is mounted on Linux only");
#endif
}

void TestFileWriter::failureAfterEachByteKeepsTheOldFile()
{
#ifdef Q_OS_UNIX
    const Folder folder;
    const QByteArray old = "the old file";
    const QString path = folder.write(QStringLiteral("f"), old);
    const QByteArray fresh(300, 'n');
    for (std::size_t bytes = 0; bytes < 300; ++bytes) {
        std::optional<Reason> problem;
        {
            const LargestFile limit(bytes);
            problem = writeFile(path, fresh);
        }
        QVERIFY2(wordsOf(problem) == qt_error_string(EFBIG), qPrintable(wordsOf(problem)));
        QVERIFY(contentOf(path) == old);
        QCOMPARE(entriesOf(folder.path()), QStringList{QStringLiteral("f")});
    }
    const LargestFile limit(300);
    QCOMPARE(wordsOf(writeFile(path, fresh)), QStringLiteral("written"));
    QVERIFY(contentOf(path) == fresh);
#else
    QSKIP("no such limit on this system");
#endif
}

/// Sessions and pictures in all their formats, half written.
void TestFileWriter::everyKindOfFileSurvivesAFailure()
{
#ifdef Q_OS_UNIX
    const Folder folder;
    const Session session{QStringLiteral("builtin:cube"), toJson(Settings()), {{0, {1, 2, 3, 1}}}};
    const QString path = folder.path(QStringLiteral("s.json"));
    QCOMPARE(wordsOf(saveSession(session, path)), QStringLiteral("written"));
    const QByteArray old = contentOf(path);
    for (const std::size_t bytes : {std::size_t(0), std::size_t(1), static_cast<std::size_t>(old.size()) - 1}) {
        std::optional<Reason> problem;
        {
            const LargestFile limit(bytes);
            problem = saveSession(session, path);
        }
        QCOMPARE(wordsOf(problem), QStringLiteral("the file cannot be written: ") + qt_error_string(EFBIG));
        QVERIFY(contentOf(path) == old);
        QVERIFY(loadSession(path).session.has_value());
    }
    QImage image(64, 64, QImage::Format_RGB32);
    image.fill(Qt::red);
    for (const QString& format : pictureSuffixes()) {
        const PictureBytes picture = pictureBytes(image, format);
        QVERIFY2(!picture.problem && QImage::fromData(picture.bytes).size() == image.size(), qPrintable(format));
        const QString file = folder.write(QStringLiteral("p.") + format, picture.bytes);
        const LargestFile limit(static_cast<std::size_t>(picture.bytes.size()) - 1);
        QVERIFY(writeFile(file, picture.bytes).has_value());
        QVERIFY(contentOf(file) == picture.bytes);
    }
#else
    QSKIP("no such limit on this system");
#endif
}

void TestFileWriter::allFilesOrNone()
{
    const Folder folder;
    const QString first = folder.write(QStringLiteral("first"), "old");
    const QString second = folder.write(QStringLiteral("second"), "old");
    const QString none = folder.path(QStringLiteral("none/third"));
    const std::array<OutputFile, 3> files{{{first, "new"}, {second, "new"}, {none, "new"}}};
    const auto failure = writeFiles(files);
    QVERIFY(failure && failure->path == none);
    QCOMPARE(contentOf(first), QByteArray("old"));
    QCOMPARE(contentOf(second), QByteArray("old"));
    QCOMPARE(entriesOf(folder.path()), (QStringList{QStringLiteral("first"), QStringLiteral("second")}));
    QVERIFY(!writeFiles(std::span(files).first(2)));
    QCOMPARE(contentOf(first), QByteArray("new"));
    QCOMPARE(contentOf(second), QByteArray("new"));
}

void TestFileWriter::devicesStayDevices()
{
    const QString null = QStringLiteral("/dev/null");
    const QString full = QStringLiteral("/dev/full");
    if (!QFile::exists(null) || !QFile::exists(full))
        QSKIP("this system has no such devices");
    QVERIFY(isStream(null) && isStream(QStringLiteral("-")) && isStream(QStringLiteral("/dev/stdout")));
    for (const QByteArray& bytes : {QByteArray("few"), QByteArray(100000, 'm')}) {
        QCOMPARE(wordsOf(writeFile(null, bytes)), QStringLiteral("written"));
        QCOMPARE(wordsOf(writeFile(full, bytes)), qt_error_string(ENOSPC));
        QCOMPARE(wordsOf(writeFile(full, bytes, NoReader::Refuse)), qt_error_string(ENOSPC));
    }
    QVERIFY(!QFileInfo(null).isFile() && !QFileInfo(full).isFile());

    // A file is never replaced where a device that was to be written with it fails.
    const Folder folder;
    const QString file = folder.write(QStringLiteral("file"), "old");
    const std::array<OutputFile, 2> files{{{file, "new"}, {full, "new"}}};
    const auto failure = writeFiles(files);
    QVERIFY(failure && failure->path == full);
    QCOMPARE(contentOf(file), QByteArray("old"));

    QFile buffered(full);
    QVERIFY(buffered.open(QIODevice::WriteOnly));
    QCOMPARE(buffered.write("few"), 3);
    QCOMPARE(wordsOf(bringToDisk(buffered)), qt_error_string(ENOSPC));
}

void TestFileWriter::pipesAreWrittenInto()
{
#ifdef Q_OS_UNIX
    const Folder folder;
    const QString pipe = folder.path(QStringLiteral("pipe"));
    QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    QVERIFY(isStream(pipe));
    QCOMPARE(wordsOf(writeFile(pipe, "nothing", NoReader::Refuse)), QStringLiteral("no program reads from this pipe"));
    const QByteArray sent(200000, 's'); // more than a pipe holds
    QByteArray received;
    std::thread reader([&] { received = contentOf(pipe); });
    const auto problem = writeFile(pipe, sent);
    reader.join();
    QCOMPARE(wordsOf(problem), QStringLiteral("written"));
    QVERIFY(received == sent);
    QVERIFY2(isStream(pipe) && !QFileInfo(pipe).isFile(), "the pipe is still a pipe");

    // The reader leaves before all is written.
    std::signal(SIGPIPE, SIG_IGN);
    std::thread leaving([&] {
        QFile file(pipe);
        if (file.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
            file.read(1);
    });
    const auto broken = writeFile(pipe, sent);
    leaving.join();
    QCOMPARE(wordsOf(broken), qt_error_string(EPIPE));
#else
    QSKIP("no named pipes on this system");
#endif
}

void TestFileWriter::linksAndPermissionsStay()
{
#ifdef Q_OS_UNIX
    const Folder folder;
    const QString file = folder.write(QStringLiteral("file"), "old");
    const QString link = folder.path(QStringLiteral("link"));
    QVERIFY(QFile::link(QStringLiteral("file"), link));
    const auto permissions = QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup;
    QVERIFY(QFile::setPermissions(file, permissions));
    const auto before = QFile::permissions(file);
    QCOMPARE(wordsOf(writeFile(link, "new")), QStringLiteral("written"));
    QVERIFY(QFileInfo(link).isSymLink());
    QCOMPARE(contentOf(file), QByteArray("new"));
    QCOMPARE(QFile::permissions(file), before);
    QVERIFY(QFile::link(QStringLiteral("later"), folder.path(QStringLiteral("dangling"))));
    QCOMPARE(wordsOf(writeFile(folder.path(QStringLiteral("dangling")), "new")), QStringLiteral("written"));
    QCOMPARE(contentOf(folder.path(QStringLiteral("later"))), QByteArray("new"));
#else
    QSKIP("links of this system are other files");
#endif
}

void TestFileWriter::whatCannotBeWrittenIsSaidBefore()
{
    const Folder folder;
    const QString file = folder.write(QStringLiteral("file"), "old");
    QCOMPARE(wordsOf(whyNotWritable(file)), QStringLiteral("written"));
    QCOMPARE(wordsOf(whyNotWritable(folder.path(QStringLiteral("new")))), QStringLiteral("written"));
    QCOMPARE(wordsOf(whyNotWritable(QStringLiteral("-"))), QStringLiteral("written"));
    QVERIFY(wordsOf(whyNotWritable(folder.path())).startsWith(QLatin1String("it is a folder")));
    QVERIFY(whyNotWritable(folder.path(QStringLiteral("none/new"))));
    QVERIFY(whyNotWritable(folder.path(QStringLiteral("file/new"))));
    QCOMPARE(contentOf(file), QByteArray("old"));
    QCOMPARE(entriesOf(folder.path()), QStringList{QStringLiteral("file")});
}

void TestFileWriter::sameFiles()
{
    const Folder folder;
    const QString file = folder.write(QStringLiteral("file"), "1");
    const QString other = folder.write(QStringLiteral("other"), "1");
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("sub")));
    const QString later = folder.path(QStringLiteral("later"));
    QVERIFY(isSameFile(file, file) && isSameFile(later, later));
    QVERIFY(isSameFile(file, folder.path(QStringLiteral("sub/../file"))));
    QVERIFY(isSameFile(later, folder.path(QStringLiteral("sub/../later"))));
    QVERIFY(isSameFile(file, QDir::current().relativeFilePath(file)));
    QVERIFY(!isSameFile(file, other) && !isSameFile(file, later) && !isSameFile(later, file));
    QVERIFY(!isSameFile(later, folder.path(QStringLiteral("sub/later"))));
#ifdef Q_OS_UNIX
    QVERIFY(QFile::link(QStringLiteral("file"), folder.path(QStringLiteral("link"))));
    QVERIFY(QFile::link(QStringLiteral("sub"), folder.path(QStringLiteral("folder link"))));
    QCOMPARE(::link(QFile::encodeName(file).constData(), QFile::encodeName(folder.path("hard")).constData()), 0);
    QVERIFY(isSameFile(file, folder.path(QStringLiteral("link"))));
    QVERIFY(isSameFile(folder.path(QStringLiteral("hard")), file));
    QVERIFY(isSameFile(folder.path(QStringLiteral("sub/new")), folder.path(QStringLiteral("folder link/new"))));
    QVERIFY(!isSameFile(other, folder.path(QStringLiteral("link"))));
#endif
}

void TestFileWriter::inputsAreNotOverwritten()
{
    const Folder folder;
    const QString model = folder.write(QStringLiteral("m.obj"), "v");
    const QString texture = folder.write(QStringLiteral("t.png"), "p");
    const QStringList inputs{model, texture};
    const QString said = QStringLiteral("it is in use as an input and would be overwritten; another name is expected");
    QCOMPARE(wordsOf(whyNotOver(texture, inputs)), said);
    QCOMPARE(wordsOf(whyNotOver(folder.path(QStringLiteral("./m.obj")), inputs)), said);
    QVERIFY(!whyNotOver(folder.path(QStringLiteral("t2.png")), inputs));
    QVERIFY(!whyNotOver(QStringLiteral("-"), inputs));
    QVERIFY(!whyNotOver(texture, {}));
}

void TestFileWriter::formatsBySuffix()
{
    QCOMPARE(formatOf(QStringLiteral("a.PNG")), QStringLiteral("png"));
    QCOMPARE(formatOf(QStringLiteral("a.tar.Jpg")), QStringLiteral("jpg"));
    QCOMPARE(formatOf(QStringLiteral("folder.d/a")), QStringLiteral("png"));
    QCOMPARE(formatOf(QStringLiteral("-"), QStringLiteral("svg")), QStringLiteral("svg"));
    for (const char* good : {"a.png", "a.ppm", "a.bmp", "a.jpg", "a.JPEG", "a", "-"})
        QVERIFY2(!whyNotFormat(QLatin1String(good), pictureSuffixes()), good);
    for (const char* bad : {"a.gif", "a.svg", "a.tga", "a.v2", "a.png.bak"})
        QVERIFY2(wordsOf(whyNotFormat(QLatin1String(bad), pictureSuffixes()))
                     .endsWith(QLatin1String("which are: png, ppm, bmp, jpg, jpeg")),
                 bad);
    QVERIFY(pictureBytes(QImage(), QStringLiteral("png")).problem.has_value());
    QImage image(3, 2, QImage::Format_RGB32);
    image.fill(Qt::blue);
    QVERIFY(pictureBytes(image, QStringLiteral("png")).bytes.startsWith("\x89PNG"));
    QVERIFY(pictureBytes(image, QStringLiteral("jpeg")).bytes.startsWith("\xff\xd8\xff"));
    QVERIFY(pictureBytes(image, QStringLiteral("bmp")).bytes.startsWith("BM"));
    QVERIFY(pictureBytes(image, QStringLiteral("ppm")).bytes.startsWith("P6"));
}

QTEST_GUILESS_MAIN(TestFileWriter)
#include "test_file_writer.moc"
