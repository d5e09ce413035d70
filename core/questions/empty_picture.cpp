#include "core/questions/empty_picture.h"

#include "core/base/grouped.h"
#include "core/render/render.h"

#include <algorithm>
#include <array>

namespace rasterlens
{
namespace
{

constexpr QSize kMostForSample{1920, 1080};
constexpr std::size_t kSampleFaces = 400;

/// Every so many-th face of a scene, and only the vertices of those.
Scene sampleOf(const Scene& scene)
{
    Scene sample;
    sample.space = scene.space;
    sample.bounds = scene.bounds;
    sample.materials = {Material{}};
    sample.mesh.origin = scene.mesh.origin;
    const std::size_t step = std::max<std::size_t>(1, scene.mesh.faceCount() / kSampleFaces);
    for (std::size_t face = 0; face < scene.mesh.faceCount(); face += step)
        for (std::size_t corner = 3 * face; corner < 3 * face + 3; ++corner) {
            sample.mesh.indices.push_back(static_cast<std::uint32_t>(sample.mesh.vertices.size()));
            sample.mesh.vertices.push_back(scene.mesh.vertices[scene.mesh.indices[corner]]);
        }
    return sample;
}

Statistics countedOf(const Scene& scene, const Settings& settings)
{
    Frame frame;
    return renderCounted(scene, settings, frame, {.depth = true, .ids = false, .coverage = false, .picture = false});
}

/// What became of most of the faces that never reached the screen.
EmptyPicture mainFate(const Statistics::Faces& faces)
{
    struct Row {
        std::uint64_t count;
        const char* why;
        const char* option;
        const char* action;
    };
    const std::array<Row, 5> rows{{
        {faces.degenerate, QT_TRANSLATE_NOOP("Diagnostic", "%1 of %2 faces are seen edge-on or have no area"),
         QT_TRANSLATE_NOOP("Diagnostic", "orbit, for example --orbit 30,30"),
         QT_TRANSLATE_NOOP("Diagnostic", "orbit by dragging the canvas")},
        {faces.culledBack, QT_TRANSLATE_NOOP("Diagnostic", "%1 of %2 faces show their back and are culled"),
         QT_TRANSLATE_NOOP("Diagnostic", "--culling none draws them"),
         QT_TRANSLATE_NOOP("Diagnostic", "C switches culling")},
        {faces.culledFront, QT_TRANSLATE_NOOP("Diagnostic", "%1 of %2 faces show their front and are culled"),
         QT_TRANSLATE_NOOP("Diagnostic", "--culling none draws them"),
         QT_TRANSLATE_NOOP("Diagnostic", "C switches culling")},
        {faces.rejected, QT_TRANSLATE_NOOP("Diagnostic", "%1 of %2 faces lie outside the view"),
         QT_TRANSLATE_NOOP("Diagnostic", "--view fit shows all"),
         QT_TRANSLATE_NOOP("Diagnostic", "Home shows the whole scene")},
        {faces.nonFinite, QT_TRANSLATE_NOOP("Diagnostic", "%1 of %2 faces have a corner that is no finite number"),
         QT_TRANSLATE_NOOP("Diagnostic", "the scene has to be mended"),
         QT_TRANSLATE_NOOP("Diagnostic", "the scene has to be mended")},
    }};
    const Row& most = *std::ranges::max_element(rows, {}, &Row::count);
    return {{most.why, {grouped(most.count), grouped(faces.submitted)}}, most.option, most.action};
}

} // namespace

std::optional<EmptyPicture> whyEmpty(const Statistics& statistics)
{
    const Statistics::Faces& faces = statistics.faces;
    if (statistics.pixels.written > 0)
        return std::nullopt;
    if (faces.submitted == 0)
        return EmptyPicture{QT_TRANSLATE_NOOP("Diagnostic", "there are no faces"),
                            QT_TRANSLATE_NOOP("Diagnostic", "another scene has some"),
                            QT_TRANSLATE_NOOP("Diagnostic", "another scene has some")};
    if (faces.rasterized == 0)
        return mainFate(faces);
    if (statistics.pixels.covered == 0)
        return EmptyPicture{
            {QT_TRANSLATE_NOOP("Diagnostic", "%1 faces reach the screen, but each lies between the centres of pixels"),
             {grouped(faces.rasterized)}},
            QT_TRANSLATE_NOOP("Diagnostic", "more --samples or a larger --size shows them"),
            QT_TRANSLATE_NOOP("Diagnostic", "more samples a pixel or a larger picture shows them")};
    return EmptyPicture{{QT_TRANSLATE_NOOP("Diagnostic", "all %1 fragments failed the depth test"),
                         {grouped(statistics.pixels.covered)}},
                        QT_TRANSLATE_NOOP("Diagnostic", "--depth-test less is the usual one"),
                        QT_TRANSLATE_NOOP("Diagnostic", "T changes the depth test")};
}

std::optional<EmptyPicture> whyEmpty(const Scene& scene, const Settings& settings)
{
    Settings some = settings;
    if (some.size.width() > kMostForSample.width() || some.size.height() > kMostForSample.height())
        some.size = some.size.scaled(kMostForSample, Qt::KeepAspectRatio).expandedTo(QSize(1, 1));
    if (scene.mesh.faceCount() > 4 * kSampleFaces && some.mistakes.empty()) {
        some.shading = Shading::Flat;
        const Scene sample = sampleOf(scene);
        if (!unsupported(sample, some) && !whyEmpty(countedOf(sample, some)))
            return std::nullopt;
    }
    return unsupported(scene, settings) ? std::nullopt : whyEmpty(countedOf(scene, settings));
}

Reason sentenceOf(const EmptyPicture& empty, const Reason& help)
{
    return {QT_TRANSLATE_NOOP("Diagnostic", "nothing is seen: %1; %2"), {empty.why, help}};
}

} // namespace rasterlens
