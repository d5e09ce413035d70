#pragma once
#include <QWidget>
#include <glm/glm.hpp>

namespace rasterlens
{

/// A ball in the light, as the camera sees it. The mouse drags the bright side: it comes to lie under the mouse, with
/// Shift as far behind the ball.
class LightBall : public QWidget
{
    Q_OBJECT

public:
    explicit LightBall(QWidget* parent = nullptr);

    /// in  view space: x to the right, y up, z to the eye; any length
    void setLight(const glm::dvec3& towardsView);

    QSize sizeHint() const override { return {40, 40}; }

Q_SIGNALS:
    void dragged(const glm::dvec3& towardsView); ///< of length 1
    void dropped();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    void drag(const QMouseEvent& event);

    glm::dvec3 m_light{0, 0, 1};
};

} // namespace rasterlens
