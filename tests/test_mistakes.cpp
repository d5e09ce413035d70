#include "core/truth/mistake_proof.h"
// The mistake table: every mistake changes the picture and its counter in its scene, and is gone when it is taken out.
#include "core/rasterizers/lines.h"
#include "core/render/count.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"

#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <cmath>
#include <map>

using namespace rasterlens;

namespace
{

const Mistake& mistakeOf(const char* id)
{
    const Mistake* mistake = findMistake(QLatin1String(id));
    Q_ASSERT(mistake);
    return *mistake;
}

/// The value of a proof in the scene of a mistake that is made there.
double mistakenValue(const char* id, Proof proof)
{
    const MistakeDemo demo = mistakeDemo(mistakeOf(id));
    return proofValue(proof, drawCounted(demo.scene, demo.mistaken), drawCounted(demo.scene, demo.right));
}

QImage mistakenImage(const char* id)
{
    const MistakeDemo demo = mistakeDemo(mistakeOf(id));
    return drawCounted(demo.scene, demo.mistaken).frame.image;
}

/// z/w of the board in the middle of the screen, with four decimals.
double middleOfBoard(const Settings& settings, const Scene& scene)
{
    const CountedPicture picture = drawCounted(scene, settings);
    const std::size_t at = 240 * 641 + 320;
    return std::round(1e4 * (2 * static_cast<double>(picture.frame.depth[at]) - 1)) / 1e4;
}

void addRowForEachMistake()
{
    QTest::addColumn<QString>("id");
    for (const Mistake& mistake : mistakes())
        QTest::newRow(mistake.id) << QString::fromLatin1(mistake.id);
}

} // namespace

class TestMistakes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tableIsComplete();
    void changesPictureAndProof_data() { addRowForEachMistake(); }
    void changesPictureAndProof();
    void documentHasEveryMistake_data() { addRowForEachMistake(); }
    void documentHasEveryMistake();
    void unknownIdIsRefused();
    void isDefinedEverywhere_data() { addRowForEachMistake(); }
    void isDefinedEverywhere();
    void everyWayOfClippingEnds_data() { addRowForEachMistake(); }
    void everyWayOfClippingEnds();
    void squareIsHitTwiceOrNotAtAll();
    void windingsAreTreatedAlike();
    void depthOfTheBoard();
    void lostWIsAffine();
    void steepLineRunsPastItsEnd();
    void heightPlusOneStandsOutAtTheMiddleCorner();
    void nudgedCutLosesTheSharedEdge();
    void whatIsOffByOneIsCounted();
    void texelsLeftOfZeroAreMoved();
};

void TestMistakes::tableIsComplete()
{
    QSet<QString> ids;
    QSet<QString> numbers;
    for (const Mistake& mistake : mistakes()) {
        const QString id = QString::fromLatin1(mistake.id);
        QVERIFY2(!ids.contains(id), mistake.id);
        ids << id;
        numbers << QString::fromLatin1(mistake.number);
        QCOMPARE(findMistake(id), &mistake);
        QVERIFY2(QRegularExpression(QStringLiteral("^[a-z0-9]+(-[a-z0-9]+)*$")).match(id).hasMatch(), mistake.id);
        for (const char* text : {mistake.title, mistake.symptom, mistake.wrongLine, mistake.seed})
            QVERIFY2(*text != '\0', mistake.id);
        QVERIFY2(makeBuiltinScene(QLatin1String(mistake.scene)).scene, mistake.scene);
    }
    for (int number = 1; number <= 40; ++number)
        QCOMPARE(numbers.contains(QStringLiteral("M%1").arg(number)), number != 7);
    const QStringList metByOthers{"C7", "C8", "C9", "C15", "C16", "C18", "D8", "K3", "K4", "K5", "K7", "T1", "T2",
                                  "T3", "T5", "T6", "T7",  "T8",  "T9",  "V1", "V2", "V3", "V4", "V5", "V7", "V8"};
    for (const QString& number : metByOthers)
        QVERIFY2(numbers.contains(number), qPrintable(number));
    QCOMPARE(findMistake(QStringLiteral("nonsense")), nullptr);
}

void TestMistakes::changesPictureAndProof()
{
    QFETCH(QString, id);
    const Mistake& mistake = *findMistake(id);
    const MistakeDemo demo = mistakeDemo(mistake);
    QCOMPARE(unsupported(demo.scene, demo.right), std::nullopt);
    QCOMPARE(unsupported(demo.scene, demo.mistaken), std::nullopt);

    const CountedPicture right = drawCounted(demo.scene, demo.right);
    const CountedPicture mistaken = drawCounted(demo.scene, demo.mistaken);
    const double before = proofValue(mistake.proof, right, right);
    const double after = proofValue(mistake.proof, mistaken, right);
    qInfo("%s: %s %g -> %g", mistake.id, proofId(mistake.proof), before, after);
    QVERIFY(right.frame.image != mistaken.frame.image);
    if (mistake.change == Change::Rises)
        QVERIFY2(after > before, proofId(mistake.proof));
    else
        QVERIFY2(after < before, proofId(mistake.proof));

    // The proof asks no more of the right picture than it says.
    const CountedPicture least = drawCounted(demo.scene, demo.right, proofOutputs(mistake.proof));
    QCOMPARE(proofValue(mistake.proof, mistaken, least), after);
    QCOMPARE(proofValue(mistake.proof, least, least), before);

    // Without counters the same picture, and taken out again the right one, into the same memory.
    Frame frame;
    render(demo.scene, demo.mistaken, frame);
    QCOMPARE(frame.image, mistaken.frame.image);
    Frame counted; // afterwards
    QVERIFY(countPicture(demo.scene, demo.mistaken, frame, counted) == mistaken.statistics);
    QVERIFY(counted.ids == mistaken.frame.ids && counted.depth == mistaken.frame.depth);
    QCOMPARE(counted.image, mistaken.frame.image);
    render(demo.scene, demo.right, frame);
    QCOMPARE(frame.image, right.frame.image);
}

void TestMistakes::documentHasEveryMistake()
{
    QFETCH(QString, id);
    const Mistake& mistake = *findMistake(id);
    QFile file(QFINDTESTDATA("../docs/MISTAKES.md"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString document = QString::fromUtf8(file.readAll());
    for (const char* text : {mistake.title, mistake.symptom, mistake.seed})
        QVERIFY2(document.contains(QString::fromUtf8(text)), text);
    const QString command = QStringLiteral("`render builtin:%1 --mistake %2`").arg(QLatin1String(mistake.scene), id);
    QVERIFY2(document.contains(command), qPrintable(command));
}

void TestMistakes::unknownIdIsRefused()
{
    const MistakeDemo demo = mistakeDemo(mistakes().front());
    Settings settings = demo.right;
    settings.mistakes << QStringLiteral("nonsense");
    const std::optional<Reason> reason = unsupported(demo.scene, settings);
    QVERIFY(reason);
    QVERIFY2(textOf(*reason).contains(QLatin1String("nonsense")), qPrintable(textOf(*reason)));
    QVERIFY2(textOf(*reason).contains(QLatin1String("--list-mistakes")), qPrintable(textOf(*reason)));
}

/// Alone and together with what multiplies trouble, where corners lie behind the eye, far out or on one line: for the
/// sanitizers to look at.
void TestMistakes::isDefinedEverywhere()
{
    QFETCH(QString, id);
    static const std::vector<SceneLoad> loads = [] {
        std::vector<SceneLoad> made;
        for (const char* name : {"floor", "tunnel", "behind-camera", "huge-triangle", "zero-area", "overhang", "lines"})
            made.push_back(makeBuiltinScene(QLatin1String(name)));
        return made;
    }();
    for (const SceneLoad& load : loads) {
        for (const char* companion : {"affine", "no-near-clip", "box-not-clamped", "zero-area-kept", "w-lost"})
            for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking}) {
                Settings settings = load.scene->defaults;
                settings.size = QSize(12, 20);
                settings.algorithm = algorithm;
                settings.samples = Samples::Grid2;
                settings.mistakes = {id, QLatin1String(companion)};
                settings.mistakes.removeDuplicates();
                QCOMPARE(unsupported(*load.scene, settings), std::nullopt);
                Frame first;
                const Statistics counted = renderCounted(*load.scene, settings, first);
                Frame second;
                render(*load.scene, settings, second);
                QCOMPARE(first.image, second.image);
                const Statistics::Faces& f = counted.faces;
                QCOMPARE(f.submitted,
                         f.rejected + f.culledBack + f.culledFront + f.degenerate + f.nonFinite + f.rasterized);
                QCOMPARE(counted.pixels.covered, counted.pixels.depthPassed + counted.pixels.depthFailed);
            }
    }
}

/// Faces behind the eye that a mistake leaves there once had Cohen-Sutherland go round the viewport for ever.
void TestMistakes::everyWayOfClippingEnds()
{
    QFETCH(QString, id);
    for (const char* name : {"behind-camera", "tunnel", "covering"}) {
        static std::map<QByteArray, Scene> scenes;
        const auto [place, isNew] = scenes.try_emplace(name);
        if (isNew)
            place->second = *makeBuiltinScene(QLatin1String(name)).scene;
        Settings settings = place->second.defaults;
        settings.size = {32, 24};
        settings.mistakes = {id};
        const SettingsField& clipping = *findSettingsField(QStringLiteral("clipping"));
        for (int mode = clipping.minimum; mode <= clipping.maximum; ++mode) {
            clipping.set(settings, mode);
            if (unsupported(place->second, settings))
                continue;
            Frame frame;
            const Statistics statistics = renderCounted(place->second, settings, frame);
            QCOMPARE(frame.image.size(), settings.size);
            QCOMPARE(statistics.pixels.covered, statistics.pixels.depthPassed + statistics.pixels.depthFailed);
        }
    }
}

void TestMistakes::squareIsHitTwiceOrNotAtAll()
{
    QCOMPARE(mistakenValue("all-inclusive", Proof::CoveredTwice), 8.0);
    QCOMPARE(mistakenValue("all-inclusive", Proof::Covered), 72.0);
    QCOMPARE(mistakenValue("all-exclusive", Proof::Holes), 8.0);
    QCOMPARE(mistakenValue("all-exclusive", Proof::Covered), 56.0);
}

void TestMistakes::windingsAreTreatedAlike()
{
    // The diagonal of the clockwise square only.
    QCOMPARE(mistakenValue("either-sign", Proof::CoveredTwice), 8.0);
    QCOMPARE(mistakenValue("one-winding", Proof::Holes), 64.0);
}

void TestMistakes::depthOfTheBoard()
{
    const MistakeDemo demo = mistakeDemo(mistakeOf("z-corrected"));
    QCOMPARE(middleOfBoard(demo.right, demo.scene), 0.8938);
    QCOMPARE(middleOfBoard(demo.mistaken, demo.scene), 0.8200);
    Settings walking = demo.mistaken;
    walking.algorithm = Algorithm::EdgeWalking;
    QCOMPARE(middleOfBoard(walking, demo.scene), 0.8200);
    walking.attributePath = AttributePath::EdgeThenSpan;
    QCOMPARE(middleOfBoard(walking, demo.scene), 0.8200);
}

void TestMistakes::lostWIsAffine() { QCOMPARE(mistakenImage("w-lost"), mistakenImage("affine")); }

void TestMistakes::steepLineRunsPastItsEnd()
{
    const auto lastRow = [](GridPoint from, GridPoint to) {
        int last = from.y;
        columnLine(from, to, [&](int, int y, double) { last = std::max(last, y); });
        return last;
    };
    QCOMPARE(lastRow({0, 0}, {1, 10}), 20);
    QCOMPARE(lastRow({0, 0}, {0, 10}), 0);
    QCOMPARE(octantOf({0, 0}, {1, -2}), 1);
    QCOMPARE(octantOf({0, 0}, {-2, 1}), 4);
}

void TestMistakes::heightPlusOneStandsOutAtTheMiddleCorner()
{
    // The first arrow head: its upper edge, from (2, 3) to (30, 5), crosses the rows 3 and 4 at 2 + 14 (0.5, 1.5) = 9,
    // 23, and the lower one mirrors it. With a height of 3 they are at 2 + 28 / 3 (0.5, 1.5) = 6.67, 16 and then, from
    // (30, 5) on, at 30 - 28 / 3 (0.5, 1.5) = 25.33, 16.
    const MistakeDemo demo = mistakeDemo(mistakeOf("height-plus-one"));
    const CountedPicture right = drawCounted(demo.scene, demo.right);
    const CountedPicture mistaken = drawCounted(demo.scene, demo.mistaken);
    const auto endOf = [](const CountedPicture& picture, int row) {
        int end = 0;
        for (int x = 0; x < 32; ++x)
            end = picture.frame.ids[static_cast<std::size_t>(32 * row + x)] >= 0 ? x + 1 : end;
        return end;
    };
    const std::array<int, 4> rightEnds{9, 23, 23, 9};
    const std::array<int, 4> mistakenEnds{7, 16, 25, 16};
    for (std::size_t i = 0; i < rightEnds.size(); ++i) {
        QCOMPARE(endOf(right, 3 + static_cast<int>(i)), rightEnds[i]);
        QCOMPARE(endOf(mistaken, 3 + static_cast<int>(i)), mistakenEnds[i]);
    }
    // All three, counted row by row: 9 + 9 + 12 pixels lost above the middle corners, 9 + 13 + 12 too many below them.
    QCOMPARE(proofValue(Proof::Holes, mistaken, right), 30.0);
    QCOMPARE(proofValue(Proof::Strays, mistaken, right), 34.0);
    QCOMPARE(proofValue(Proof::WrongFaces, mistaken, right), 64.0);
}

void TestMistakes::nudgedCutLosesTheSharedEdge()
{
    // The edge y = x + 8 of the orange triangle owns the centres (i + 0.5, i + 8.5), i = 0 .. 39. Cut at (0.001, 8), it
    // passes them 0.001 (1 - (i + 0.5) / 40) pixels too far right; the blue triangle, not cut, does not own them.
    const MistakeDemo demo = mistakeDemo(mistakeOf("nudged-cut"));
    const CountedPicture right = drawCounted(demo.scene, demo.right);
    const CountedPicture mistaken = drawCounted(demo.scene, demo.mistaken);
    QCOMPARE(right.statistics.pixels.coveredTwice, 0U);
    for (int i = 0; i < 40; ++i) {
        const auto at = static_cast<std::size_t>(64 * (i + 8) + i);
        QCOMPARE(right.frame.ids[at], 0);
        QCOMPARE(mistaken.frame.ids[at], -1);
    }
    QCOMPARE(proofValue(Proof::Holes, mistaken, right), 40.0);
    QCOMPARE(proofValue(Proof::WrongFaces, mistaken, right), 40.0);
    // Without the 0.001 the same clipping in the same numbers loses nothing.
    Settings even = demo.right;
    even.clipping = Clipping::CohenSutherland;
    even.numberType = NumberType::Float64;
    QVERIFY(drawCounted(demo.scene, even).frame.ids == right.frame.ids);
}

void TestMistakes::whatIsOffByOneIsCounted()
{
    // The last column and the last row of 8 x 8.
    QCOMPARE(mistakenValue("viewport-one-short", Proof::Holes), 15.0);
    // The points at -0.5 hit the first column and the first row of 12 x 10 pixels once more, and the corner three
    // times.
    QCOMPARE(mistakenValue("truncate-to-zero", Proof::WrongPixels), 21.0);
    QCOMPARE(mistakenValue("truncate-to-zero", Proof::Covered), 120.0 + 12 + 10 + 1);
    // A blade is seen whole, or not at all where its middle corner lies left of the long edge.
    const MistakeDemo demo = mistakeDemo(mistakeOf("ends-not-sorted"));
    const CountedPicture right = drawCounted(demo.scene, demo.right);
    const CountedPicture wrong = drawCounted(demo.scene, demo.mistaken);
    for (std::int32_t face = 0; face < 16; ++face) {
        const auto seen = std::ranges::count(wrong.frame.ids, face);
        QVERIFY(seen == 0 || seen == std::ranges::count(right.frame.ids, face));
    }
}

void TestMistakes::texelsLeftOfZeroAreMoved()
{
    // Left of the middle, where u is below 0, every texel is the one that belongs 8 pixels further right.
    const MistakeDemo demo = mistakeDemo(mistakeOf("negative-uv"));
    const QImage right = drawCounted(demo.scene, demo.right).frame.image;
    const QImage wrong = drawCounted(demo.scene, demo.mistaken).frame.image;
    for (int x = 0; x < 96; ++x) // in the upper half, where v is not below 0
        QCOMPARE(wrong.pixel(x, 20), right.pixel(x < 48 ? x + 8 : x, 20));
}

QTEST_GUILESS_MAIN(TestMistakes)
#include "test_mistakes.moc"
