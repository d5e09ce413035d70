#pragma once
#include "core/base/reason.h"
#include "core/pipeline/frame.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rasterlens
{

/// A renderer that is not ours, asked to draw what ours draw and judged as they are. All calls come from the thread
/// that made it, its end included.
class OtherRenderer
{
public:
    OtherRenderer() = default;
    OtherRenderer(const OtherRenderer&) = delete;
    OtherRenderer& operator=(const OtherRenderer&) = delete;
    virtual ~OtherRenderer() = default;

    /// The id of its variant: stable on one machine, no spaces.
    [[nodiscard]] virtual QString id() const = 0;
    /// What it calls itself.
    [[nodiscard]] virtual QString name() const = 0;

    /// Why it does not draw this, or nothing; a text of the context "Unsupported".
    [[nodiscard]] virtual std::optional<Reason> unsupported(const Scene& scene, const Settings& settings) const = 0;

    /// Takes what draw() is to draw.
    ///
    /// in   settings for which unsupported() is empty
    virtual void load(const Scene& scene, const Settings& settings) = 0;

    /// Clears, draws what was loaded and brings the picture back to memory; depth, ids and coverage where they are
    /// asked for. Holes of masks are not cut.
    virtual void draw(Frame& frame, Outputs outputs) = 0;
};

/// The other renderers that a machine has; or why there is none, a text of the context "Experiment".
struct OtherRenderers {
    std::vector<std::unique_ptr<OtherRenderer>> renderers;
    std::optional<Reason> lack;
};
using FindRenderers = std::function<OtherRenderers()>;

} // namespace rasterlens
