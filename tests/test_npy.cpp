// NumPy files: the header byte by byte, values there and back, and what is not such a file.
#include "core/io/npy.h"

#include <QTest>

#include <array>
#include <limits>

using namespace rasterlens;

class TestNpy : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void headerIsThatOfVersionOne();
    void headerFillsWholeBlocks();
    void numbersAreLittleEndianRowByRow();
    void valuesComeBack();
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
    QCOMPARE(read.array->rows, rows);
    QCOMPARE(read.array->columns, columns);
    QVERIFY(read.array->values == std::vector<double>(values.begin(), values.end()));
}

void TestNpy::valuesComeBack()
{
    compareThereAndBack<float>({0, -0.0F, 0.1F, 1, 1e-45F, std::numeric_limits<float>::max()}, 2, 3);
    compareThereAndBack<std::int32_t>({-1, 0, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}, 4, 1);
    compareThereAndBack<std::uint16_t>({0, 1, 65535}, 1, 3);
}

void TestNpy::brokenFilesAreRefused()
{
    const std::array<float, 2> values{1, 2};
    const QByteArray good = npyBytes(std::span<const float>(values), 1, 2);
    QVERIFY(readNpy(good).array);
    QByteArray otherVersion = good;
    otherVersion[6] = 2;
    QByteArray otherOrder = good;
    otherOrder.replace("False", "True ");
    QByteArray otherType = good;
    otherType.replace("<f4", "<f8");
    QByteArray otherShape = good;
    otherShape.replace("(1, 2)", "(2, 2)");
    QByteArray oneDimension = good;
    oneDimension.replace("(1, 2)", "(2,)  ");
    const QByteArray broken[] = {{},          good.left(9),     good.left(60), good.chopped(1),
                                 good + '\0', "P6 1 1 255 abc", otherVersion,  otherOrder,
                                 otherType,   otherShape,       oneDimension};
    for (const QByteArray& bytes : broken) {
        const NpyRead read = readNpy(bytes);
        QVERIFY2(!read.array, bytes.left(70).toHex().constData());
        QVERIFY(!read.error.isEmpty());
    }
}

QTEST_APPLESS_MAIN(TestNpy)
#include "test_npy.moc"
