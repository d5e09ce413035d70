#pragma once
#include "core/questions/race.h"
#include "ui/face/face_picker.h"

#include <QTimer>
#include <QWidget>

#include <memory>

class QLabel;
class QSlider;
class QToolButton;

namespace rasterlens
{

/// Edge walking and edge equation beside each other on one face, in lockstep.
class RacePanel : public QWidget
{
    Q_OBJECT

public:
    explicit RacePanel(FaceSelection& selection, QWidget* parent = nullptr);

    /// Why there is no race.
    enum class Absence { NotDrawn, TooLarge };
    /// Null: there is no race. A new race is shown finished, and stands still.
    void setRace(std::shared_ptr<const AlgorithmRace> race, Absence why = Absence::NotDrawn);
    [[nodiscard]] const std::shared_ptr<const AlgorithmRace>& race() const { return m_race; }

    /// How many samples both have looked at.
    void setTick(std::size_t tick);
    [[nodiscard]] std::size_t tick() const { return m_tick; }
    [[nodiscard]] std::size_t ticks() const;
    void setPlaying(bool playing);
    [[nodiscard]] bool isPlaying() const { return m_clock.isActive(); }
    /// What a lane has done up to the present tick.
    [[nodiscard]] OperationCounts counts(Algorithm algorithm) const;

    QSize sizeHint() const override { return {760, 260}; }

protected:
    void changeEvent(QEvent* event) override;

private:
    class Track;

    void advance();
    void sync();
    void retranslate();
    [[nodiscard]] const RaceLane& lane(Algorithm algorithm) const;

    std::shared_ptr<const AlgorithmRace> m_race;
    Absence m_absence = Absence::NotDrawn;
    std::size_t m_tick = 0;
    bool m_blink = true;
    QTimer m_clock;
    QTimer m_blinker;
    QToolButton* m_play;
    QToolButton* m_back;
    QToolButton* m_step;
    QSlider* m_slider;
    QLabel* m_position;
    Track* m_tracks[2];
};

} // namespace rasterlens
