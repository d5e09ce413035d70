// The light: its direction by hand on a face, the headlight, what is refused, culling by it, and its derivation.
#include "core/observe/step_log.h"
#include "core/pipeline/culling.h"
#include "core/pipeline/shading.h"
#include "core/questions/unchanged.h"
#include "core/render/steps.h"
#include "tests/derivation_fixture.h"
#include "tests/support.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

bool close(const glm::vec3& a, const glm::vec3& b) { return glm::length(a - b) < 1e-6F; }

/// One face in the plane z = 0 of object space that looks along +z, red.
Scene redFace()
{
    Scene scene = soup({{-1, -1, 0, 1}, {1, -1, 0, 1}, {-1, 1, 0, 1}});
    scene.space = SceneSpace::Object;
    scene.lit = true;
    for (MeshVertex& v : scene.mesh.vertices) {
        v.color = {1, 0, 0};
        v.normal = {0, 0, 1};
    }
    return scene;
}

Settings litBy(const Light& light, Shading shading = Shading::Flat)
{
    Settings settings = plainSettings({16, 16});
    settings.light = light;
    settings.shading = shading;
    return settings;
}

int redOf(const Scene& scene, const Settings& settings) { return qRed(draw(scene, settings).image.pixel(6, 9)); }

} // namespace

class TestLight : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theUsualLightIsThatOfTheRules();
    void byHandOnAFace();
    void headlightTurnsWithTheCamera();
    void lightAtTheEyeHasNoHighlight();
    void textIsReadBack();
    void jsonIsReadBack();
    void cullingGoesByIt();
    void derivationSaysItsNumbers();
    void reasonsWhyItChangesNothing();
};

void TestLight::theUsualLightIsThatOfTheRules()
{
    const glm::vec3 usual(glm::normalize(glm::dvec3(0.3, 0.5, 1)));
    QVERIFY(Rules().light == usual);
    QVERIFY(resolve(Settings(), redFace()).rules.light == usual);
    QVERIFY(lightDirection(Light{glm::dvec3(3, 5, 10)}, {}) == usual);
    QVERIFY(close(lightDirection(Light{glm::dvec3(0, -1e-300, 0)}, {}), {0, -1, 0}));
    QVERIFY(close(lightDirection(Light{glm::dvec3(1e30, 0, -1e30)}, {}), glm::vec3(1, 0, -1) / std::sqrt(2.0F)));
}

/// l = (0, 3, 4) / 5, n = (0, 0, 1): n . l = 0.8, and 255 (0.2 + 0.8 * 0.8) = 214.2. From behind: 255 * 0.2 = 51.
void TestLight::byHandOnAFace()
{
    const Scene scene = redFace();
    for (const Shading shading : {Shading::Flat, Shading::Gouraud}) {
        QCOMPARE(redOf(scene, litBy({glm::dvec3(0, 3, 4)}, shading)), 214);
        QCOMPARE(redOf(scene, litBy({glm::dvec3(0, 0, 7)}, shading)), 255);
        QCOMPARE(redOf(scene, litBy({glm::dvec3(0, 3, -4)}, shading)), 51);
    }
}

/// The eye stands 60 degrees to the side: n . l = cos 60 = 1/2, and 255 (0.2 + 0.4) = 153.
void TestLight::headlightTurnsWithTheCamera()
{
    const Scene scene = redFace();
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        Settings settings = litBy({std::nullopt});
        settings.projection = projection;
        QCOMPARE(redOf(scene, settings), 255);
        settings.view.yaw = 60;
        QVERIFY(close(resolve(settings, scene).rules.light, {std::sqrt(0.75F), 0, 0.5F}));
        Settings turned = settings;
        turned.light.towards = glm::dvec3(std::sqrt(3.0), 0, 1);
        const QImage byNumbers = draw(scene, turned).image;
        QVERIFY(draw(scene, settings).image == byNumbers);
        QCOMPARE(redOf(scene, settings), 153);
    }
    // In clip space counter-clockwise faces turn to it.
    QVERIFY(resolve(litBy({std::nullopt}), soup({{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}})).rules.light ==
            glm::vec3(0, 0, 1));
}

/// An orthographic camera looks along -z everywhere, and the light along +z: nothing lies halfway between the two.
void TestLight::lightAtTheEyeHasNoHighlight()
{
    Settings settings = litBy({glm::dvec3(0, 0, -1)}, Shading::Phong);
    settings.projection = Projection::Orthographic;
    QCOMPARE(redOf(redFace(), settings), 51);
    settings.light.towards = glm::dvec3(0, 0, 1); // ambient, diffuse, and all of the highlight
    QCOMPARE(redOf(redFace(), settings), 255);
    // l = (0, 3, 4) / 5 and the gaze (0, 0, 1): halfway is (0, 1, 3) / sqrt(10) on all of the face.
    settings.light.towards = glm::dvec3(0, 3, 4);
    const Material material;
    const double shine = std::pow(3 / std::sqrt(10.0), double(material.shininess)) * double(material.specular.x);
    const double expected = 255 * std::min(0.84 + shine, 1.0);
    for (const QPoint pixel : {QPoint(6, 9), QPoint(5, 10), QPoint(7, 8)})
        QVERIFY(std::abs(qRed(draw(redFace(), settings).image.pixel(pixel)) - expected) <= 0.51);
}

void TestLight::textIsReadBack()
{
    QVERIFY(parseLight(QStringLiteral("head"))->isHead());
    QVERIFY(*parseLight(QStringLiteral("0, -3 4")) == Light{glm::dvec3(0, -3, 4)});
    for (const Light& light : {Light(), Light{std::nullopt}, Light{glm::dvec3(1.0 / 3, -1e-20, 1e30)}})
        QVERIFY(*parseLight(lightText(light)) == light);
    QCOMPARE(lightText(Light()), QStringLiteral("0.3,0.5,1"));
    for (const char* bad : {"", "0,0,0", "0 0 -0", "nan,0,1", "inf,0,0", "1,2", "1,2,3,4", "1e31,0,0", "side", "Head"})
        QVERIFY2(!parseLight(QLatin1String(bad)), bad);
}

void TestLight::jsonIsReadBack()
{
    for (const Light& light : {Light(), Light{std::nullopt}, Light{glm::dvec3(1.0 / 3, -2, 1e-20)}}) {
        Settings settings;
        settings.light = light;
        settings.projection = Projection::Orthographic;
        const QByteArray text = QJsonDocument(toJson(settings)).toJson();
        const SettingsParse read = settingsFromJson(QJsonDocument::fromJson(text).object());
        QVERIFY(read.errors.empty() && read.settings == settings);
    }
    QVERIFY(settingsFromJson(QJsonObject()).settings.light == Light()); // files of before say nothing of it
    for (const char* bad : {R"({"light": "side"})", R"({"light": [0, 0, 0]})", R"({"light": [1, 2]})",
                            R"({"light": [1, 2, "3"]})", R"({"light": 1})", R"({"light": [1e31, 0, 0]})"}) {
        const SettingsParse read = settingsFromJson(QJsonDocument::fromJson(bad).object());
        QCOMPARE(read.errors.size(), std::size_t(1));
        QVERIFY2(textOf(read.errors.front()).contains(QStringLiteral("\"light\" takes")), bad);
        QVERIFY(read.settings == Settings());
    }
}

/// The normal AB x AC is (0, 0, 4): its product with (0, 0.6, -0.8) is -3.2, so the mistake drops a front face.
void TestLight::cullingGoesByIt()
{
    const Scene scene = redFace();
    Settings settings = litBy({glm::dvec3(0, 3, -4)});
    settings.culling = Culling::Back;
    QCOMPARE(process(scene, settings).fates.front(), FaceFate::Rasterized);
    settings.mistakes = {QStringLiteral("cull-by-light")};
    QCOMPARE(process(scene, settings).fates.front(), FaceFate::CulledBack);
    const auto log = renderSteps(scene, settings, {});
    const auto events = log->eventsOf(StepKind::Facing);
    QCOMPARE(events.size(), std::size_t(1));
    const double value = log->payload<FacingStep>(log->event(events.front())).decision.value;
    QVERIFY(std::abs(value + 3.2) < 1e-6);
    settings.light.towards = glm::dvec3(0, 3, 4);
    QCOMPARE(process(scene, settings).fates.front(), FaceFate::Rasterized);
    QCOMPARE(directionFacing(scene.mesh, 0, {0, 3, -4}), -16.0);
}

void TestLight::derivationSaysItsNumbers()
{
    const Scene scene = redFace();
    const Derivation d = derived(DerivationTopic::FlatLight, scene, litBy({glm::dvec3(0, 3, 4)}), {});
    QVERIFY(isNear(valueOf(d, "l_y"), 0.6, 1e-7));
    QVERIFY(isNear(valueOf(d, "l_z"), 0.8, 1e-7));
    QVERIFY(isNear(valueOf(d, "n.l"), 0.8, 1e-7));
    QVERIFY(isNear(valueOf(d, "brightness"), 0.84, 1e-7));
    QCOMPARE(valueOf(d, "r"), 214.0);
    Settings aside = litBy({std::nullopt});
    aside.view.yaw = 60;
    const Derivation head = derived(DerivationTopic::FlatLight, scene, aside, {});
    QVERIFY(isNear(valueOf(head, "n.l"), 0.5, 1e-7));
    QCOMPARE(valueOf(head, "r"), 153.0);
    const auto says = [](const Derivation& derivation, const char* words) {
        return std::ranges::any_of(derivation.lines, [&](const DerivationLine& line) {
            return textOf(line.words).contains(QLatin1String(words));
        });
    };
    QVERIFY(says(head, "The headlight: l is the camera's backward axis"));
    QVERIFY(!says(d, "The headlight: l is"));
}

void TestLight::reasonsWhyItChangesNothing()
{
    Scene scene = redFace();
    const auto reason = [&](const Settings& settings) {
        const auto why = whyLightUnchanged(scene, settings);
        return why ? textOf(*why) : QString();
    };
    Settings settings = litBy({std::nullopt});
    QCOMPARE(reason(settings), QString());
    settings.shading = Shading::Normals;
    QCOMPARE(reason(settings), QStringLiteral("this shading asks for no light"));
    settings.fill = Fill::Wireframe;
    QCOMPARE(reason(settings), QStringLiteral("lines and points are drawn without light"));
    scene.lit = false;
    QCOMPARE(reason(settings), QStringLiteral("this scene has no light: its colours are shown as they are"));
    settings.mistakes = {QStringLiteral("cull-by-light")};
    QCOMPARE(reason(settings), QString()); // faces go by it
}

QTEST_APPLESS_MAIN(TestLight)
#include "test_light.moc"
