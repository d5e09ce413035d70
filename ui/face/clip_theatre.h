#pragma once
#include "ui/face/clip_story.h"
#include "ui/face/face_picker.h"

#include <QWidget>

#include <array>
#include <memory>

class QComboBox;
class QLabel;
class QToolButton;

namespace rasterlens
{

/// The polygon of a face in clip space, plane by plane, beside the screen it ends up on.
class ClipTheatre : public QWidget
{
    Q_OBJECT

public:
    explicit ClipTheatre(FaceSelection& selection, QWidget* parent = nullptr);

    /// Null: there is no face. Shows the step that is followed, else the last plane that cuts.
    void setStory(std::shared_ptr<const ClipStory> story);
    [[nodiscard]] const std::shared_ptr<const ClipStory>& story() const { return m_story; }

    /// Follows the step mode: the triangle before any plane at a corner, a plane, the four sides of Cohen-Sutherland.
    ///
    /// in  nothing: there is no step of the face's clipping
    void followStep(std::optional<StepKind> kind, std::optional<ClipPlane> plane);
    /// The scene that is shown: 0 is the triangle before any plane, then one after each step.
    void setStage(std::size_t stage);
    [[nodiscard]] std::size_t stage() const { return m_stage; }
    [[nodiscard]] QToolButton* planeButton(ClipPlane plane) const { return m_planes[static_cast<std::size_t>(plane)]; }
    /// `3 -> 4 -> 5 corners, a fan of 3`; while a step is followed only as far as the shown stage: `3 -> 4 -> ...`
    [[nodiscard]] QString summary() const;
    /// The cuts of the shown stage, one a line: from, to, t.
    [[nodiscard]] QStringList cuts() const;

    QSize sizeHint() const override { return {760, 260}; }

protected:
    void changeEvent(QEvent* event) override;

private:
    class Stage;
    enum class View { ClipSpace, Screen };

    [[nodiscard]] const std::vector<ClipVertex>& before() const;
    [[nodiscard]] const std::vector<ClipVertex>& after() const;
    [[nodiscard]] std::size_t usualStage() const;
    /// Whether a plane's outcome is told: while a step is followed, what comes after the shown stage is not.
    [[nodiscard]] bool isTold(std::size_t stage) const { return !m_followed || stage <= m_stage; }
    void showAxisOfStage();
    void sync();
    void retranslate();

    std::shared_ptr<const ClipStory> m_story;
    std::size_t m_stage = 0;
    std::optional<StepKind> m_followed;
    std::optional<ClipPlane> m_followedPlane;
    std::array<QToolButton*, kClipPlanes> m_planes{};
    QToolButton* m_start;
    QToolButton* m_sides; ///< the four sides of Cohen-Sutherland
    QComboBox* m_axis;
    QLabel* m_summary;
    QLabel* m_cuts;
    Stage* m_stages[2];
};

} // namespace rasterlens
