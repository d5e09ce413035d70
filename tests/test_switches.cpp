// Every switch of the pipeline panel reaches its field and is seen in the picture or its counters. One window serves
// all.
#include "core/questions/without_effect.h"
#include "core/render/render.h"
#include "tests/window_fixture.h"
#include "ui/base/applicability.h"
#include "ui/base/field_row.h"
#include "ui/pipeline/light_ball.h"
#include "ui/pipeline/light_fields.h"
#include "ui/pipeline/pipeline_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QSpinBox>

#include <algorithm>
#include <set>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// A triangle in front of the near half of the view volume, one across the right border and one behind the eye.
constexpr auto kClipped = R"(size 32 32
tri -0.8 -0.8 -0.5 1 1 0 0   0.2 -0.8 -0.5 1 0 1 0   -0.8 0.8 -0.5 1 0 0 1
tri 0.3 -0.5 0.4 1 1 1 0   3 0 0.4 1 0 1 1   0.3 0.6 0.4 1 1 0 1
tri 0 0 0 1 1 1 1   0.5 0.9 0.1 0.5 1 1 1   0.1 0.5 0.2 -0.4 1 1 1
)";

} // namespace

class TestSwitches : public WindowFixture
{
    Q_OBJECT

private:
    void choose(const QString& field, int value)
    {
        QWidget* editor = m_window->pipelinePanel().editor(field);
        if (auto* combo = qobject_cast<QComboBox*>(editor))
            combo->setCurrentIndex(value);
        else if (auto* spin = qobject_cast<QSpinBox*>(editor))
            spin->setValue(value);
        else if (auto* check = qobject_cast<QCheckBox*>(editor))
            check->setChecked(value != 0);
    }

private Q_SLOTS:
    void initTestCase()
    {
        WindowFixture::initTestCase();
        openWindow();
    }
    void init() {}
    void cleanup() {}
    void cleanupTestCase() { closeWindow(); }

    void everySwitchChangesItsField_data()
    {
        QTest::addColumn<QString>("id");
        for (const SettingsField& field : settingsFields())
            QTest::newRow(field.id) << QString::fromLatin1(field.id);
    }

    void everySwitchChangesItsField()
    {
        QFETCH(QString, id);
        const SettingsField& field = *findSettingsField(id);
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        const int before = field.get(settings());
        const int panelCount = m_window->pipelinePanel().changedCount();
        for (int value = field.minimum; value <= std::min(field.maximum, field.minimum + 9); ++value) {
            choose(id, value);
            QCOMPARE(field.get(settings()), value);
        }
        choose(id, before == field.maximum ? field.minimum : before + 1);
        QVERIFY(field.get(settings()) != before);
        QCOMPARE(m_window->pipelinePanel().changedCount(), panelCount + 1);
        while (document().canUndo() && field.get(settings()) != before)
            document().undo();
        QCOMPARE(field.get(settings()), before);
        QCOMPARE(m_window->pipelinePanel().changedCount(), panelCount);
        QVERIFY(settle());
    }

    void everySwitchShows_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QStringList>("before");
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("value");
        const auto row = [](const char* scene, const QStringList& before, const char* field, const char* value) {
            QTest::newRow(qPrintable(QStringLiteral("%1 %2").arg(QLatin1String(field), QLatin1String(value))))
                << QString::fromLatin1(scene) << before << QString::fromLatin1(field) << QString::fromLatin1(value);
        };
        row("clipped", {}, "clipping", "any-vertex-inside");
        row("clipped", {}, "clipping", "guard-band");
        row("clipped", {}, "clip-z", "d3d");
        row("builtin:cube", {"shading=depth"}, "reversed-z", "true");
        row("builtin:cube", {}, "projection", "orthographic");
        row("builtin:cube", {}, "subpixel-bits", "0");
        row("builtin:slivers", {}, "number-type", "float32");
        row("builtin:cube", {}, "culling", "none");
        row("builtin:cube", {}, "culling", "front");
        row("builtin:cube", {}, "winding", "cw");
        row("builtin:behind-camera", {"culling=back", "clipping=none"}, "cull-space", "clip");
        row("builtin:cube", {}, "fill", "wireframe");
        row("builtin:cube", {}, "fill", "points");
        row("builtin:square-diagonal", {}, "algorithm", "edge-walking");
        row("builtin:slivers", {"number-type=float32"}, "stepping", "direct");
        row("builtin:square-diagonal", {}, "tie-rule", "inclusive");
        row("builtin:square-diagonal", {}, "tie-rule", "exclusive");
        row("builtin:torus-knot", {"fill=wireframe"}, "line", "dda");
        row("builtin:triangle", {}, "samples", "2x2");
        row("builtin:piercing", {}, "visibility", "painter");
        row("builtin:piercing", {}, "visibility", "submission-order");
        row("builtin:piercing", {}, "depth-test", "greater");
        row("builtin:z-fighting", {}, "depth-format", "unorm16");
        row("builtin:head", {}, "depth-order", "after-shading");
        row("builtin:tile-square", {}, "interpolation", "affine");
        row("builtin:cube", {}, "shading", "normals");
        row("builtin:tile-square", {"shading=texture"}, "texture-filter", "bilinear");
    }

    /// Each switch, used in the panel, changes the picture or the counters of a scene that is about it. Not so the
    /// attribute path, which reaches the same values by other sums, nor threads and vector instructions.
    void everySwitchShows()
    {
        QFETCH(QString, scene);
        QFETCH(QStringList, before);
        QFETCH(QString, field);
        QFETCH(QString, value);
        QVERIFY(scene == QLatin1String("clipped") ? openText(kClipped) : openSmall(scene));
        Settings prepared = settings();
        for (const QString& assignment : before) {
            const QStringList parts = assignment.split(QLatin1Char('='));
            const auto error = setFromText(*findSettingsField(parts[0]), parts[1], prepared);
            QVERIFY2(!error, error ? qPrintable(textOf(*error)) : "");
        }
        document().setSettings(prepared);
        QVERIFY(settle());
        const QString message = m_window->message();
        QVERIFY2(message.isEmpty() || message.contains(QStringLiteral("nothing is seen")), qPrintable(message));
        QVERIFY2(!whyWithoutEffect(*findSettingsField(field), settings()), "the switch is greyed out");
        const QImage pictureBefore = picture();
        const Statistics statisticsBefore = viewport().frame()->statistics;

        Settings target = settings();
        QVERIFY(!setFromText(*findSettingsField(field), value, target));
        choose(field, findSettingsField(field)->get(target));
        QVERIFY(settings() == target);
        QVERIFY(settle());
        QVERIFY2(m_window->message().isEmpty(), qPrintable(m_window->message()));
        QVERIFY2(picture() != pictureBefore || !(viewport().frame()->statistics == statisticsBefore),
                 "neither the picture nor a counter changed");
    }

    void keysToggle_data()
    {
        QTest::addColumn<Qt::Key>("keyOfField");
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("one");
        QTest::addColumn<QString>("other");
        const auto row = [](const char* name, Qt::Key key, const char* id, const char* one, const char* other) {
            QTest::newRow(name) << key << QString::fromLatin1(id) << QString::fromLatin1(one)
                                << QString::fromLatin1(other);
        };
        row("W", Qt::Key_W, "fill", "solid", "wireframe");
        row("C", Qt::Key_C, "culling", "back", "none");
        row("X", Qt::Key_X, "clipping", "frustum", "none");
        row("T", Qt::Key_T, "depth-test", "less", "none");
        row("P", Qt::Key_P, "interpolation", "perspective", "affine");
    }

    /// To and fro between the two values of a lecture, and from any other value to the first of them.
    void keysToggle()
    {
        QFETCH(Qt::Key, keyOfField);
        QFETCH(QString, id);
        QFETCH(QString, one);
        QFETCH(QString, other);
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        const SettingsField& field = *findSettingsField(id);
        const auto value = [&] { return QString::fromLatin1(field.choices[std::size_t(field.get(settings()))].id); };
        QCOMPARE(value(), one);
        for (const QString& expected : {other, one, other}) {
            key(keyOfField);
            QCOMPARE(value(), expected);
        }
        const auto isThird = [&](const Choice& choice) {
            return QLatin1String(choice.id) != one && QLatin1String(choice.id) != other;
        };
        const auto third = std::ranges::find_if(field.choices, isThird);
        if (third == field.choices.end())
            return; // two values are all there are
        QVERIFY(change([&](Settings& s) { field.set(s, int(third - field.choices.begin())); }));
        key(keyOfField);
        QCOMPARE(value(), one);
    }

    void keysStepTheFields_data()
    {
        QTest::addColumn<Qt::Key>("keyOfField");
        QTest::addColumn<bool>("withShift");
        QTest::addColumn<QString>("id");
        QTest::newRow("W") << Qt::Key_W << true << QStringLiteral("fill");
        QTest::newRow("E") << Qt::Key_E << false << QStringLiteral("algorithm");
        QTest::newRow("C") << Qt::Key_C << true << QStringLiteral("culling");
        QTest::newRow("X") << Qt::Key_X << true << QStringLiteral("clipping");
        QTest::newRow("T") << Qt::Key_T << true << QStringLiteral("depth-test");
        QTest::newRow("P") << Qt::Key_P << true << QStringLiteral("interpolation");
        QTest::newRow("N") << Qt::Key_N << false << QStringLiteral("number-type");
    }

    void keysStepTheFields()
    {
        QFETCH(Qt::Key, keyOfField);
        QFETCH(bool, withShift);
        QFETCH(QString, id);
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        const SettingsField& field = *findSettingsField(id);
        const int first = field.get(settings());
        const auto step = [&] { key(keyOfField, withShift ? Qt::ShiftModifier : Qt::NoModifier); };
        std::set<int> values{first};
        for (step(); field.get(settings()) != first && values.size() <= 20; step())
            values.insert(field.get(settings()));
        QCOMPARE(field.get(settings()), first);
        QVERIFY(values.size() >= 2);
    }

    /// Neither depth order nor stepping changes what the tiled algorithm draws or counts, and the panel says so.
    void tiledHasItsOwnOrderAndStepping()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:head")));
        QVERIFY(change([](Settings& s) { s.algorithm = Algorithm::Tiled; }));
        const QImage pictureBefore = picture();
        const Statistics statisticsBefore = viewport().frame()->statistics;
        for (const char* id : {"depth-order", "stepping"}) {
            const SettingsField& field = *findSettingsField(QLatin1String(id));
            QVERIFY(whyWithoutEffect(field, settings()));
            QVERIFY(!m_window->pipelinePanel().editor(QLatin1String(id))->isEnabled());
            QVERIFY(change([&](Settings& s) { s = withNextValue(field, s); }));
            QCOMPARE(picture(), pictureBefore);
            QVERIFY(viewport().frame()->statistics == statisticsBefore);
        }
    }

    /// Threads and instructions left to the machine are told.
    void automaticValuesAreTold()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        Settings chosen = withoutAuto(settings());
        QVERIFY(chosen.threads > 0 && chosen.simd != Simd::Auto);
        const auto* threads = qobject_cast<QSpinBox*>(m_window->pipelinePanel().editor(QStringLiteral("threads")));
        QCOMPARE(threads->text(), QStringLiteral("auto (%1)").arg(chosen.threads));
        const auto* simd = qobject_cast<QComboBox*>(m_window->pipelinePanel().editor(QStringLiteral("simd")));
        const QString best = valueTitle(*findSettingsField(QStringLiteral("simd")), chosen);
        QCOMPARE(simd->currentText(), QStringLiteral("auto (%1)").arg(best));
        choose(QStringLiteral("threads"), 3);
        QCOMPARE(threads->text(), QStringLiteral("3"));
        document().undo();
        QVERIFY(settle());
    }

    void lightIsTypedSwitchedAndDragged()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:sphere")));
        LightFields& fields = m_window->pipelinePanel().light();
        const QImage usual = picture();
        const int changed = m_window->pipelinePanel().changedCount();
        QCOMPARE(fields.edit().text(), QStringLiteral("0.3, 0.5, 1"));
        const auto type = [&](const char* text) {
            fields.edit().setFocus();
            fields.edit().setText(QLatin1String(text));
            QTest::keyClick(&fields.edit(), Qt::Key_Return);
        };
        for (const char* bad : {"0, 0, 0", "1, 2", "nan 0 1", "up"}) {
            type(bad);
            QVERIFY2(m_window->message().contains(QStringLiteral("is no direction")), bad);
            QVERIFY(settings().light == Light());
            QTest::keyClick(&fields.edit(), Qt::Key_Escape);
        }
        type("-2 0 1");
        QVERIFY(settle());
        QVERIFY(settings().light == Light{glm::dvec3(-2, 0, 1)});
        QCOMPARE(m_window->pipelinePanel().changedCount(), changed + 1);
        QVERIFY(picture() != usual);
        fields.headBox().click();
        QVERIFY(settings().light.isHead());
        QVERIFY(change([](Settings& s) { s.view.yaw = 90; }));
        QCOMPARE(fields.edit().text(), QStringLiteral("1, 0, 0")); // the eye stands there now
        fields.headBox().click();
        QVERIFY(settings().light == Light{glm::dvec3(-2, 0, 1)}); // what it was before
        document().undo();
        document().undo();
        document().undo();
        QVERIFY(settings().light == Light{glm::dvec3(-2, 0, 1)} && settings().view.yaw == 0);
        // The right end of the ball is the camera's right, and a drag is one step of undo.
        const QSize ball = fields.ball().size();
        QTest::mousePress(&fields.ball(), Qt::LeftButton, {}, {ball.width() / 2, ball.height() / 2});
        QTest::mouseMove(&fields.ball(), {ball.width() - 5, ball.height() / 2});
        QTest::mouseMove(&fields.ball(), {ball.width() + 30, ball.height() / 2});
        QTest::mouseRelease(&fields.ball(), Qt::LeftButton, {}, {ball.width() + 30, ball.height() / 2});
        QVERIFY2(settings().light == Light{glm::dvec3(1, 0, 0)}, qPrintable(lightText(settings().light)));
        document().undo();
        QVERIFY(settings().light == Light{glm::dvec3(-2, 0, 1)});
        document().undo();
        QVERIFY(settle());
        QVERIFY(settings().light == Light());
        QCOMPARE(picture(), usual);
    }

    void lightAndProjectionSayWhereTheyChangeNothing()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:square-diagonal")));
        QVERIFY(change([](Settings& s) {
            s.projection = Projection::Orthographic;
            s.light.towards.reset();
        }));
        QTRY_COMPARE(m_window->pipelinePanel().note(QStringLiteral("projection")),
                     QStringLiteral("changes nothing here: the scene is given in clip space: no camera projects it"));
        QVERIFY(m_window->pipelinePanel().light().note().contains(QStringLiteral("this scene has no light")));
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        QVERIFY(change([](Settings& s) { s.projection = Projection::Orthographic; }));
        QVERIFY(m_window->pipelinePanel().note(QStringLiteral("projection")).isEmpty());
        QVERIFY(m_window->pipelinePanel().light().note().isEmpty());
    }

    /// A switch that is turned by its key comes in sight in the panel, and with it why it changes nothing.
    void whatAKeyChangesComesInSight()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:games101")));
        const QList<FieldRow*> rows = m_window->pipelinePanel().findChildren<FieldRow*>();
        const auto row = std::ranges::find_if(
            rows, [](const FieldRow* row) { return QLatin1String(row->field().id) == QLatin1String("interpolation"); });
        QVERIFY(row != rows.end());
        const auto isInSight = [&] { return (*row)->visibleRegion().boundingRect().height() == (*row)->height(); };
        QVERIFY(!isInSight());
        key(Qt::Key_P);
        QVERIFY(complete());
        QTRY_VERIFY((*row)->note().startsWith(
            QStringLiteral("changes nothing here: the three w of each face are equal: 7 and 10")));
        QTRY_VERIFY(isInSight());
    }

    /// Every letter that is typed into a number appears; what is refused says why and stays until it is mended.
    void refusedNumbersStayInTheirBox()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        QVERIFY(change([](Settings& s) { s.algorithm = Algorithm::Tiled; }));
        auto* spin = qobject_cast<PanelSpin*>(m_window->pipelinePanel().editor(QStringLiteral("threads")));
        QVERIFY(spin && spin->isEnabled());
        const auto type = [&](const char* text) {
            spin->selectAll();
            QTest::keyClicks(spin, QLatin1String(text));
        };
        for (const char* wrong : {"three", "3 4", "2.5", "-1", "99999", "3,"}) {
            type(wrong);
            QCOMPARE(spin->text(), QLatin1String(wrong));
            QVERIFY2(!spin->isRefused(), wrong); // not before it is to be used
            QTest::keyClick(spin, Qt::Key_Return);
            QVERIFY2(spin->isRefused() && spin->text() == QLatin1String(wrong), wrong);
            QVERIFY(spin->whyRefused().contains(QLatin1String(wrong)));
            QTest::keyClick(spin, Qt::Key_Escape);
            QVERIFY(!spin->isRefused() && spin->text() != QLatin1String(wrong));
        }
        type("x");
        QTest::keyClick(spin, Qt::Key_Return);
        type("(3)");
        QTest::keyClick(spin, Qt::Key_Return);
        QVERIFY(settle());
        QVERIFY(!spin->isRefused());
        QCOMPARE(settings().threads, 3);
        QCOMPARE(spin->text(), QStringLiteral("3"));
        type("auto");
        QTest::keyClick(spin, Qt::Key_Return);
        QVERIFY(settle());
        QCOMPARE(settings().threads, 0);
        type("y");
        QTest::keyClick(spin, Qt::Key_Return);
        QVERIFY(change([](Settings& s) { s.culling = Culling::Front; })); // another field; the text stays
        QVERIFY(spin->isRefused());
        QCOMPARE(spin->text(), QStringLiteral("y"));
        QTest::keyClick(spin, Qt::Key_Escape);
    }

    /// A key that finds no other value says why.
    void keysWithoutAnotherValueSayWhy()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:cube")));
        QVERIFY(change([](Settings& s) { s.algorithm = Algorithm::Tiled; }));
        for (const Qt::Key stuck : {Qt::Key_N, Qt::Key_W}) {
            const Settings before = settings();
            key(stuck);
            QVERIFY(settings() == before);
            QVERIFY(m_window->message().contains(stuck == Qt::Key_N ? QLatin1String("number-type")
                                                                    : QLatin1String("fill solid")));
        }
    }
};

QTEST_MAIN(TestSwitches)
#include "test_switches.moc"
