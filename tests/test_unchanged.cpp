#include "core/questions/unchanged.h"
// Why a switch changes nothing: what is said holds in every scene, and is said where the classroom's scenes need it.
#include "core/questions/without_effect.h"
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

/// Equal in every pixel; depths of what is drawn may differ by the rounding of their weights.
bool looksAlike(const Frame& a, const Frame& b)
{
    constexpr float kRounding = 1e-6F;
    for (std::size_t i = 0; i < a.ids.size(); ++i)
        if (a.ids[i] >= 0 && !(std::abs(a.depth[i] - b.depth[i]) <= kRounding))
            return false;
    return a.image == b.image && a.ids == b.ids && a.coverage == b.coverage;
}

QString reasonOf(const char* mistake, const Scene& scene)
{
    const auto why = whyUnchanged(*findMistake(QLatin1String(mistake)), scene.defaults,
                                  frameFacts(scene, scene.defaults, FactsOf::Samples));
    return why ? textOf(*why) : QString();
}

QString reasonOf(const char* fieldId, int value, const Scene& scene)
{
    const SettingsField& field = *findSettingsField(QLatin1String(fieldId));
    Settings other = scene.defaults;
    field.set(other, value);
    const auto why = whyUnchanged(field, other, scene.defaults, frameFacts(scene, scene.defaults, factsFor(field)));
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
    void samplesTellOfTiesAndDepths();
    void settingsTakeFactsOfSamplesAway();
    void fieldsWithoutEffectHaveNone_data() { addRowForEachScene(); }
    void fieldsWithoutEffectHaveNone();
};

void TestUnchanged::whatIsSaidHolds()
{
    QFETCH(QString, name);
    const Scene scene = *makeBuiltinScene(name).scene;
    const Settings settings = smallSettings(scene);
    const FrameFacts facts = frameFacts(scene, settings, FactsOf::Samples);
    const Frame right = drawn(scene, settings);
    for (const SettingsField& field : settingsFields()) {
        if (!canBeUnchanged(field))
            continue;
        for (int value = field.minimum; value <= field.maximum; ++value) {
            Settings other = settings;
            field.set(other, value);
            if (whyUnchanged(field, other, settings, facts) && !unsupported(scene, other)) {
                const QByteArray what = QByteArray(field.id) + " " + valueId(field, other).toUtf8();
                QVERIFY2(looksAlike(drawn(scene, other), right), what.constData());
            }
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

void TestUnchanged::samplesTellOfTiesAndDepths()
{
    // The diagonal of the square goes through centres of samples, and one face covers each of them.
    const Scene square = make("square-diagonal");
    QCOMPARE(reasonOf("tie-rule", int(TieRule::Inclusive), square), QString());
    QCOMPARE(reasonOf("all-inclusive", square), QString());
    QCOMPARE(reasonOf("depth-test", int(DepthTest::Greater), square),
             QStringLiteral("no sample is covered by two faces"));
    QCOMPARE(reasonOf("visibility", int(Visibility::Painter), square),
             QStringLiteral("no sample is covered by two faces"));
    // A sixteenth of a pixel to the right no centre lies on an edge. The 8 pixels are 2 wide in clip space.
    Scene moved = square;
    for (MeshVertex& vertex : moved.mesh.vertices)
        vertex.position.x += 2.0F / 8 / 16;
    QCOMPARE(reasonOf("tie-rule", int(TieRule::Inclusive), moved), QStringLiteral("no sample lies exactly on an edge"));
    QCOMPARE(reasonOf("all-exclusive", moved), QStringLiteral("no sample lies exactly on an edge"));
    // Two faces, one before the other, of different depths everywhere.
    const Scene games = make("games101");
    QCOMPARE(reasonOf("depth-test", int(DepthTest::LessEqual), games),
             QStringLiteral("no depth is exactly the one that it is compared with"));
    QCOMPARE(reasonOf("depth-test", int(DepthTest::Greater), games), QString());
    QCOMPARE(reasonOf("visibility", int(Visibility::SubmissionOrder), games), QString());
    // A face that is sent twice meets its own depths.
    Scene twice = make("triangle");
    for (std::size_t i = 0; i < 3; ++i)
        twice.mesh.indices.push_back(twice.mesh.indices[i]);
    if (!twice.mesh.faceMaterial.empty())
        twice.mesh.faceMaterial.push_back(twice.mesh.faceMaterial.front());
    QCOMPARE(reasonOf("depth-test", int(DepthTest::LessEqual), twice), QString());
}

void TestUnchanged::settingsTakeFactsOfSamplesAway()
{
    const auto depthTest = [](const Scene& scene) { return reasonOf("depth-test", int(DepthTest::Greater), scene); };
    Scene scene = make("square-diagonal");
    QVERIFY(!depthTest(scene).isEmpty());
    QCOMPARE(reasonOf("stepping", int(Stepping::Direct), scene),
             QStringLiteral("fixed point is exact: adding up gives what the formula gives"));
    scene.defaults.depthTest = DepthTest::Always;
    QCOMPARE(reasonOf("depth-test", int(DepthTest::None), scene), QStringLiteral("either way every fragment is drawn"));
    scene.defaults.depthTest = DepthTest::Less;
    scene.defaults.fill = Fill::Wireframe; // lines of faces meet in corners
    QCOMPARE(depthTest(scene), QString());
    scene.defaults.fill = Fill::Solid;
    scene.defaults.algorithm = Algorithm::EdgeWalking;
    QVERIFY(!depthTest(scene).isEmpty());
    scene.defaults.numberType = NumberType::Float32; // its own floats decide
    QCOMPARE(depthTest(scene), QString());
    QCOMPARE(reasonOf("stepping", int(Stepping::Direct), scene), QString());
    scene.defaults.numberType = NumberType::Fixed;
    scene.defaults.mistakes = {QStringLiteral("all-inclusive")}; // the diagonal is covered twice
    QCOMPARE(depthTest(scene), QString());
}

/// What is greyed out makes no difference in any scene.
void TestUnchanged::fieldsWithoutEffectHaveNone()
{
    QFETCH(QString, name);
    const Scene scene = *makeBuiltinScene(name).scene;
    std::vector<Settings> asked(5, smallSettings(scene));
    asked[1].fill = Fill::Wireframe;
    asked[2].algorithm = Algorithm::ColumnFill;
    asked[3].visibility = Visibility::Painter;
    asked[4].algorithm = Algorithm::EdgeWalking;
    int fields = 0;
    for (const Settings& settings : asked) {
        // The first pass of two is filled all the same, which a reason that knows the settings alone cannot tell.
        if ((settings.fill != Fill::Solid && scene.secondPassFrom > 0) || unsupported(scene, settings))
            continue;
        const Frame right = drawn(scene, settings);
        for (const SettingsField& field : settingsFields()) {
            if (!canBeUnchanged(field) || !whyWithoutEffect(field, settings))
                continue;
            ++fields;
            for (int value = field.minimum; value <= field.maximum; ++value) {
                Settings other = settings;
                field.set(other, value);
                QVERIFY2(looksAlike(drawn(scene, other), right), field.id);
            }
        }
    }
    const bool asksLess = scene.secondPassFrom > 0 || patternSamples(scene.defaults.samples) > 1;
    QVERIFY(fields > 5 || asksLess);
}

QTEST_GUILESS_MAIN(TestUnchanged)
#include "test_unchanged.moc"
