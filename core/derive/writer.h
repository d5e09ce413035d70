#pragma once
#include "core/derive/derivation.h"
#include "core/derive/expression.h"

#include <initializer_list>
#include <map>
#include <optional>

namespace rasterlens
{

/// Writes a derivation. Formulas are texts in which symbols stand in braces: the program computes with the text that is
/// printed, so the two cannot differ.
class DerivationWriter
{
public:
    DerivationWriter(DerivationTopic topic, Reason place);

    /// A symbol whose value comes from the scene or from a stage. A symbol that has a value keeps it.
    void given(const QString& id, double value, CanvasPart canvas = {});
    /// A symbol that is four bits.
    void givenBits(const QString& id, unsigned bits, CanvasPart canvas = {});
    /// What a symbol that a line will define is in the picture.
    void show(const QString& id, CanvasPart canvas) { m_canvas[id] = std::move(canvas); }

    /// A line `left = formula`. Symbols on the left that have no value yet get what the formula gives; a symbol that
    /// has one keeps it, and the line says how it comes about.
    ///
    /// in   left: `{E_AB}`, or a list `({AB_x}, {AB_y})`; formula: see evaluate()
    void line(const QString& left, const QString& formula, Reason words, std::vector<CanvasPart> marks = {});
    /// A comparison of two formulas.
    void compare(const QString& formula, Reason words, std::vector<CanvasPart> marks = {});
    /// A line of the listing.
    void code(const QString& text) { m_derivation.listing.push_back(text); }

    void figure(DerivationFigure figure) { m_derivation.figures.push_back(std::move(figure)); }

    [[nodiscard]] double valueOf(const QString& id) const;
    /// Where a symbol that has a value stands in Derivation::symbols.
    [[nodiscard]] int indexOf(const QString& id) const { return m_index.at(id); }
    [[nodiscard]] bool knows(const QString& id) const { return m_index.contains(id); }
    [[nodiscard]] Derivation take() { return std::move(m_derivation); }

private:
    void define(const QString& id, const Quantity& quantity, CanvasPart canvas);
    [[nodiscard]] Quantity quantityOf(const QString& id) const;
    [[nodiscard]] std::vector<DerivationToken> symbolTokens(const QString& formula) const;
    [[nodiscard]] std::vector<DerivationToken> numberTokens(const QString& formula) const;

    Derivation m_derivation;
    std::map<QString, int> m_index; ///< of a symbol, by its id
    std::vector<Quantity> m_values; ///< one a symbol
    std::map<QString, CanvasPart> m_canvas;
};

/// A float in the fewest digits that name it, 0.37375 and not 0.373750001: what a float holds is no more exact.
[[nodiscard]] double inFewestDigits(float value);

/// A pattern with the names of symbols in place of %1, %2 ..
///
/// in  every place has a name; a name may have no place
[[nodiscard]] QString filled(const char* pattern, std::initializer_list<QString> names);

template <class... Names>
[[nodiscard]] QString formula(const char* pattern, const Names&... names)
{
    return filled(pattern, {QString(names)...});
}

[[nodiscard]] inline CanvasPart edgePart(const QString& name, const glm::dvec2& from, const glm::dvec2& to)
{
    return {CanvasKind::Edge, name, {from, to}};
}
[[nodiscard]] inline CanvasPart vectorPart(const QString& name, const glm::dvec2& from, const glm::dvec2& to)
{
    return {CanvasKind::Vector, name, {from, to}};
}
[[nodiscard]] inline CanvasPart areaPart(const QString& name, std::vector<glm::dvec2> corners)
{
    return {CanvasKind::Area, name, std::move(corners)};
}

} // namespace rasterlens
