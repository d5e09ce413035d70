#pragma once
#include "core/base/reason.h"
#include "core/derive/figure.h"
#include "core/derive/topics.h"

#include <QJsonObject>
#include <QString>
#include <glm/glm.hpp>

#include <string_view>
#include <vector>

namespace rasterlens
{

/// What a symbol is in the picture.
enum class CanvasKind {
    Nothing,
    Edge,   ///< two points
    Vector, ///< from the first point to the second
    Area,   ///< the corners of a polygon
    Point,
    Corner, ///< of the face
    Sample, ///< its centre
    Plane,  ///< of the view volume; no points
    Row,    ///< two points on the centre line of a row of samples
    Column, ///< two points on the centre line of a column of samples
};
[[nodiscard]] const char* canvasKindId(CanvasKind kind);

/// A part of the figure.
struct CanvasPart {
    CanvasKind kind = CanvasKind::Nothing;
    QString name;                   ///< `AB`, `P`, `near`
    std::vector<glm::dvec2> points; ///< pixels, y down; empty where it has no place on the screen
};

/// A quantity of a derivation.
struct DerivationSymbol {
    enum class Form { Number, Bits }; ///< Bits: four binary digits

    QString id;   ///< what formulas call it: `alpha`, `E_AB`; unique within a derivation
    QString name; ///< what people read: `α`
    double value = 0;
    QString exact; ///< `299/800` where the value is a rational number without rounding; else empty
    Form form = Form::Number;
    CanvasPart canvas;
};

/// A piece of a formula: a symbol, or text between symbols.
struct DerivationToken {
    QString text;    ///< as it is printed
    int symbol = -1; ///< index into Derivation::symbols; -1 none
};

/// A formula, with and without its numbers, and what it says.
struct DerivationLine {
    std::vector<DerivationToken> left;    ///< what is computed; empty where the line is a comparison
    std::vector<DerivationToken> formula; ///< what it is computed from, in symbols
    std::vector<DerivationToken> numbers; ///< `formula` with the numbers put in
    std::vector<double> values;           ///< what comes out: one for each symbol on the left, or 1 or 0
    QString result;                       ///< `values` as they are printed; empty for a comparison
    Reason words{QString()};              ///< of the context "Derive"
    std::vector<CanvasPart> marks;        ///< parts of the figure that belong to the line

    [[nodiscard]] bool isComparison() const { return left.empty(); }
    [[nodiscard]] bool holds() const { return values.front() != 0; }
};

/// How a number comes about, line by line, with the numbers of one scene.
struct Derivation {
    DerivationTopic topic = DerivationTopic::Bresenham;
    Reason place{QString()}; ///< what it was made at; of the context "Derive"
    std::vector<DerivationSymbol> symbols;
    std::vector<DerivationLine> lines;
    std::vector<DerivationFigure> figures;
    std::vector<QString> listing; ///< a few lines of code, where the subject is an algorithm

    [[nodiscard]] const DerivationSymbol* find(std::string_view id) const;
};

/// The text of tokens put together.
[[nodiscard]] QString textOf(const std::vector<DerivationToken>& tokens);

/// A line as text: formula, numbers with the result, words.
///
/// in   translate of the context "Derive"; English without
[[nodiscard]] QString textOf(const DerivationLine& line, Translate translate = nullptr);
/// A derivation as text, one block a line.
[[nodiscard]] QString textOf(const Derivation& derivation, Translate translate = nullptr);
[[nodiscard]] QJsonObject toJson(const Derivation& derivation);

/// A number as derivations print it: with nine digits, or in full where that is short.
[[nodiscard]] QString derivedNumber(double value);

} // namespace rasterlens
