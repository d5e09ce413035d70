#include "core/derive/topic_list.h"
#include "core/questions/why.h"

#include <QCoreApplication>

#include <algorithm>

namespace rasterlens
{
namespace
{

/// So many faces at a pixel are written down at most.
constexpr std::size_t kMostFaces = 6;

/// A face at the pixel: what it would write there if nothing hid it.
struct Layer {
    QString number; ///< of the face
    double depth;
    std::uint32_t color; ///< 0xffRRGGBB
};

/// All faces that cover the pixel, in the order in which they are drawn.
std::vector<Layer> layersAt(const FaceRecord& record, const SampledTriangle& sample, const std::stop_token& stop)
{
    Settings all = record.settings();
    all.visibility = Visibility::ZBuffer;
    all.depthTest = DepthTest::Always;
    const int grid = record.rules().sampleGrid;
    const WhyReport report = why(record.scene(), all, sample.x / grid, sample.y / grid, stop);
    std::vector<Layer> layers;
    for (const WhyFace& face : report.faces)
        if (face.verdict == WhyVerdict::Written && face.fragment && layers.size() < kMostFaces)
            layers.push_back({QString::number(face.face), face.fragment->depth, face.write.after.color});
    return layers;
}

/// Writes what half-transparent faces would make of a pixel, in two orders, and what a depth test makes of that.
class BlendWriter
{
public:
    BlendWriter(const FaceRecord& record, const SampledTriangle& sample, std::vector<Layer> layers)
        : m_layers(std::move(layers)), m_mark{CanvasKind::Sample, QStringLiteral("P"), {record.pixels(sample.point)}},
          m_background(record.scene().background), m_largerIsNearer(record.settings().reversedZ),
          m_writer(DerivationTopic::Blend, pixelReason(record, sample))
    {
        constexpr int kWhole = 255;
        for (int i = 0; i < 3; ++i) {
            for (const Layer& layer : m_layers)
                m_writer.given(formula("%1_F%2", kNames[i], layer.number),
                               double(layer.color >> (16 - 8 * i) & 255U) / kWhole, m_mark);
            m_writer.given(formula("%1_back", kNames[i]), inFewestDigits(float(m_background[i])));
        }
        for (const Layer& layer : m_layers)
            m_writer.given(QStringLiteral("z_F") + layer.number, layer.depth, m_mark);
    }

    Derivation write()
    {
        m_writer.given(QStringLiteral("a"), 0.5);
        writeBlend(m_layers, "s",
                   QT_TRANSLATE_NOOP("Derive",
                                     "Suppose every face lets half of what is behind it through: a = 1/2. Face %1 is "
                                     "drawn over what is there, in the order in which faces are sent."));
        std::vector<Layer> sorted = m_layers;
        std::ranges::stable_sort(sorted, [this](const Layer& a, const Layer& b) {
            return m_largerIsNearer ? a.depth < b.depth : a.depth > b.depth;
        });
        writeBlend(sorted, "f",
                   QT_TRANSLATE_NOOP("Derive", "From far to near, as a painter works, face %1 comes here."));
        const auto last = [&](const char* order) { return formula("%1%2", order, QString::number(m_layers.size())); };
        m_writer.compare(formula("{r_%1} == {r_%2}", last("s"), last("f")),
                         QT_TRANSLATE_NOOP("Derive",
                                           "Whether both orders make one colour (its red part). Where they do not, "
                                           "transparent faces have to be sorted."),
                         {m_mark});
        writeDepthTest();
        return m_writer.take();
    }

private:
    static constexpr const char* kNames[] = {"r", "g", "b"};

    void writeBlend(const std::vector<Layer>& layers, const char* order, const char* words)
    {
        QString below = QStringLiteral("back");
        for (std::size_t i = 0; i < layers.size(); ++i) {
            const QString now = QLatin1String(order) + QString::number(i + 1);
            m_writer.line(
                formula("({r_%1}, {g_%1}, {b_%1})", now),
                formula("(lerp({r_%1}, {r_F%2}, {a}), lerp({g_%1}, {g_F%2}, {a}), lerp({b_%1}, {b_F%2}, {a}))", below,
                        layers[i].number),
                {words, {layers[i].number}}, {m_mark});
            below = now;
        }
    }

    /// A test that writes depth loses what is sent later and lies behind.
    void writeDepthTest()
    {
        std::size_t stored = 0;
        for (std::size_t i = 1; i < m_layers.size(); ++i) {
            const bool isNearer = m_largerIsNearer ? m_layers[i].depth > m_layers[stored].depth
                                                   : m_layers[i].depth < m_layers[stored].depth;
            m_writer.compare(
                formula(m_largerIsNearer ? "{z_F%1} > {z_F%2}" : "{z_F%1} < {z_F%2}", m_layers[i].number,
                        m_layers[stored].number),
                {QT_TRANSLATE_NOOP("Derive",
                                   "A depth test before shading asks this of face %1 where the depth of face %2 is "
                                   "stored. If it does not hold, the face is dropped, although half of it should shine "
                                   "through. A shader that changes depth has the same trouble: the test cannot know "
                                   "it yet."),
                 {m_layers[i].number, m_layers[stored].number}},
                {m_mark});
            stored = isNearer ? i : stored;
        }
    }

    std::vector<Layer> m_layers;
    CanvasPart m_mark;
    glm::dvec3 m_background;
    bool m_largerIsNearer;
    DerivationWriter m_writer;
};

} // namespace

Derivation deriveBlend(const Scene& scene, const Settings& settings, const DerivationPlace& place,
                       const std::stop_token& stop)
{
    const FaceRecord record(scene, withArea(settings), place, stop);
    const SampledTriangle sample = sampleOf(record, SampleNeed::Inside);
    std::vector<Layer> layers = layersAt(record, sample, stop);
    if (layers.empty())
        throw NoDerivation{QT_TRANSLATE_NOOP("Derive", "no face is drawn at this pixel")};
    return BlendWriter(record, sample, std::move(layers)).write();
}

} // namespace rasterlens
