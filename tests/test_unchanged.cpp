#include "core/questions/unchanged.h"
// Why a switch changes nothing: what is said holds in every scene, and is said where the classroom's scenes need it.
#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"
#include "core/truth/mistake_proof.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace rasterlens;

namespace
{

Scene make(const char* name) { return *makeBuiltinScene(QLatin1String(name)).scene; }

/// The settings of a scene in a picture small enough to draw many of.
Settings smallSettings(const Scene& scene)
{
    constexpr QSize kMost(160, 120);
    Settings settings = scene.defaults;
    if (settings.size.width() > kMost.width() || settings.size.height() > kMost.height())
        settings.size = settings.size.scaled(kMost, Qt::KeepAspectRatio).expandedTo(QSize(1, 1));
    return settings;
}

Frame drawn(const Scene& scene, const Settings& settings)
{
    Frame frame;
    render(scene, settings, frame, {.depth = true, .ids = true, .coverage = true});
    return frame;
}

/// Equal in every pixel; depths may differ by the rounding of their weights.
bool looksAlike(const Frame& a, const Frame& b)
{
    constexpr float kRounding = 1e-6F;
    const auto isNear = [](float one, float other) { return std::abs(one - other) <= kRounding; };
    return a.image == b.image && a.ids == b.ids && a.coverage == b.coverage &&
           std::ranges::equal(a.depth, b.depth, isNear);
}

QString reasonOf(const char* mistake, const Scene& scene)
{
    const auto why =
        whyUnchanged(*findMistake(QLatin1String(mistake)), scene.defaults, frameFacts(scene, scene.defaults));
    return why ? textOf(*why) : QString();
}

QString reasonOf(const char* fieldId, int value, const Scene& scene)
{
    const SettingsField& field = *findSettingsField(QLatin1String(fieldId));
    Settings other = scene.defaults;
    field.set(other, value);
    const auto why = whyUnchanged(field, other, scene.defaults, frameFacts(scene, scene.defaults));
    return why ? textOf(*why) : QString();
}

void addRowForEachScene()
{
    QTest::addColumn<QString>("name");
    for (const BuiltinScene& entry : builtinScenes())
        QTest::newRow(entry.name) << QString::fromLatin1(entry.name);
}

} // namespace

class TestUnchanged : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsSaidHolds_data() { addRowForEachScene(); }
    void whatIsSaidHolds();
    void everyReasonIsSaidSomewhere();
    void games101SaysItsW();
    void tiltedTwinShowsWhatGames101Hides();
    void aCutFaceTakesTheReasonAway();
    void aBackFaceTakesTheReasonAway();
};

void TestUnchanged::whatIsSaidHolds()
{
    QFETCH(QString, name);
    const Scene scene = *makeBuiltinScene(name).scene;
    const Settings settings = smallSettings(scene);
    const FrameFacts facts = frameFacts(scene, settings);
    const Frame right = drawn(scene, settings);
    for (const SettingsField& field : settingsFields()) {
        if (!canBeUnchanged(field))
            continue;
        for (int value = field.minimum; value <= field.maximum; ++value) {
            Settings other = settings;
            field.set(other, value);
            if (whyUnchanged(field, other, settings, facts) && !unsupported(scene, other))
                QVERIFY2(looksAlike(drawn(scene, other), right), field.choices[std::size_t(value)].id);
        }
    }
    for (const Mistake& mistake : mistakes()) {
        Settings other = settings;
        other.mistakes = {QLatin1String(mistake.id)};
        if (whyUnchanged(mistake, other, facts))
            QVERIFY2(looksAlike(drawn(scene, other), right), mistake.id);
    }
}

void TestUnchanged::everyReasonIsSaidSomewhere()
{
    const Scene triangle = make("triangle");
    QCOMPARE(reasonOf("culling", int(Culling::None), triangle), QStringLiteral("every face is a front face"));
    QCOMPARE(reasonOf("culling", int(Culling::Front), triangle), QString()); // the front face would go
    QCOMPARE(reasonOf("alpha-test", int(AlphaTest::Off), triangle), QStringLiteral("no material has a mask"));
    QCOMPARE(reasonOf("alpha-test", int(AlphaTest::Off), make("cut-outs")), QString());
    QCOMPARE(reasonOf("steep-columns", triangle), QStringLiteral("no lines are drawn"));
    QCOMPARE(reasonOf("steep-columns", make("lines")), QString());
    QCOMPARE(reasonOf("coverage-times-color", triangle), QStringLiteral("there is one sample a pixel"));
    QCOMPARE(reasonOf("coverage-times-color", make("samples")), QString());
    QCOMPARE(reasonOf("stride-exchanged", make("square-diagonal")),
             QStringLiteral("the picture is as wide as it is high"));
    QCOMPARE(reasonOf("cull-reversed", make("square-diagonal")), QStringLiteral("nothing is culled"));
    QVERIFY(reasonOf("no-near-clip", triangle).startsWith(QStringLiteral("no face is cut")));
    QVERIFY(reasonOf("clipping", int(Clipping::None), triangle).startsWith(QStringLiteral("no face is cut")));
    // All corners of the square have w = 1.
    QCOMPARE(reasonOf("affine", make("square-diagonal")), QStringLiteral("all w of these faces are equal: 1"));
}

void TestUnchanged::games101SaysItsW()
{
    // The eye is at z = 5, the faces lie at z = -2 and z = -5.
    const Scene scene = make("games101");
    for (const char* id : {"affine", "w-lost", "w-not-inverted", "z-corrected"})
        QCOMPARE(reasonOf(id, scene), QStringLiteral("the three w of each face are equal: 7 and 10"));
    QCOMPARE(reasonOf("interpolation", int(Interpolation::Affine), scene),
             QStringLiteral("the three w of each face are equal: 7 and 10"));
}

void TestUnchanged::tiltedTwinShowsWhatGames101Hides()
{
    const Scene scene = make("games101-tilted");
    const CountedPicture right = drawCounted(scene, scene.defaults);
    const Scene twin = make("games101");
    const CountedPicture flat = drawCounted(twin, twin.defaults);
    QCOMPARE(right.statistics.pixels.covered, flat.statistics.pixels.covered);
    QCOMPARE(right.statistics.pixels.covered, 93'120U);
    for (const char* id : {"affine", "w-lost", "w-not-inverted", "z-corrected"}) {
        QCOMPARE(reasonOf(id, scene), QString());
        Settings mistaken = scene.defaults;
        mistaken.mistakes = {QLatin1String(id)};
        QVERIFY2(proofValue(Proof::WrongPixels, drawCounted(scene, mistaken), right) > 1000, id);
    }
    // The middle between the corners with w = 3.5 and w = 14 on the screen lies at 2 / (1 / 3.5 + 1 / 14) = 5.6.
    const double depth = 0.5 + 0.5 * (50.1 / 49.9 - 2 * 50 * 0.1 / 49.9 / 5.6);
    // Its place is the middle of the edge y = 0 of games101: the centre of the picture. The pixel above it is half a
    // pixel away, which makes 3e-5.
    const std::size_t above = std::size_t(349) * 700 + 350;
    QCOMPARE(right.frame.ids[above], 0);
    QVERIFY2(std::abs(double(right.frame.depth[above]) - depth) < 5e-5,
             qPrintable(QString::number(double(right.frame.depth[above]), 'g', 9)));
}

void TestUnchanged::aCutFaceTakesTheReasonAway()
{
    Scene scene = make("square-diagonal");
    QVERIFY(!reasonOf("no-near-clip", scene).isEmpty());
    scene.mesh.vertices[scene.mesh.indices[0]].position.x = -1.5F;
    QCOMPARE(reasonOf("no-near-clip", scene), QString());
    scene.mesh.vertices[scene.mesh.indices[0]].position = {-2, 2, 0, 2}; // inside again, at another w
    QVERIFY(!reasonOf("no-near-clip", scene).isEmpty());
    QCOMPARE(reasonOf("affine", scene), QString());
}

void TestUnchanged::aBackFaceTakesTheReasonAway()
{
    Scene scene = make("triangle");
    std::swap(scene.mesh.indices[0], scene.mesh.indices[1]);
    QCOMPARE(reasonOf("culling", int(Culling::None), scene), QString());
    Scene shownFromBehind = scene;
    shownFromBehind.defaults.culling = Culling::Front;
    QCOMPARE(reasonOf("culling", int(Culling::None), shownFromBehind), QStringLiteral("every face is a back face"));
}

QTEST_GUILESS_MAIN(TestUnchanged)
#include "test_unchanged.moc"
