#pragma once
#include "core/observe/step_log.h"

#include <QStringList>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace rasterlens
{

/// What a glyph says about the sign of an edge value.
enum class EdgeSign : std::uint8_t { Minus, Zero, Plus, NotANumber };
[[nodiscard]] EdgeSign signOf(double value);

/// What the lens shows at one sample.
struct LensCell {
    enum class State : std::uint8_t { OutOfBounds, Waiting, Rejected, Covered };

    State state = State::OutOfBounds;
    bool hasValues = false; ///< the algorithm looks at edge values
    EdgeValues values{};    ///< AB, BC, CA of the setup; those the algorithm had, where it has been here
    std::array<EdgeSign, 3> signs{};
    int deciding = 0; ///< the edge whose value decides: of those the sample fails, or else of all, the smallest
    bool tie = false; ///< the deciding value is 0
    std::array<bool, 3> ours{}; ///< the value counts as inside
};

/// What the lens keeps to itself while a question is open or to come, for it would be the answer: what samples are
/// before their turn, and the pixel that is asked about.
struct LensSecret {
    std::optional<glm::ivec2> pixel; ///< nothing: the question is not about one

    friend bool operator==(const LensSecret&, const LensSecret&) = default;
};

/// The samples of one triangle at one position of a log, as the lens shows them.
class LensModel
{
public:
    /// in  `triangle`: an event of kind Triangle of the log, which must outlive the model
    LensModel(const StepLog& log, const StepEvent& triangle, std::size_t position);
    /// The model with a present event that need not be of this log, such as one of another window; null: none.
    LensModel(const StepLog& log, const StepEvent& triangle, std::size_t position, const StepEvent* now);

    /// Looks at what happened elsewhere, where the log is a window that holds only a part of the triangle.
    ///
    /// in  the coverage of the triangle (StepRecord::coverage) in the pixels that are in sight
    void setFar(std::shared_ptr<const StepLog> coverage) const { m_far = std::move(coverage); }
    [[nodiscard]] bool wantsFar() const;

    /// in  nothing: everything is told
    void setSecret(const std::optional<LensSecret>& secret) { m_secret = secret; }

    /// in    a sample
    /// cost  logarithmic in the events of the triangle
    [[nodiscard]] LensCell cell(int x, int y) const;

    [[nodiscard]] const StepLog& log() const { return *m_log; }
    [[nodiscard]] const StepTriangle& triangle() const { return *m_triangle; }
    /// Its edge functions are set up at this position.
    [[nodiscard]] bool hasSetup() const { return m_hasSetup; }
    /// The sample of the pattern that is shown: that of the present event, else the first one.
    [[nodiscard]] int sample() const { return m_sample; }
    /// The event the position is just after; null at 0.
    [[nodiscard]] const StepEvent* event() const { return m_now; }
    /// Whether that event belongs to the triangle; it may be another's where a face is selected.
    [[nodiscard]] bool ownsEvent() const
    {
        return event() != nullptr && event()->face == m_triangle->screen.face && event()->triangle == m_index;
    }
    /// Edge walking: the corners sorted by height; null before that step.
    [[nodiscard]] const WalkedTriangle* walk() const;
    /// Edge walking: the long edge is told from the broken one; the middle corner's cut; the present row's crossings.
    /// Null before that step.
    [[nodiscard]] const WalkedTriangle* sides() const;
    [[nodiscard]] const WalkedHalves* halves() const;
    [[nodiscard]] const RowCrossings* crossings() const;
    /// Edge walking: the present row's span; null before the first one.
    [[nodiscard]] const SpanStep* span() const;
    /// Column fill: the present column; null where another triangle's is the last one.
    [[nodiscard]] const FilledColumn* column() const;
    /// Bresenham: the present decision.
    [[nodiscard]] const LineStep* line() const;
    /// DDA: the present position.
    [[nodiscard]] const LinePosition* linePosition() const;
    /// The ends of the line that decision belongs to, in samples.
    [[nodiscard]] std::optional<std::array<glm::ivec2, 2>> lineEnds() const;

private:
    [[nodiscard]] std::span<const std::uint32_t> eventsOfTriangle(StepKind kind) const;
    [[nodiscard]] bool isFinished() const;
    [[nodiscard]] bool isPastElsewhere(int x, int y) const;
    [[nodiscard]] const StepEvent* sampleAt(int x, int y) const;
    [[nodiscard]] const StepEvent* farEvent(StepKind kind, int x, int y) const;
    void readSample(LensCell& cell, int x, int y) const;
    void readSpan(LensCell& cell, int x, int y) const;
    [[nodiscard]] bool isSecret(const LensCell& cell, int x, int y) const;

    const StepLog* m_log;
    const StepTriangle* m_triangle;
    std::uint32_t m_index; ///< of the triangle
    std::size_t m_begin;   ///< the number of the event it begins with
    std::size_t m_position;
    const StepEvent* m_now;
    mutable std::shared_ptr<const StepLog> m_far;
    int m_sample = 0;
    bool m_hasSetup = false;
    bool m_walks = false;
    std::span<const std::uint32_t> m_samples; ///< event numbers
    std::span<const std::uint32_t> m_spans;
    std::optional<LensSecret> m_secret;
};

/// `-3.5`, `+8`; `tie: left, ours` where the deciding value is 0. In the language in use.
[[nodiscard]] QString lensCellText(const StepSetup& setup, const LensCell& cell);

/// The three values at a sample, what a step adds to them, and who owns a tie; empty where there are none.
[[nodiscard]] QStringList lensHoverLines(const LensModel& model, int x, int y);

/// Why an edge owns its points or does not: `left edge`. In the language in use.
[[nodiscard]] QString edgeSideText(EdgeSide side);

} // namespace rasterlens
