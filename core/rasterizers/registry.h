#pragma once
#include "core/base/reason.h"
#include "core/settings/rules.h"

#include <optional>

namespace rasterlens
{

/// What a rasterizer says of itself. Title and id are those of the choice in the field table.
struct RasterizerInfo {
    Algorithm algorithm;
    const char* source;
};

} // namespace rasterlens
