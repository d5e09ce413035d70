// What people type for a point, a size or a position is read; what is none of them is refused.
#include "core/base/typed_numbers.h"

#include <QTest>

using namespace rasterlens;

class TestTypedNumbers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pointsAreRead()
    {
        for (const char* text : {"3,4", "3, 4", "3 4", "(3, 4)", "( 3,4 )", "[3;4]", "3\t4", " 3 , 4 ", "3\uff0c4",
                                 "\uff083\uff0c4\uff09", "\uff13\u3001\uff14", "3\uff1b4", "3\u30004", "+3,4"})
            QVERIFY2(typedPoint(QString::fromUtf8(text)) == QPoint(3, 4), text);
        QCOMPARE(typedPoint(QString::fromUtf8("\u22123, -4")), std::optional(QPoint(-3, -4)));
        for (const char* text : {"", "3", "3,", ",4", "3,,4", "3,4,5", "(3,4", "3,4)", "3.5,4", "3,4e", "a,b", "3x4",
                                 "()", "99999999999,1"})
            QVERIFY2(!typedPoint(QString::fromUtf8(text)), text);
    }

    void sizesAreRead()
    {
        for (const char* text :
             {"12x9", "12 x 9", "12X9", "12 \u00d7 9", "12*9", "12, 9", "12 9", "(12x9)", "\uff11\uff12\uff58\uff19"})
            QVERIFY2(typedSize(QString::fromUtf8(text), 100) == QSize(12, 9), text);
        QCOMPARE(typedSize(QStringLiteral("100x1"), 100), std::optional(QSize(100, 1)));
        for (const char* text :
             {"", "12", "12x", "x9", "12xx9", "12x9x1", "0x9", "12x-9", "101x9", "12 x 9e", "12.5x9"})
            QVERIFY2(!typedSize(QString::fromUtf8(text), 100), text);
    }

    void numbersAreRead()
    {
        const std::vector<double> expected{1, -2.5, 0.001};
        for (const char* text :
             {"1,-2.5,1e-3", "1 -2.5 1e-3", "(1; \u22122.5; 0.001)", "\uff081\uff0c\uff0d2\uff0e5\uff0c1e-3\uff09"})
            QVERIFY2(typedNumbers(QString::fromUtf8(text)) == expected, text);
        for (const char* text : {"", "1,nan", "inf", "1e999", "1,,2", "1, 2)", "one"})
            QVERIFY2(!typedNumbers(QString::fromUtf8(text)), text);
    }
};

QTEST_APPLESS_MAIN(TestTypedNumbers)
#include "test_typed_numbers.moc"
