// Files in memory: what is said about those that cannot be had, and those that shrink while they are read.
#include "core/io/mapped_file.h"
#include "scene_files.h"

#include <unistd.h>

#include <algorithm>

using namespace rasterlens;
using namespace rasterlens::test;

class TestMappedFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holdsTheBytes();
    void saysWhyNot();
    void fileThatShrinks();
    void manyAtOnce();
};

void TestMappedFile::holdsTheBytes()
{
    const Folder folder;
    MappedFile file;
    QVERIFY(!file.open(folder.write(QStringLiteral("a"), "some bytes")));
    QVERIFY(file.text() == "some bytes");
    QVERIFY(!file.wasShortened());
}

void TestMappedFile::saysWhyNot()
{
    const Folder folder;
    const auto why = [](const QString& path) {
        MappedFile file;
        return textOf(file.open(path).value_or(Reason("opened")));
    };
    QCOMPARE(why(folder.path(QStringLiteral("none"))), QStringLiteral("there is no such file"));
    QCOMPARE(why(folder.path()), QStringLiteral("this is a directory; a file is expected"));
    QCOMPARE(why(folder.write(QStringLiteral("empty"), "")), QStringLiteral("the file is empty"));
    QCOMPARE(why(QStringLiteral("/dev/null")), QStringLiteral("this is a device or a pipe; a file is expected"));
}

/// Without the guard the read raises SIGBUS, which ends the program.
void TestMappedFile::fileThatShrinks()
{
    const Folder folder;
    const QByteArray bytes(1'000'000, 'x');
    const QString path = folder.write(QStringLiteral("a"), bytes);
    MappedFile file;
    QVERIFY(!file.open(path));
    QCOMPARE(::truncate(path.toUtf8().constData(), 100), 0);
    const std::string_view text = file.text();
    QCOMPARE(static_cast<qsizetype>(text.size()), bytes.size());
    QVERIFY(text.substr(0, 100) == std::string(100, 'x'));
    QCOMPARE(std::count(text.begin() + 500'000, text.end(), '\0'), std::ptrdiff_t{500'000});
    QVERIFY(file.wasShortened());
    MappedFile other;
    QVERIFY(!other.open(path));
    QVERIFY(!other.wasShortened());
}

void TestMappedFile::manyAtOnce()
{
    const Folder folder;
    const QString path = folder.write(QStringLiteral("a"), "x");
    std::array<MappedFile, 100> files;
    const auto opened = std::ranges::count_if(files, [&](MappedFile& file) { return !file.open(path); });
    QVERIFY(opened >= 50 && opened < 100);
    QVERIFY(std::ranges::all_of(files, [](const MappedFile& f) { return f.text() == "x" || f.text().empty(); }));
}

QTEST_APPLESS_MAIN(TestMappedFile)
#include "test_mapped_file.moc"
