// The referee in the core: pictures held against the truth, and the bits that edge values need.
#include "core/settings/number_budget.h"
#include "core/truth/judgement.h"
#include "tests/support.h"

#include <QTest>

using namespace rasterlens;
using namespace rasterlens::test;

class TestJudgement : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsWhatIsWrong_data();
    void findsWhatIsWrong();
    void saysWhatItDoesNotJudge();
    void letsSnappingPassWhereTheTruthDoesNotSnap();
    void stops();
    void bitsHoldTheLargestEdgeValue();
    void bitsOfFloats();
    void largePicturesAreJudgedInBands();
};

namespace
{

Scene square() { return *makeBuiltinScene(QStringLiteral("square-diagonal")).scene; }

} // namespace

void TestJudgement::findsWhatIsWrong_data()
{
    QTest::addColumn<TieRule>("rule");
    QTest::addColumn<int>("wrong");
    QTest::addColumn<PixelVerdict>("verdict");
    QTest::newRow("top-left") << TieRule::TopLeft << 0 << PixelVerdict::Right;
    QTest::newRow("inclusive") << TieRule::Inclusive << 8 << PixelVerdict::HitTwice;
    QTest::newRow("exclusive") << TieRule::Exclusive << 8 << PixelVerdict::Missing;
}

void TestJudgement::findsWhatIsWrong()
{
    QFETCH(TieRule, rule);
    QFETCH(int, wrong);
    QFETCH(PixelVerdict, verdict);
    const Scene scene = square();
    Settings settings = scene.defaults;
    settings.tieRule = rule;
    const Judgement judgement = judge(scene, settings);
    QCOMPARE(judgement.difference.pixels, std::uint64_t{64});
    QCOMPARE(judgement.difference.wrong(), static_cast<std::uint64_t>(wrong));
    QCOMPARE(judgement.wrong.size(), static_cast<std::size_t>(wrong));
    for (int i = 0; i < wrong; ++i) { // the diagonal rises from the lower left
        const WrongPixel& pixel = judgement.wrong[static_cast<std::size_t>(i)];
        QVERIFY(pixel == (WrongPixel{7 - i, i, verdict, pixel.face}));
        QCOMPARE(pixel.face, judgement.wrong.front().face); // whose left or top edge it is
        QVERIFY(pixel.face == 0 || pixel.face == 1);
    }
}

void TestJudgement::saysWhatItDoesNotJudge()
{
    const Scene scene = square();
    Settings settings = scene.defaults;
    QCOMPARE(notJudged(scene, settings), NotJudged::No);
    settings.fill = Fill::Wireframe;
    QCOMPARE(notJudged(scene, settings), NotJudged::NotFilled);
    settings = scene.defaults;
    settings.algorithm = Algorithm::Tiled;
    settings.numberType = NumberType::Float32;
    QCOMPARE(notJudged(scene, settings), NotJudged::Unsupported);
}

void TestJudgement::letsSnappingPassWhereTheTruthDoesNotSnap()
{
    // The right edge passes a hair beyond the centres of column 2 and snaps onto them.
    const double x = 2.5 + 1.0 / 4096;
    Scene scene = soup({atPixel(0, 0, 0.5, {4, 4}), atPixel(0, 4, 0.5, {4, 4}), atPixel(x, 4, 0.5, {4, 4}),
                        atPixel(0, 0, 0.5, {4, 4}), atPixel(x, 4, 0.5, {4, 4}), atPixel(x, 0, 0.5, {4, 4})});
    const Settings settings = plainSettings({4, 4});
    QCOMPARE(judge(scene, settings).difference.tolerated, std::uint64_t{0});
    scene.exact = true;
    const Judgement judgement = judge(scene, settings);
    QVERIFY(judgement.bandPixels > 0);
    QCOMPARE(judgement.difference.tolerated, std::uint64_t{4});
    QCOMPARE(judgement.difference.wrong(), std::uint64_t{0});
}

void TestJudgement::stops()
{
    std::stop_source source;
    source.request_stop();
    QVERIFY(judge(square(), square().defaults, source.get_token()).wrong.empty());
}

/// No edge value of vertices and pixel centres of the viewport needs more bits, and one needs all of them.
void TestJudgement::bitsHoldTheLargestEdgeValue()
{
    Random random = seededRandom();
    for (int round = 0; round < 200; ++round) {
        Settings settings;
        settings.size = {integer(random, 1, 20), integer(random, 1, 20)};
        settings.subpixelBits = integer(random, 0, 8);
        settings.samples = static_cast<Samples>(integer(random, 0, 3));
        const NumberBudget budget = numberBudget(settings);
        QCOMPARE(budget.unitLog2, -settings.subpixelBits);
        QCOMPARE(budget.available, 63);

        // Vertices in units of 2^-bits samples; the third point in units of which a half is a multiple.
        const int grid = sampleGrid(settings.samples);
        const std::int64_t unit = std::int64_t{1} << settings.subpixelBits;
        const std::int64_t fine = std::max<std::int64_t>(unit, 2);
        const std::int64_t width = settings.size.width() * grid;
        const std::int64_t height = settings.size.height() * grid;
        const auto edgeValue = [&](std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by, std::int64_t px,
                                   std::int64_t py) {
            return (by - ay) * (px - ax * (fine / unit)) + (ax - bx) * (py - ay * (fine / unit));
        };
        std::int64_t largest = edgeValue(0, 0, 0, height * unit, width * fine, 0);
        for (int i = 0; i < 50; ++i) {
            const auto x = [&] { return std::int64_t{integer(random, 0, static_cast<int>(width * unit))}; };
            const auto y = [&] { return std::int64_t{integer(random, 0, static_cast<int>(height * unit))}; };
            largest =
                std::max(largest, std::abs(edgeValue(x(), y(), x(), y(), x() * (fine / unit), y() * (fine / unit))));
        }
        QCOMPARE(static_cast<int>(std::bit_width(static_cast<std::uint64_t>(largest))), budget.needed);
    }
}

void TestJudgement::bitsOfFloats()
{
    Settings settings;
    settings.size = {1920, 1080};
    QCOMPARE(numberBudget(settings).needed, 21 + 16);
    QCOMPARE(numberBudget(settings).left(), 63 - 37);
    settings.numberType = NumberType::Float32;
    QCOMPARE(numberBudget(settings).unitLog2, -13); // floats from 1024 to 2048 are 2^-13 apart
    QCOMPARE(std::nextafter(1919.0F, 2048.0F) - 1919.0F, 0x1p-13F);
    QCOMPARE(numberBudget(settings).left(), 24 - (21 + 26));
    settings.numberType = NumberType::Float64;
    QCOMPARE(numberBudget(settings).unitLog2, -42);
    QVERIFY(numberBudget(settings).left() < 0);
}

/// More samples than one band holds: every wrong pixel of every band is found once, and the share done grows.
void TestJudgement::largePicturesAreJudgedInBands()
{
    const Scene scene = square();
    Settings settings = scene.defaults;
    settings.size = {1024, 1024};
    settings.samples = Samples::Grid3;
    settings.tieRule = TieRule::Exclusive;
    QVERIFY(bandsOf(exactOptions(scene, settings)).size() > 1);
    std::vector<double> shares;
    const Judgement judgement = judge(scene, settings, {}, [&](double share) { shares.push_back(share); });
    // The diagonal runs through the middle sample of each pixel.
    QCOMPARE(judgement.difference.missing, std::uint64_t{1024});
    QCOMPARE(judgement.difference.pixels, std::uint64_t{1024} * 1024);
    QCOMPARE(judgement.wrong.size(), std::size_t{1024});
    for (std::size_t i = 0; i < judgement.wrong.size(); ++i) {
        QCOMPARE(judgement.wrong[i].y, static_cast<int>(i));
        QCOMPARE(judgement.wrong[i].x, 1023 - static_cast<int>(i));
    }
    QVERIFY(std::ranges::is_sorted(shares));
    QVERIFY(shares.front() == 0 && shares.back() >= 0.5 && shares.back() <= 1);
}

QTEST_APPLESS_MAIN(TestJudgement)
#include "test_judgement.moc"
