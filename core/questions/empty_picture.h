#pragma once
#include "core/base/reason.h"
#include "core/pipeline/statistics.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <optional>

namespace rasterlens
{

/// Why nothing is seen, and what to do about it; texts of the context "Diagnostic".
struct EmptyPicture {
    Reason why;
    Reason option; ///< what helps on the command line
    Reason action; ///< what helps in the window
};

/// Nothing where something was drawn.
[[nodiscard]] std::optional<EmptyPicture> whyEmpty(const Statistics& statistics);

/// Says why a scene that has not been drawn yet would show nothing; nothing where something would be seen.
///
/// in     settings for which unsupported() is empty
/// cost   as a rule that of a picture of a few hundred faces; where that is empty, of the whole picture
[[nodiscard]] std::optional<EmptyPicture> whyEmpty(const Scene& scene, const Settings& settings);

/// `nothing is seen: why; what helps`.
[[nodiscard]] Reason sentenceOf(const EmptyPicture& empty, const Reason& help);

} // namespace rasterlens
