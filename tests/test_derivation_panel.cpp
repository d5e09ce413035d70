// The panel of derivations: lines, symbols and figures, and what of them is lit over the picture.
#include "core/scenes/builtin_scenes.h"
#include "tests/window_fixture.h"
#include "ui/face/cards.h"
#include "ui/face/derivation_panel.h"
#include "ui/face/figure_view.h"

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

QTEST_MAIN(TestDerivationPanel)
#include "test_derivation_panel.moc"
