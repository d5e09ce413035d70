#pragma once
#include "core/derive/derive.h"
#include "ui/canvas/pixel_overlay.h"
#include "ui/face/face_picker.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QTextBrowser;

namespace rasterlens
{

/// The figure of a derivation over the picture: what belongs to the present line, and the symbol under the mouse.
class DerivationLayer : public CanvasLayer
{
public:
    void setMarks(std::vector<CanvasPart> marks) { m_marks = std::move(marks); }
    void setHovered(const CanvasPart& part) { m_hovered = part; }

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return false; }

private:
    std::vector<CanvasPart> m_marks;
    CanvasPart m_hovered;
};

/// How a number of the selected pixel or face comes about: formulas, numbers and words, line by line.
class DerivationPanel : public QWidget
{
    Q_OBJECT

public:
    explicit DerivationPanel(FaceSelection& selection, QWidget* parent = nullptr);

    /// What is to be derived; the face and the pixel are the window's.
    [[nodiscard]] DerivationTopic topic() const;
    [[nodiscard]] int edge() const;
    void setTopic(DerivationTopic topic);

    /// A derivation, or why there is none. The present line stays where the topic is the one before.
    void setDerived(std::shared_ptr<const Derived> derived);
    [[nodiscard]] const std::shared_ptr<const Derived>& derived() const { return m_derived; }

    [[nodiscard]] std::size_t line() const { return m_line; }
    void setLine(std::size_t line);
    /// Lights what a symbol is in the picture; nothing: no symbol.
    void hoverSymbol(std::optional<std::size_t> symbol);

    [[nodiscard]] const DerivationLayer& layer() const { return m_layer; }
    [[nodiscard]] QTextBrowser* view() const { return m_view; }

    QSize sizeHint() const override { return {440, 520}; }

Q_SIGNALS:
    /// Another topic or edge is to be derived.
    void asked();
    /// The figure has changed.
    void layerChanged();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] const Derivation* derivation() const;
    [[nodiscard]] QString tokensHtml(const std::vector<DerivationToken>& tokens) const;
    [[nodiscard]] QString lineHtml(std::size_t i) const;
    void showText();
    void showFigure();
    void retranslate();

    std::shared_ptr<const Derived> m_derived;
    std::size_t m_line = 0;
    DerivationLayer m_layer;
    QComboBox* m_topic;
    QComboBox* m_edge;
    QLabel* m_place;
    QTextBrowser* m_view;
};

} // namespace rasterlens
