#pragma once
#include "ui/truth/comparison.h"

#include <QFrame>

class QComboBox;
class QLabel;
class QToolButton;

namespace rasterlens
{

class HeatLegend;

/// The lines above the canvas that say what A and B are, how they are shown and how far they are apart.
class CompareBar : public QFrame
{
    Q_OBJECT

public:
    CompareBar(Document& document, Comparison& comparison, QWidget* parent = nullptr);

    /// All parts; without the line of settings; the controls in one line; or nothing.
    enum class Extent { Full, Brief, Line, None };
    void setExtent(Extent extent);
    [[nodiscard]] QComboBox* withBox() const { return m_with; }
    [[nodiscard]] QComboBox* amplificationBox() const { return m_amplification; }

protected:
    void changeEvent(QEvent* event) override;

private:
    QToolButton* addViewButton(CompareView view);
    void sync();
    void retranslate();
    [[nodiscard]] QString settingsText(std::size_t most) const;

    Comparison& m_comparison;
    Extent m_extent = Extent::Full;
    QLabel* m_title;
    QComboBox* m_with;
    QToolButton* m_pin;
    QToolButton* m_swap;
    QToolButton* m_wipe;
    QToolButton* m_blink;
    QToolButton* m_heat;
    QComboBox* m_amplification;
    QToolButton* m_close;
    QLabel* m_text;
    QLabel* m_settings;
    HeatLegend* m_legend;
};

} // namespace rasterlens
