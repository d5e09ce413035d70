#pragma once
#include "core/lessons/moment.h"
#include "core/observe/step_log.h"
#include "core/questions/race.h"
#include "core/questions/why.h"
#include "core/truth/judgement.h"
#include "core/truth/mistake_proof.h"

#include <QJsonValue>
#include <QPoint>
#include <QString>

#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace rasterlens
{

/// What a fact is: a number, an id or a colour, or a set of pixels in the order of rows.
using FactValue = std::variant<double, QString, std::vector<QPoint>>;

/// A fact by name, with what it is about: `hit-twice`, `winner 3,4`, `edge BC 0 3,4`.
struct FactName {
    std::size_t row = 0;         ///< of the table of facts
    std::optional<QPoint> pixel; ///< where the fact is about one
    std::uint32_t face = 0;      ///< where the fact is about one
    QString word;                ///< an edge `BC` or a corner `A`, where the fact is about one
    std::vector<double> numbers;
};

class MomentFacts;

/// A row of the table of facts.
struct FactRow {
    const char* name;
    const char* kinds;     ///< one letter an argument: F a face, P a pixel, W a word, N a number
    const char* arguments; ///< the arguments as people write them: `EDGE FACE X,Y`
    const char* meaning;   ///< in English
    /// in  a face and a pixel that are there
    std::optional<FactValue> (*find)(MomentFacts&, const FactName&);
};
[[nodiscard]] std::span<const FactRow> factRows();

/// errors  nothing, and `why` in the context "Diagnostic", where there is no fact of this name or its arguments are
/// wrong
[[nodiscard]] std::optional<FactName> factFromText(const QString& text, Reason* why);

/// Computes what can be said about a moment with numbers. What it needs is drawn once, when it is first asked for.
///
/// cost  drawing the picture, and as a fact needs it the other picture, the step log or the exact reference
class MomentFacts
{
public:
    /// in  `moment` opened as `open`; both outlive this
    MomentFacts(const Moment& moment, const OpenMoment& open);

    /// errors  nothing where the moment has no such fact: no step of that kind, a pixel outside the picture
    [[nodiscard]] std::optional<FactValue> find(const FactName& name);

    /// The picture: at the moment's step, or finished.
    ///
    /// errors  a null image where the log does not have the step
    [[nodiscard]] QImage picture();

    // What facts are made of.
    [[nodiscard]] const OpenMoment& open() const { return m_open; }
    [[nodiscard]] const CountedPicture& shown();
    [[nodiscard]] const CountedPicture& other();
    [[nodiscard]] const Judgement& judgement();
    [[nodiscard]] const std::shared_ptr<const StepLog>& log();
    /// The log's position at the moment's step, or its end; nothing where it does not have the step.
    [[nodiscard]] std::optional<std::size_t> position();
    /// The event just before position().
    [[nodiscard]] const StepEvent* event();
    [[nodiscard]] bool holds(QPoint pixel) const;
    [[nodiscard]] std::size_t indexOf(QPoint pixel) const;
    [[nodiscard]] bool hasFace(std::uint32_t face) const { return face < m_open.scene.mesh.faceCount(); }

private:
    const Moment& m_moment;
    const OpenMoment& m_open;
    std::optional<CountedPicture> m_shown;
    std::optional<CountedPicture> m_other;
    std::optional<Judgement> m_judgement;
    std::shared_ptr<const StepLog> m_log;
};

/// Whether a fact is the value of an edge function at a sample, as the lens shows it.
[[nodiscard]] bool isEdgeValue(const FactName& name);

/// Whether a fact is what a lesson says. Whole numbers are to be equal; of others four digits.
[[nodiscard]] bool agrees(const FactValue& value, const QJsonValue& said);

/// Whether a lesson may say this of a fact at all: a number, a text, or a list of pixels [x, y].
[[nodiscard]] bool canBeFact(const QJsonValue& said);

/// The value in words: `8`, `1,327,244`, `0.8938`, `lost-tie`, `(3, 4), (4, 3)`.
[[nodiscard]] QString textOf(const FactValue& value);
[[nodiscard]] QString factText(const QJsonValue& said);

} // namespace rasterlens
