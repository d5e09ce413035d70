// Every sentence of the step log, of `why` and of the window agrees with its own numbers and with the counters: for
// every mistake, every depth setting and every built-in scene.
#include "core/pipeline/shading.h"
#include "core/questions/vertex_table.h"
#include "core/questions/why.h"
#include "core/render/count.h"
#include "core/render/render.h"
#include "core/render/steps.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "tests/seed.h"
#include "tests/sentence_reader.h"
#include "ui/canvas/pixel_numbers.h"
#include "ui/face/pixel_card.h"

#include <QTest>

#include <random>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr std::size_t kMostFaces = 4000; ///< scenes of more are left to tests that draw them once
constexpr int kPixelsToAsk = 40;         ///< wrong pixels of a picture, at most
constexpr std::size_t kReadWhole = 1200; ///< events: of longer records a sample is read

/// The built-in scenes of few faces; under the sanitizers a fifth of them.
const std::vector<Scene>& scenes()
{
    static const std::vector<Scene> all = [] {
        std::vector<Scene> made;
        for (const BuiltinScene& scene : builtinScenes())
            if (Scene one = *makeBuiltinScene(QLatin1String(scene.name)).scene; one.mesh.faceCount() <= kMostFaces)
                made.push_back(std::move(one));
        for (std::size_t i = 1; RASTERLENS_SANITIZED && i < made.size(); ++i)
            made.erase(made.begin() + std::ptrdiff_t(i), made.begin() + std::ptrdiff_t(std::min(i + 4, made.size())));
        return made;
    }();
    return all;
}

/// Reads the sentences of a record.
QString readLog(const StepLog& log, std::mt19937& random)
{
    const bool whole = log.size() <= kReadWhole && !log.truncated();
    const std::size_t step = whole ? 1 : log.size() / (kReadWhole / 4) + 1;
    Told told;
    Reader reader;
    for (std::size_t i = whole ? 0 : random() % step; i < log.size(); i += step) {
        const QString text = stepText(log, i);
        told.add(log.event(i), text);
        readEvent(log, i, text, reader);
        if (!reader.complaint().isEmpty())
            return QString::number(i) + QLatin1Char(' ') + reader.complaint();
    }
    if (whole && !told.agrees(log.countersAt(log.size())))
        return QStringLiteral("the counters say otherwise");
    return {};
}

/// Reads what `why` and the pixel card say of a pixel.
QString readWhy(const WhyReport& report)
{
    Reader reader;
    static const QRegularExpression outside(
        QStringLiteral("outside edge (\\w\\w) \\((\\S+?)(?: < t_(\\w\\w) = (\\S+))?\\)(?:;|$)"));
    static const QRegularExpression seen(QStringLiteral("; seen(;|$)"));
    for (const WhyFace& face : report.faces) {
        const QString text = whyText(report, face);
        reader.readComparisons(text);
        if (const auto match = outside.match(text); match.hasMatch()) {
            const double value = number(match.captured(2));
            const bool named = match.captured(3) == match.captured(1);
            reader.expect(match.captured(3).isEmpty() ? !(value >= 0) : named && value < number(match.captured(4)),
                          text, "edge");
        }
        if (face.verdict == WhyVerdict::LostTie)
            reader.expect(text.contains(QStringLiteral("(0)")) || text.contains(QStringLiteral("(-0)")), text, "tie");
        if (face.verdict == WhyVerdict::Written)
            reader.expect(text.contains(seen) == (report.visibleFace == face.face), text, "seen");
        if (face.verdict == WhyVerdict::Degenerate)
            reader.expect(text.contains(QStringLiteral("no area")) == (face.facing->screenArea == 0), text, "no area");
        const WhyWords words = whyWords(report, face);
        const QString all = plain(words.verdict + QLatin1Char('\n') + words.details.join(QLatin1Char('\n')));
        reader.readComparisons(all);
        for (const Mistake* mistake : face.because)
            reader.expect(all.contains(QStringLiteral("because of ")) && all.contains(QLatin1String(mistake->title)),
                          all, "cause in the card");
        reader.expect(!face.because.empty() || !all.contains(QStringLiteral("because of")), all, "no cause");
    }
    return reader.complaint();
}

QString readVertices(const Scene& scene, const Settings& settings, const Rules& rules, std::uint32_t face)
{
    const double unit = rules.numberType == NumberType::Fixed ? 1.0 / (1 << rules.subpixelBits) : 0;
    for (const VertexRow& row : vertexTable(scene, settings, face))
        for (const int axis : {0, 1})
            if (std::abs(row.screen[axis]) < 1e5 &&
                !isNear(row.screen[axis], row.snapped[axis],
                        rules.verticesTruncated ? 1 + unit
                        : rules.rowsRounded     ? 0.5 + unit
                                                : unit / 2 + 1e-9 * (1 + std::abs(row.screen[axis]))))
                return QStringLiteral("a corner at %1 is snapped to %2").arg(row.screen[axis]).arg(row.snapped[axis]);
    return {};
}

/// Everything that is said of a scene with some settings. Empty: all of it is true.
QString readAll(const Scene& scene, const Settings& settings, std::mt19937& random)
{
    if (unsupported(scene, settings))
        return {};
    StepFilter filter;
    filter.cap = 60'000;
    const auto log = renderSteps(scene, settings, filter);
    if (const QString complaint = readLog(*log, random); !complaint.isEmpty())
        return complaint;
    const int x = int(random() % unsigned(settings.size.width()));
    const int y = int(random() % unsigned(settings.size.height()));
    if (const QString complaint = readWhy(why(scene, settings, x, y)); !complaint.isEmpty())
        return QStringLiteral("pixel (%1, %2) ").arg(x).arg(y) + complaint;
    const auto face = std::uint32_t(random() % scene.mesh.faceCount());
    return readVertices(scene, settings, log->rules(), face);
}

} // namespace

class TestSentences : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reversedDepthIsComparedTheOtherWay();
    void whyComparesAsTheMistakeDoes();
    void snappingMovesNoCornerFar();
    void walkingByMistakeIsListedAsWalking();
    void untestedDepthIsSaidToBe();
    void overlayNumbersMeanWhatIsShown();
    void everyMistake_data();
    void everyMistake();
    void everyMistakeIsNamed_data() { everyMistake_data(); }
    void everyMistakeIsNamed();
    void leftOutSamplesAreExplained_data();
    void leftOutSamplesAreExplained();
    void everyDepthSetting_data();
    void everyDepthSetting();
    void everyAlgorithm_data();
    void everyAlgorithm();
};

void TestSentences::reversedDepthIsComparedTheOtherWay()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("games101")).scene;
    Settings settings = scene.defaults;
    settings.size = {40, 40};
    settings.reversedZ = true;
    const auto log = renderSteps(scene, settings);
    int failed = 0;
    for (const std::uint32_t i : log->eventsOf(StepKind::Fragment)) {
        const bool passed = log->event(i).has(StepEvent::kPassed);
        failed += passed ? 0 : 1;
        const auto& step = log->payload<FragmentStep>(log->event(i));
        const QString verdict = QStringLiteral("depth %1 > %2: %3")
                                    .arg(depthNumber(step.depth), depthNumber(step.storedDepth),
                                         passed ? QStringLiteral("passed") : QStringLiteral("failed"));
        QVERIFY2(stepText(*log, i).contains(verdict), qPrintable(stepText(*log, i)));
        QVERIFY2(explainStep(*log, i).formula.startsWith(verdict), qPrintable(explainStep(*log, i).formula));
        QCOMPARE(step.depth > step.storedDepth, passed);
    }
    QVERIFY(failed > 0);
}

void TestSentences::whyComparesAsTheMistakeDoes()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("piercing")).scene;
    Settings settings = scene.defaults;
    settings.size = {200, 200};
    settings.mistakes = {QStringLiteral("depth-reversed")};
    const WhyReport report = why(scene, settings, 90, 100);
    int failed = 0;
    for (const WhyFace& face : report.faces) {
        if (face.verdict != WhyVerdict::FailedDepth)
            continue;
        ++failed;
        QVERIFY2(whyText(report, face).contains(QStringLiteral(" > ")), qPrintable(whyText(report, face)));
        QVERIFY(!(face.fragment->depth > face.fragment->storedDepth));
        QCOMPARE(face.because.size(), std::size_t(1));
        QVERIFY(whyWords(report, face).details.last() ==
                QStringLiteral("because of M30 The depth comparison is reversed"));
    }
    QVERIFY(failed > 0);
}

void TestSentences::snappingMovesNoCornerFar()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("letter-f")).scene;
    Settings settings = scene.defaults;
    settings.mistakes = {QStringLiteral("y-flipped-once")};
    StepFilter filter;
    filter.kinds = kindBit(StepKind::Viewport);
    const auto log = renderSteps(scene, settings, filter);
    QVERIFY(log->eventsOf(StepKind::Viewport).size() > 10);
    for (const std::uint32_t i : log->eventsOf(StepKind::Viewport)) {
        const auto& step = log->payload<ViewportStep>(log->event(i));
        QVERIFY(glm::distance(step.unsnapped, step.screen.position) < 0.01);
        QCOMPARE(becauseOf(*log, i).size(), std::size_t(1));
    }
}

void TestSentences::walkingByMistakeIsListedAsWalking()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("tiny-tiles")).scene;
    Settings settings = scene.defaults;
    settings.mistakes = {QStringLiteral("height-plus-one")};
    StepFilter filter;
    filter.cap = 5000;
    const auto log = renderSteps(scene, settings, filter);
    const auto spans = log->eventsOf(StepKind::Span);
    QVERIFY(!spans.empty());
    const StepExplanation crossing = explainStep(*log, log->eventsOf(StepKind::Crossing).front());
    QCOMPARE(crossing.line, 3);
    QVERIFY(crossing.listing[3].right.contains(QStringLiteral("alpha = (y-y1)")));
    QVERIFY(crossing.listing[3].code.contains(QStringLiteral("(b.y - a.y + 1)")));
    const StepExplanation span = explainStep(*log, spans.front());
    QVERIFY(span.listing[0].right.contains(QStringLiteral("crossings(y)")));
    QVERIFY(span.listing[0].code.contains(QStringLiteral("(b.y - a.y + 1)")));
    const LensModel model(*log, log->event(log->eventsOf(StepKind::Triangle).front()), log->size());
    const PixelRect& bounds = model.triangle().setup.bounds;
    QVERIFY(!model.cell(bounds.x, bounds.y).hasValues);
}

void TestSentences::untestedDepthIsSaidToBe()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("games101")).scene;
    Settings settings = scene.defaults;
    settings.size = {20, 20};
    settings.mistakes = {QStringLiteral("no-z-buffer")};
    const auto log = renderSteps(scene, settings);
    for (const std::uint32_t i : log->eventsOf(StepKind::Fragment)) {
        QVERIFY(stepText(*log, i).contains(QStringLiteral("compared with nothing: passed")));
        QVERIFY(explainStep(*log, i).formula.contains(QStringLiteral("because of M28 No z-buffer")));
    }
}

void TestSentences::overlayNumbersMeanWhatIsShown()
{
    const auto scene = std::make_shared<const Scene>(*makeBuiltinScene(QStringLiteral("games101")).scene);
    for (const Shading shading : {Shading::Gouraud, Shading::Depth, Shading::TriangleId, Shading::Overdraw})
        for (const Samples samples : {Samples::One, Samples::Grid2}) {
            RenderedFrame frame;
            frame.scene = scene;
            frame.settings = scene->defaults;
            frame.settings.size = {24, 24};
            frame.settings.shading = shading;
            frame.settings.samples = samples;
            render(*scene, frame.settings, frame.frame);
            const auto shown = [&](int x, int y) { return pixelNumbers(frame, {x, y}, NumberRoom::Details).first(); };
            if (shading == Shading::Depth || shading == Shading::TriangleId)
                QCOMPARE(shown(12, 12), QString()); // not known before it is counted
            Frame counted;
            (void)countPicture(*scene, frame.settings, frame.frame, counted);
            frame.frame = counted;
            frame.counted = true;
            for (int y = 0; y < 24; ++y)
                for (int x = 0; x < 24; ++x) {
                    const auto at = std::size_t(y * 24 + x);
                    const std::int32_t face = frame.frame.ids[at];
                    const QColor color(frame.frame.image.pixel(x, y));
                    QString expected = QStringLiteral("%1 %2 %3").arg(color.red()).arg(color.green()).arg(color.blue());
                    if (shading == Shading::Depth)
                        expected = QString::number(double(frame.frame.depth[at]), 'f', 4);
                    if (shading == Shading::TriangleId)
                        expected = face < 0 ? QString() : QStringLiteral("#%1").arg(face);
                    if (shading == Shading::Overdraw)
                        expected = QStringLiteral("\u00d7%1").arg(frame.frame.coverage[at]);
                    QCOMPARE(shown(x, y), expected);
                }
        }
    for (int count = 0; count < kMostOverdraw; ++count) { // before it is counted, the colour of one sample tells it
        RenderedFrame frame;
        frame.settings.shading = Shading::Overdraw;
        frame.frame.image = QImage(1, 1, QImage::Format_RGB32);
        frame.frame.image.fill(overdrawColor(std::uint32_t(count)));
        QCOMPARE(pixelNumbers(frame, {0, 0}, NumberRoom::Hex), QStringList{QStringLiteral("\u00d7%1").arg(count)});
    }
}

void TestSentences::everyMistake_data()
{
    QTest::addColumn<QString>("id");
    for (const Mistake& mistake : mistakes())
        QTest::newRow(mistake.id) << QString::fromLatin1(mistake.id);
}

void TestSentences::everyMistake()
{
    QFETCH(QString, id);
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    for (const Scene& scene : scenes()) {
        Settings settings = scene.defaults;
        settings.size = {16, 12};
        settings.mistakes = {id};
        const QString complaint = readAll(scene, settings, random);
        QVERIFY2(complaint.isEmpty(),
                 qPrintable(QStringLiteral("%1, seed %2: %3").arg(scene.id).arg(seed).arg(complaint)));
    }
}

/// The record of the scene that shows a mistake has a step that names it.
void TestSentences::everyMistakeIsNamed()
{
    QFETCH(QString, id);
    const Mistake* const mistake = findMistake(id);
    const Scene scene = *makeBuiltinScene(QLatin1String(mistake->scene)).scene;
    Settings settings = scene.defaults;
    settings.mistakes = {id};
    StepFilter filter;
    filter.kinds =
        stepsOf(*mistake) | kindBit(StepKind::Facing) | kindBit(StepKind::Fate) | kindBit(StepKind::Triangle);
    const auto log = renderSteps(scene, settings, filter);
    std::size_t i = 0;
    while (i < log->size() && becauseOf(*log, i).empty())
        ++i;
    QVERIFY(i < log->size());
    QVERIFY(becauseOf(*log, i) == std::vector{mistake});
    QVERIFY2(stepTitle(*log, i).contains(QLatin1String(mistake->title)), qPrintable(stepTitle(*log, i)));
    Reader reader;
    readExplanation(*log, i, explainStep(*log, i), reader);
    QVERIFY2(reader.complaint().isEmpty(), qPrintable(reader.complaint()));
}

void TestSentences::leftOutSamplesAreExplained_data()
{
    QTest::addColumn<QString>("id");
    for (const char* id : {"missing-octant", "missing-last-pixel", "one-depth-per-pixel"})
        QTest::newRow(id) << QString::fromLatin1(id);
}

/// Some pixel that comes out wrong is explained by the mistake.
void TestSentences::leftOutSamplesAreExplained()
{
    QFETCH(QString, id);
    const Mistake* const mistake = findMistake(id);
    const Scene scene = *makeBuiltinScene(QLatin1String(mistake->scene)).scene;
    Settings settings = scene.defaults;
    Frame right;
    render(scene, settings, right);
    settings.mistakes = {id};
    Frame wrong;
    render(scene, settings, wrong);
    int asked = 0;
    for (int y = 0; y < settings.size.height() && asked < kPixelsToAsk; ++y)
        for (int x = 0; x < settings.size.width() && asked < kPixelsToAsk; ++x) {
            if (right.image.pixel(x, y) == wrong.image.pixel(x, y))
                continue;
            ++asked;
            const WhyReport report = why(scene, settings, x, y);
            for (const WhyFace& face : report.faces)
                if (face.because == std::vector{mistake}) {
                    const WhyWords words = whyWords(report, face);
                    QVERIFY(words.details.last().contains(QLatin1String(mistake->title)));
                    QVERIFY(!whyText(report, face).contains(QStringLiteral("clipping")));
                    QVERIFY(!words.verdict.contains(QStringLiteral("clipping")));
                    return;
                }
        }
    QFAIL(qPrintable(QStringLiteral("no face names it at any of %1 wrong pixels").arg(asked)));
}

void TestSentences::everyDepthSetting_data()
{
    QTest::addColumn<QStringList>("values");
    for (const char* format : {"float32", "unorm24", "unorm16"})
        for (const char* test : {"less", "lequal", "greater", "always", "none"})
            for (const char* reversed : {"false", "true"})
                QTest::addRow("%s %s %s", format, test, reversed)
                    << QStringList{QLatin1String(format), QLatin1String(test), QLatin1String(reversed)};
}

void TestSentences::everyDepthSetting()
{
    QFETCH(QStringList, values);
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    for (const Scene& scene : scenes()) {
        Settings settings = scene.defaults;
        settings.size = {16, 12};
        const char* const fields[] = {"depth-format", "depth-test", "reversed-z"};
        for (int i = 0; i < 3; ++i)
            QVERIFY(!setFromText(*findSettingsField(QLatin1String(fields[i])), values[i], settings));
        const QString complaint = readAll(scene, settings, random);
        QVERIFY2(complaint.isEmpty(),
                 qPrintable(QStringLiteral("%1, seed %2: %3").arg(scene.id).arg(seed).arg(complaint)));
    }
}

void TestSentences::everyAlgorithm_data()
{
    QTest::addColumn<QStringList>("values");
    for (const char* algorithm : {"edge-equation", "edge-walking", "tiled", "column-fill"})
        for (const char* numbers : {"fixed", "float32", "float64"})
            for (const char* fill : {"solid", "wireframe", "points"})
                QTest::addRow("%s %s %s", algorithm, numbers, fill)
                    << QStringList{QLatin1String(algorithm), QLatin1String(numbers), QLatin1String(fill)};
}

void TestSentences::everyAlgorithm()
{
    QFETCH(QStringList, values);
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    for (const Scene& scene : scenes()) {
        Settings settings = scene.defaults;
        settings.size = {16, 12};
        const char* const fields[] = {"algorithm", "number-type", "fill"};
        for (int i = 0; i < 3; ++i)
            QVERIFY(!setFromText(*findSettingsField(QLatin1String(fields[i])), values[i], settings));
        settings.samples = Samples(random() % 3);
        settings.stepping = Stepping(random() % 2);
        settings.line = LineAlgorithm(random() % 2);
        const QString complaint = readAll(scene, settings, random);
        QVERIFY2(complaint.isEmpty(),
                 qPrintable(QStringLiteral("%1, seed %2: %3").arg(scene.id).arg(seed).arg(complaint)));
    }
}

QTEST_GUILESS_MAIN(TestSentences)
#include "test_sentences.moc"
