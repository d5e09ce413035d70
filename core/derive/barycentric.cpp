#include "core/derive/topic_list.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlens
{
namespace
{

/// Writes the barycentric weights of one sample in five ways.
class BarycentricWriter
{
public:
    BarycentricWriter(const FaceRecord& record, const SampledTriangle& sample, const FragmentStep& fragment)
        : m_record(record), m_sample(sample), m_fragment(fragment),
          m_writer(DerivationTopic::Barycentric, pixelReason(record, sample))
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const CanvasPart corner{CanvasKind::Corner, cornerLetter(i), {cornerAt(i)}};
            m_writer.given(cornerLetter(i) + QStringLiteral("_x"), position(i).x, corner);
            m_writer.given(cornerLetter(i) + QStringLiteral("_y"), position(i).y, corner);
        }
        const CanvasPart point{CanvasKind::Sample, QStringLiteral("P"), {this->point()}};
        m_writer.given(QStringLiteral("P_x"), sample.point.x, point);
        m_writer.given(QStringLiteral("P_y"), sample.point.y, point);
    }

    Derivation write()
    {
        writeEdgeValues();
        writeAreas();
        writeClosedFormulas();
        writeCramer();
        writeRatios();
        writeComparison();
        return m_writer.take();
    }

private:
    [[nodiscard]] const glm::dvec2& position(std::size_t i) const
    {
        return m_sample.triangle->screen.vertices[i].position;
    }
    [[nodiscard]] glm::dvec2 cornerAt(std::size_t i) const { return m_record.pixels(position(i)); }
    [[nodiscard]] glm::dvec2 point() const { return m_record.pixels(m_sample.point); }

    /// The triangle of the sample and the side opposite a corner: its area belongs to that corner.
    [[nodiscard]] CanvasPart areaOpposite(std::size_t corner) const
    {
        std::size_t i = (corner + 1) % 3;
        std::size_t j = (corner + 2) % 3;
        if (m_sample.triangle->setup.source[1] != 1)
            std::swap(i, j); // named after the edge of the set-up, which has turned the corners round
        return areaPart(cornerLetter(i) + cornerLetter(j) + QLatin1Char('P'), {cornerAt(i), cornerAt(j), point()});
    }

    void showWeights(const char* suffix)
    {
        constexpr const char* kNames[] = {"alpha", "beta", "gamma"};
        for (std::size_t i = 0; i < 3; ++i)
            m_writer.show(QLatin1String(kNames[i]) + QLatin1String(suffix), areaOpposite(i));
    }

    [[nodiscard]] std::vector<CanvasPart> allAreas() const
    {
        return {areaOpposite(0), areaOpposite(1), areaOpposite(2)};
    }

    /// Way 1: edge value over the sum of the three.
    void writeEdgeValues()
    {
        const StepSetup& setup = m_sample.triangle->setup;
        std::array<QString, 3> opposite; // the edge value that belongs to corner A, B, C
        QStringList sum;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const QString id = edgeValueName(setup, static_cast<int>(edge));
            const std::size_t corner = setup.source[(edge + 2) % 3];
            m_writer.given(id, m_sample.values[edge], areaOpposite(corner));
            opposite[corner] = id;
            sum << QStringLiteral("{%1}").arg(id);
        }
        m_writer.line(QStringLiteral("{r}"), QStringLiteral("1 / (%1)").arg(sum.join(QStringLiteral(" + "))),
                      QT_TRANSLATE_NOOP("Derive", "Way 1. The three edge values have the same sum everywhere, so one "
                                                  "division a triangle is enough: its reciprocal is kept."),
                      allAreas());
        showWeights("_1");
        m_writer.line(formula("({alpha_1}, {beta_1}, {gamma_1})"),
                      formula("({%1} * {r}, {%2} * {r}, {%3} * {r})", opposite[0], opposite[1], opposite[2]),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Each corner is weighted by the edge opposite to it: the edge value is "
                                        "largest at the corner and 0 on the edge."),
                      allAreas());
    }

    /// Way 2: the areas of the three triangles at the sample.
    void writeAreas()
    {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const QString i = cornerLetter((corner + 1) % 3);
            const QString j = cornerLetter((corner + 2) % 3);
            m_writer.show(QStringLiteral("S_") + i + j + QLatin1Char('P'), areaOpposite(corner));
            m_writer.line(
                formula("{S_%1%2P}", i, j),
                formula("|({%2_x} - {%1_x}) * ({P_y} - {%1_y}) - ({%2_y} - {%1_y}) * ({P_x} - {%1_x})| / 2", i, j),
                {QT_TRANSLATE_NOOP("Derive", "Way 2. The area of the triangle %1%2P, half a cross product."), {i, j}},
                {areaOpposite(corner)});
        }
        showWeights("_2");
        m_writer.line(formula("({alpha_2}, {beta_2}, {gamma_2})"),
                      formula("({S_BCP} / ({S_ABP} + {S_BCP} + {S_CAP}), {S_CAP} / ({S_ABP} + {S_BCP} + {S_CAP}), "
                              "{S_ABP} / ({S_ABP} + {S_BCP} + {S_CAP}))"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Each weight is the part that the triangle opposite the corner has of the "
                                        "whole area."),
                      allAreas());
        m_writer.line(formula("({N_x}, {N_y})"),
                      formula("({S_BCP} * ({A_x} - {P_x}) + {S_CAP} * ({B_x} - {P_x}) + {S_ABP} * ({C_x} - {P_x}), "
                              "{S_BCP} * ({A_y} - {P_y}) + {S_CAP} * ({B_y} - {P_y}) + {S_ABP} * ({C_y} - {P_y}))"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The vectors from P to the corners, each times the area opposite, cancel "
                                        "out: that is why these areas are the weights."),
                      {vectorPart(QStringLiteral("PA"), point(), cornerAt(0)),
                       vectorPart(QStringLiteral("PB"), point(), cornerAt(1)),
                       vectorPart(QStringLiteral("PC"), point(), cornerAt(2))});
    }

    /// Way 3: the line equation through two corners, scaled to 1 at the third.
    void writeClosedFormulas()
    {
        showWeights("_3");
        m_writer.line(formula("{gamma_3}"),
                      formula("(({A_y} - {B_y}) * {P_x} + ({B_x} - {A_x}) * {P_y} + {A_x} * {B_y} - {B_x} * {A_y}) / "
                              "(({A_y} - {B_y}) * {C_x} + ({B_x} - {A_x}) * {C_y} + {A_x} * {B_y} - {B_x} * {A_y})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Way 3. The line equation of AB at P, over its value at C: 0 on AB and 1 "
                                        "at C."),
                      {areaOpposite(2)});
        m_writer.line(formula("{beta_3}"),
                      formula("(({A_y} - {C_y}) * {P_x} + ({C_x} - {A_x}) * {P_y} + {A_x} * {C_y} - {C_x} * {A_y}) / "
                              "(({A_y} - {C_y}) * {B_x} + ({C_x} - {A_x}) * {B_y} + {A_x} * {C_y} - {C_x} * {A_y})"),
                      QT_TRANSLATE_NOOP("Derive", "The line equation of AC at P, over its value at B."),
                      {areaOpposite(1)});
        m_writer.line(formula("{alpha_3}"), formula("1 - {beta_3} - {gamma_3}"),
                      QT_TRANSLATE_NOOP("Derive", "What the other two leave: the weights add up to 1."),
                      {areaOpposite(0)});
    }

    /// Way 4: two linear equations by determinants, and as one cross product.
    void writeCramer()
    {
        const CanvasPart ca = vectorPart(QStringLiteral("CA"), cornerAt(2), cornerAt(0));
        const CanvasPart cb = vectorPart(QStringLiteral("CB"), cornerAt(2), cornerAt(1));
        const CanvasPart cp = vectorPart(QStringLiteral("CP"), cornerAt(2), point());
        m_writer.line(formula("{D}"), formula("({A_x} - {C_x}) * ({B_y} - {C_y}) - ({B_x} - {C_x}) * ({A_y} - {C_y})"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "Way 4. P - C is to be alpha (A - C) + beta (B - C): two equations, one for "
                                        "x and one for y. The determinant of the two base vectors."),
                      {ca, cb});
        m_writer.line(formula("{D_u}"),
                      formula("({P_x} - {C_x}) * ({B_y} - {C_y}) - ({B_x} - {C_x}) * ({P_y} - {C_y})"),
                      QT_TRANSLATE_NOOP("Derive", "Cramer: P - C takes the place of the first column."), {cp, cb});
        m_writer.line(formula("{D_v}"),
                      formula("({A_x} - {C_x}) * ({P_y} - {C_y}) - ({P_x} - {C_x}) * ({A_y} - {C_y})"),
                      QT_TRANSLATE_NOOP("Derive", "P - C takes the place of the second column."), {ca, cp});
        m_writer.line(formula("({U_x}, {U_y}, {U_z})"),
                      formula("(({B_x} - {C_x}) * ({C_y} - {P_y}) - ({C_x} - {P_x}) * ({B_y} - {C_y}), "
                              "({C_x} - {P_x}) * ({A_y} - {C_y}) - ({A_x} - {C_x}) * ({C_y} - {P_y}), "
                              "({A_x} - {C_x}) * ({B_y} - {C_y}) - ({B_x} - {C_x}) * ({A_y} - {C_y}))"),
                      QT_TRANSLATE_NOOP("Derive",
                                        "The cross product of the row of x and the row of y, each of A - C, B - C "
                                        "and C - P, has the three determinants as its parts: U = (Du, Dv, D)."),
                      {ca, cb, cp});
        showWeights("_4");
        m_writer.line(formula("({alpha_4}, {beta_4}, {gamma_4})"),
                      formula("({U_x} / {U_z}, {U_y} / {U_z}, 1 - {U_x} / {U_z} - {U_y} / {U_z})"),
                      QT_TRANSLATE_NOOP("Derive", "Where U_z is nearly 0 the triangle has no area, and no weights."),
                      allAreas());
    }

    /// Way 5: the line from a corner through P to the opposite side. The corner of the smallest weight is the farthest.
    void writeRatios()
    {
        const auto smallest = std::ranges::min_element(m_fragment.screen);
        const auto corner = static_cast<std::size_t>(smallest - m_fragment.screen.begin());
        const std::size_t second = (corner + 1) % 3;
        const std::size_t third = (corner + 2) % 3;
        const QString i = cornerLetter(corner);
        const QString j = cornerLetter(second);
        const QString k = cornerLetter(third);
        const CanvasPart side = edgePart(j + k, cornerAt(second), cornerAt(third));
        m_writer.line(
            formula("{s}"),
            formula("(({%2_x} - {%1_x}) * ({%3_y} - {%2_y}) - ({%2_y} - {%1_y}) * ({%3_x} - {%2_x})) / "
                    "(({P_x} - {%1_x}) * ({%3_y} - {%2_y}) - ({P_y} - {%1_y}) * ({%3_x} - {%2_x}))",
                    i, j, k),
            {QT_TRANSLATE_NOOP("Derive", "Way 5. The line from %1 through P meets %2%3 in a point Q; Q lies s times "
                                         "as far from %1 as P."),
             {i, j, k}},
            {side, vectorPart(i + QLatin1Char('P'), cornerAt(corner), point())});
        const glm::dvec2 q =
            position(corner) + m_writer.valueOf(QStringLiteral("s")) * (m_sample.point - position(corner));
        const CanvasPart foot{CanvasKind::Point, QStringLiteral("Q"), {m_record.pixels(q)}};
        m_writer.show(QStringLiteral("Q_x"), foot);
        m_writer.show(QStringLiteral("Q_y"), foot);
        m_writer.line(formula("({Q_x}, {Q_y})"),
                      formula("({%1_x} + {s} * ({P_x} - {%1_x}), {%1_y} + {s} * ({P_y} - {%1_y}))", i),
                      QT_TRANSLATE_NOOP("Derive", "The point Q on the side."), {foot, side});
        const glm::dvec2 along = position(third) - position(second);
        const QString axis = std::abs(along.x) >= std::abs(along.y) ? QStringLiteral("x") : QStringLiteral("y");
        m_writer.line(formula("{q}"), formula("({Q_%3} - {%1_%3}) / ({%2_%3} - {%1_%3})", j, k, axis),
                      {QT_TRANSLATE_NOOP("Derive", "The part of the way from %1 to %2 at which Q lies."), {j, k}},
                      {foot, side});
        constexpr const char* kNames[] = {"alpha", "beta", "gamma"};
        const auto weight = [&](std::size_t c) { return QLatin1String(kNames[c]) + QStringLiteral("_5"); };
        showWeights("_5");
        m_writer.line(
            formula("({%1}, {%2}, {%3})", weight(corner), weight(second), weight(third)),
            formula("(1 - 1 / {s}, (1 / {s}) * (1 - {q}), (1 / {s}) * {q})"),
            {QT_TRANSLATE_NOOP("Derive", "Ratios of lengths: PQ over %1Q for the corner, and the rest is shared "
                                         "between the ends of the side as Q divides it."),
             {i}},
            {foot, side});
    }

    void writeComparison()
    {
        for (std::size_t i = 0; i < 3; ++i) {
            constexpr const char* kNames[] = {"alpha", "beta", "gamma"};
            m_writer.given(QLatin1String(kNames[i]), m_fragment.screen[i], areaOpposite(i));
        }
        m_writer.line(
            formula("({X}, {Y})"),
            formula("({alpha} * {A_x} + {beta} * {B_x} + {gamma} * {C_x}, "
                    "{alpha} * {A_y} + {beta} * {B_y} + {gamma} * {C_y})"),
            QT_TRANSLATE_NOOP("Derive", "The weights the program drew with put the corners together to P again."),
            allAreas());
        m_writer.line(formula("{sum}"), formula("{alpha} + {beta} + {gamma}"),
                      QT_TRANSLATE_NOOP("Derive", "Their sum."), allAreas());
        QStringList differences;
        for (const char* way : {"1", "2", "3", "4", "5"}) {
            const QString number = QLatin1String(way);
            m_writer.line(formula("{d_%1}", number),
                          formula("max(|{alpha_%1} - {alpha}|, |{beta_%1} - {beta}|, |{gamma_%1} - {gamma}|)", number),
                          {QT_TRANSLATE_NOOP("Derive", "How far way %1 is from what the program drew with, in double "
                                                       "precision."),
                           {number}});
            differences << QStringLiteral("{d_%1}").arg(number);
        }
        m_writer.line(QStringLiteral("{d}"), QStringLiteral("max(%1)").arg(differences.join(QStringLiteral(", "))),
                      QT_TRANSLATE_NOOP("Derive", "The largest difference: rounding, and nothing else."));
    }

    const FaceRecord& m_record;
    const SampledTriangle& m_sample;
    const FragmentStep& m_fragment;
    DerivationWriter m_writer;
};

} // namespace

Derivation deriveBarycentric(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                             const std::stop_token& stop)
{
    const FaceRecord record(scene, withArea(settings), place, stop);
    const SampledTriangle sample = sampleOf(record, SampleNeed::Inside);
    const SampledFragment fragment = fragmentOf(record, sample, record.settings());
    return BarycentricWriter(record, sample, fragment.numbers).write();
}

} // namespace rasterlens
