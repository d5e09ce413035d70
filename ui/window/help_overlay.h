#pragma once
#include <QFrame>
#include <QString>

#include <vector>

class QLabel;

namespace rasterlens
{

/// A card over the window that lists the keys with the state each of them changes.
class HelpOverlay : public QFrame
{
    Q_OBJECT

public:
    struct Line {
        QString keys;
        QString what;
        QString state; ///< may be empty
    };
    struct Section {
        QString title;
        std::vector<Line> lines;
    };

    explicit HelpOverlay(QWidget* parent);

    void setSections(const std::vector<Section>& sections);
    void place();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLabel* m_left = nullptr;
    QLabel* m_right = nullptr;
};

} // namespace rasterlens
