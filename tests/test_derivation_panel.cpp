// The panel of derivations: lines, symbols and figures, and what of them is lit over the picture.
#include "core/observe/names.h"
#include "core/scenes/builtin_scenes.h"
#include "tests/window_fixture.h"
#include "ui/face/cards.h"
#include "ui/face/derivation_panel.h"
#include "ui/face/figure_view.h"
#include "ui/steps/step_listing.h"

#include <QComboBox>
#include <QSlider>
#include <QTextBrowser>

using namespace rasterlens;
using namespace rasterlens::test;

class TestDerivationPanel : public WindowFixture
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
    void topicsAreThoseOfCore();
    void linesAndSymbolsLightTheFigure();
    void symbolsAreFoundInThePicture();
    void figuresFollowTheSliders();
    void firstEdgeIsTheMostUnequal();
    void namesStandBesideTheirPoints();
    void pointsAreNamedOverThePicture();
    void everyLineHasAFigure();
    void theStepIsFollowed();
};

/// Every topic, at the selected pixel: the text of the panel holds what core derives, or says why there is nothing.
void TestDerivationPanel::topicsAreThoseOfCore()
{
    QVERIFY(open(QStringLiteral("builtin:triangle-600")));
    QVERIFY(select({250, 400}));
    QVERIFY(show("derive"));
    DerivationPanel& panel = cards().derivationPanel();
    for (const DerivationTopicInfo& info : derivationTopics()) {
        panel.setTopic(info.topic);
        QVERIFY(complete());
        const Derived expected = derive(info.topic, *document().scene(), settings(), {0, QPoint(250, 400), 0, 0.5, {}});
        QVERIFY(panel.derived());
        QCOMPARE(panel.derived()->derivation.has_value(), expected.derivation.has_value());
        if (!expected.derivation) {
            QVERIFY(!textOf(expected.refusal).isEmpty());
            continue;
        }
        const QString shown = panel.view()->toPlainText();
        for (const DerivationLine& line : expected.derivation->lines) {
            QVERIFY2(shown.contains(textOf(line.numbers)), qPrintable(textOf(line.numbers)));
            QVERIFY2(shown.contains(textOf(line.words)), qPrintable(textOf(line.words)));
        }
    }
}

/// The arrows go from line to line, whose marks are drawn; a symbol under the mouse changes the picture too.
void TestDerivationPanel::linesAndSymbolsLightTheFigure()
{
    QVERIFY(open(QStringLiteral("builtin:triangle-600")));
    QVERIFY(select({250, 400}));
    QVERIFY(show("derive"));
    DerivationPanel& panel = cards().derivationPanel();
    panel.setTopic(DerivationTopic::EdgeFunction);
    QVERIFY(complete());
    QCOMPARE(panel.line(), std::size_t(0));
    const auto& derivation = *panel.derived()->derivation;
    QVERIFY(derivation.lines.size() > 2);
    QTest::keyClick(panel.view(), Qt::Key_Down);
    QCOMPARE(panel.line(), std::size_t(1));
    QTest::keyClick(panel.view(), Qt::Key_Up);
    QTest::keyClick(panel.view(), Qt::Key_Up);
    QCOMPARE(panel.line(), std::size_t(0));
    const auto drawnSymbol = std::ranges::find_if(
        derivation.symbols, [](const DerivationSymbol& symbol) { return symbol.canvas.points.size() == 2; });
    QVERIFY(drawnSymbol != derivation.symbols.end());
    const QImage before = viewport().grab().toImage();
    panel.hoverSymbol(std::size_t(drawnSymbol - derivation.symbols.begin()));
    QVERIFY(viewport().grab().toImage() != before);
    panel.hoverSymbol(std::nullopt);
    QVERIFY(viewport().grab().toImage() == before);
}

/// A symbol is lit in both directions: from the formulas and from the picture.
void TestDerivationPanel::symbolsAreFoundInThePicture()
{
    QVERIFY(open(QStringLiteral("builtin:triangle-600")));
    QVERIFY(select({250, 400}));
    QVERIFY(show("derive"));
    DerivationPanel& panel = cards().derivationPanel();
    panel.setTopic(DerivationTopic::EdgeFunction);
    panel.edgeBox()->setCurrentIndex(2); // AC, as it leads counter-clockwise
    QVERIFY(complete());
    const auto& derivation = *panel.derived()->derivation;
    const auto idAt = [&](QPointF point) {
        const auto symbol = panel.symbolAt(point, 4);
        return symbol ? derivation.symbols[*symbol].id : QString();
    };
    QCOMPARE(idAt({100, 400}), QStringLiteral("A_x")); // the corner, not the edge that begins there
    QCOMPARE(idAt({200, 434}), QStringLiteral("AC_x"));
    QCOMPARE(idAt({20, 20}), QString());
    // The mouse over the edge AC on the canvas, one that the present line speaks of.
    QCOMPARE(panel.view()->extraSelections().isEmpty(), false); // hues of edges
    const qsizetype plain = panel.view()->extraSelections().size();
    QTest::mouseMove(&viewport(), viewport().transform().toCanvas(QPointF(100, 400)).toPoint());
    QVERIFY(waitFor([&] { return panel.hovered().has_value(); }));
    QCOMPARE(derivation.symbols[*panel.hovered()].id, QStringLiteral("A_x"));
    QVERIFY(panel.view()->extraSelections().size() > plain);
    QTest::mouseMove(&viewport(), viewport().transform().toCanvas(QPointF(20, 20)).toPoint());
    QVERIFY(waitFor([&] { return !panel.hovered(); }));
    QCOMPARE(panel.view()->extraSelections().size(), plain);
}

/// The figures beside the formulas: the slider moves the point, and what is under the mouse is lit in the formulas.
void TestDerivationPanel::figuresFollowTheSliders()
{
    QVERIFY(open(QStringLiteral("builtin:four-z")));
    QVERIFY(show("derive"));
    DerivationPanel& panel = cards().derivationPanel();
    panel.setTopic(DerivationTopic::EdgeFunction);
    QVERIFY(complete());
    QVERIFY(!panel.mSlider()->isVisible() && !panel.figures().front()->isVisible());
    panel.setTopic(DerivationTopic::Perspective);
    QVERIFY(complete());
    QVERIFY(panel.mSlider()->isVisible() && panel.figures()[0]->isVisible() && panel.figures()[1]->isVisible());
    const auto value = [&](const char* id) { return panel.derived()->derivation->find(id)->value; };
    QCOMPARE(value("m"), 0.5);
    const QImage before = panel.figures().front()->grab().toImage();
    const glm::dvec2 seen = panel.derived()->derivation->symbols[0].canvas.points.front();
    panel.mSlider()->setValue(250);
    QVERIFY(complete());
    QCOMPARE(value("m"), 0.25);
    QVERIFY(panel.figures().front()->grab().toImage() != before);
    QVERIFY(panel.derived()->derivation->symbols[0].canvas.points.front() != seen);
    // What is seen of the far end, in the figure from the side
    FigureView& figure = *panel.figures().front();
    const QString seenEnd = QStringLiteral("BCA").mid(*panel.derived()->edge, 1) + QLatin1Char('\'');
    const QPoint at = figure.toWidget({1, value(qPrintable(seenEnd))}).toPoint();
    QTest::mouseMove(&figure, at);
    QVERIFY(waitFor([&] { return panel.hovered().has_value(); }));
    QCOMPARE(panel.derived()->derivation->symbols[*panel.hovered()].id, seenEnd);
    panel.setTopic(DerivationTopic::DepthCurve);
    QVERIFY(complete());
    QVERIFY(panel.depthSlider()->isVisible() && panel.edgeBox()->isVisible());
    QVERIFY(panel.depthSlider()->parentWidget()->width() >= panel.depthSlider()->geometry().right());
    panel.setTopic(DerivationTopic::Painter);
    QVERIFY(complete());
    QVERIFY2(!panel.edgeBox()->isVisible(), "a topic without an edge asks for none");
    panel.setTopic(DerivationTopic::DepthCurve);
    QVERIFY(complete());
    const double middle = value("z");
    panel.depthSlider()->setValue(750);
    QVERIFY(complete());
    QVERIFY(std::abs(value("z") - (value("n") + 0.75 * (value("f") - value("n")))) < 1e-9);
    QVERIFY(value("z") > middle);
}

/// Perspective is shown along an edge that has some, until the user chooses another one.
void TestDerivationPanel::firstEdgeIsTheMostUnequal()
{
    QVERIFY(open(QStringLiteral("builtin:tile-square"))); // AB lies straight before the eye
    QVERIFY(show("derive"));
    DerivationPanel& panel = cards().derivationPanel();
    panel.edgeBox()->setCurrentIndex(2); // the user's choice
    panel.setTopic(DerivationTopic::Perspective);
    QVERIFY(complete());
    QCOMPARE(panel.edge(), std::optional(2));
    const auto value = [&](const char* id) { return panel.derived()->derivation->find(id)->value; };
    QVERIFY(std::abs(value("Z1") - value("Z2")) > 1);
    FaceSelection selection;
    DerivationPanel fresh(selection);
    QCOMPARE(fresh.edge(), std::optional<int>());
    const Derived derived = derive(DerivationTopic::Perspective, *document().scene(), settings(), {});
    fresh.setDerived(std::make_shared<const Derived>(derived));
    QVERIFY(derived.edge && *derived.edge > 0);
    QCOMPARE(fresh.edgeBox()->currentIndex(), *derived.edge);
    QCOMPARE(fresh.edge(), std::optional<int>());
    fresh.edgeBox()->setCurrentIndex(0);
    QCOMPARE(fresh.edge(), std::optional(0));
}

/// The names in a figure: none over another, and none nearer to another point than to its own.
void TestDerivationPanel::namesStandBesideTheirPoints()
{
    const auto away = [](const QRectF& box, QPointF point) {
        const QPointF nearest(std::clamp(point.x(), box.left(), box.right()),
                              std::clamp(point.y(), box.top(), box.bottom()));
        return QLineF(point, nearest).length();
    };
    QVERIFY(open(QStringLiteral("builtin:tile-square")));
    QVERIFY(show("derive"));
    DerivationPanel& panel = cards().derivationPanel();
    for (const DerivationTopic topic : {DerivationTopic::Perspective, DerivationTopic::DepthCurve}) {
        panel.setTopic(topic);
        QVERIFY(complete());
        for (std::size_t k = 0; k < panel.derived()->derivation->figures.size(); ++k) {
            const FigureView& view = *panel.figures()[k];
            const DerivationFigure& figure = panel.derived()->derivation->figures[k];
            const std::vector<FigureName> names = view.names();
            QVERIFY(names.size() >= 4);
            for (const FigureName& name : names) {
                QVERIFY2(view.rect().toRectF().contains(name.box), qPrintable(name.name));
                for (const FigureName& other : names)
                    QVERIFY2(&other == &name || !other.box.intersects(name.box), qPrintable(name.name));
                const bool isOfPoint = std::ranges::any_of(figure.points, [&](const FigurePoint& point) {
                    return point.name == name.name && view.toWidget(point.at) == name.at;
                });
                if (!isOfPoint)
                    continue;                     // a stroke is long: its name is near the ends of others
                constexpr double kAlmostOne = 12; // points so near to one another share their names' place
                for (const FigurePoint& point : figure.points)
                    QVERIFY2(QLineF(view.toWidget(point.at), name.at).length() < kAlmostOne ||
                                 away(name.box, view.toWidget(point.at)) >= away(name.box, name.at),
                             qPrintable(name.name + QLatin1Char(' ') + point.name));
            }
        }
    }
}

/// The ends of a vector have their names over the picture. While steps name the corners the derivation does not.
void TestDerivationPanel::pointsAreNamedOverThePicture()
{
    QVERIFY(open(QStringLiteral("builtin:triangle-600")));
    QVERIFY(select({250, 350}));
    QVERIFY(show("derive"));
    DerivationPanel& panel = cards().derivationPanel();
    panel.setTopic(DerivationTopic::EdgeFunction);
    QVERIFY(complete());
    const auto named = [&] {
        QStringList names;
        for (const NamedPlace& place : panel.layer().names())
            names << QStringLiteral("%1 (%2, %3)").arg(place.name).arg(place.at.x()).arg(place.at.y());
        names.sort();
        return names.join(QStringLiteral(", "));
    };
    QCOMPARE(named(), QStringLiteral("A (100, 400), B (300, 200)"));
    panel.setLine(1);
    QCOMPARE(named(), QStringLiteral("B (300, 200), P (250.5, 350.5)"));
    m_window->stepMode().showStep(QStringLiteral("setup"));
    QVERIFY(complete());
    QCOMPARE(named(), QStringLiteral("P (250.5, 350.5)"));
}

/// A line without marks of its own shows what its symbols are in the picture; the light has its vectors.
void TestDerivationPanel::everyLineHasAFigure()
{
    QVERIFY(open(QStringLiteral("builtin:triangle-600")));
    QVERIFY(show("derive"));
    DerivationPanel& panel = cards().derivationPanel();
    panel.setTopic(DerivationTopic::Bounds);
    QVERIFY(complete());
    QVERIFY(panel.derived()->derivation->lines.front().marks.empty());
    QVERIFY(!panel.layer().marks().empty());
    QVERIFY(open(QStringLiteral("builtin:cube")));
    panel.setTopic(DerivationTopic::FlatLight);
    QVERIFY(complete());
    const auto& lines = panel.derived()->derivation->lines;
    const auto both = std::ranges::find_if(lines, [](const DerivationLine& line) { return line.marks.size() == 2; });
    QVERIFY(both != lines.end());
    const CanvasPart& normal = both->marks[0];
    const CanvasPart& light = both->marks[1];
    QVERIFY(normal.kind == CanvasKind::Vector && light.kind == CanvasKind::Vector);
    QVERIFY(normal.points.front() == light.points.front());
    const double longest =
        std::max(glm::distance(normal.points[0], normal.points[1]), glm::distance(light.points[0], light.points[1]));
    QVERIFY(std::abs(longest - 0.2 * settings().size.height()) < 0.01);
}

/// Without a selected pixel the numbers are those of the step: of its pixel, its edge, its plane.
void TestDerivationPanel::theStepIsFollowed()
{
    QVERIFY(open(QStringLiteral("builtin:lines")));
    QVERIFY(show("derive"));
    DerivationPanel& panel = cards().derivationPanel();
    panel.setTopic(DerivationTopic::Bresenham);
    QVERIFY(complete());
    QCOMPARE(panel.derived()->edge, std::optional(0));
    StepMode& steps = m_window->stepMode();
    steps.showStep(QStringLiteral("line-decision #50"));
    QVERIFY(complete());
    const StepEvent event = *steps.session().event();
    QCOMPARE(event.kind, StepKind::LineDecision);
    QCOMPARE(panel.derived()->edge, std::optional(2));
    const Derived there =
        derive(DerivationTopic::Bresenham, *document().scene(), settings(), {0, QPoint(event.x, event.y), 2, 0.5, {}});
    QVERIFY(there.derivation);
    QCOMPARE(textOf(*panel.derived()->derivation), textOf(*there.derivation));
    panel.edgeBox()->setCurrentIndex(1); // the user's choice holds until a step of another edge
    QVERIFY(complete());
    QCOMPARE(panel.derived()->edge, std::optional(1));
    steps.showStep(QStringLiteral("line-decision #2"));
    QVERIFY(complete());
    QCOMPARE(panel.derived()->edge, std::optional(0));

    QVERIFY(openSmall(QStringLiteral("builtin:behind-camera")));
    panel.setTopic(DerivationTopic::Cut);
    steps.showStep(QStringLiteral("clip-plane"));
    QVERIFY(complete());
    const StepEvent cut = *steps.session().event();
    QCOMPARE(cut.kind, StepKind::ClipPlane);
    const QString sign = QLatin1String(infoOf(steps.session().log()->payload<ClipStep>(cut).plane).sign);
    const QString formula = steps.listing().explanation().formula;
    QVERIFY2(formula.contains(QStringLiteral("right, x \u2264 w")), qPrintable(formula));
    QVERIFY2(formula.contains(QStringLiteral("A\u2192B t=")), qPrintable(formula));
    const DerivationLine& line = panel.derived()->derivation->lines[panel.line()];
    QCOMPARE(textOf(line.left), QString(QStringLiteral("t_") + sign).replace(QLatin1Char('-'), QChar(0x2212)));
}

QTEST_MAIN(TestDerivationPanel)
#include "test_derivation_panel.moc"
