// The pipeline: settings and clip-space faces from the input. Conservation laws, tiled against edge equation, the step
// record against a fresh run, forth and back, and `why` against the picture.
#include "core/questions/why.h"
#include "core/render/steps.h"
#include "core/settings/mistakes.h"
#include "tests/fuzz/frames.h"

#include <algorithm>
#include <bit>
#include <memory>

using namespace rasterlens;

namespace
{

/// A coordinate of many kinds: on the subpixel grid, on a border of the view volume, large, tiny, no number.
float coordinate(fuzz::Bytes& bytes)
{
    const int kind = bytes.byte();
    const auto value = static_cast<float>(static_cast<std::int16_t>(bytes.word()));
    switch (kind % 16) {
    case 0: return 0;
    case 1: return 1;
    case 2: return -1;
    case 3: return value * 1e10F;
    case 4: return value * 1e-30F;
    case 5: return std::bit_cast<float>(std::uint32_t(bytes.word()) << 16 | std::uint32_t(bytes.word()));
    default: return value / 16384;
    }
}

Scene facesOf(fuzz::Bytes& bytes)
{
    constexpr std::size_t kMostVertices = 24;
    Scene scene;
    scene.space = SceneSpace::Clip;
    scene.lit = false;
    scene.materials.emplace_back();
    const std::size_t count = 3 + std::size_t(bytes.upTo(kMostVertices - 3));
    for (std::size_t i = 0; i < count; ++i) {
        MeshVertex vertex;
        for (int k = 0; k < 3; ++k)
            vertex.position[k] = coordinate(bytes);
        vertex.position.w = bytes.upTo(2) == 0 ? coordinate(bytes) : 1;
        vertex.color = {float(i % 3 == 0), float(i % 3 == 1), float(i % 3 == 2)};
        vertex.uv = {float(i % 5) / 4, float(i % 7) / 6};
        scene.mesh.vertices.push_back(vertex);
    }
    do
        for (int k = 0; k < 3; ++k)
            scene.mesh.indices.push_back(std::uint32_t(bytes.upTo(int(count) - 1)));
    while (bytes.left() > 0 && scene.mesh.faceCount() < 12);
    scene.bounds = boundingSphere(scene.mesh);
    return scene;
}

Settings settingsOf(fuzz::Bytes& bytes)
{
    Settings settings;
    settings.size = {1 + bytes.upTo(23), 1 + bytes.upTo(23)};
    const auto fields = settingsFields();
    for (int changes = bytes.upTo(5); changes > 0; --changes) {
        const SettingsField& field = fields[std::size_t(bytes.upTo(int(fields.size()) - 1))];
        field.set(settings, field.minimum + bytes.upTo(field.maximum - field.minimum));
    }
    if (bytes.upTo(3) == 0)
        settings.mistakes = {QString::fromLatin1(mistakes()[std::size_t(bytes.upTo(int(mistakes().size()) - 1))].id)};
    settings.threads = std::min(settings.threads, 4);
    return settings;
}

/// Tiled draws what edge equation draws: bits but for colours, which may be one step off.
void requireTiledAgrees(const Scene& scene, Settings settings, const Frame& frame)
{
    settings.algorithm = Algorithm::Tiled;
    if (unsupported(scene, settings))
        return;
    Frame tiled;
    render(scene, settings, tiled, {.depth = true, .ids = true, .coverage = true});
    fuzz::require(tiled.coverage == frame.coverage, "tiled covers what edge equation covers");
    fuzz::require(tiled.ids == frame.ids, "tiled has the faces of edge equation");
    fuzz::require(std::ranges::equal(tiled.depth, frame.depth, {}, std::bit_cast<std::uint32_t, float>,
                                     std::bit_cast<std::uint32_t, float>),
                  "tiled has the depths of edge equation");
}

/// The frame at positions of the record, met forth and back, is that of a fresh cursor; its end is the picture.
void requireReplay(const Scene& scene, const Settings& settings, const Frame& frame, fuzz::Bytes& bytes)
{
    constexpr RecordMemory kLittle{60, std::size_t(1) << 18, 100};
    const auto record = recordSteps(std::make_shared<const Scene>(scene), settings, {}, {}, kLittle);
    StepCursor cursor(record);
    const auto anywhere = [&] { return std::size_t(bytes.word()) % (record->size() + 1); };
    for (int i = 0; i < 3; ++i) {
        const std::size_t to = anywhere();
        cursor.moveTo(to);
        cursor.moveTo(to + 1);
        cursor.moveTo(to);
        StepCursor fresh(record);
        fresh.moveTo(to);
        fuzz::require(cursor.image() == fresh.image(), "going back restores the picture");
        fuzz::require(std::ranges::equal(cursor.sampleOwners(), fresh.sampleOwners()), "and the faces");
        fuzz::require(cursor.counters() == fresh.counters(), "and the counters");
    }
    cursor.moveTo(record->size());
    fuzz::require(cursor.image() == frame.image, "the record ends in the picture");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Bytes bytes(data, size);
    const Settings settings = settingsOf(bytes);
    const Scene scene = facesOf(bytes);
    if (unsupported(scene, settings))
        return 0;
    const Outputs outputs{.depth = true, .ids = true, .coverage = true};
    if (unsupportedOutputs(settings, outputs)) {
        fuzz::requireDrawn(scene, settings);
        return 0;
    }
    Frame frame;
    render(scene, settings, frame, outputs);
    Frame again;
    const Statistics statistics = renderCounted(scene, settings, again, outputs);
    fuzz::requireLaws(statistics, scene, settings);
    fuzz::require(again.image == frame.image && again.ids == frame.ids, "counting changes nothing");
    if (settings.algorithm == Algorithm::EdgeEquation && settings.mistakes.isEmpty())
        requireTiledAgrees(scene, settings, frame);
    if (settings.algorithm != Algorithm::Tiled)
        requireReplay(scene, settings, frame, bytes);
    const int x = bytes.upTo(settings.size.width() - 1);
    const int y = bytes.upTo(settings.size.height() - 1);
    const WhyReport report = why(scene, settings, x, y);
    const std::int32_t shown = frame.ids[std::size_t(y) * std::size_t(settings.size.width()) + std::size_t(x)];
    fuzz::require((report.visibleFace ? std::int32_t(*report.visibleFace) : -1) == shown, "why names the face shown");
    return 0;
}
