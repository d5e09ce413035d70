#pragma once
#include "core/io/text_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace rasterlens
{

/// The statement's name as tinyobjloader knows it, whatever its letter case is: `Kd` for `kd`, `map_Kd` for `MAP_KD`.
///
/// out     as long as `keyword`; in the case of the file where the name is not known
[[nodiscard]] std::string canonicalMtlKeyword(std::string_view keyword);

/// Collects the statements of an MTL file that are not drawn, so that none is left out in silence: each name is told
/// once, with its first line and how often it stands.
class UnusedStatements
{
public:
    /// in   a statement with its canonical name, and what follows it
    void add(int line, std::string_view keyword, std::string_view rest);

    /// A warning about those that would be seen (maps, glow, mirrors), a note about the others: values that change
    /// nothing, and parts of lighting models that are not drawn here. Statements that no MTL text knows are a warning,
    /// too.
    void report(DiagnosticSink& diagnostics) const;

private:
    enum class Kind { Seen, Silent, Unknown };

    struct Row {
        std::string keyword;
        Kind kind;
        int line;
        int count;
    };

    static Kind kindOf(std::string_view keyword, std::string_view rest);

    std::vector<Row> m_rows;
};

} // namespace rasterlens
