#include "core/derive/parallel.h"
#include "core/derive/place_edge.h"
#include "core/derive/topic_list.h"

#include <QCoreApplication>

#include <algorithm>

namespace rasterlens
{
namespace
{

/// Z1 / Z2 of the edges that n(m) is compared for.
constexpr const char* kRatios[] = {"0.25", "0.5", "1", "2", "4", "10"};

/// Writes the way from weights on the screen to weights in space: along an edge seen from the side, and over the face.
class PerspectiveWriter
{
public:
    PerspectiveWriter(const FaceRecord& record, const SampledTriangle& sample, const FragmentStep& fragment)
        : m_record(record), m_sample(sample), m_fragment(fragment), m_edge(record),
          m_writer(DerivationTopic::Perspective, pixelReason(record, sample))
    {
        m_edge.giveSideView(m_writer, QStringLiteral("Z"));
    }

    Derivation write()
    {
        writeSideView();
        writeFraction();
        writeCurve();
        writeFace();
        drawSideView();
        drawCurves();
        return m_writer.take();
    }

private:
    void writeSideView()
    {
        m_writer.line(m_edge.named("({%1'}, {%2'})"), formula("({X1} / {Z1}, {X2} / {Z2})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "From the side: the eye at 0, the screen at distance 1, the ends of the "
                                        "edge at height X and distance Z (the w of clip space). A ray to the eye "
                                        "meets the screen at X / Z."),
                      {m_edge.startPart(), m_edge.endPart()});
        m_writer.line(formula("{P'}"), m_edge.named("(1 - {m}) * {%1'} + {m} * {%2'}"),
                      QT_TRANSLATE_NOOP("Derive", "The point at the part m of the way on the screen."),
                      {m_edge.seenPart(), m_edge.part()});
        m_writer.line(
            m_edge.named("({%1G}, {%2K})"), m_edge.named("(({P'} - {%1'}) * {Z1}, ({%2'} - {P'}) * {Z2})"),
            {QT_TRANSLATE_NOOP("Derive", "Parallels to the screen through the ends, up to the ray of P: what is seen "
                                         "as P'%1' and P'%2' is Z1 and Z2 times as long there."),
             {m_edge.startName(), m_edge.endName()}},
            {m_edge.part()});
        m_writer.line(
            formula("{n_ratio}"), formula("{m} * {Z1} / ((1 - {m}) * {Z2})"),
            {QT_TRANSLATE_NOOP("Derive", "The two triangles along the ray are similar, so n / (1 - n) = %1G / %2K: P "
                                         "divides the edge in space in this ratio. The size of the screen cancels "
                                         "out."),
             {m_edge.startName(), m_edge.endName()}},
            {m_edge.part()});
        if (m_writer.valueOf(m_edge.named("%2K")) != 0)
            m_writer.line(formula("{n_ratio}"), m_edge.named("{%1G} / {%2K}"),
                          QT_TRANSLATE_NOOP("Derive", "The same from the lengths."), {m_edge.part()});
    }

    void writeFraction()
    {
        m_writer.line(formula("{n}"), formula("{m} * {Z1} / ((1 - {m}) * {Z2} + {m} * {Z1})"),
                      QT_TRANSLATE_NOOP("Derive", "Solved for n: the part of the way in space."), {m_edge.part()});
        m_writer.line(formula("{n_ratio}"), formula("{n} / (1 - {n})"), QT_TRANSLATE_NOOP("Derive", "Put in again."),
                      {m_edge.part()});
        const bool areEqual = m_writer.valueOf(QStringLiteral("Z1")) == m_writer.valueOf(QStringLiteral("Z2"));
        m_writer.line(formula("{n_swapped}"), formula("{m} * {Z2} / ((1 - {m}) * {Z1} + {m} * {Z2})"),
                      areEqual ? QT_TRANSLATE_NOOP("Derive", "Z1 and Z2 exchanged, a mistake often seen: with both "
                                                             "equal nothing shows it.")
                               : QT_TRANSLATE_NOOP("Derive", "With Z1 and Z2 exchanged, a mistake often seen, the "
                                                             "near end weighs too little."),
                      {m_edge.part()});
        m_writer.line(formula("{Zn}"), formula("(1 - {n}) * {Z1} + {n} * {Z2}"),
                      QT_TRANSLATE_NOOP("Derive", "The distance of P: linear in n."), {m_edge.part()});
        m_writer.line(formula("{Zn}"), formula("{Z1} * {Z2} / ((1 - {m}) * {Z2} + {m} * {Z1})"),
                      QT_TRANSLATE_NOOP("Derive", "With n put in."), {m_edge.part()});
        m_writer.line(formula("{Zn}"), formula("1 / ((1 - {m}) / {Z1} + {m} / {Z2})"),
                      QT_TRANSLATE_NOOP("Derive", "Divided by Z1 Z2: 1 / Z is linear on the screen."), {m_edge.part()});
        m_writer.line(formula("{P'}"), formula("((1 - {n}) * {X1} + {n} * {X2}) / {Zn}"),
                      QT_TRANSLATE_NOOP("Derive", "The point of the edge at n is seen at P' indeed."),
                      {m_edge.seenPart()});
    }

    /// n(m) of several edges: the steeper they lead away from the eye, the further from the diagonal.
    void writeCurve()
    {
        for (const char* ratio : kRatios) {
            const QString k = QLatin1String(ratio);
            m_writer.given(QStringLiteral("k_") + k, k.toDouble());
            m_writer.line(
                formula("{n_%1}", k), formula("{m} * {k_%1} / ((1 - {m}) + {m} * {k_%1})", k),
                {QT_TRANSLATE_NOOP("Derive", "n at this m where Z1 / Z2 is %1; it is m where both are equal."), {k}},
                {m_edge.seenPart()});
        }
    }

    /// The edge from the side: the eye, the screen, the ends and what is seen of them, and the parallels to the screen.
    void drawSideView()
    {
        const auto value = [&](const char* id) { return m_writer.valueOf(QLatin1String(id)); };
        const auto symbol = [&](const char* id) { return m_writer.indexOf(QLatin1String(id)); };
        using enum FigureStroke::Look;
        const glm::dvec2 eye(0, 0);
        const glm::dvec2 a(value("Z1"), value("X1"));
        const glm::dvec2 b(value("Z2"), value("X2"));
        const glm::dvec2 p = a + value("n") * (b - a);
        const glm::dvec2 seenA(1, m_writer.valueOf(m_edge.startSeen()));
        const glm::dvec2 seenB(1, m_writer.valueOf(m_edge.endSeen()));
        const glm::dvec2 seenP(1, value("P'"));
        const glm::dvec2 g(a.x, value("P'") * a.x);
        const glm::dvec2 k(b.x, value("P'") * b.x);
        const glm::dvec2 far = eye + std::max({a.x, b.x, 1.0}) * seenP;
        DerivationFigure figure;
        figure.title = QT_TRANSLATE_NOOP("Derive", "From the side: eye O, screen at 1");
        figure.xName = QStringLiteral("Z");
        figure.yName = QStringLiteral("X");
        figure.low = glm::min(glm::min(eye, glm::min(a, b)), glm::min(glm::min(g, k), glm::min(seenA, seenB)));
        figure.high =
            glm::max(glm::max(glm::dvec2(1, 0), glm::max(a, b)), glm::max(glm::max(g, k), glm::max(seenA, seenB)));
        figure.strokes = {
            {{{1, figure.low.y}, {1, figure.high.y}}, QString(), Solid, -1},
            {{eye, a.x < 1 ? seenA : a}, QString(), Dashed, m_writer.indexOf(m_edge.startSeen())},
            {{eye, b.x < 1 ? seenB : b}, QString(), Dashed, m_writer.indexOf(m_edge.endSeen())},
            {{eye, far}, QString(), Dashed, symbol("P'")},
            {{a, b}, QString(), Solid, -1},
            {{a, p}, QStringLiteral("n"), Solid, symbol("n")},
            {{a, g}, QString(), Solid, m_writer.indexOf(m_edge.named("%1G"))},
            {{b, k}, QString(), Solid, m_writer.indexOf(m_edge.named("%2K"))},
            {{seenA, seenB}, QString(), Solid, -1},
            {{seenA, seenP}, QStringLiteral("m"), Solid, symbol("m")},
        };
        figure.points = {{eye, QStringLiteral("O"), -1},
                         {a, m_edge.startName(), symbol("X1")},
                         {b, m_edge.endName(), symbol("X2")},
                         {p, QStringLiteral("P"), symbol("Zn")},
                         {g, QStringLiteral("G"), m_writer.indexOf(m_edge.named("%1G"))},
                         {k, QStringLiteral("K"), m_writer.indexOf(m_edge.named("%2K"))},
                         {seenA, m_edge.startSeen(), m_writer.indexOf(m_edge.startSeen())},
                         {seenB, m_edge.endSeen(), m_writer.indexOf(m_edge.endSeen())},
                         {seenP, QStringLiteral("P'"), symbol("P'")}};
        m_writer.figure(std::move(figure));
    }

    /// n(m) for several Z1 / Z2 at once, and for the edge's own; each curve has its point at m.
    void drawCurves()
    {
        constexpr int kPieces = 48;
        const double m = m_record.place().m;
        const auto curve = [](double ratio) {
            std::vector<glm::dvec2> points;
            for (int i = 0; i <= kPieces; ++i) {
                const double x = double(i) / kPieces;
                points.emplace_back(x, x * ratio / (1 - x + x * ratio));
            }
            return points;
        };
        DerivationFigure figure;
        figure.title = QT_TRANSLATE_NOOP("Derive", "n(m) for Z1 / Z2; solid: this edge");
        figure.xName = QStringLiteral("m");
        figure.yName = QStringLiteral("n");
        for (const char* ratio : kRatios) {
            const QString k = QLatin1String(ratio);
            const int symbol = m_writer.indexOf(QStringLiteral("n_") + k);
            figure.strokes.push_back({curve(k.toDouble()), k, FigureStroke::Look::Dashed, symbol});
            figure.points.push_back({{m, m_writer.valueOf(QStringLiteral("n_") + k)}, QString(), symbol});
        }
        const double own = m_writer.valueOf(QStringLiteral("Z1")) / m_writer.valueOf(QStringLiteral("Z2"));
        const int n = m_writer.indexOf(QStringLiteral("n"));
        figure.strokes.push_back({curve(own), QString(), FigureStroke::Look::Solid, n});
        figure.points.push_back({{m, m_writer.valueOf(QStringLiteral("n"))}, QStringLiteral("n"), n});
        m_writer.figure(std::move(figure));
    }

    /// From weights on the screen to weights in space at the sample, and back.
    void writeFace()
    {
        const auto& corners = m_sample.triangle->screen.vertices;
        const CanvasPart point{CanvasKind::Sample, QStringLiteral("P"), {m_record.pixels(m_sample.point)}};
        constexpr const char* kNames[] = {"alpha", "beta", "gamma"};
        for (std::size_t i = 0; i < 3; ++i) {
            const CanvasPart corner{CanvasKind::Corner, cornerLetter(i), {m_record.pixels(corners[i].position)}};
            m_writer.given(QLatin1String(kNames[i]), m_fragment.screen[i]);
            m_writer.given(QStringLiteral("w_") + cornerLetter(i), 1 / corners[i].invW, corner);
        }
        m_writer.line(formula("{w_spread}"), formula("max({w_A}, {w_B}, {w_C}) - min({w_A}, {w_B}, {w_C})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Over a face. How much the distances of its corners differ: if it is 0, the "
                                        "weights on the screen are those in space, and correction changes nothing."),
                      {areaPart(QStringLiteral("ABC"),
                                {m_record.pixels(corners[0].position), m_record.pixels(corners[1].position),
                                 m_record.pixels(corners[2].position)})});
        m_writer.line(formula("{w}"), formula("1 / ({alpha} / {w_A} + {beta} / {w_B} + {gamma} / {w_C})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The same over a face, at the pixel: 1 / w is linear on the screen, so the "
                                        "weights on the screen give it, and it gives w."),
                      {point});
        if (m_record.rules().perspectiveCorrect)
            for (std::size_t i = 0; i < 3; ++i)
                m_writer.given(QLatin1String(kNames[i]) + QStringLiteral("_p"), m_fragment.weights[i]);
        m_writer.line(formula("({alpha_p}, {beta_p}, {gamma_p})"),
                      formula("({alpha} / {w_A} * {w}, {beta} / {w_B} * {w}, {gamma} / {w_C} * {w})"),
                      QT_TRANSLATE_NOOP("Derive", "The weights in space, which attributes are weighted with."),
                      {point});
        m_writer.line(formula("{sum}"), formula("{alpha_p} + {beta_p} + {gamma_p}"),
                      QT_TRANSLATE_NOOP("Derive", "They add up to 1, because w was chosen so."), {point});
        m_writer.line(formula("{w}"), formula("{alpha_p} * {w_A} + {beta_p} * {w_B} + {gamma_p} * {w_C}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "From the matrix: it is linear, so w P' = alpha wA A' + beta wB B' + gamma wC "
                                        "C' with the weights in space; the last row is this sum."),
                      {point});
        m_writer.line(formula("({alpha}, {beta}, {gamma})"),
                      formula("({alpha_p} * {w_A} / {w}, {beta_p} * {w_B} / {w}, {gamma_p} * {w_C} / {w})"),
                      QT_TRANSLATE_NOOP("Derive", "Divided by w: the weights of A', B' and C' on the screen."),
                      {point});
    }

    const FaceRecord& m_record;
    const SampledTriangle& m_sample;
    const FragmentStep& m_fragment;
    PlaceEdge m_edge;
    DerivationWriter m_writer;
};

} // namespace

Derivation derivePerspective(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                             const std::stop_token& stop)
{
    const FaceRecord record(scene, withArea(settings), place, stop);
    requireBeforeEye(record);
    const SampledTriangle sample = sampleOf(record, SampleNeed::Inside);
    const SampledFragment fragment = fragmentOf(record, sample, record.settings());
    if (record.rules().orthographic)
        return deriveParallelWeights(record, sample, fragment.numbers);
    return PerspectiveWriter(record, sample, fragment.numbers).write();
}

} // namespace rasterlens
