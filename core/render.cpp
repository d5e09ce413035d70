#include "core/render.h"

namespace rasterlens {

std::optional<QString> unsupported(const Scene&, const Settings&) { return std::nullopt; }

void render(const Scene&, const Settings&, Frame&, Outputs, std::stop_token) {}

Statistics renderCounted(const Scene&, const Settings&, Frame&, Outputs, std::stop_token) { return {}; }

}  // namespace rasterlens
