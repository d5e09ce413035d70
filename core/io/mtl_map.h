#pragma once
#include "core/io/text_input.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace rasterlens
{

/// What a `map_...` statement of an MTL file says.
struct MtlMap {
    std::string name;       ///< of the image file, as bytes; may hold blanks
    glm::vec2 scale{1, 1};  ///< -s: the texture is looked up at uv * scale + offset
    glm::vec2 offset{0, 0}; ///< -o
    float base = 0;         ///< -mm: a texel t becomes base + gain * t
    float gain = 1;
    bool clamp = false; ///< -clamp: the texture does not repeat
    char channel = 0;   ///< -imfchan: r, g, b, m (matte), l (luminance) or z; 0: none named

    friend bool operator==(const MtlMap&, const MtlMap&) = default;
};

/// Reads what follows the name of a `map_...` statement: options, then the file name.
///
/// covers  all options of the MTL text; `-s`, `-o` and `-t` may leave out their second and third number
/// out     nothing if no file is named
/// errors  warnings with line, and the option is left out: values that are wrong, options that no MTL text knows. A
///         warning, too, for options that would change the picture elsewhere and change nothing here
[[nodiscard]] std::optional<MtlMap> parseMtlMap(std::string_view keyword, std::string_view rest, int line,
                                                DiagnosticSink& diagnostics);

} // namespace rasterlens
