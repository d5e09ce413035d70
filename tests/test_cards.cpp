#include "core/truth/mistake_proof.h"
// The panels about one pixel or one face show what core computes, and edit what they say they edit.
#include "core/observe/step_text.h"
#include "core/questions/race.h"
#include "core/questions/why.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "tests/window_fixture.h"
#include "ui/base/theme.h"
#include "ui/face/cards.h"
#include "ui/face/clip_theatre.h"
#include "ui/face/curve_plot.h"
#include "ui/face/curves_panel.h"
#include "ui/face/pixel_card.h"
#include "ui/face/race_panel.h"
#include "ui/face/vertex_handles.h"
#include "ui/face/vertex_panel.h"
#include "ui/pipeline/mistake_badge.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/pipeline_panel.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFontMetricsF>
#include <QIcon>
#include <QMenu>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include <set>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// One corner beyond the right side, one above the top: 3 -> 4 -> 5 corners.
constexpr auto kTwoCuts = "size 32 32\ntri -0.5 -0.5 0 1 1 0 0   2 -0.5 0 1 0 1 0   -0.5 2 0 1 0 0 1\n";

QString plain(QString text)
{
    return text.replace(QChar(0x2212), QLatin1Char('-')).replace(QChar(0xa0), QLatin1Char(' '));
}

} // namespace

class TestCards : public WindowFixture
{
    Q_OBJECT

private:
    Cards& cards() { return m_window->cards(); }

    bool select(QPoint pixel)
    {
        viewport().selectPixel(pixel);
        return complete();
    }
    bool show(const char* panel) { return cards().show(QLatin1String(panel)) && complete(); }

private Q_SLOTS:
    void pixelCardEqualsWhy();
    void pixelCardFollowsTheSettings();
    void pixelCardFollowsLanguageAndTheme();
    void pixelCardRowsAskForTheirStep();
    void thePanelsFollowTheFaceOfTheStep();
    void pixelCardIsEmptyWithoutAPixel();
    void mistakesChangeSettingsAndPicture();
    void mistakeOpensItsScene();
    void keyUnfoldsTheMistakes();
    void vertexModelIsSound();
    void vertexCellsEqualTheTable();
    void longValuesDoNotWidenTheCard();
    void badgeLeavesRoomForNames();
    void vertexEditsAreUndone();
    void largeScenesAreNotEdited();
    void handlesSnapToTheSubpixelGrid();
    void draggingOnTheCanvasIsOneUndoStep();
    void clipTheatreCounts();
    void clipTheatreShowsCuts();
    void clipTheatreShowsTheRegions();
    void boardHasTheNumbersOfTheTextbook();
    void curvesTakeTheEdge();
    void textsOfMarksStayInThePlots();
    void raceCountsInLockstep();
    void panelsAreHiddenAtFirstAndInTheMenu();
};

void TestCards::pixelCardEqualsWhy()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    for (const QPoint pixel : {QPoint(3, 4), QPoint(0, 0), QPoint(7, 7), QPoint(6, 1)}) {
        QVERIFY(select(pixel));
        const WhyReport report = why(*document().scene(), settings(), pixel.x(), pixel.y());
        const PixelCard& card = cards().pixelCard();
        QVERIFY(card.report());
        QVERIFY(toJson(*card.report()) == toJson(report));
        QCOMPARE(card.rows().size(), report.faces.size());
        const QString text = plain(card.asText());
        QVERIFY(text.contains(QStringLiteral("(%1, %2)").arg(pixel.x()).arg(pixel.y())));
        for (std::size_t i = 0; i < report.faces.size(); ++i) {
            const WhyFace& face = report.faces[i];
            const WhyWords& words = card.rows()[i];
            QCOMPARE(words.face, face.face);
            QCOMPARE(words.good, face.verdict == WhyVerdict::Written);
            const QString row = plain(words.verdict + QLatin1Char('\n') + words.details.join(QLatin1Char('\n')));
            for (const WhyEdge& edge : face.edges)
                QVERIFY2(row.contains(edge.name) && row.contains(edgeValueText(edge.value, face.unitsPerArea)),
                         qPrintable(row));
        }
    }
    // The diagonal: face 0 lost the tie that face 1 won.
    QVERIFY(select({3, 4}));
    QVERIFY(plain(cards().pixelCard().rows()[0].verdict).contains(QStringLiteral("lost the tie")));
    QVERIFY(plain(cards().pixelCard().asText()).contains(QStringLiteral("won the tie")));
}

void TestCards::pixelCardFollowsTheSettings()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(select({3, 4}));
    QCOMPARE(cards().pixelCard().report()->faces[0].verdict, WhyVerdict::LostTie);
    Settings next = settings();
    next.tieRule = TieRule::Inclusive;
    document().setSettings(next);
    QVERIFY(complete());
    QVERIFY(cards().pixelCard().report()->faces[0].verdict > WhyVerdict::LostTie);
}

void TestCards::pixelCardFollowsLanguageAndTheme()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(select({3, 4}));
    const QString english = cards().pixelCard().rows()[0].verdict;
    m_window->setLook({ThemeKind::Dark, false});
    m_window->setLanguage(LanguageKind::Chinese);
    QVERIFY(waitFor([&] { return cards().pixelCard().rows()[0].verdict != english; }));
    m_window->setLook({ThemeKind::Light, false});
    m_window->setLanguage(LanguageKind::English);
    QVERIFY(waitFor([&] { return cards().pixelCard().rows()[0].verdict == english; }));
}

void TestCards::pixelCardRowsAskForTheirStep()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(select({3, 4}));
    QSignalSpy asked(&cards(), &Cards::stepRequested);
    const auto rows = cards().pixelCard().findChildren<QFrame*>(QStringLiteral("whyRow"));
    QCOMPARE(rows.size(), 2);
    QTest::mouseClick(rows[1], Qt::LeftButton);
    QCOMPARE(asked.size(), 1);
    QCOMPARE(asked[0][0].toUInt(), cards().pixelCard().rows()[1].face);
    QCOMPARE(asked[0][1].toPoint(), QPoint(3, 4));
    QVERIFY(complete());
    const StepSession& session = m_window->stepMode().session();
    QVERIFY(session.isOpen());
    QVERIFY(session.event());
    QCOMPARE(session.event()->face, cards().pixelCard().rows()[1].face);
    QCOMPARE(session.event()->kind, StepKind::Sample);
    QCOMPARE(QPoint(session.event()->x, session.event()->y), QPoint(3, 4));
}

void TestCards::thePanelsFollowTheFaceOfTheStep()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(cards().show(QStringLiteral("vertices")));
    StepSession& session = m_window->stepMode().session();
    session.open();
    QVERIFY(complete());
    std::set<int> faces;
    for (std::size_t position = 1; position <= session.size(); ++position) {
        session.moveTo(position);
        if (session.event()->face == StepEvent::kNone)
            continue;
        faces.insert(int(session.event()->face));
        QCOMPARE(m_window->findChild<VertexPanel*>()->findChild<QSpinBox*>()->value(), int(session.event()->face));
    }
    QCOMPARE(faces.size(), 2U);
}

void TestCards::pixelCardIsEmptyWithoutAPixel()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(!cards().pixelCard().report());
    QVERIFY(select({1, 1}));
    QVERIFY(cards().pixelCard().report());
    viewport().selectPixel(std::nullopt);
    QVERIFY(complete());
    QVERIFY(!cards().pixelCard().report());
    QVERIFY(cards().pixelCard().asText().isEmpty());
}

void TestCards::mistakesChangeSettingsAndPicture()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    const QImage right = picture();
    MistakesSection& section = m_window->pipelinePanel().mistakes();
    for (const Mistake& mistake : mistakes()) {
        const QString id = QLatin1String(mistake.id);
        section.box(id)->setChecked(true);
        QCOMPARE(settings().mistakes, QStringList{id});
        QVERIFY(section.heading().contains(QLatin1String(mistake.number)));
        section.box(id)->setChecked(false);
        QVERIFY(settings().mistakes.isEmpty());
    }
    section.box(QStringLiteral("all-exclusive"))->setChecked(true);
    QVERIFY(complete());
    QVERIFY(picture() != right);
    QVERIFY(m_window->mistakeBadge().isVisible());
    QCOMPARE(m_window->mistakeBadge().lines().size(), 1);
    QVERIFY2(m_window->mistakeBadge().lines()[0].endsWith(QStringLiteral("holes 8")),
             qPrintable(m_window->mistakeBadge().lines()[0]));
    section.box(QStringLiteral("all-exclusive"))->setChecked(false);
    section.box(QStringLiteral("all-inclusive"))->setChecked(true);
    QVERIFY(complete());
    QVERIFY2(m_window->mistakeBadge().lines()[0].endsWith(QStringLiteral("hit twice 8")),
             qPrintable(m_window->mistakeBadge().lines()[0]));
    document().undo();
    document().undo();
    document().undo();
    QVERIFY(complete());
    QVERIFY(!section.box(QStringLiteral("all-inclusive"))->isChecked());
    QCOMPARE(picture(), right);
    QVERIFY(!m_window->mistakeBadge().isVisible());
}

void TestCards::mistakeOpensItsScene()
{
    document().openMistake(QStringLiteral("any-vertex-inside"));
    QVERIFY(complete());
    const Mistake& mistake = *findMistake(QStringLiteral("any-vertex-inside"));
    QCOMPARE(document().scene()->id, QStringLiteral("builtin:") + QLatin1String(mistake.scene));
    QVERIFY(settings() == mistakeDemo(mistake).mistaken);
    QVERIFY(m_window->mistakeBadge().isVisible());
}

void TestCards::keyUnfoldsTheMistakes()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    MistakesSection& section = m_window->pipelinePanel().mistakes();
    QVERIFY(!section.isOpen());
    QTest::keyClick(&viewport(), Qt::Key_M);
    QVERIFY(section.isOpen());
    QTest::keyClick(&viewport(), Qt::Key_M);
    QVERIFY(!section.isOpen());
}

void TestCards::vertexModelIsSound()
{
    FaceSelection selection;
    Document own;
    const VertexEditing editing;
    VertexTableModel model(own, selection, editing);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.refresh();
    own.setScene(std::make_shared<const Scene>(*makeBuiltinScene(QStringLiteral("cube")).scene));
    selection.setCount(12);
    model.refresh();
    selection.setFace(7);
    model.refresh();
    QCOMPARE(model.rowCount(), int(VertexTableModel::kRowCount));
    QCOMPARE(model.columnCount(), 3);
}

void TestCards::vertexCellsEqualTheTable()
{
    QVERIFY(open(QStringLiteral("builtin:tile-square")));
    QVERIFY(show("vertices"));
    cards().selection().setFace(1);
    QVERIFY(complete());
    const auto table = vertexTable(*document().scene(), settings(), 1);
    const VertexTableModel& model = cards().vertexPanel().model();
    const auto cell = [&](int row, int column) { return plain(model.index(row, column).data().toString()); };
    for (int i = 0; i < 3; ++i) {
        const VertexRow& corner = table[static_cast<std::size_t>(i)];
        QVERIFY(model.headerData(i, Qt::Horizontal, Qt::DisplayRole)
                    .toString()
                    .endsWith(QString::number(corner.meshVertex)));
        QVERIFY(cell(VertexTableModel::ClipSpace, i).endsWith(shortNumber(corner.clip.w)));
        QVERIFY(cell(VertexTableModel::ViewSpace, i).startsWith(shortNumber(corner.view.x)));
        QVERIFY(cell(VertexTableModel::SnappedSpace, i).startsWith(fullNumber(corner.snapped.x)));
        QCOMPARE(cell(VertexTableModel::DepthValue, i), shortNumber(corner.depth));
        const auto patch = model.index(VertexTableModel::VertexColor, i).data(Qt::DecorationRole).value<QIcon>();
        QCOMPARE(patch.pixmap(8, 8, QIcon::Selected).toImage(), patch.pixmap(8, 8).toImage()); // not tinted
    }
}

/// Values of many digits are rounded where they would widen the card; the list of edges has all digits.
void TestCards::longValuesDoNotWidenTheCard()
{
    QVERIFY(open(QStringLiteral("builtin:games101")));
    QVERIFY(show("why"));
    QVERIFY(select({350, 350}));
    const PixelCard& card = cards().pixelCard();
    const QString text = plain(card.asText()).replace(QChar(0xa0), QLatin1Char(' '));
    QVERIFY2(text.contains(QStringLiteral("E_CA \u2248 -5482.26")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("E_CA = -5482.2636566162109375")), qPrintable(text));
}

/// The picture is fitted below the badge, with room for the name of a corner at its border.
void TestCards::badgeLeavesRoomForNames()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(change([](Settings& s) {
        s.algorithm = Algorithm::EdgeWalking;
        s.mistakes = QStringList{QStringLiteral("whole-rows")};
    }));
    m_window->stepMode().showStep(QStringLiteral("span #3"));
    QVERIFY(complete());
    const QWidget& badge = m_window->mistakeBadge();
    QVERIFY(badge.isVisible());
    const int bottom = badge.mapTo(&viewport(), QPoint(0, badge.height())).y();
    const double name = 1.2 * QFontMetricsF(textFont(1, true)).height(); // above the corner it stands beside
    QVERIFY2(viewport().transform().toCanvas(QPointF(0, 0)).y() - name >= bottom, qPrintable(QString::number(bottom)));
}

void TestCards::vertexEditsAreUndone()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(show("vertices"));
    const QImage before = picture();
    const auto original = document().scene();
    VertexTableModel& model = cards().vertexPanel().model();
    const QModelIndex cell = model.index(VertexTableModel::ObjectSpace, 0);
    QVERIFY(cell.flags() & Qt::ItemIsEditable);
    QVERIFY(!model.setData(cell, QStringLiteral("a b c")));
    QVERIFY(!model.setData(cell, QStringLiteral("1 2")));
    QVERIFY(document().scene() == original);
    QVERIFY(model.setData(cell, QStringLiteral("0 0.5 0 1")));
    QVERIFY(complete());
    const std::uint32_t vertex = original->mesh.indices[0];
    QVERIFY(document().scene()->mesh.vertices[vertex].position == glm::vec4(0, 0.5F, 0, 1));
    QVERIFY(document().isDirty());
    QVERIFY(picture() != before);
    document().undo();
    QVERIFY(complete());
    QVERIFY(document().scene() == original);
    QCOMPARE(picture(), before);
    document().redo();
    QVERIFY(document().scene() != original);
}

void TestCards::largeScenesAreNotEdited()
{
    QVERIFY(open(QStringLiteral("builtin:cube")));
    QVERIFY(show("vertices"));
    VertexTableModel& model = cards().vertexPanel().model();
    const QModelIndex cell = model.index(VertexTableModel::ObjectSpace, 0);
    QVERIFY(!(cell.flags() & Qt::ItemIsEditable));
    QVERIFY(!model.setData(cell, QStringLiteral("0 0 0")));
    QVERIFY(!cards().vertexHandles().isVisible());
}

void TestCards::handlesSnapToTheSubpixelGrid()
{
    for (const char* name : {"builtin:square-diagonal", "builtin:tile-square"}) {
        QVERIFY(open(QLatin1String(name)));
        QVERIFY(show("vertices"));
        const std::uint32_t vertex = document().scene()->mesh.indices[1];
        VertexHandles& handles = cards().vertexHandles();
        const auto from = handles.screenOf(vertex);
        QVERIFY(from);
        const double w = vertexTable(*document().scene(), settings(), 0)[1].clip.w;
        handles.moveVertex(vertex, *from + QPointF(1.3001, -0.7003));
        QVERIFY(complete());
        const VertexRow moved = vertexTable(*document().scene(), settings(), 0)[1];
        const glm::dvec2 target = glm::round(glm::dvec2(from->x() + 1.3001, from->y() - 0.7003) * 256.0) / 256.0;
        QCOMPARE(moved.snapped.x, target.x);
        QCOMPARE(moved.snapped.y, target.y);
        QVERIFY(std::abs(moved.clip.w - w) < 1e-5 * w);
    }
}

void TestCards::draggingOnTheCanvasIsOneUndoStep()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(show("vertices"));
    const auto original = document().scene();
    const std::uint32_t vertex = original->mesh.indices[0];
    ViewportWidget& canvas = viewport();
    const auto at = [&](QPointF pixels) { return canvas.transform().toCanvas(pixels).toPoint(); };
    const QPointF from = *cards().vertexHandles().screenOf(vertex);
    QTest::mousePress(&canvas, Qt::LeftButton, {}, at(from));
    for (int i = 1; i <= 4; ++i)
        QTest::mouseMove(&canvas, at(from + QPointF(0.5, 0.5) * i));
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, at(from + QPointF(2, 2)));
    QVERIFY(complete());
    const QPointF to = *cards().vertexHandles().screenOf(vertex);
    QVERIFY(std::hypot(to.x() - from.x() - 2, to.y() - from.y() - 2) < 0.1);
    QVERIFY(document().scene() != original);
    document().undo();
    QVERIFY(document().scene() == original);
    QVERIFY(!document().canUndo());
}

void TestCards::clipTheatreCounts()
{
    QVERIFY(openText(kTwoCuts));
    QVERIFY(show("clip"));
    ClipTheatre& theatre = cards().clipTheatre();
    QVERIFY(theatre.story());
    QCOMPARE(theatre.story()->counts(), (std::vector<int>{3, 4, 5}));
    QCOMPARE(theatre.story()->pieces, 3);
    QVERIFY(theatre.summary().startsWith(QStringLiteral("3 \u2192 4 \u2192 5")));
    QVERIFY(theatre.planeButton(ClipPlane::Right)->isEnabled());
    QVERIFY(theatre.planeButton(ClipPlane::Top)->isEnabled());
    for (const ClipPlane plane : {ClipPlane::W, ClipPlane::Left, ClipPlane::Bottom, ClipPlane::Near, ClipPlane::Far})
        QVERIFY(!theatre.planeButton(plane)->isEnabled());
    QVERIFY(theatre.planeButton(ClipPlane::Right)->text().endsWith(QLatin1Char('4')));
    QVERIFY(theatre.planeButton(ClipPlane::Top)->text().endsWith(QLatin1Char('5')));

    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(theatre.story()->steps.empty());
    QCOMPARE(theatre.story()->counts(), std::vector<int>{3});
}

void TestCards::clipTheatreShowsCuts()
{
    QVERIFY(openText(kTwoCuts));
    QVERIFY(show("clip"));
    ClipTheatre& theatre = cards().clipTheatre();
    theatre.planeButton(ClipPlane::Right)->click();
    QCOMPARE(theatre.stage(), std::size_t(1));
    const QStringList cuts = theatre.cuts();
    QCOMPARE(cuts.size(), 2);
    // From A (-0.5) to B (2): x = w at t = 1.5 / 2.5.
    QVERIFY2(cuts.join(QLatin1Char('\n')).contains(QStringLiteral("A \u2192 B  t = 0.6000")),
             qPrintable(cuts.join(QLatin1Char('\n'))));
    // From C (-0.5, 2) to B (2, -0.5): x = w at t = 1.5 / 2.5.
    QVERIFY(cuts.join(QLatin1Char('\n')).contains(QStringLiteral("C \u2192 B  t = 0.6000")));
    theatre.setStage(0);
    QCOMPARE(theatre.cuts().size(), 3);
}

void TestCards::clipTheatreShowsTheRegions()
{
    QVERIFY(openText(kTwoCuts));
    QVERIFY(show("clip"));
    Settings next = settings();
    next.clipping = Clipping::CohenSutherland;
    document().setSettings(next);
    QVERIFY(complete());
    ClipTheatre& theatre = cards().clipTheatre();
    QVERIFY(theatre.story()->regions);
    const QString text = theatre.cuts().join(QLatin1Char('\n'));
    QVERIFY2(text.contains(QStringLiteral("A  outcode 0000")) && text.contains(QStringLiteral("B  outcode 0010")) &&
                 text.contains(QStringLiteral("C  outcode 1000")),
             qPrintable(text));
}

void TestCards::boardHasTheNumbersOfTheTextbook()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(show("curves"));
    CurvesPanel& curves = cards().curvesPanel();
    curves.edgeBox()->setCurrentIndex(3);
    QCOMPARE(curves.boardText(0, 0), QStringLiteral("0.8938"));
    QCOMPARE(curves.boardText(0, 1), QStringLiteral("0.8938"));
    QCOMPARE(curves.boardText(0, 3), QStringLiteral("0.8200"));
    QCOMPARE(curves.boardText(1, 0), QStringLiteral("1.8182"));
    QCOMPARE(curves.boardText(1, 1), QStringLiteral("5.5000"));
    QCOMPARE(curves.boardText(1, 3), QStringLiteral("1.8182"));
    QCOMPARE(plain(curves.boardText(0, 4)), QStringLiteral("-0.0738"));
    curves.slider()->setValue(0);
    QCOMPARE(curves.boardText(1, 0), QStringLiteral("1.0000"));
}

void TestCards::textsOfMarksStayInThePlots()
{
    QVERIFY(open(QStringLiteral("builtin:cube")));
    CurvesPanel& curves = cards().curvesPanel();
    curves.edgeBox()->setCurrentIndex(3);
    for (const bool presentation : {false, true}) {
        m_window->setPresentation(presentation); // which puts the panels away
        QVERIFY(show("curves"));
        for (const int place : {0, 20, 300, 500, 700, 980, 1000}) {
            curves.slider()->setValue(place);
            QCoreApplication::processEvents();
            for (const CurvePlot* plot : {&curves.correctionPlot(), &curves.squeezePlot()}) {
                const QRectF text = plot->markTextBox();
                QVERIFY(text.width() > 20 && text.height() > 8);
                QVERIFY2(
                    plot->area().contains(text),
                    qPrintable(QStringLiteral(
                                   "stage %10, panel %11, m = %1, text %2 x %3 at (%4, %5), area %6 x %7 at (%8, %9)")
                                   .arg(place / 1000.0)
                                   .arg(text.width())
                                   .arg(text.height())
                                   .arg(text.x())
                                   .arg(text.y())
                                   .arg(plot->area().width())
                                   .arg(plot->area().height())
                                   .arg(plot->area().x())
                                   .arg(plot->area().y())
                                   .arg(presentation)
                                   .arg(curves.width())));
            }
        }
    }
}

void TestCards::curvesTakeTheEdge()
{
    QVERIFY(open(QStringLiteral("builtin:four-z")));
    QVERIFY(show("curves"));
    const auto corners = vertexTable(*document().scene(), settings(), 0);
    const CurvesPanel& curves = cards().curvesPanel();
    QVERIFY2(std::max(curves.input().z1, curves.input().z2) > 1.5 * std::min(curves.input().z1, curves.input().z2),
             "an edge with something to correct is shown first");
    for (int edge = 0; edge < 3; ++edge) {
        curves.edgeBox()->setCurrentIndex(edge);
        QVERIFY(curves.input().ofEdge);
        QCOMPARE(curves.input().z1, corners[static_cast<std::size_t>(edge)].clip.w);
        QCOMPARE(curves.input().z2, corners[static_cast<std::size_t>((edge + 1) % 3)].clip.w);
    }
}

void TestCards::raceCountsInLockstep()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(show("race"));
    RacePanel& panel = cards().racePanel();
    const AlgorithmRace race = raceAlgorithms(*document().scene(), settings(), 0);
    QVERIFY(panel.race());
    QVERIFY(!panel.isPlaying());
    QCOMPARE(panel.tick(), panel.ticks());
    QVERIFY(panel.counts(Algorithm::EdgeEquation) == race.equation.total);
    QVERIFY(panel.counts(Algorithm::EdgeWalking) == race.walking.total);
    for (std::size_t tick = 0; tick <= panel.ticks(); ++tick) {
        panel.setTick(tick);
        QCOMPARE(panel.counts(Algorithm::EdgeEquation).candidates,
                 std::uint64_t(std::min(tick, race.equation.ticks.size())));
        QCOMPARE(panel.counts(Algorithm::EdgeWalking).candidates,
                 std::uint64_t(std::min(tick, race.walking.ticks.size())));
    }
    panel.setPlaying(true);
    QCOMPARE(panel.tick(), std::size_t(0));
    QVERIFY(waitFor([&] { return panel.tick() > 0; }));
    panel.setPlaying(false);
}

void TestCards::panelsAreHiddenAtFirstAndInTheMenu()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    for (const QString& name : Cards::names()) {
        auto* dock = m_window->findChild<QDockWidget*>(name + QStringLiteral("Dock"));
        QVERIFY(dock);
        QCOMPARE(dock->isVisible(), name == QLatin1String("why"));
        QVERIFY(!dock->toggleViewAction()->text().isEmpty());
        QVERIFY(cards().show(name));
        QVERIFY(complete());
        QVERIFY(dock->isVisible());
    }
    m_window->resetLayout();
    QVERIFY(!m_window->findChild<QDockWidget*>(QStringLiteral("raceDock"))->isVisible());
    QVERIFY(m_window->findChild<QDockWidget*>(QStringLiteral("whyDock"))->isVisible());
}

QTEST_MAIN(TestCards)
#include "test_cards.moc"
