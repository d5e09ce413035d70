// NumPy files: the header byte by byte, values there and back, and what is not such a file.
#include "core/io/npy.h"

#include <QTest>

#include <array>
#include <limits>
#include <variant>
#include <vector>

using namespace rasterlens;

namespace
{

/// A file of version 1, as NumPy writes it.
QByteArray npyFile(const QByteArray& type, const QByteArray& shape, const QByteArray& data, bool columnsFirst = false)
{
    QByteArray dictionary = "{'descr': '" + type + "', 'fortran_order': " + (columnsFirst ? "True" : "False") +
                            ", 'shape': " + shape + ", }\n";
    QByteArray file("\x93NUMPY\x01\x00", 8);
    file.append(static_cast<char>(dictionary.size())).append('\0');
    return file + dictionary + data;
}

std::vector<double> doublesOf(const NpyArray& array)
{
    return std::visit([](const auto& all) { return std::vector<double>(all.begin(), all.end()); }, array.values);
}

/// 1, 2, .. as bytes.
QByteArray counted(int count)
{
    QByteArray bytes;
    for (int i = 1; i <= count; ++i)
        bytes.append(static_cast<char>(i));
    return bytes;
}

} // namespace

class TestNpy : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void headerIsThatOfVersionOne();
    void headerFillsWholeBlocks();
    void numbersAreLittleEndianRowByRow();
    void valuesComeBack();
    void everyRealType_data();
    void everyRealType();
    void integersOfEightBytesAreExact();
    void ordersOfTheValues_data();
    void ordersOfTheValues();
    void headersOfOtherWriters_data();
    void headersOfOtherWriters();
    void otherTypesAreNamed_data();
    void otherTypesAreNamed();
    void brokenFilesAreRefused();
};

void TestNpy::headerIsThatOfVersionOne()
{
    const QByteArray header = npyHeader("<f4", 2, 3);
    const QByteArray dictionary = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }";
    QCOMPARE(header.size(), 128);
    QCOMPARE(header.left(10), QByteArray("\x93NUMPY\x01\x00\x76\x00", 10));
    QCOMPARE(header.mid(10, dictionary.size()), dictionary);
    QCOMPARE(header.mid(10 + dictionary.size()), QByteArray(128 - 11 - dictionary.size(), ' ') + '\n');
}

void TestNpy::headerFillsWholeBlocks()
{
    for (int columns = 1; columns < 1'000'000'000 / 10; columns *= 10) {
        const QByteArray header = npyHeader("<u2", columns, 1);
        QCOMPARE(header.size() % 64, 0);
        QVERIFY(header.endsWith('\n'));
    }
}

void TestNpy::numbersAreLittleEndianRowByRow()
{
    const std::array<std::uint16_t, 4> covered{1, 2, 0x0304, 0xffff};
    QCOMPARE(npyBytes(std::span<const std::uint16_t>(covered), 2, 2).mid(128),
             QByteArray("\x01\x00\x02\x00\x04\x03\xff\xff", 8));
    const std::array<std::int32_t, 1> none{-1};
    QCOMPARE(npyBytes(std::span<const std::int32_t>(none), 1, 1).mid(128), QByteArray("\xff\xff\xff\xff", 4));
    const std::array<float, 1> one{1};
    QCOMPARE(npyBytes(std::span<const float>(one), 1, 1).mid(128), QByteArray("\x00\x00\x80\x3f", 4));
}

template <NpyNumber T>
void compareThereAndBack(const std::vector<T>& values, int rows, int columns)
{
    const NpyRead read = readNpy(npyBytes(std::span<const T>(values), rows, columns));
    QVERIFY2(read.array, qPrintable(read.error));
    QCOMPARE(read.array->type, QLatin1String(npyType<T>()));
    QVERIFY(read.array->shape == (std::vector<qint64>{rows, columns}));
    QVERIFY(doublesOf(*read.array) == std::vector<double>(values.begin(), values.end()));
}

void TestNpy::valuesComeBack()
{
    compareThereAndBack<float>({0, -0.0F, 0.1F, 1, 1e-45F, std::numeric_limits<float>::max()}, 2, 3);
    compareThereAndBack<std::int32_t>({-1, 0, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}, 4, 1);
    compareThereAndBack<std::uint16_t>({0, 1, 65535}, 1, 3);
}

void TestNpy::everyRealType_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<double>("value");
    const auto row = [](const char* type, const QByteArray& bytes, double value) {
        QTest::newRow(type) << bytes << value;
    };
    row("|b1", QByteArray("\x01", 1), 1);
    row("|i1", QByteArray("\xfe", 1), -2);
    row("|u1", QByteArray("\xfe", 1), 254);
    row("<i2", QByteArray("\xfe\xff", 2), -2);
    row(">i2", QByteArray("\x01\x02", 2), 258);
    row(">u2", QByteArray("\xff\xfe", 2), 65534);
    row(">i4", QByteArray("\xff\xff\xff\xfe", 4), -2);
    row("<u4", QByteArray("\xfe\xff\xff\xff", 4), 4294967294.0);
    row("<i8", QByteArray("\xfe\xff\xff\xff\xff\xff\xff\xff", 8), -2);
    row(">u8", QByteArray("\x00\x00\x00\x01\x00\x00\x00\x00", 8), 4294967296.0);
    row("<f2", QByteArray("\x00\x3e", 2), 1.5);
    row(">f2", QByteArray("\xbe\x00", 2), -1.5);
    row(">f4", QByteArray("\x3f\xc0\x00\x00", 4), 1.5);
    row("<f8", QByteArray("\x00\x00\x00\x00\x00\x00\xf8\x3f", 8), 1.5);
    row(">f8", QByteArray("\x3f\xf8\x00\x00\x00\x00\x00\x00", 8), 1.5);
    row("=f4", QByteArray("\x00\x00\xc0\x3f", 4), 1.5);
    row("u1", QByteArray("\x07", 1), 7);
}

void TestNpy::everyRealType()
{
    QFETCH(QByteArray, bytes);
    QFETCH(double, value);
    const NpyRead read = readNpy(npyFile(QTest::currentDataTag(), "(1, 1)", bytes));
    QVERIFY2(read.array, qPrintable(read.error));
    QCOMPARE(doublesOf(*read.array), std::vector<double>{value});
}

void TestNpy::integersOfEightBytesAreExact()
{
    const NpyRead largest = readNpy(npyFile("<u8", "(1,)", QByteArray(8, '\xff')));
    QVERIFY(largest.array && std::get<std::vector<std::uint64_t>>(largest.array->values)[0] == 18446744073709551615ULL);
    const NpyRead odd = readNpy(npyFile("<i8", "(1,)", QByteArray("\x01\x00\x00\x00\x00\x00\x20\x00", 8)));
    QVERIFY(odd.array && std::get<std::vector<std::int64_t>>(odd.array->values)[0] == 9007199254740993LL);
}

void TestNpy::ordersOfTheValues_data()
{
    QTest::addColumn<QByteArray>("shape");
    QTest::addColumn<bool>("columnsFirst");
    QTest::addColumn<QString>("kept");
    QTest::addColumn<std::vector<double>>("values");
    const auto row = [](const char* name, const char* shape, bool columnsFirst, const char* kept,
                        const std::vector<double>& values) {
        QTest::newRow(name) << QByteArray(shape) << columnsFirst << QString::fromLatin1(kept) << values;
    };
    row("rows first", "(2, 3)", false, "(2, 3)", {1, 2, 3, 4, 5, 6});
    row("columns first", "(2, 3)", true, "(2, 3)", {1, 3, 5, 2, 4, 6});
    row("a last dimension of 1", "(2, 3, 1)", false, "(2, 3)", {1, 2, 3, 4, 5, 6});
    row("and columns first", "(2, 3, 1)", true, "(2, 3)", {1, 3, 5, 2, 4, 6});
    row("three dimensions, first one first", "(3, 1, 2)", true, "(3, 1, 2)", {1, 4, 2, 5, 3, 6});
    row("one dimension", "(6,)", false, "(6,)", {1, 2, 3, 4, 5, 6});
    row("one dimension, columns first", "(6,)", true, "(6,)", {1, 2, 3, 4, 5, 6});
    row("a column stays one", "(6, 1)", false, "(6, 1)", {1, 2, 3, 4, 5, 6});
    row("no dimension", "()", false, "()", {1});
    row("no values", "(0, 6)", true, "(0, 6)", {});
}

void TestNpy::ordersOfTheValues()
{
    QFETCH(QByteArray, shape);
    QFETCH(bool, columnsFirst);
    QFETCH(QString, kept);
    QFETCH(std::vector<double>, values);
    const NpyRead read = readNpy(npyFile("|u1", shape, counted(static_cast<int>(values.size())), columnsFirst));
    QVERIFY2(read.array, qPrintable(read.error));
    QCOMPARE(shapeText(read.array->shape), kept);
    QCOMPARE(doublesOf(*read.array), values);
}

void TestNpy::headersOfOtherWriters_data()
{
    QTest::addColumn<int>("version");
    QTest::addColumn<QByteArray>("dictionary");
    QTest::newRow("other order of the keys")
        << 1 << QByteArray("{'shape': (1, 2), 'fortran_order': False, 'descr': '|u1'}\n");
    QTest::newRow("double quotes, no blanks")
        << 1 << QByteArray(R"({"descr":"|u1","fortran_order":False,"shape":(1,2)})");
    QTest::newRow("long integers") << 1 << QByteArray("{'descr': '|u1', 'fortran_order': False, 'shape': (1L, 2L), }");
    QTest::newRow("version 2") << 2 << QByteArray("{'descr': '|u1', 'fortran_order': False, 'shape': (1, 2), }\n");
    QTest::newRow("version 3") << 3 << QByteArray("{'descr': '|u1', 'fortran_order': False, 'shape': (1, 2), }\n");
}

void TestNpy::headersOfOtherWriters()
{
    QFETCH(int, version);
    QFETCH(QByteArray, dictionary);
    QByteArray file("\x93NUMPY");
    file.append(static_cast<char>(version)).append('\0').append(static_cast<char>(dictionary.size())).append('\0');
    if (version > 1)
        file.append('\0').append('\0');
    const NpyRead read = readNpy(file + dictionary + counted(2));
    QVERIFY2(read.array, qPrintable(read.error));
    QCOMPARE(doublesOf(*read.array), (std::vector<double>{1, 2}));
}

void TestNpy::otherTypesAreNamed_data()
{
    QTest::addColumn<QByteArray>("type");
    for (const char* type : {"<c8", "<c16", "|S4", "<U4", "|O", "<M8[ns]", "<f16", "|V8", "", "<i3", "<b2"})
        QTest::newRow(type) << QByteArray(type);
}

void TestNpy::otherTypesAreNamed()
{
    QFETCH(QByteArray, type);
    const NpyRead read = readNpy(npyFile(type, "(1, 1)", QByteArray(16, '\0')));
    QVERIFY(!read.array);
    QVERIFY2(read.error.startsWith(QStringLiteral("holds numbers of type \"%1\"; ").arg(QLatin1String(type))),
             qPrintable(read.error));
}

void TestNpy::brokenFilesAreRefused()
{
    const std::array<float, 2> values{1, 2};
    const QByteArray good = npyBytes(std::span<const float>(values), 1, 2);
    QVERIFY(readNpy(good).array && isNpy(good));
    const auto with = [&](const char* before, const char* after) {
        QByteArray changed = good;
        return changed.replace(before, after);
    };
    QByteArray otherVersion = good;
    otherVersion[6] = 4;
    QByteArray longHeader = good;
    longHeader[9] = '\xff';
    const QByteArray records = npyFile("x", "(1, 2)", QByteArray(8, '\0')).replace("'x'", "[('a', '<f4')]");
    const QByteArray broken[] = {{},
                                 good.left(9),
                                 good.left(60),
                                 good.chopped(1),
                                 good + '\0',
                                 "P6 1 1 255 abc",
                                 otherVersion,
                                 longHeader,
                                 records,
                                 with("<f4", "<f8"),
                                 with("(1, 2)", "(2, 2)"),
                                 with("(1, 2)", "(3,)  "),
                                 with("(1, 2)", "(-1,2)"),
                                 with("(1, 2)", "(1, x)"),
                                 with("(1, 2)", "[1, 2]"),
                                 with("shape", "chape"),
                                 with("descr", "desc_"),
                                 with("False", "Maybe"),
                                 with("(1, 2), ", "(9999999999999999999, 2), "),
                                 npyFile("|u1", "(4294967296, 4294967296, 4294967296)", {})};
    for (const QByteArray& bytes : broken) {
        const NpyRead read = readNpy(bytes);
        QVERIFY2(!read.array, bytes.left(70).toHex().constData());
        QVERIFY(!read.error.isEmpty());
    }
}

QTEST_APPLESS_MAIN(TestNpy)
#include "test_npy.moc"
