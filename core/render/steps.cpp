#include "core/render/steps.h"

#include "core/base/give_back.h"
#include "core/observe/recorder.h"
#include "core/render/counted_stage.h"
#include "core/render/draw.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rasterlens
{
namespace
{

/// A window ends when so many samples have changed in it: 20 MB.
constexpr std::size_t kMostEffects = std::size_t(1) << 20;

/// A record that draws by the stages of render().
class DrawnRecord final : public StepRecord
{
public:
    DrawnRecord(std::shared_ptr<const Scene> scene, Resolved resolved, const StepFilter& filter, FramePlanes cleared,
                std::size_t mostEvents, const RecordMemory& memory, const std::stop_token& stop)
        : StepRecord(cleared, memory), m_scene(std::move(scene)), m_resolved(std::move(resolved)), m_filter(filter),
          m_geometry(*m_scene, m_resolved.matrices, m_resolved.rules), m_order(m_geometry.order())
    {
        std::stop_source ending;
        const std::stop_callback stopToo(stop, [&] { ending.request_stop(); });
        StepRecorder recorder(*m_scene, m_resolved, m_filter, cleared, ending, mostEvents, m_index);
        draw({}, cleared, recorder, ending.get_token());
        m_index.seal();
        m_stopped = stop.stop_requested();
        m_truncated = recorder.isFull();
        m_emptyWindow = recorder.finish(m_stopped);
        if (m_resolved.rules.resolve != Resolve::AllSamples && !m_stopped && !m_truncated)
            m_finished = finishedPicture(stop);
    }

    [[nodiscard]] std::shared_ptr<const StepLog> window(std::size_t first, std::size_t count,
                                                        FramePlanes& planes) const override
    {
        const std::size_t number = m_index.pointBefore(first);
        const ResumePoint& from = m_index.point(number);
        m_index.history().restore(static_cast<std::uint32_t>(number), planes);
        const std::size_t last = std::min(first + std::max<std::size_t>(count, 1), size());
        const RecordedPart part{first, last, kMostEffects, from, m_index.doubleHits()};
        std::stop_source ending;
        StepRecorder recorder(*m_scene, m_resolved, m_filter, planes, ending, part);
        draw(from, planes, recorder, ending.get_token());
        return recorder.finish(false);
    }

    [[nodiscard]] std::shared_ptr<const StepLog> coverage(const ScreenTriangle& triangle,
                                                          const PixelRect& pixels) const override
    {
        StepFilter filter;
        filter.pixels = pixels;
        filter.cap = std::numeric_limits<std::size_t>::max();
        FramePlanes planes; // nothing is written
        StepRecorder recorder(*m_scene, m_resolved, filter, planes, {});
        Unheeding stage;
        drawTriangle(triangle, m_resolved.rules, coverFor<Unheeding, StepRecorder>(m_resolved.rules), stage, recorder);
        return recorder.finish(false);
    }

private:
    /// A stage that does nothing with the samples.
    struct Unheeding {
        void begin(const ScreenTriangle&) {}
        template <class... Sample>
        void operator()(const Sample&...)
        {
        }
    };

    /// Draws on from a moment.
    void draw(const ResumePoint& from, FramePlanes& planes, StepRecorder& recorder, const std::stop_token& stop) const
    {
        if (stop.stop_requested()) // the planes may be unfinished
            return;
        const Rules& rules = m_resolved.rules;
        SampleBuffer samples;
        samples.columns = rules.columns();
        samples.rows = rules.rows();
        samples.stride = rules.strideIsRows ? rules.rows() : rules.columns();
        samples.color = planes.color.data();
        samples.depth = rules.depthTested ? planes.depth.data() : nullptr;
        if (!from.resolves)
            drawAllFaces(from, samples, recorder, stop);
        samples.ids = planes.owners.data(); // the recorder writes them
        if (rules.samplesPerPixel() > 1)
            resolvePixels(from, samples, recorder, stop);
    }

    void drawAllFaces(const ResumePoint& from, SampleBuffer samples, StepRecorder& recorder,
                      const std::stop_token& stop) const
    {
        const Rules& rules = m_resolved.rules;
        std::vector<std::uint32_t> unseen; // with overdraw the picture shows counts, whatever is drawn
        if (rules.shading == Shading::Overdraw) {
            unseen.resize(storedSamples(rules));
            samples.color = unseen.data();
        }
        const glm::vec3 eye(m_resolved.matrices.eyeObject);
        const auto drawInto = [&]<class Stage>(Stage stage) {
            stage.stopBy(stop);
            drawFaces(from, CountedStage<Stage>(std::move(stage), recorder), recorder);
        };
        if (rules.multiSampled())
            drawInto(MultisampleStage<StepRecorder>(*m_scene, rules, samples, eye, recorder));
        else if (SampleRouter<StepRecorder>::wanted(rules))
            drawInto(SampleRouter<StepRecorder>(*m_scene, rules, samples, eye, recorder));
        else
            drawInto(FragmentStage<StepRecorder>(*m_scene, rules, samples, eye, recorder));
    }

    void resolvePixels(const ResumePoint& from, const SampleBuffer& samples, StepRecorder& recorder,
                       const std::stop_token& stop) const
    {
        const Rules& rules = m_resolved.rules;
        const auto width = static_cast<std::size_t>(rules.width);
        const std::size_t count = width * static_cast<std::size_t>(rules.height);
        for (std::size_t n = from.resolves ? from.calls : 0; n < count && !stop.stop_requested(); ++n) {
            recorder.beginPixel(n);
            recorder.onResolve(resolvedPixel(samples, rules, static_cast<int>(n % width), static_cast<int>(n / width)));
        }
    }

    template <class Stage>
    void drawFaces(const ResumePoint& from, Stage stage, StepRecorder& recorder) const
    {
        const Rules& rules = m_resolved.rules;
        const Cover<Stage, StepRecorder> cover = coverFor<Stage, StepRecorder>(rules);
        std::vector<ScreenTriangle> triangles;
        std::span<const std::uint32_t> faces = std::span(m_order).subspan(from.face);
        while (!faces.empty() && !stage.stopped()) {
            recorder.beginFace(m_order.size() - faces.size(), faces.front());
            faces = m_geometry.processBatch(faces, triangles, recorder);
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                if (!recorder.takeTriangle(i))
                    continue;
                drawTriangle(triangles[i], rules, cover, stage, recorder);
                stage.finish();
            }
        }
    }

    [[nodiscard]] QImage finishedPicture(const std::stop_token& stop) const
    {
        Frame frame;
        NullObserver observer;
        drawScene(*m_scene, m_resolved, frame, {}, observer, stop);
        return frame.image;
    }

    std::shared_ptr<const Scene> m_scene;
    Resolved m_resolved;
    StepFilter m_filter;
    Geometry m_geometry;
    std::vector<std::uint32_t> m_order;
};

} // namespace

Settings recordedAs(Settings settings)
{
    if (settings.algorithm == Algorithm::Tiled)
        settings.algorithm = Algorithm::EdgeEquation;
    return settings;
}

std::shared_ptr<const StepLog> renderSteps(const Scene& scene, const Settings& settings, const StepFilter& filter,
                                           std::stop_token stop)
{
    const Settings shown = recordedAs(settings);
    std::stop_source ending;
    const std::stop_callback stopToo(stop, [&] { ending.request_stop(); });
    const Resolved resolved = resolve(shown, scene);
    FramePlanes planes = clearedPlanes(resolved.rules, clearedPixel(scene, resolved.rules),
                                       resolved.rules.depthPerPixel || resolved.rules.depthInLockstep,
                                       stop); // what is read is not what is stored
    StepRecorder recorder(scene, resolved, filter, planes, ending);
    Frame frame;
    drawScene(scene, resolved, frame, {}, recorder, ending.get_token());
    return recorder.finish(stop.stop_requested(), frame.image);
}

namespace
{

std::shared_ptr<const StepRecord> recordUpTo(std::size_t mostEvents, std::shared_ptr<const Scene> scene,
                                             const Settings& settings, const StepFilter& filter,
                                             const std::stop_token& stop, const RecordMemory& memory)
{
    Resolved resolved = resolve(recordedAs(settings), *scene);
    FramePlanes planes = clearedPlanes(resolved.rules, clearedPixel(*scene, resolved.rules), true, stop);
    auto record = std::make_shared<DrawnRecord>(std::move(scene), std::move(resolved), filter, std::move(planes),
                                                mostEvents, memory, stop);
    giveBackFreedMemory(); // the planes, and what was kept on the way
    return record;
}

} // namespace

std::shared_ptr<const StepRecord> recordSteps(std::shared_ptr<const Scene> scene, const Settings& settings,
                                              const StepFilter& filter, std::stop_token stop,
                                              const RecordMemory& memory)
{
    return recordUpTo(StepIndex::kMostPositions, std::move(scene), settings, filter, stop, memory);
}

std::shared_ptr<const StepRecord> recordBeginning(std::shared_ptr<const Scene> scene, const Settings& settings,
                                                  const StepFilter& filter, std::stop_token stop)
{
    return recordUpTo(filter.cap, std::move(scene), settings, filter, stop, {});
}

} // namespace rasterlens
