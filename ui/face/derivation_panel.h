#pragma once
#include "core/derive/derive.h"
#include "ui/face/derivation_layer.h"
#include "ui/face/face_picker.h"

#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QSlider;
class QTextBrowser;

namespace rasterlens
{

class FigureView;

/// How a number of the selected pixel or face comes about: formulas, numbers and words, line by line, and the figures
/// that have no place over the picture. A symbol under the mouse is lit wherever it stands: in the formulas, in the
/// figures and over the picture.
class DerivationPanel : public QWidget
{
    Q_OBJECT

public:
    explicit DerivationPanel(FaceSelection& selection, QWidget* parent = nullptr);

    /// What is to be derived; the face and the pixel are the window's.
    [[nodiscard]] DerivationTopic topic() const;
    /// The edge that the user chose; nothing: the topic's own choice.
    [[nodiscard]] std::optional<int> edge() const;
    /// The part of the way along the edge, between 0 and 1.
    [[nodiscard]] double m() const;
    /// The distance of free choice as a part of the way from near to far; nothing: half-way.
    [[nodiscard]] std::optional<double> depthPart() const;
    void setTopic(DerivationTopic topic);
    /// The edge that the user chose gives way to that of the step.
    void followEdge() { m_edgeIsChosen = false; }
    /// The line that computes a symbol becomes the present one, now or once it is derived; empty: no line in
    /// particular.
    void followSymbol(const QString& id);
    /// Whether the steps name the corners over the picture.
    void setCornersAreNamed(bool on) { m_layer.setCornersAreNamed(on); }

    /// A derivation, or why there is none. The present line stays where the topic is the one before.
    void setDerived(std::shared_ptr<const Derived> derived);
    [[nodiscard]] const std::shared_ptr<const Derived>& derived() const { return m_derived; }

    [[nodiscard]] std::size_t line() const { return m_line; }
    void setLine(std::size_t line);
    /// Lights a symbol in the formulas, in the figures and in the picture; nothing: no symbol.
    void hoverSymbol(std::optional<std::size_t> symbol);
    [[nodiscard]] std::optional<std::size_t> hovered() const { return m_hovered; }
    /// The symbol whose part of the picture lies at a point; those of the present line come first.
    ///
    /// in   pixels of the picture; how near it has to be, in pixels
    [[nodiscard]] std::optional<std::size_t> symbolAt(QPointF point, double reach) const;

    [[nodiscard]] const DerivationLayer& layer() const { return m_layer; }
    [[nodiscard]] QTextBrowser* view() const { return m_view; }
    [[nodiscard]] QComboBox* edgeBox() const { return m_edge; }
    [[nodiscard]] QSlider* mSlider() const { return m_m; }
    [[nodiscard]] QSlider* depthSlider() const { return m_depth; }
    /// The views of the figures; a derivation with fewer figures hides the last ones.
    [[nodiscard]] const std::array<FigureView*, 2>& figures() const { return m_figures; }

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
    [[nodiscard]] std::vector<int> presentSymbols() const;
    void showText();
    void findSymbols();
    [[nodiscard]] std::optional<std::size_t> followedLine() const;
    void lightSymbols();
    void showFigure();
    void showFigures();
    void showFields();
    void retranslate();

    /// Where a symbol stands in the text.
    struct SymbolPlace {
        std::size_t symbol;
        int begin;
        int end;
    };

    std::shared_ptr<const Derived> m_derived;
    std::size_t m_line = 0;
    bool m_edgeIsChosen = false;
    QString m_followed; ///< the symbol whose line is to be the present one
    DerivationLayer m_layer;
    QComboBox* m_topic;
    QComboBox* m_edge;
    QLabel* m_mName;
    QSlider* m_m;
    QLabel* m_depthName;
    QSlider* m_depth;
    QLabel* m_place;
    std::array<FigureView*, 2> m_figures;
    QTextBrowser* m_view;
    std::vector<SymbolPlace> m_symbols;
    std::optional<std::size_t> m_hovered;
};

} // namespace rasterlens
