#pragma once
#include "core/base/reason.h"
#include "core/pipeline/frame.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace rasterlens
{

/// How a picture moves by itself, frame by frame.
enum class Motion : std::uint8_t {
    Turntable, ///< the eye goes round, a degree a frame
    Jitter     ///< the picture goes to the right by a pixel and back again, 1/256 of it a frame
};

struct MotionInfo {
    Motion motion;
    const char* id;    ///< stable: command line
    const char* title; ///< QT_TRANSLATE_NOOP("Motion", ...)
};

[[nodiscard]] std::span<const MotionInfo> motions();
[[nodiscard]] const MotionInfo& infoOf(Motion motion);
[[nodiscard]] std::optional<Motion> motionFromId(const QString& id);

/// Why a scene does not move so, a text of the context "Unsupported"; nothing where it does.
[[nodiscard]] std::optional<Reason> whyNotMoved(const Scene& scene, Motion motion);

/// How far frame n is: degrees, 0..359, or 1/256 of a pixel, 0..256.
[[nodiscard]] int motionPlace(Motion motion, std::size_t n);

/// What a frame is drawn of.
struct MovedScene {
    std::shared_ptr<const Scene> scene;
    Settings settings;
};

/// Frame n of a motion; 0 is the picture that does not move.
///
/// covers  the jitter of a scene with a camera moves eye and target: what lies as far away as the target goes by
///         1/256 of a pixel, what is nearer by more; that of a scene in clip space moves all corners alike
/// in      a scene for which whyNotMoved() is empty
[[nodiscard]] MovedScene movedScene(const std::shared_ptr<const Scene>& scene, Settings settings, Motion motion,
                                    std::size_t n);

/// Which pixels two frames of one size differ in.
struct FrameChange {
    std::size_t colors = 0; ///< pixels of another colour
    std::size_t owners = 0; ///< pixels that show another face

    friend bool operator==(const FrameChange&, const FrameChange&) = default;
};
/// in  frames with ids
[[nodiscard]] FrameChange changeBetween(const Frame& before, const Frame& now);

/// Reads a run of frames of a motion, `ID:FIRST-LAST`, or one frame, `ID:N`.
///
/// errors  nothing for any other text
struct MotionRun {
    Motion motion;
    std::pair<std::size_t, std::size_t> frames;
};
[[nodiscard]] std::optional<MotionRun> motionRunFromText(const QString& text);
/// `turntable:0-89, jitter:12`: what it reads.
[[nodiscard]] QString motionRunHelp();

} // namespace rasterlens
