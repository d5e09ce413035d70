// The window says how right the picture is: referee, comparison, number dial.
#include "core/scenes/builtin_scenes.h"
#include "tests/window_fixture.h"
#include "ui/base/applicability.h"
#include "ui/canvas/wipe.h"
#include "ui/pipeline/number_dial.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/steps/step_mode.h"
#include "ui/truth/compare_bar.h"
#include "ui/truth/referee_bar.h"
#include "ui/truth/truth_mode.h"

#include <QComboBox>
#include <QLabel>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr auto kSquare = "builtin:square-diagonal";

} // namespace

class TestTruthMode : public WindowFixture
{
    Q_OBJECT

private:
    TruthMode& truth() { return m_window->truthMode(); }
    Referee& referee() { return truth().referee(); }
    Comparison& comparison() { return truth().comparison(); }

    QRgb shownAt(QPoint pixel)
    {
        const QPointF at = viewport().transform().toCanvas(QPointF(pixel) + QPointF(0.25, 0.75));
        return viewport().grab().toImage().pixel(at.toPoint());
    }
    static Frame drawn(const Scene& scene, const Settings& settings)
    {
        Frame frame;
        render(scene, settings, frame);
        return frame;
    }

private Q_SLOTS:
    void refereeFollowsThePicture()
    {
        QVERIFY(open(kSquare));
        QVERIFY(referee().text().isEmpty());
        key(Qt::Key_V);
        QVERIFY(referee().isOn());
        QVERIFY(complete());
        QCOMPARE(referee().text(), QStringLiteral("none wrong of 64 samples"));
        QVERIFY(change([](Settings& s) { s.tieRule = TieRule::Exclusive; }));
        QCOMPARE(referee().text(), QStringLiteral("8 missing of 64 samples"));
        QVERIFY(change([](Settings& s) { s.tieRule = TieRule::Inclusive; }));
        QCOMPARE(referee().text(), QStringLiteral("8 hit twice of 64 samples"));
        QVERIFY(change([](Settings& s) { s.fill = Fill::Wireframe; }));
        QVERIFY(!referee().judgement());
        QVERIFY(referee().text().startsWith(QStringLiteral("not checked")));
        key(Qt::Key_V);
        QVERIFY(!referee().isOn());
        QVERIFY(referee().text().isEmpty());
    }

    void wrongPixelsGlow()
    {
        QVERIFY(open(kSquare));
        QVERIFY(change([](Settings& s) { s.tieRule = TieRule::Inclusive; }));
        referee().setOn(true);
        QVERIFY(complete());
        QCoreApplication::processEvents();
        const QRgb wrong = shownAt({0, 7});
        const QRgb right = shownAt({7, 7});
        const QRgb wrongInPicture = viewport().frame()->frame.image.pixel(0, 7);
        QCOMPARE(right, viewport().frame()->frame.image.pixel(7, 7));
        QVERIFY(wrong != wrongInPicture);
        referee().setOn(false);
        QCoreApplication::processEvents();
        QCOMPARE(shownAt({0, 7}), wrongInPicture);
    }

    /// However far one is away: the picture itself is then smaller than what glows.
    void wrongPixelsGlowFromAfar()
    {
        QVERIFY(open("builtin:slivers"));
        QVERIFY(change([](Settings& s) { s.numberType = NumberType::Float32; }));
        referee().setOn(true);
        QVERIFY(complete());
        const std::vector<WrongPixel>& wrong = referee().judgement()->wrong;
        QVERIFY(!wrong.empty());
        viewport().fit();
        const double zoom = viewport().transform().zoom;
        QVERIFY(zoom < kGridFromZoom);
        const QPoint beside =
            viewport().transform().toCanvas(QPointF(wrong[0].x + 0.5, wrong[0].y + 0.5)).toPoint() + QPoint(0, 5);
        const QRgb glowing = viewport().grab().toImage().pixel(beside);
        viewport().setOverlays({});
        QVERIFY(viewport().grab().toImage().pixel(beside) != glowing);
    }

    void nextWrongGoesRound()
    {
        QVERIFY(open(kSquare));
        QVERIFY(change([](Settings& s) { s.tieRule = TieRule::Exclusive; }));
        referee().setOn(true);
        QVERIFY(complete());
        for (int i = 0; i < 17; ++i) {
            key(Qt::Key_V, Qt::ShiftModifier);
            QCOMPARE(viewport().selectedPixel(), std::optional(QPoint(7 - i % 8, i % 8)));
        }
    }

    /// A change while a check is under way is checked; no verdict belongs to other settings.
    void latestCheckWins()
    {
        QVERIFY(open("builtin:torus-knot"));
        referee().setOn(true);
        QVERIFY(referee().isChecking());
        QVERIFY(!referee().judgement());
        Settings small = document().settings();
        small.size = {40, 30};
        document().setSettings(small);
        QVERIFY(!referee().judgement());
        QVERIFY(complete());
        QCOMPARE(referee().judgement()->difference.pixels, std::uint64_t{1200});
        document().undo();
        QVERIFY(referee().isChecking());
        referee().setOn(false);
        QVERIFY(!referee().isChecking());
        QVERIFY(truth().refereeBar().isHidden());
    }

    void mistakesAreComparedWithTheRightPicture()
    {
        QVERIFY(open(kSquare));
        QVERIFY(change([](Settings& s) {
            s.mistakes = {QStringLiteral("all-exclusive")};
            s.size = {64, 64};
        }));
        key(Qt::Key_S);
        QVERIFY(complete());
        QCOMPARE(comparison().with(), CompareWith::Right);
        Settings right = document().settings();
        right.mistakes.clear();
        QCOMPARE(comparison().wiped()->frame.image, drawn(*document().scene(), right).image);
        QCOMPARE(comparison().difference()->differing, std::uint64_t{64});
        QVERIFY(comparison().text().contains(QStringLiteral("64 of 4,096 pixels differ")));
        QCOMPARE(comparison().settingsDifferences().size(), std::size_t{1});
        key(Qt::Key_S);
        QCOMPARE(comparison().view(), CompareView::Off);
        QVERIFY(!viewport().overlays().wipe);
    }

    void wipeShowsAOnTheLeftAndMoves()
    {
        QVERIFY(open(kSquare));
        QVERIFY(change([](Settings& s) { s.shading = Shading::TriangleId; }));
        comparison().setView(CompareView::Wipe);
        QVERIFY(complete());
        const QRgb b = viewport().frame()->frame.image.pixel(2, 0);
        const QRgb a = comparison().wiped()->frame.image.pixel(2, 0);
        QVERIFY(a != b);
        const auto column = [&] {
            return wipeColumn(*viewport().overlays().wipe, viewport().rect(), viewport().transform(), 8);
        };
        const auto dragTo = [&](double x) {
            const int y = viewport().height() / 2;
            QTest::mousePress(&viewport(), Qt::LeftButton, {}, QPoint(int(column()), y));
            QTest::mouseMove(&viewport(), QPoint(int(x), y));
            QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, QPoint(int(x), y));
        };
        const View view = document().settings().view;
        dragTo(viewport().transform().toCanvas(QPointF(4, 0)).x());
        QCOMPARE(shownAt({2, 0}), a);
        dragTo(viewport().transform().toCanvas(QPointF(1, 0)).x());
        QCOMPARE(shownAt({2, 0}), b);
        QVERIFY(document().settings().view == view);
        viewport().zoomAt(QPointF(0, 0), 128); // the line stays within reach
        QVERIFY(viewport().rect().contains(QPoint(int(column()), 10)));
    }

    void comparisonFollowsTheCamera()
    {
        QVERIFY(open("builtin:cube"));
        QVERIFY(change([](Settings& s) {
            s.size = {80, 60};
            s.interpolation = Interpolation::Affine;
            s.shading = Shading::Flat;
        }));
        comparison().setView(CompareView::Wipe);
        QVERIFY(complete());
        for (const double yaw : {20.0, 40.0, 60.0}) {
            QVERIFY(change([yaw](Settings& s) { s.view.yaw = yaw; }));
            Settings a = document().defaults();
            a.size = document().settings().size;
            a.view = document().settings().view;
            QVERIFY(comparison().wiped()->settings == a);
            QCOMPARE(comparison().frame()->settings.view.yaw, yaw);
            QCOMPARE(*comparison().difference(),
                     rasterlens::difference(drawn(*document().scene(), a).image,
                                            drawn(*document().scene(), document().settings()).image));
        }
    }

    void blinkShowsBothInTurn()
    {
        QVERIFY(open(kSquare));
        QVERIFY(change([](Settings& s) { s.shading = Shading::TriangleId; }));
        key(Qt::Key_B);
        QVERIFY(complete());
        QSet<QString> tags;
        QVERIFY(waitFor([&] {
            tags << viewport().overlays().tag;
            return tags.contains(QStringLiteral("A")) && tags.contains(QStringLiteral("B"));
        }));
        const bool showsA = viewport().overlays().tag == QLatin1String("A");
        QCOMPARE(viewport().frame()->settings.shading, showsA ? document().defaults().shading : Shading::TriangleId);
        key(Qt::Key_B);
        QVERIFY(viewport().overlays().tag.isEmpty());
        QCOMPARE(viewport().frame()->settings.shading, Shading::TriangleId);
    }

    void differenceIsAmplified()
    {
        QVERIFY(open("builtin:sphere"));
        QVERIFY(change([](Settings& s) {
            s.size = {80, 60};
            s.subpixelBits = 4;
        }));
        key(Qt::Key_D);
        QVERIFY(complete());
        const QImage a = drawn(*document().scene(), comparison().other(document().settings())).image;
        const QImage b = drawn(*document().scene(), document().settings()).image;
        QVERIFY(a != b);
        QCOMPARE(viewport().frame()->frame.image, heatMap(a, b));
        QComboBox* box = truth().compareBar().amplificationBox();
        box->setCurrentIndex(box->findData(16));
        Q_EMIT box->activated(box->currentIndex());
        QVERIFY(complete());
        QCOMPARE(viewport().frame()->frame.image, heatMap(a, b, 16));
        QVERIFY(heatMap(a, b, 16) != heatMap(a, b));
    }

    void coloursThatAreCodesHaveNoDistance()
    {
        QVERIFY(openSmall(QStringLiteral("builtin:square-diagonal")));
        for (const auto& [shading, hasAmounts] :
             {std::pair(Shading::Gouraud, true), std::pair(Shading::Overdraw, false),
              std::pair(Shading::TriangleId, false)}) {
            QVERIFY(change([shading = shading](Settings& s) {
                s.shading = shading;
                s.mistakes = {QStringLiteral("all-exclusive")};
            }));
            comparison().setWith(CompareWith::Right);
            comparison().setView(CompareView::Difference);
            QVERIFY(complete());
            QVERIFY2(comparison().text().startsWith(QStringLiteral("8 of 64 pixels differ")),
                     qPrintable(comparison().text()));
            QCOMPARE(comparison().text().contains(QStringLiteral("PSNR")), hasAmounts);
            QCOMPARE(m_window->findChild<QWidget*>(QStringLiteral("amplification"))->isVisible(), hasAmounts);
        }
    }

    void pinnedSettingsAreKeptAndExchanged()
    {
        QVERIFY(open(kSquare));
        QVERIFY(change([](Settings& s) { s.tieRule = TieRule::Exclusive; }));
        key(Qt::Key_A);
        QVERIFY(change([](Settings& s) {
            s.tieRule = TieRule::TopLeft;
            s.size = {16, 16};
        }));
        key(Qt::Key_S);
        QVERIFY(complete());
        QCOMPARE(comparison().with(), CompareWith::Pinned);
        QCOMPARE(comparison().wiped()->settings.tieRule, TieRule::Exclusive);
        QCOMPARE(comparison().wiped()->frame.image.size(), QSize(16, 16));
        QCOMPARE(comparison().difference()->differing, std::uint64_t{16});
        key(Qt::Key_A, Qt::ShiftModifier);
        QVERIFY(complete());
        QCOMPARE(document().settings().tieRule, TieRule::Exclusive);
        QCOMPARE(comparison().wiped()->settings.tieRule, TieRule::TopLeft);
        document().undo();
        QCOMPARE(document().settings().tieRule, TieRule::TopLeft);
    }

    /// Steps of a picture are not compared; afterwards the comparison goes on. A new scene has nothing of the old one.
    void comparisonPausesForStepsAndForgetsScenes()
    {
        QVERIFY(open(kSquare));
        QVERIFY(change([](Settings& s) { s.tieRule = TieRule::Exclusive; }));
        comparison().setView(CompareView::Wipe);
        QVERIFY(complete());
        QVERIFY(viewport().overlays().wipe);
        m_window->stepMode().showStep(QStringLiteral("3"));
        QVERIFY(complete());
        QVERIFY(!viewport().overlays().wipe);
        m_window->stepMode().session().close();
        QVERIFY(complete());
        QVERIFY(viewport().overlays().wipe);
        QVERIFY(open("builtin:cube"));
        QCOMPARE(comparison().frame()->scene->id, QStringLiteral("builtin:cube"));
        QCOMPARE(comparison().difference()->differing, std::uint64_t{0});
    }

    void whatCannotBeDrawnIsSaid()
    {
        QVERIFY(open(kSquare));
        Settings pinned = document().settings();
        pinned.algorithm = Algorithm::Tiled;
        pinned.numberType = NumberType::Float32;
        const auto reason = unsupported(*document().scene(), pinned);
        QVERIFY(reason);
        document().setSettings(pinned);
        comparison().pin();
        document().undo();
        comparison().setView(CompareView::Wipe);
        QVERIFY(complete());
        QCOMPARE(comparison().text(), QStringLiteral("A cannot be drawn: ") + textOf(*reason));
        m_window->setLanguage(LanguageKind::Chinese);
        QVERIFY(comparison().text().endsWith(whyUnsupported(*reason)));
        QVERIFY(whyUnsupported(*reason) != textOf(*reason));
        m_window->setLanguage(LanguageKind::English);
        QVERIFY(!viewport().overlays().wipe);
    }

    void dialTurnsTypeAndBits()
    {
        QVERIFY(open(kSquare));
        NumberDial& dial = m_window->pipelinePanel().numberDial();
        QSet<QString> texts;
        for (int i = 0; i < static_cast<int>(NumberDial::kStops.size()); ++i) {
            dial.choose(i);
            QCOMPARE(dial.stop(), i);
            const NumberDial::Stop& stop = NumberDial::kStops[static_cast<std::size_t>(i)];
            QCOMPARE(document().settings().numberType, stop.type);
            if (stop.type == NumberType::Fixed)
                QCOMPARE(document().settings().subpixelBits, stop.subpixelBits);
            texts << dial.unitText() + dial.bitsText();
        }
        QCOMPARE(texts.size(), static_cast<int>(NumberDial::kStops.size()));
        dial.choose(2);
        QVERIFY(change([](Settings& s) { s.algorithm = Algorithm::Tiled; }));
        dial.choose(1); // float32, which tiled does not draw
        QCOMPARE(dial.stop(), 2);
        QVERIFY(change([](Settings& s) { s.algorithm = Algorithm::EdgeEquation; }));
        QTest::keyClick(&dial, Qt::Key_Down);
        QCOMPARE(dial.stop(), 3);
    }

    void float32FailsWhereTheMenuSays()
    {
        for (const QLatin1String name : kFloatFailures) {
            Q_EMIT m_window->pipelinePanel().floatFailureChosen(QStringLiteral("builtin:") + name);
            QVERIFY(complete());
            QCOMPARE(document().settings().numberType, NumberType::Float32);
            QVERIFY2(referee().judgement() && referee().judgement()->difference.wrong() > 0, name.data());
            QVERIFY(change([](Settings& s) { s.numberType = NumberType::Fixed; }));
            QVERIFY2(referee().judgement() && referee().judgement()->difference.wrong() == 0, name.data());
        }
    }

    /// A check that takes its time says how far it is; to send the referee off ends it.
    void longChecksTellHowFarTheyAre()
    {
        document().open(QStringLiteral("stress:medium"));
        QVERIFY(complete());
        QStringList texts;
        connect(&referee(), &Referee::changed, &referee(), [&] { texts << referee().text(); });
        referee().setOn(true);
        const auto tellsShare = [&] {
            return std::ranges::any_of(texts, [](const QString& t) { return t.contains(QLatin1Char('%')); });
        };
        QVERIFY(QTest::qWaitFor(tellsShare, kPatienceMs));
        QVERIFY(referee().isChecking());
        referee().setOn(false);
        QVERIFY(!referee().isChecking());
        QVERIFY(referee().text().isEmpty());
        QVERIFY(complete());
        QVERIFY(!referee().judgement());
    }

    /// The status bar shows a pixel of both pictures, and what lies between them.
    void readoutNamesBothPictures()
    {
        QVERIFY(open(kSquare));
        QVERIFY(change([](Settings& s) { s.tieRule = TieRule::Exclusive; }));
        viewport().selectPixel(QPoint(7, 0));
        const auto text = [this] { return m_window->findChild<QLabel*>(QStringLiteral("readout"))->text(); };
        QVERIFY(!text().contains(QStringLiteral("B ")));
        key(Qt::Key_S);
        QVERIFY(complete());
        const auto colors = comparison().at({7, 0});
        QVERIFY(colors && colors->a != colors->b);
        const QColor a(colors->a);
        const QColor b(colors->b);
        QVERIFY(text().contains(QStringLiteral("A %1 %2 %3").arg(a.red()).arg(a.green()).arg(a.blue())));
        QVERIFY(text().contains(QStringLiteral("B %1 %2 %3").arg(b.red()).arg(b.green()).arg(b.blue())));
        QVERIFY(!comparison().at({8, 0}));
        const auto differences = comparison().settingsDifferences();
        QCOMPARE(differences.size(), std::size_t{1});
        QVERIFY(differences[0].a != differences[0].b);
        key(Qt::Key_S);
        QVERIFY(!comparison().at({7, 0}));
        QVERIFY(complete()); // the words follow before the window is painted
        QVERIFY(!text().contains(QStringLiteral("B ")));
    }
};

QTEST_MAIN(TestTruthMode)
#include "test_truth_mode.moc"
