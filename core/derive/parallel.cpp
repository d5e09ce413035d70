#include "core/derive/parallel.h"

#include "core/derive/place_edge.h"

#include <QCoreApplication>

#include <algorithm>

namespace rasterlens
{
namespace
{

class WeightsWriter
{
public:
    WeightsWriter(const FaceRecord& record, const SampledTriangle& sample, const FragmentStep& fragment)
        : m_record(record), m_sample(sample), m_fragment(fragment), m_edge(record),
          m_writer(DerivationTopic::Perspective, pixelReason(record, sample))
    {
        m_edge.giveSideView(m_writer, QStringLiteral("w"));
    }

    Derivation write()
    {
        writeEdge();
        writeFace();
        drawSideView();
        return m_writer.take();
    }

private:
    void writeEdge()
    {
        m_writer.line(m_edge.named("({%1'}, {%2'})"), formula("({X1} / {w1}, {X2} / {w2})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "An orthographic camera: the rays are parallel, and w is 1 at both ends of the "
                                        "edge. The divide by w changes nothing."),
                      {m_edge.startPart(), m_edge.endPart()});
        m_writer.line(formula("{P'}"), m_edge.named("(1 - {m}) * {%1'} + {m} * {%2'}"),
                      QT_TRANSLATE_NOOP("Derive", "The point at the part m of the way on the screen."),
                      {m_edge.seenPart(), m_edge.part()});
        m_writer.line(formula("{n}"), formula("{m}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Parallel rays divide the edge in space as its picture is divided: the part of "
                                        "the way in space is m itself."),
                      {m_edge.part()});
        m_writer.line(formula("{n}"), formula("{m} * {w1} / ((1 - {m}) * {w2} + {m} * {w1})"),
                      QT_TRANSLATE_NOOP("Derive", "The formula of perspective says the same where both w are equal."),
                      {m_edge.part()});
    }

    void writeFace()
    {
        const auto& corners = m_sample.triangle->screen.vertices;
        const CanvasPart point{CanvasKind::Sample, QStringLiteral("P"), {m_record.pixels(m_sample.point)}};
        constexpr const char* kNames[] = {"alpha", "beta", "gamma"};
        std::vector<glm::dvec2> outline;
        for (std::size_t i = 0; i < 3; ++i) {
            outline.push_back(m_record.pixels(corners[i].position));
            const CanvasPart corner{CanvasKind::Corner, cornerLetter(i), {outline.back()}};
            m_writer.given(QLatin1String(kNames[i]), m_fragment.screen[i]);
            m_writer.given(QStringLiteral("w_") + cornerLetter(i), 1 / corners[i].invW, corner);
        }
        m_writer.line(formula("{w_spread}"), formula("max({w_A}, {w_B}, {w_C}) - min({w_A}, {w_B}, {w_C})"),
                      QT_TRANSLATE_NOOP("Derive", "Over a face. All three w are 1: they do not differ."),
                      {areaPart(QStringLiteral("ABC"), std::move(outline))});
        m_writer.line(formula("{w}"), formula("1 / ({alpha} / {w_A} + {beta} / {w_B} + {gamma} / {w_C})"),
                      QT_TRANSLATE_NOOP("Derive", "At the pixel 1 / w is the sum of the weights on the screen, 1."),
                      {point});
        if (m_record.rules().perspectiveCorrect)
            for (std::size_t i = 0; i < 3; ++i)
                m_writer.given(QLatin1String(kNames[i]) + QStringLiteral("_p"), m_fragment.weights[i]);
        m_writer.line(formula("({alpha_p}, {beta_p}, {gamma_p})"),
                      formula("({alpha} / {w_A} * {w}, {beta} / {w_B} * {w}, {gamma} / {w_C} * {w})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The weights in space are those on the screen: there is nothing to correct, "
                                        "and affine interpolation is right."),
                      {point});
    }

    /// The edge from the side, and the parallel rays that carry its ends and its point to the screen.
    void drawSideView()
    {
        const auto value = [&](const char* id) { return m_writer.valueOf(QLatin1String(id)); };
        const auto symbol = [&](const char* id) { return m_writer.indexOf(QLatin1String(id)); };
        using enum FigureStroke::Look;
        const glm::dvec2 a(-m_edge.start().view.z, m_writer.valueOf(m_edge.startSeen()));
        const glm::dvec2 b(-m_edge.end().view.z, m_writer.valueOf(m_edge.endSeen()));
        const glm::dvec2 p = a + value("n") * (b - a);
        const double screen = std::min({m_record.matrices().near, a.x, b.x});
        const auto onScreen = [&](const glm::dvec2& at) { return glm::dvec2(screen, at.y); };
        DerivationFigure figure;
        figure.title =
            QT_TRANSLATE_NOOP("Derive", "From the side: the rays are parallel, the screen is the near plane");
        figure.xName = QStringLiteral("Z");
        figure.yName = QStringLiteral("X");
        figure.low = {screen, std::min(a.y, b.y)};
        figure.high = {std::max(a.x, b.x), std::max(a.y, b.y)};
        figure.strokes = {
            {{onScreen(figure.low), onScreen(figure.high)}, QString(), Solid, -1},
            {{onScreen(a), a}, QString(), Dashed, m_writer.indexOf(m_edge.startSeen())},
            {{onScreen(b), b}, QString(), Dashed, m_writer.indexOf(m_edge.endSeen())},
            {{onScreen(p), p}, QString(), Dashed, symbol("P'")},
            {{a, b}, QString(), Solid, -1},
            {{a, p}, QStringLiteral("n"), Solid, symbol("n")},
            {{onScreen(a), onScreen(p)}, QStringLiteral("m"), Solid, symbol("m")},
        };
        figure.points = {{a, m_edge.startName(), symbol("X1")},
                         {b, m_edge.endName(), symbol("X2")},
                         {p, QStringLiteral("P"), symbol("n")},
                         {onScreen(a), m_edge.startSeen(), m_writer.indexOf(m_edge.startSeen())},
                         {onScreen(b), m_edge.endSeen(), m_writer.indexOf(m_edge.endSeen())},
                         {onScreen(p), QStringLiteral("P'"), symbol("P'")}};
        m_writer.figure(std::move(figure));
    }

    const FaceRecord& m_record;
    const SampledTriangle& m_sample;
    const FragmentStep& m_fragment;
    PlaceEdge m_edge;
    DerivationWriter m_writer;
};

class DepthWriter
{
public:
    explicit DepthWriter(const FaceRecord& record)
        : m_record(record), m_edge(record), m_writer(DerivationTopic::DepthCurve, faceReason(record))
    {
        const Matrices matrices = record.matrices();
        const Settings& settings = record.settings();
        const double low = settings.clipZ == ClipZ::Gl ? -1 : 0;
        m_writer.given(QStringLiteral("n"), matrices.near);
        m_writer.given(QStringLiteral("f"), matrices.far);
        m_writer.given(QStringLiteral("c_n"), settings.reversedZ ? 1 : low);
        m_writer.given(QStringLiteral("c_f"), settings.reversedZ ? low : 1);
        giveEnd(m_edge.start(), m_edge.startPart(), "1");
        giveEnd(m_edge.end(), m_edge.endPart(), "2");
        m_writer.given(QStringLiteral("a"), 1 - record.place().m);
    }

    Derivation write()
    {
        writeMatrix();
        writeEdge();
        writeChoice();
        drawLine();
        return m_writer.take();
    }

private:
    /// View space looks along -z; distances in front of the eye are positive here.
    void giveEnd(const VertexRow& row, const CanvasPart& corner, const char* number)
    {
        const QString suffix = QLatin1String(number);
        m_writer.given(QStringLiteral("z") + suffix, -row.view.z, corner);
        m_writer.show(QStringLiteral("c") + suffix, corner);
    }

    void writeMatrix()
    {
        m_writer.line(formula("({T_33}, {T_34})"),
                      formula("(({c_f} - {c_n}) / ({f} - {n}), ({c_n} * {f} - {c_f} * {n}) / ({f} - {n}))"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "An orthographic matrix scales and moves z, the distance in front of the eye, "
                                        "so that near comes to c_n and far to c_f. Its last row is (0, 0, 0, 1): w is "
                                        "1, and the divide changes nothing."));
        m_writer.line(formula("{n'}"), formula("{T_33} * {n} + {T_34}"),
                      QT_TRANSLATE_NOOP("Derive", "Near comes to c_n..."));
        m_writer.line(formula("{f'}"), formula("{T_33} * {f} + {T_34}"),
                      QT_TRANSLATE_NOOP("Derive", "...and far to c_f."));
        for (const char* number : {"1", "2"}) {
            const QString i = QLatin1String(number);
            m_writer.line(formula("{c%1}", i), formula("{T_33} * {z%1} + {T_34}", i),
                          {QT_TRANSLATE_NOOP("Derive", "End %1 of the edge: z' is linear in the distance."), {i}},
                          {m_edge.part()});
        }
    }

    void writeEdge()
    {
        m_writer.line(formula("{z3}"), formula("{a} * {z1} + (1 - {a}) * {z2}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "A point of the edge: a parts of end 1, 1 - a of end 2. On the screen it "
                                        "divides the edge in the same way."),
                      {m_edge.part()});
        m_writer.line(formula("{c3}"), formula("{a} * {c1} + (1 - {a}) * {c2}"),
                      QT_TRANSLATE_NOOP("Derive", "Its z', by the same weights."), {m_edge.part()});
        m_writer.line(formula("{c3}"), formula("{T_33} * {z3} + {T_34}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The same from its distance: on the screen both are linear, and neither is to "
                                        "be corrected."),
                      {m_edge.part()});
    }

    void writeChoice()
    {
        const double middle = (m_writer.valueOf(QStringLiteral("n")) + m_writer.valueOf(QStringLiteral("f"))) / 2;
        m_writer.given(QStringLiteral("z"), m_record.place().depth.value_or(middle));
        m_writer.line(formula("{z'}"), formula("{T_33} * {z} + {T_34}"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "A distance of free choice; half-way from near to far unless another is asked "
                                        "for."));
        m_writer.line(formula("{part}"), formula("({z'} - {c_n}) / ({c_f} - {c_n})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The part of the way from near to far at which it comes to lie: half-way stays "
                                        "half-way, and equal steps of distance stay equal."));
    }

    /// z' over z, which is a straight line, with the ends of the edge, its point, and the distance of free choice.
    void drawLine()
    {
        const auto value = [&](const char* id) { return m_writer.valueOf(QLatin1String(id)); };
        const auto symbol = [&](const char* id) { return m_writer.indexOf(QLatin1String(id)); };
        using enum FigureStroke::Look;
        const double first = std::min({value("n"), value("z"), value("z1"), value("z2")});
        const double last = std::max({value("f"), value("z"), value("z1"), value("z2")});
        const auto at = [&](double z) { return glm::dvec2(z, value("T_33") * z + value("T_34")); };
        const glm::dvec2 from = at(first);
        const glm::dvec2 to = at(last);
        DerivationFigure figure;
        figure.title = QT_TRANSLATE_NOOP("Derive", "z' over z: a straight line");
        figure.xName = QStringLiteral("z");
        figure.yName = QStringLiteral("z'");
        figure.low = glm::min(from, to);
        figure.high = glm::max(from, to);
        const double atNear = value("c_n");
        const double atFar = value("c_f");
        figure.strokes = {{{{first, atNear}, {last, atNear}}, QStringLiteral("c_n"), Dashed, symbol("c_n")},
                          {{{first, atFar}, {last, atFar}}, QStringLiteral("c_f"), Dashed, symbol("c_f")},
                          {{from, to}, QString(), Solid, symbol("z'")}};
        figure.points = {{{value("z1"), value("c1")}, QStringLiteral("1"), symbol("c1")},
                         {{value("z2"), value("c2")}, QStringLiteral("2"), symbol("c2")},
                         {{value("z3"), value("c3")}, QStringLiteral("3"), symbol("c3")},
                         {{value("z"), value("z'")}, QStringLiteral("z"), symbol("z'")}};
        m_writer.figure(std::move(figure));
    }

    const FaceRecord& m_record;
    PlaceEdge m_edge;
    DerivationWriter m_writer;
};

} // namespace

Derivation deriveParallelWeights(const FaceRecord& record, const SampledTriangle& sample, const FragmentStep& fragment)
{
    return WeightsWriter(record, sample, fragment).write();
}

Derivation deriveParallelDepth(const FaceRecord& record) { return DepthWriter(record).write(); }

} // namespace rasterlens
