#include "core/io/case_file.h"

#include "core/io/byte_order_mark.h"
#include "core/io/reach.h"
#include "core/io/text_input.h"
#include "core/io/texture_loader.h"
#include "core/settings/numbers_field.h"

#include <QDir>
#include <QFileInfo>

#include <array>
#include <charconv>
#include <span>

namespace rasterlens
{
namespace
{

/// A value of a directive and the word that stands for it.
template <typename Enum>
struct Word {
    const char* text;
    Enum value;
};

constexpr Word<Culling> kCulling[] = {{"back", Culling::Back}, {"front", Culling::Front}, {"none", Culling::None}};
constexpr Word<DepthTest> kDepthTest[] = {{"less", DepthTest::Less},       {"lequal", DepthTest::LessEqual},
                                          {"equal", DepthTest::Equal},     {"gequal", DepthTest::GreaterEqual},
                                          {"greater", DepthTest::Greater}, {"notequal", DepthTest::NotEqual},
                                          {"none", DepthTest::None}};
constexpr Word<DepthFormat> kDepthFormat[] = {{"float32", DepthFormat::Float32},
                                              {"unorm16", DepthFormat::Unorm16},
                                              {"unorm24", DepthFormat::Unorm24},
                                              {"unorm8", DepthFormat::Unorm8}};
constexpr Word<TextureFilter> kTextureFilter[] = {{"nearest", TextureFilter::Nearest},
                                                  {"bilinear", TextureFilter::Bilinear},
                                                  {"trilinear", TextureFilter::Trilinear}};
constexpr Word<ClipZ> kClipZ[] = {{"gl", ClipZ::Gl}, {"d3d", ClipZ::D3d}};

QString text(std::string_view view) { return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size())); }

class Parser
{
public:
    explicit Parser(const QString& name) : m_diagnostics(name)
    {
        m_scene.id = name;
        m_scene.title = QFileInfo(name).completeBaseName();
        m_scene.space = SceneSpace::Clip;
        m_scene.lit = false;
        m_scene.background = glm::vec3(0);
        m_scene.materials = {Material{}};
        m_scene.defaults.culling = Culling::None;
    }

    SceneLoad run(QByteArray bytes)
    {
        LineCursor lines(bytes, Continuation::None);
        while (const auto line = lines.next()) {
            m_line = line->number;
            statement(line->text());
        }
        finish(lines.lastLine());
        if (m_diagnostics.hasErrors())
            return {std::nullopt, m_diagnostics.take()};
        return {std::move(m_scene), m_diagnostics.take()};
    }

private:
    using Handler = void (Parser::*)();
    struct Directive {
        std::string_view name;
        Handler handle;
    };

    void statement(std::string_view line)
    {
        const std::size_t hash = std::min(line.find('#'), line.size());
        m_rest = trimmed(line.substr(0, hash));
        m_directive = nextWord(m_rest);
        if (m_directive.empty()) {
            if (m_firstComment.isEmpty() && hash < line.size())
                m_firstComment = text(trimmed(line.substr(hash + 1)));
            return;
        }
        static constexpr Directive kDirectives[] = {
            {"size", &Parser::size},
            {"subpixel_bits", &Parser::subpixelBits},
            {"exact", &Parser::exact},
            {"cull", &Parser::cull},
            {"depth_test", &Parser::depthTest},
            {"depth_format", &Parser::depthFormat},
            {"depth_bias", &Parser::depthBias},
            {"depth_range", &Parser::depthRange},
            {"depth_clamp", &Parser::depthClamp},
            {"depth_clear", &Parser::depthClear},
            {"second_pass", &Parser::secondPass},
            {"clear", &Parser::clear},
            {"ssaa", &Parser::ssaa},
            {"samples", &Parser::samples},
            {"attribute_at", &Parser::attributeAt},
            {"coverage_rule", &Parser::coverageRule},
            {"zrange", &Parser::zRange},
            {"window", &Parser::window},
            {"line_rule", &Parser::lineRule},
            {"line_ties", &Parser::lineTies},
            {"line", &Parser::line},
            {"tri", &Parser::tri},
            {"triuv", &Parser::triuv},
            {"texture", &Parser::texture},
            {"texture_filter", &Parser::textureFilter},
            {"note", &Parser::note},
            {"expect", &Parser::expect},
        };
        for (const Directive& directive : kDirectives)
            if (directive.name == m_directive)
                return (this->*directive.handle)();
        m_diagnostics.error(
            m_line,
            {QT_TRANSLATE_NOOP("Diagnostic",
                               "%1 is not a directive; size, subpixel_bits, exact, cull, depth_test, depth_format, "
                               "depth_bias, depth_range, depth_clamp, depth_clear, second_pass, clear, ssaa, samples, "
                               "attribute_at, coverage_rule, zrange, window, tri, triuv, line, line_rule, line_ties, "
                               "texture, texture_filter, note or expect expected"),
             {quotedWord(m_directive)}});
    }

    void fault(Reason message)
    {
        m_diagnostics.error(m_line,
                            {QT_TRANSLATE_NOOP("Diagnostic", "%1: %2"), {text(m_directive), std::move(message)}});
    }

    /// All the words that are left, if there are as many as there must be; `expected` says how many.
    template <std::size_t N>
    std::optional<std::array<std::string_view, N>> words(const char* expected)
    {
        std::array<std::string_view, N> found;
        std::size_t count = 0;
        for (std::string_view word = nextWord(m_rest); !word.empty(); word = nextWord(m_rest), ++count)
            if (count < N)
                found[count] = word;
        if (count == N)
            return found;
        fault({QT_TRANSLATE_NOOP("Diagnostic", "%1 values; %2 expected"), {count, expected}});
        return std::nullopt;
    }

    template <std::size_t N>
    std::optional<std::array<int, N>> integers(const char* expected, int minimum, int maximum)
    {
        const auto found = words<N>(expected);
        if (!found)
            return std::nullopt;
        std::array<int, N> values{};
        for (std::size_t i = 0; i < N; ++i) {
            const std::string_view word = (*found)[i];
            const auto parsed = std::from_chars(word.data(), word.data() + word.size(), values[i]);
            if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size() || values[i] < minimum ||
                values[i] > maximum) {
                fault({QT_TRANSLATE_NOOP("Diagnostic", "%1 is not a whole number from %2 to %3"),
                       {quotedWord(word), minimum, maximum}});
                return std::nullopt;
            }
        }
        return values;
    }

    template <typename Enum>
    void choice(std::span<const Word<Enum>> choices, Enum& value)
    {
        QStringList names;
        for (const Word<Enum>& choice : choices)
            names << QString::fromLatin1(choice.text);
        const QString expected = names.join(QStringLiteral(", "));
        const auto found = words<1>(QT_TRANSLATE_NOOP("Diagnostic", "one"));
        if (!found)
            return;
        for (const Word<Enum>& choice : choices)
            if ((*found)[0] == choice.text) {
                value = choice.value;
                return;
            }
        fault({QT_TRANSLATE_NOOP("Diagnostic", "%1 is not one of %2"), {quotedWord((*found)[0]), expected}});
    }

    void size()
    {
        if (const auto v = integers<2>(QT_TRANSLATE_NOOP("Diagnostic", "width and height"), 1, kMaxViewport)) {
            m_scene.defaults.size = {(*v)[0], (*v)[1]};
            m_sized = true;
        }
        m_sizeSeen = true;
    }

    void subpixelBits()
    {
        if (const auto v = integers<1>(QT_TRANSLATE_NOOP("Diagnostic", "one"), 0, 8))
            m_scene.defaults.subpixelBits = (*v)[0];
    }

    void exact()
    {
        if (words<0>(QT_TRANSLATE_NOOP("Diagnostic", "none")))
            m_scene.exact = true;
    }

    void cull() { choice<Culling>(kCulling, m_scene.defaults.culling); }
    void depthTest() { choice<DepthTest>(kDepthTest, m_scene.defaults.depthTest); }
    void depthFormat() { choice<DepthFormat>(kDepthFormat, m_scene.defaults.depthFormat); }
    void zRange() { choice<ClipZ>(kClipZ, m_scene.defaults.clipZ); }

    void ssaa()
    {
        if (const auto v = integers<1>(QT_TRANSLATE_NOOP("Diagnostic", "one"), 1, 4))
            m_scene.defaults.samples = static_cast<Samples>((*v)[0] - 1);
    }

    /// The side of a grid, as for ssaa, or a pattern: 1, 2, 3, 4, msaa2, msaa4, msaa8, msaa16.
    void samples()
    {
        static constexpr Word<Samples> kSamples[] = {{"1", Samples::One},       {"2", Samples::Grid2},
                                                     {"3", Samples::Grid3},     {"4", Samples::Grid4},
                                                     {"msaa2", Samples::Msaa2}, {"msaa4", Samples::Msaa4},
                                                     {"msaa8", Samples::Msaa8}, {"msaa16", Samples::Msaa16}};
        choice<Samples>(kSamples, m_scene.defaults.samples);
    }

    void attributeAt()
    {
        static constexpr Word<AttributeAt> kPlaces[] = {
            {"centre", AttributeAt::Centre}, {"centroid", AttributeAt::Centroid}, {"sample", AttributeAt::Sample}};
        choice<AttributeAt>(kPlaces, m_scene.defaults.attributeAt);
    }

    void coverageRule()
    {
        static constexpr Word<CoverageRule> kRules[] = {{"centre", CoverageRule::Centre},
                                                        {"conservative", CoverageRule::Conservative},
                                                        {"inner", CoverageRule::Inner}};
        choice<CoverageRule>(kRules, m_scene.defaults.coverageRule);
    }

    void lineRule()
    {
        static constexpr Word<LineRule> kRules[] = {{"inclusive", LineRule::Inclusive},
                                                    {"half-open", LineRule::HalfOpen},
                                                    {"diamond-exit", LineRule::DiamondExit}};
        choice<LineRule>(kRules, m_scene.defaults.lineRule);
    }

    void lineTies()
    {
        static constexpr Word<LineTies> kTies[] = {{"by-direction", LineTies::ByDirection},
                                                   {"canonical", LineTies::Canonical}};
        choice<LineTies>(kTies, m_scene.defaults.lineTies);
    }

    void clear()
    {
        const auto found = words<3>(QT_TRANSLATE_NOOP("Diagnostic", "red, green and blue"));
        for (int i = 0; found && i < 3; ++i) {
            const std::string_view word = (*found)[static_cast<std::size_t>(i)];
            const NumberText number = numberFromText(word);
            if (number.fault != NumberFault::None)
                return fault(describe(number.fault, word));
            if (number.value < 0 || number.value > 1)
                return fault({QT_TRANSLATE_NOOP("Diagnostic", "%1 is not from 0 to 1"), {quotedWord(word)}});
            m_scene.background[i] = number.value;
        }
    }

    void numbers(const char* id)
    {
        if (const auto wrong =
                setFromText(*findNumbersField(QLatin1String(id)), text(trimmed(m_rest)), m_scene.defaults))
            fault(*wrong);
    }
    void depthBias() { numbers("depth-bias"); }
    void depthRange() { numbers("depth-range"); }

    void depthClamp()
    {
        if (words<0>(QT_TRANSLATE_NOOP("Diagnostic", "none")))
            m_scene.defaults.clipping = Clipping::DepthClamp;
    }

    void depthClear()
    {
        const auto found = words<1>(QT_TRANSLATE_NOOP("Diagnostic", "one"));
        if (!found)
            return;
        const NumberText number = numberFromText((*found)[0]);
        if (number.fault != NumberFault::None)
            return fault(describe(number.fault, (*found)[0]));
        if (number.value < 0 || number.value > 1)
            return fault({QT_TRANSLATE_NOOP("Diagnostic", "%1 is not from 0 to 1"), {quotedWord((*found)[0])}});
        m_scene.depthClear = static_cast<double>(number.value);
    }

    /// The triangles that follow are drawn over those before.
    void secondPass()
    {
        if (!words<0>(QT_TRANSLATE_NOOP("Diagnostic", "none")))
            return;
        if (m_scene.mesh.indices.empty() || m_scene.secondPassFrom > 0)
            return fault(
                QT_TRANSLATE_NOOP("Diagnostic", "it stands once, behind the triangles and lines of the first pass"));
        m_scene.secondPassFrom = static_cast<std::uint32_t>(m_scene.mesh.faceCount());
    }

    void window()
    {
        if (const auto v = integers<4>(QT_TRANSLATE_NOOP("Diagnostic", "x, y, width and height"), 0, kMaxViewport)) {
            m_scene.window = PixelRect{(*v)[0], (*v)[1], (*v)[2], (*v)[3]};
            m_windowLine = m_line;
        }
    }

    void textureFilter() { choice<TextureFilter>(kTextureFilter, m_scene.defaults.textureFilter); }

    /// `checker N`: N x N texels, light and dark in turn; else an image beside the case.
    void texture()
    {
        const QString rest = text(trimmed(m_rest));
        const std::string_view first = nextWord(m_rest);
        if (first.empty())
            return fault(
                QT_TRANSLATE_NOOP("Diagnostic", "\"checker\" and a size, or the name of an image, is expected"));
        std::optional<Texture> made;
        if (first == "checker") {
            const auto side = integers<1>(QT_TRANSLATE_NOOP("Diagnostic", "one"), 1, 1024);
            if (!side)
                return;
            made = checkerOf((*side)[0]);
        } else {
            const QString image = QFileInfo(m_scene.id).absoluteDir().filePath(rest);
            const bool isOutside = !Consent::reachOf(m_scene.id).covers(image);
            if (isOutside)
                Consent::refuse(m_scene.id, image);
            TextureLoad load = isOutside ? TextureLoad{{}, {}, outsideReason()} : loadTexture(image);
            if (load.problem)
                return fault(*load.problem);
            made = std::move(load.texture);
        }
        m_scene.textures = {std::move(*made)};
        m_scene.materials.front().texture = 0;
        m_scene.defaults.shading = Shading::Texture;
    }

    static Texture checkerOf(int side)
    {
        Texture checker{QStringLiteral("checker"), side, side, {}};
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                checker.texels.push_back((x + y) % 2 == 0 ? 0xffe6e6e6 : 0xff283c78);
        return checker;
    }

    void tri() { corners<3, 7>(QT_TRANSLATE_NOOP("Diagnostic", "21 (x y z w r g b of three corners)")); }
    void triuv() { corners<3, 9>(QT_TRANSLATE_NOOP("Diagnostic", "27 (x y z w r g b u v of three corners)")); }

    /// A face from the first corner to the second, and back.
    void line()
    {
        if (!corners<2, 7>(QT_TRANSLATE_NOOP("Diagnostic", "14 (x y z w r g b of both ends)")))
            return;
        Mesh& mesh = m_scene.mesh;
        mesh.indices.push_back(mesh.indices.back());
        mesh.lines.push_back(static_cast<std::uint32_t>(mesh.faceCount() - 1));
    }

    /// Corners of x y z w r g b, and u v if there are nine numbers. Positions may be non-finite: that is what some
    /// cases are about.
    ///
    /// out  whether the statement is right
    template <std::size_t kCorners, std::size_t kPerCorner>
    bool corners(const char* expected)
    {
        constexpr std::size_t kPosition = 4;
        const auto found = words<kCorners * kPerCorner>(expected);
        if (!found)
            return false;
        std::array<float, kCorners * kPerCorner> v{};
        for (std::size_t i = 0; i < v.size(); ++i) {
            const NumberText number = numberFromText((*found)[i]);
            const bool mayBeNonFinite = i % kPerCorner < kPosition;
            if (number.fault != NumberFault::None && !(number.fault == NumberFault::NotFinite && mayBeNonFinite)) {
                fault(describe(number.fault, (*found)[i]));
                return false;
            }
            v[i] = number.value;
        }
        for (std::size_t i = 0; i < v.size(); i += kPerCorner) {
            m_scene.mesh.indices.push_back(static_cast<std::uint32_t>(m_scene.mesh.vertices.size()));
            MeshVertex& corner = m_scene.mesh.vertices.emplace_back();
            corner.position = {v[i], v[i + 1], v[i + 2], v[i + 3]};
            corner.color = {v[i + 4], v[i + 5], v[i + 6]};
            if constexpr (kPerCorner > 7)
                corner.uv = {v[i + 7], v[i + 8]};
        }
        return true;
    }

    void note() { m_notes << text(trimmed(m_rest)); }

    void expect()
    {
        const std::string_view key = nextWord(m_rest);
        const std::string_view value = trimmed(m_rest);
        if (value.empty())
            fault(QT_TRANSLATE_NOOP("Diagnostic", "a key and a value are expected"));
        else
            m_scene.expectations.emplace_back(text(key), text(value));
    }

    void finish(int lastLine)
    {
        if (!m_sizeSeen)
            m_diagnostics.error(
                lastLine, QT_TRANSLATE_NOOP("Diagnostic", "the file ends without a size; \"size W H\" is expected"));
        if (m_scene.window && m_sized) {
            const PixelRect& w = *m_scene.window;
            const QSize viewport = m_scene.defaults.size;
            if (w.width < 1 || w.height < 1 || w.x + w.width > viewport.width() || w.y + w.height > viewport.height())
                m_diagnostics.error(
                    m_windowLine,
                    {QT_TRANSLATE_NOOP("Diagnostic", "window: it is empty or not within the size %1 x %2"),
                     {viewport.width(), viewport.height()}});
        }
        if (!m_scene.mesh.lines.empty() && !m_scene.textures.empty()) { // lines have colours alone
            m_scene.materials.emplace_back();
            m_scene.mesh.faceMaterial.assign(m_scene.mesh.faceCount(), 0);
            for (const std::uint32_t face : m_scene.mesh.lines)
                m_scene.mesh.faceMaterial[face] = 1;
        }
        m_scene.note = m_notes.isEmpty() ? m_firstComment : m_notes.join(QLatin1Char('\n'));
        m_scene.bounds = boundingSphere(m_scene.mesh);
    }

    DiagnosticSink m_diagnostics;
    Scene m_scene;
    int m_line = 0;
    std::string_view m_directive;
    std::string_view m_rest;
    bool m_sizeSeen = false;
    bool m_sized = false;
    int m_windowLine = 0;
    QString m_firstComment;
    QStringList m_notes;
};

} // namespace

SceneLoad loadCase(const QString& path)
{
    InputBytes input = readInput(path);
    if (!input.problem)
        input.problem = takeOffByteOrderMark(input.bytes);
    if (input.problem)
        return {std::nullopt, {{Severity::Error, path, 0, *input.problem}}};
    return parseCase(input.bytes, path);
}

SceneLoad parseCase(const QByteArray& text, const QString& name) { return Parser(name).run(text); }

} // namespace rasterlens
