#pragma once
#include "core/render/steps.h"
#include "ui/base/latest_result.h"
#include "ui/document/document.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPoint>
#include <QTimer>

#include <array>
#include <functional>
#include <memory>
#include <optional>

namespace rasterlens
{

/// What of the frame is recorded.
enum class StepScope { Frame, Geometry, Coverage, SelectedFace, Rectangle, SelectedPixel };
constexpr std::size_t kStepScopes = 6;

/// What playing goes on by: each tick of the speed is one step of this level; or the whole record takes some seconds.
enum class PlayBy { Event, Sample, Row, Face, Stage, Seconds };

constexpr double kSlowestSteps = 0.25;
constexpr double kFastestSteps = 64;

/// The step mode: records the document's frame on a background thread, and holds the position in the record.
///
/// Off until open(). While it is open, a change of the document records anew; the latest wins, and the former record
/// stays until the new one is there unless the scene is another. The beginning of a frame of many events can be stepped
/// while the rest is recorded; what asks for more than the beginning is done once all is there. Panels hold no copy:
/// they listen and ask.
class StepSession : public QObject
{
    Q_OBJECT

public:
    explicit StepSession(Document& document, QObject* parent = nullptr);

    /// Enters the step mode and records; the position is then 0 and nothing plays.
    void open();
    /// Leaves the step mode and lets go of the record.
    void close();
    [[nodiscard]] bool isOpen() const { return m_open; }
    [[nodiscard]] bool isRecording() const { return m_result.isBusy(); }
    /// Whether the record is one of the document as it is now: all of it, or its beginning.
    [[nodiscard]] bool isReady() const { return m_record && (m_isBeginning || !isRecording()); }
    /// Whether the record is a beginning: size() will grow.
    [[nodiscard]] bool isBeginning() const { return m_isBeginning; }
    /// Whether something that was asked for is done once all of the record is there.
    [[nodiscard]] bool isPutOff() const { return m_putOff != nullptr; }

    [[nodiscard]] const Document& document() const { return m_document; }
    /// What the record shows.
    [[nodiscard]] const Settings& settings() const { return m_settings; }
    /// The record; null where there is none (yet).
    [[nodiscard]] const std::shared_ptr<const StepRecord>& record() const { return m_record; }
    /// Different for each record there was.
    [[nodiscard]] std::uint64_t recordNumber() const { return m_recordNumber; }
    /// Its window about the position; null without a record.
    [[nodiscard]] std::shared_ptr<const StepLog> log() const { return m_cursor ? m_cursor->sharedLog() : nullptr; }
    /// The position in that window.
    [[nodiscard]] std::size_t positionInLog() const { return m_cursor ? m_cursor->positionInLog() : 0; }
    /// The frame at the position; null where there is no record.
    [[nodiscard]] const StepCursor* cursor() const { return m_cursor.get(); }
    /// 0 is the cleared frame, size() the end of the record.
    [[nodiscard]] std::size_t position() const { return m_cursor ? m_cursor->position() : 0; }
    [[nodiscard]] std::size_t size() const { return m_record ? m_record->size() : 0; }
    using QObject::event;
    /// What happened last; null at position 0 and without a record.
    [[nodiscard]] const StepEvent* event() const { return m_cursor ? m_cursor->lastEvent() : nullptr; }
    /// The screen triangle that is looked at: that of the present event or, before coverage begins, the next triangle
    /// of the present face; of the selected face where one is selected.
    struct LookedAt {
        std::shared_ptr<const StepLog> log; ///< a window that holds it; null: there is no triangle
        const StepEvent* begin = nullptr;   ///< the event it begins with
        std::size_t position = 0;           ///< how many events of that window have happened

        [[nodiscard]] const StepTriangle* triangle() const { return log ? log->triangle(*begin) : nullptr; }
    };
    [[nodiscard]] const LookedAt& lookedAt() const { return m_lookedAt; }

    void moveTo(std::size_t position);
    void moveToEnd();
    /// Does something as soon as the record is more than a beginning, which may be now. What is asked for before then
    /// takes its place.
    void whenWhole(std::function<void()> request);
    void step(StepLevel level, StepDirection direction);
    /// Goes to just after the next event that stops the run; to the end if there is none, which stopMissed() tells.
    void runUntil(const StepStop& stop);
    /// The first event of a face at a pixel, or of the face at all if it has none there; nothing: the record has none.
    [[nodiscard]] std::optional<std::size_t> firstEventOf(std::uint32_t face, QPoint pixel);
    /// StepRecord::coverage(); what was asked for last is kept.
    [[nodiscard]] std::shared_ptr<const StepLog> coverage(const StepTriangle& triangle, const PixelRect& pixels);
    /// The face that was last at work at a pixel.
    [[nodiscard]] std::optional<std::uint32_t> lastFaceAt(QPoint pixel);

    void setPlaying(bool on);
    [[nodiscard]] bool isPlaying() const { return m_clock.isActive(); }
    void setPlayBy(PlayBy by);
    [[nodiscard]] PlayBy playBy() const { return m_playBy; }
    /// How long the whole record takes with PlayBy::Seconds.
    void setSeconds(double seconds);
    [[nodiscard]] double seconds() const { return m_seconds; }
    /// in  kSlowestSteps..kFastestSteps; at 1, kStepsPerSecond steps a second
    void setSpeed(double speed);
    [[nodiscard]] double speed() const { return m_speed; }
    void setLooping(bool on);
    [[nodiscard]] bool isLooping() const { return m_looping; }
    static constexpr double kStepsPerSecond = 8;

    /// Records anew if that makes a difference.
    void setScope(StepScope scope);
    [[nodiscard]] StepScope scope() const { return m_scope; }
    /// What StepScope::Rectangle records.
    void setRectangle(const std::optional<PixelRect>& pixels);

    [[nodiscard]] std::optional<QPoint> selectedPixel() const { return m_selectedPixel; }
    void selectPixel(std::optional<QPoint> pixel);
    [[nodiscard]] std::optional<std::uint32_t> selectedFace() const { return m_selectedFace; }
    void selectFace(std::optional<std::uint32_t> face);
    /// The selected face, else that of the present event; nothing without either.
    [[nodiscard]] std::optional<std::uint32_t> face() const;

Q_SIGNALS:
    void openChanged(bool open);
    void recordingChanged(bool recording);
    void logChanged();       ///< another record, or none; positionChanged follows
    void positionChanged();  ///< of the cursor: pixels, counters, event, triangle
    void playbackChanged();  ///< playing, what by, speed, looping
    void selectionChanged(); ///< selected pixel or face
    void stopMissed();       ///< runUntil() came to the end
    void failed(const QString& message);

private:
    /// What recording brings: all of the record, or its beginning and then all of it.
    struct Recorded {
        std::shared_ptr<const StepRecord> record;
        bool isBeginning = false;
    };

    void recordAnew();
    void drop();
    void take(Recorded recorded);
    void giveUp(Lack lack);
    void syncRecording();
    void advance();
    [[nodiscard]] std::size_t playedTo(std::size_t steps);
    [[nodiscard]] LookedAt currentTriangle();
    [[nodiscard]] LookedAt triangleElsewhere(std::uint32_t face);
    [[nodiscard]] StepFilter filter() const;

    Document& m_document;
    std::shared_ptr<const Scene> m_scene; ///< of the record
    Settings m_settings;                  ///< of the record
    bool m_open = false;
    std::shared_ptr<const StepRecord> m_record;
    bool m_isBeginning = false;     ///< see isBeginning()
    std::function<void()> m_putOff; ///< what waits for all of the record; may be empty
    std::uint64_t m_recordNumber = 0;
    std::unique_ptr<StepCursor> m_cursor;
    std::unique_ptr<StepFinder> m_finder;
    LookedAt m_lookedAt;
    struct Coverage {
        std::array<glm::dvec2, 3> corners; ///< of the triangle
        PixelRect pixels;
        std::shared_ptr<const StepLog> log;
    };
    std::optional<Coverage> m_coverage;
    bool m_wasRecording = false; ///< as recordingChanged() told

    StepScope m_scope = StepScope::Frame;
    std::optional<PixelRect> m_rectangle;
    std::optional<QPoint> m_selectedPixel;
    std::optional<std::uint32_t> m_selectedFace;

    QTimer m_clock;
    QElapsedTimer m_sinceTick;
    double m_owedSteps = 0;
    double m_speed = 1;
    PlayBy m_playBy = PlayBy::Event;
    double m_seconds = 10;
    bool m_looping = false;
    LatestResult<Recorded> m_result; ///< last: its thread uses the members above
};

} // namespace rasterlens
