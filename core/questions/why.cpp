#include "core/questions/why.h"

#include "core/observe/recorder.h"
#include "core/observe/step_text.h"
#include "core/pipeline/clipping.h"
#include "core/pipeline/pixel_area.h"
#include "core/render/draw.h"
#include "core/render/render_resolved.h"
#include "core/render/steps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace rasterlens
{
namespace
{

/// Watches one face through geometry.
class FaceWatch : public NullObserver
{
public:
    explicit FaceWatch(const ClipVolume& volume) : m_volume(&volume) {}

    std::array<glm::dvec4, 3> clip{};
    ClipPlanes outsideAll = 0; ///< planes all vertices are outside of
    ClipPlanes outsideAny = 0;
    ClipPlanes cutBy = 0;
    std::optional<ClipPlane> emptiedBy;
    std::optional<FacingDecision> facing;
    glm::dvec2 low{0, 0}; ///< samples: bounds of what got to the screen
    glm::dvec2 high{0, 0};
    bool onScreen = false;
    FaceFate fate = FaceFate::Rejected;

    void onVertex(std::uint32_t, int corner, std::uint32_t, const ClipVertex& vertex)
    {
        clip[std::size_t(corner)] = vertex.positionClip;
        const ClipPlanes code = outcode(vertex.positionClip, *m_volume).view;
        outsideAll = corner == 0 ? code : outsideAll & code;
        outsideAny |= code;
    }
    void onClipPlane(std::uint32_t, ClipPlane plane, const ClipPolygon&, const ClipPolygon& after)
    {
        cutBy |= planeBit(plane);
        if (after.count == 0)
            emptiedBy = plane;
    }
    void onCohenSutherland(std::uint32_t, const ClipPolygon&, const ClipPolygon&) { cutBy |= outsideAny; }
    void onFacing(std::uint32_t, const FacingDecision& decision) { facing = decision; }
    void onViewport(std::uint32_t, int, const ClipVertex&, const ScreenVertex& vertex)
    {
        low = onScreen ? glm::min(low, vertex.position) : vertex.position;
        high = onScreen ? glm::max(high, vertex.position) : vertex.position;
        onScreen = true;
    }
    void onFace(std::uint32_t, FaceFate f) { fate = f; }

    [[nodiscard]] bool boundsHold(const glm::dvec2& point, double margin) const
    {
        return onScreen && glm::all(glm::lessThanEqual(low - margin, point)) &&
               glm::all(glm::lessThanEqual(point, high + margin));
    }

    /// Whether the line from the eye through a point of the screen meets the face as it was before clipping.
    ///
    /// in      NDC
    /// source  Olano & Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997
    [[nodiscard]] bool isMetBy(const glm::dvec2& ndc) const
    {
        const glm::dvec3 ray(ndc, 1);
        const auto xyw = [&](std::size_t i) { return glm::dvec3(clip[i].x, clip[i].y, clip[i].w); };
        const double a = glm::dot(ray, glm::cross(xyw(1), xyw(2)));
        const double b = glm::dot(ray, glm::cross(xyw(2), xyw(0)));
        const double c = glm::dot(ray, glm::cross(xyw(0), xyw(1)));
        return (a >= 0 && b >= 0 && c >= 0 && a + b + c > 0) || (a <= 0 && b <= 0 && c <= 0 && a + b + c < 0);
    }

    [[nodiscard]] ClipPlanes rejectedBy() const
    {
        if (emptiedBy)
            return planeBit(*emptiedBy);
        return outsideAll != 0 ? outsideAll : outsideAny;
    }

private:
    const ClipVolume* m_volume;
};

WhyVerdict verdictOf(FaceFate fate)
{
    switch (fate) {
    case FaceFate::Rejected: return WhyVerdict::Rejected;
    case FaceFate::CulledBack: return WhyVerdict::CulledBack;
    case FaceFate::CulledFront: return WhyVerdict::CulledFront;
    case FaceFate::Degenerate: return WhyVerdict::Degenerate;
    case FaceFate::NonFinite: return WhyVerdict::NonFinite;
    case FaceFate::Rasterized: break;
    }
    return WhyVerdict::OutsideEdge;
}

/// Hands on what falls into one pixel: the others need no fragments.
template <class Stage>
class PixelStage
{
public:
    PixelStage(Stage& stage, const PixelRect& samples) : m_stage(&stage), m_samples(samples) {}

    void begin(const ScreenTriangle& triangle) { m_stage->begin(triangle); }

    void beginSample(int sample) requires requires(Stage& stage) { stage.beginSample(0); }
    {
        m_stage->beginSample(sample);
    }

    void finish() { m_stage->finish(); }

    [[nodiscard]] bool stopped() const { return m_stage->stopped(); }

    template <class... Known>
    void operator()(int x, int y, const Known&... known)
    {
        if (x >= m_samples.x && x < m_samples.x + m_samples.width && y >= m_samples.y &&
            y < m_samples.y + m_samples.height)
            (*m_stage)(x, y, known...);
    }

private:
    Stage* m_stage;
    PixelRect m_samples;
};

/// Finds what concerns the pixel, then draws that alone with the recorder.
class Inquiry
{
public:
    Inquiry(const Scene& scene, const Resolved& resolved, int x, int y, const std::stop_token& stop)
        : m_scene(scene), m_resolved(resolved), m_rules(resolved.rules), m_volume(clipVolume(m_rules)),
          m_geometry(scene, resolved.matrices, m_rules), m_stop(stop)
    {
        const int grid = m_rules.sampleGrid;
        m_report.x = x;
        m_report.y = y;
        m_report.sampleX = x * grid + grid / 2;
        m_report.sampleY = y * grid + grid / 2;
        m_report.rules = m_rules;
        m_margin = 1.0 + grid;
        if (m_rules.algorithm == Algorithm::ColumnFill) // its steep edges run on beyond their ends
            m_margin += m_rules.rows();
        m_centre =
            m_rules.multiSampled() ? testedPoint(m_rules, x, y) : glm::dvec2(m_report.sampleX, m_report.sampleY) + 0.5;
        m_ndc = {2 * m_centre.x / m_rules.columns() - 1, 1 - 2 * m_centre.y / m_rules.rows()};
    }

    WhyReport answer()
    {
        for (const std::uint32_t face : m_geometry.order())
            if (m_stop.stop_requested() || (look(face) == FaceFate::Rejected && !m_rules.continuesAfterReject))
                break;
        draw();
        judge();
        return std::move(m_report);
    }

private:
    FaceFate look(std::uint32_t face)
    {
        FaceWatch watch(m_volume);
        m_batch.clear();
        m_geometry.process(face, m_batch, watch);
        if (watch.fate == FaceFate::Rasterized && watch.boundsHold(m_centre, m_margin))
            m_toDraw.push_back(face);

        const bool drawn = watch.fate == FaceFate::Rasterized;
        const bool cutAway = watch.cutBy != 0 && (drawn || watch.fate == FaceFate::Rejected);
        const bool concerned = watch.fate == FaceFate::NonFinite ||
                               watch.boundsHold(m_centre, goesByCentre(face) ? 0 : m_margin) ||
                               ((cutAway || watch.fate == FaceFate::Rejected) && watch.isMetBy(m_ndc));
        if (!concerned)
            return watch.fate;
        WhyFace row;
        row.face = face;
        row.line = m_scene.mesh.lineOf(face);
        row.verdict = cutAway && watch.isMetBy(m_ndc) ? WhyVerdict::ClippedAway : verdictOf(watch.fate);
        row.planes = watch.fate == FaceFate::Rejected ? watch.rejectedBy() : watch.cutBy;
        row.facing = watch.facing;
        m_report.faces.push_back(row);
        return watch.fate;
    }

    /// Whether a face concerns the pixel only where its bounds hold the sample that the rows are about.
    [[nodiscard]] bool goesByCentre(std::uint32_t face) const
    {
        return passRules(m_rules, face).coversByCentres() && !m_rules.multiSampled() &&
               m_rules.coverageRule == CoverageRule::Centre;
    }

    void draw()
    {
        StepFilter filter;
        filter.pixels = PixelRect{m_report.x, m_report.y, 1, 1};
        filter.cap = std::numeric_limits<std::size_t>::max();
        std::stop_source ending;
        const std::stop_callback stopToo(m_stop, [&] { ending.request_stop(); });
        FramePlanes planes = clearedPlanes(m_rules, clearedPixel(m_scene, m_rules), m_rules.depthPerPixel, m_stop);
        StepRecorder recorder(m_scene, m_resolved, filter, planes, ending);
        Frame frame;
        if (m_resolved.mistakes.empty())
            drawPixel(frame, recorder);
        else // samples may be drawn at other places than their own, and the picture finished in other ways
            drawScene(m_scene, m_resolved, frame, {true, false, false}, recorder, m_stop);
        m_log = recorder.finish(false, frame.image);
        if (m_stop.stop_requested()) // there may be no frame
            return;
        m_report.depth = frame.depth[std::size_t(m_report.y) * std::size_t(m_rules.width) + std::size_t(m_report.x)];
        m_report.background = m_log->clear().color;
        m_report.color = frame.image.pixel(m_report.x, m_report.y);
        for (const std::uint32_t i : m_log->eventsOf(StepKind::Resolve))
            m_report.samples = m_log->payload<ResolveStep>(m_log->event(i)).pixel;
    }

    /// Draws what may touch the pixel, and of that only the fragments of the pixel.
    void drawPixel(Frame& frame, StepRecorder& recorder)
    {
        Framebuffer framebuffer(frame, m_rules, {true, false, false}, packColor(m_scene.background), m_stop);
        const glm::vec3 eye(m_resolved.matrices.eyeObject);
        if (m_rules.multiSampled())
            drawPixel(MultisampleStage<StepRecorder>(m_scene, m_rules, framebuffer.samples(), eye, recorder), recorder);
        else
            drawPixel(SampleRouter<StepRecorder>(m_scene, m_rules, framebuffer.samples(), eye, recorder), recorder);
        if (!m_stop.stop_requested())
            resolvePicture(framebuffer, m_rules, recorder);
    }

    template <class Stage>
    void drawPixel(Stage stage, StepRecorder& recorder)
    {
        stage.stopBy(m_stop);
        const int grid = m_rules.sampleGrid;
        const auto cover = coverFor<PixelStage<Stage>, StepRecorder>(m_rules);
        PixelStage<Stage> pixelStage(stage, {m_report.x * grid, m_report.y * grid, grid, grid});
        for (const std::uint32_t face : m_toDraw) {
            if (m_stop.stop_requested())
                return;
            m_batch.clear();
            m_geometry.process(face, m_batch, recorder);
            for (const ScreenTriangle& triangle : m_batch)
                if (isNear(triangle)) {
                    drawTriangle(triangle, m_rules, cover, pixelStage, recorder);
                    pixelStage.finish();
                }
        }
    }

    [[nodiscard]] bool isNear(const ScreenTriangle& triangle) const
    {
        const auto& [a, b, c] = triangle.vertices;
        const glm::dvec2 low = glm::min(glm::min(a.position, b.position), c.position) - m_margin;
        const glm::dvec2 high = glm::max(glm::max(a.position, b.position), c.position) + m_margin;
        return glm::all(glm::lessThanEqual(low, m_centre)) && glm::all(glm::lessThanEqual(m_centre, high));
    }

    /// Goes through what the recorder saw and raises verdicts.
    void judge()
    {
        if ((m_rules.fill == Fill::Solid || m_rules.firstPassFaces > 0) && m_rules.algorithm == Algorithm::EdgeWalking)
            judgeUntested();
        WhyFace* lastWritten = nullptr;
        for (const StepEvent& event : m_log->events()) {
            if (event.x != m_report.sampleX || event.y != m_report.sampleY || event.sample != 0)
                continue;
            const auto at = std::ranges::find(m_report.faces, event.face, &WhyFace::face);
            if (at == m_report.faces.end())
                continue;
            judgeEvent(*at, event);
            if (event.kind != StepKind::Write)
                continue;
            if (lastWritten != nullptr && lastWritten != &*at)
                lastWritten->overwrittenBy = at->face;
            lastWritten = &*at;
            m_report.visibleFace = at->face;
        }
        judgeHoles();
        if (m_rules.multiSampled())
            judgeMasks();
        if (m_rules.coverageRule !=
            CoverageRule::Centre) // faces that are near, but whose bounds do not touch the pixel
            std::erase_if(m_report.faces,
                          [](const WhyFace& row) { return row.verdict == WhyVerdict::OutsideEdge && !row.hasEdges; });
        measureAreas();
    }

    /// What a face covers of the pixel: what its samples tell as yes or no.
    void measureAreas()
    {
        NullObserver nobody;
        for (WhyFace& row : m_report.faces) {
            if (!row.hasEdges)
                continue;
            m_batch.clear();
            m_geometry.process(row.face, m_batch, nobody);
            for (const ScreenTriangle& triangle : m_batch)
                row.area += areaInPixel(triangle, m_report.x, m_report.y, m_rules.sampleGrid);
        }
    }

    /// Which samples the faces cover. What covers none and whose bounds do not even hold the first one does not concern
    /// the pixel.
    void judgeMasks()
    {
        NullObserver nobody;
        for (WhyFace& row : m_report.faces) {
            m_batch.clear();
            m_geometry.process(row.face, m_batch, nobody);
            for (const ScreenTriangle& triangle : m_batch)
                row.coveredSamples |= maskOf(triangle);
            if (row.hasEdges || row.coveredSamples == 0)
                continue;
            for (const ScreenTriangle& triangle : m_batch)
                if (const auto setup = setupOf(triangle, std::countr_zero(row.coveredSamples)))
                    judgeEdges(row, *setup, setup->at(m_centre));
        }
        std::erase_if(m_report.faces, [](const WhyFace& row) {
            return row.verdict == WhyVerdict::OutsideEdge && !row.hasEdges && row.coveredSamples == 0;
        });
    }

    [[nodiscard]] SampleMask maskOf(const ScreenTriangle& triangle) const
    {
        unsigned mask = 0;
        for (int sample = 0; sample < m_rules.patternSamples; ++sample)
            if (const auto setup = setupOf(triangle, sample); setup && covers(*setup, sample))
                mask |= 1U << sample;
        return static_cast<SampleMask>(mask);
    }

    void judgeEvent(WhyFace& row, const StepEvent& event) const
    {
        if (event.kind == StepKind::Sample) {
            judgeEdges(row, m_log->triangle(event)->setup, m_log->payload<SampleStep>(event).values);
        } else if (event.kind == StepKind::Fragment) {
            // Lines of a face meet in its corners: what was written is not taken back by what fails after it.
            if (row.verdict != WhyVerdict::Written || event.has(StepEvent::kPassed)) {
                row.fragment = m_log->payload<FragmentStep>(event);
                row.texels = texelFootprint(m_scene, m_rules, m_log->triangle(event)->screen, *row.fragment);
            }
            row.verdict = std::max(row.verdict, WhyVerdict::FailedDepth);
        } else if (event.kind == StepKind::Write) {
            row.write = m_log->payload<WriteStep>(event);
            row.verdict = WhyVerdict::Written;
        }
    }

    /// Edge walking tests no sample; what the edge functions would have said.
    void judgeUntested()
    {
        NullObserver nobody;
        for (const std::uint32_t face : m_toDraw) {
            const auto row = std::ranges::find(m_report.faces, face, &WhyFace::face);
            if (row == m_report.faces.end())
                continue;
            m_batch.clear();
            m_geometry.process(face, m_batch, nobody);
            for (const ScreenTriangle& triangle : m_batch)
                if (const auto setup = setupOf(triangle); setup && holdsSample(setup->bounds))
                    judgeEdges(*row, *setup, setup->at(m_centre));
        }
    }

    /// Where the alpha test cut a hole no fragment was heard of.
    void judgeHoles()
    {
        NullObserver nobody;
        for (WhyFace& row : m_report.faces) {
            if (row.verdict != WhyVerdict::FailedDepth || row.fragment)
                continue;
            const MaskTest test = maskTest(m_scene, row.face, m_rules);
            if (test.mask == nullptr)
                continue;
            m_batch.clear();
            m_geometry.process(row.face, m_batch, nobody);
            for (const ScreenTriangle& triangle : m_batch)
                if (const auto setup = setupOf(triangle); setup && covers(*setup))
                    judgeHole(row, triangle, test);
        }
    }

    void judgeHole(WhyFace& row, const ScreenTriangle& triangle, const MaskTest& test) const
    {
        const FaceInterpolation interpolation(triangle, triangle.area2, m_rules);
        const Weights screen = interpolation.weightsAt(shadedAt(triangle));
        const float opacity = opacityAt(test, interpolation, screen, interpolation.perspective(screen));
        if (!(opacity < kLeastOpacity))
            return;
        row.verdict = WhyVerdict::Hole;
        row.opacity = opacity;
    }

    /// Where the alpha test of a triangle that covers the sample looks.
    [[nodiscard]] glm::dvec2 shadedAt(const ScreenTriangle& triangle) const
    {
        const glm::dvec2 centre = glm::dvec2(m_report.sampleX, m_report.sampleY) + 0.5;
        if (!m_rules.multiSampled())
            return centre;
        const SampleMask shaded = m_rules.attributeAt == AttributeAt::Sample ? SampleMask(1) : maskOf(triangle);
        return centre + shadingOffset(m_rules, shaded);
    }

    [[nodiscard]] bool covers(const StepSetup& setup, int sample = 0) const
    {
        const EdgeValues values = testedValues(setup, m_rules, m_report.sampleX, m_report.sampleY, sample);
        return holdsSample(setup.bounds) && std::ranges::all_of(std::array{0U, 1U, 2U}, [&](std::size_t i) {
                   return values[i] >= setup.edges[i].threshold;
               });
    }

    /// The set-up by which a sample is tested, as it lies on the screen.
    [[nodiscard]] std::optional<StepSetup> setupOf(const ScreenTriangle& triangle, int sample = 0) const
    {
        const glm::dvec2 offset = m_rules.multiSampled() ? testedOffset(m_rules, sample).pixels() : glm::dvec2(0);
        ScreenTriangle moved = triangle;
        for (ScreenVertex& vertex : moved.vertices)
            vertex.position -= offset;
        const auto as = [&]<class T>(T) -> std::optional<StepSetup> {
            const auto setup = setupTriangle<T>(moved, m_rules);
            if (!setup)
                return std::nullopt;
            StepSetup out = stepSetup(*setup);
            out.move(offset);
            return out;
        };
        switch (m_rules.numberType) {
        case NumberType::Fixed: return as(std::int64_t(0));
        case NumberType::Float32: return as(0.0F);
        case NumberType::Float64: break;
        }
        return as(0.0);
    }

    [[nodiscard]] bool holdsSample(const PixelRect& r) const
    {
        return m_report.sampleX >= r.x && m_report.sampleX < r.x + r.width && m_report.sampleY >= r.y &&
               m_report.sampleY < r.y + r.height;
    }

    /// Raises the verdict of a face by one of its pieces: the piece that got furthest decides.
    void judgeEdges(WhyFace& row, const StepSetup& setup, const EdgeValues& values) const
    {
        const DecidingEdge deciding = decidingEdge(setup, values, m_rules);
        std::array<WhyEdge, 3> edges;
        for (std::size_t i = 0; i < 3; ++i) {
            const StepEdge& edge = setup.edges[i];
            const bool passed = deciding.sign == DecidingEdge::Sign::AtMost || values[i] >= edge.threshold ||
                                m_rules.insideTest == InsideTest::None;
            edges[i] = {edgeName(setup, int(i)), values[i], edge.threshold, edge.side, passed};
        }
        const WhyVerdict verdict = deciding.isInside() ? WhyVerdict::FailedDepth
                                   : deciding.isTie()  ? WhyVerdict::LostTie
                                                       : WhyVerdict::OutsideEdge;
        const bool further = !row.hasEdges || verdict > row.verdict ||
                             (verdict == row.verdict && !deciding.isInside() && row.edge >= 0 &&
                              deciding.value > row.edges[std::size_t(row.edge)].value);
        if (!further)
            return;
        row.hasEdges = true;
        row.edges = edges;
        row.edge = deciding.isInside() ? -1 : int(deciding.edge);
        row.unitsPerArea = setup.unitsPerArea;
        if (row.verdict != WhyVerdict::ClippedAway || verdict > WhyVerdict::OutsideEdge)
            row.verdict = verdict;
    }

    const Scene& m_scene;
    const Resolved& m_resolved;
    const Rules& m_rules;
    ClipVolume m_volume;
    Geometry m_geometry;
    std::stop_token m_stop;
    std::vector<ScreenTriangle> m_batch;
    std::vector<std::uint32_t> m_toDraw;
    std::shared_ptr<const StepLog> m_log;
    glm::dvec2 m_centre; ///< samples
    glm::dvec2 m_ndc;
    double m_margin = 0; ///< samples: what lies as near as this may draw into the pixel, also as lines
    WhyReport m_report;
};

/// A mistake is the reason for a face's verdict if without it another sentence were true.
void nameMistakes(WhyReport& report, const Scene& scene, const Settings& settings, const std::stop_token& stop)
{
    for (const QString& id : settings.mistakes) {
        const Mistake* const mistake = findMistake(id);
        Settings without = settings;
        without.mistakes.removeOne(id);
        const Resolved resolved = resolve(without, scene);
        const bool known = !unsupported(scene, without, resolved);
        const WhyReport other = known ? Inquiry(scene, resolved, report.x, report.y, stop).answer() : WhyReport();
        if (stop.stop_requested())
            return;
        if (report.samples && other.samples && *report.samples != *other.samples)
            report.without.push_back({mistake, *other.samples});
        for (WhyFace& row : report.faces) {
            const WhyFace* const same = other.find(row.face);
            if (same == nullptr || whyText(other, *same) != whyText(report, row))
                row.because.push_back(mistake);
        }
    }
}

} // namespace

const WhyFace* WhyReport::find(std::uint32_t face) const
{
    const auto at = std::ranges::find(faces, face, &WhyFace::face);
    return at == faces.end() ? nullptr : &*at;
}

std::int32_t WhyReport::lineOf(std::uint32_t face) const
{
    const WhyFace* const row = find(face);
    return row == nullptr ? -1 : row->line;
}

WhyReport why(const Scene& scene, const Settings& settings, int x, int y, const std::stop_token& stop)
{
    const Settings shown = recordedAs(settings);
    const Resolved resolved = resolve(shown, scene);
    WhyReport report = Inquiry(scene, resolved, x, y, stop).answer();
    nameMistakes(report, scene, shown, stop);
    // Lines and columns elsewhere do not concern the pixel, unless it is for a mistake that they do.
    std::erase_if(report.faces, [&](const WhyFace& row) {
        return row.verdict == WhyVerdict::OutsideEdge && row.because.empty() &&
               !passRules(report.rules, row.face).coversByCentres();
    });
    return report;
}

} // namespace rasterlens
