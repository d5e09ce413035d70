#pragma once
#include <QImage>
#include <QRect>
#include <QString>
#include <QWidget>

#include <vector>

namespace rasterlens
{

/// Pictures of one size beside each other, each below its name, as large as there is room; by whole pixels where they
/// are enlarged.
class PictureStrip : public QWidget
{
    Q_OBJECT

public:
    struct Picture {
        QString name;
        QImage image;
    };

    explicit PictureStrip(QWidget* parent = nullptr);

    /// in  `marked`: a part of the pictures that gets a frame, in pixels; empty: none
    void setPictures(std::vector<Picture> pictures, const QRect& marked);
    [[nodiscard]] const std::vector<Picture>& pictures() const { return m_pictures; }

    QSize sizeHint() const override { return {400, 170}; }
    QSize minimumSizeHint() const override { return {180, 96}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintOne(QPainter& painter, const Picture& picture, const QRect& room) const;

    std::vector<Picture> m_pictures;
    QRect m_marked;
};

} // namespace rasterlens
