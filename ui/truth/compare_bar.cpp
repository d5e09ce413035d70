#include "ui/truth/compare_bar.h"

#include "ui/base/field_row.h"
#include "ui/base/flow_layout.h"
#include "ui/base/parts.h"
#include "ui/base/text_on.h"
#include "ui/base/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr int kGap = 4; ///< pixels between the parts of the bar

} // namespace

/// The colours of the difference with the steps they stand for.
class HeatLegend : public QWidget
{
public:
    void setAmplification(int factor)
    {
        m_amplification = factor;
        update();
    }

    /// As narrow as its numbers allow.
    void setNarrow(bool narrow)
    {
        m_isNarrow = narrow;
        updateGeometry();
    }

    [[nodiscard]] QSize sizeHint() const override
    {
        constexpr int kLeast = 200;
        const QFontMetrics metrics(textFont(-1));
        const int each = metrics.horizontalAdvance(m_isNarrow ? QStringLiteral("255") : QStringLiteral(" 255 "));
        return {std::max(kLeast, each * static_cast<int>(heatScale().size())), metrics.height() + 4};
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setFont(textFont(-1));
        const auto scale = heatScale();
        const double each = static_cast<double>(width()) / static_cast<double>(scale.size());
        for (std::size_t i = 0; i < scale.size(); ++i) {
            const QRectF cell(static_cast<double>(i) * each, 0, each, height());
            painter.fillRect(cell, QColor(scale[i].color));
            // The smallest difference that takes this colour; whole steps are all there is.
            const int steps = (scale[i].steps + m_amplification - 1) / m_amplification;
            const bool used =
                i + 1 == scale.size() || steps < (scale[i + 1].steps + m_amplification - 1) / m_amplification;
            if (used)
                drawTextOn(painter, cell, Qt::AlignCenter, QString::number(steps), scale[i].color);
        }
    }

private:
    int m_amplification = 1;
    bool m_isNarrow = false;
};

CompareBar::CompareBar(Document& document, Comparison& comparison, QWidget* parent)
    : QFrame(parent), m_comparison(comparison), m_title(new QLabel), m_with(new PanelCombo), m_pin(makeLink()),
      m_swap(makeLink()), m_wipe(addViewButton(CompareView::Wipe)), m_blink(addViewButton(CompareView::Blink)),
      m_heat(addViewButton(CompareView::Difference)), m_amplification(new PanelCombo), m_close(makeLink()),
      m_text(new QLabel), m_settings(new QLabel), m_legend(new HeatLegend)
{
    setObjectName(QStringLiteral("toolRow"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 8, 4);
    column->setSpacing(2);
    m_title->setObjectName(QStringLiteral("groupHeading"));
    m_with->setObjectName(QStringLiteral("compareWith"));
    m_with->addItems({QString(), QString(), QString()});
    m_with->setSizeAdjustPolicy(QComboBox::AdjustToContents); // the language changes them
    m_amplification->setObjectName(QStringLiteral("amplification"));
    for (int factor = 1; factor <= Comparison::kMostAmplification; factor *= 2)
        m_amplification->addItem(QStringLiteral("\u00d7%1").arg(factor), factor);
    auto* with = new QWidget;
    auto* pair = new QHBoxLayout(with);
    pair->setContentsMargins(0, 0, 0, 0);
    pair->addWidget(m_title);
    pair->addWidget(m_with);
    auto* row = new FlowLayout(kGap); // beside a lesson and the statistics it has not the room of one line
    row->addWidget(with);
    for (QToolButton* button : {m_pin, m_swap, m_wipe, m_blink, m_heat, m_close})
        row->addWidget(button);
    row->addWidget(m_amplification);
    row->addWidget(m_legend);
    column->addLayout(row);
    m_text->setWordWrap(true);
    column->addWidget(m_text);
    m_settings->setObjectName(QStringLiteral("muted"));
    m_settings->setWordWrap(true);
    column->addWidget(m_settings);

    connect(m_with, &QComboBox::activated, this,
            [this](int index) { m_comparison.setWith(static_cast<CompareWith>(index)); });
    connect(m_amplification, &QComboBox::activated, this,
            [this](int index) { m_comparison.setAmplification(m_amplification->itemData(index).toInt()); });
    connect(m_pin, &QToolButton::clicked, this, [this] { m_comparison.pin(); });
    connect(m_swap, &QToolButton::clicked, this, [this] { m_comparison.swap(); });
    connect(m_close, &QToolButton::clicked, this, [this] { m_comparison.setView(CompareView::Off); });
    connect(&comparison, &Comparison::changed, this, &CompareBar::sync);
    connect(&document, &Document::settingsChanged, this, &CompareBar::sync);
    retranslate();
}

QToolButton* CompareBar::addViewButton(CompareView view)
{
    QToolButton* button = makeLink();
    button->setCheckable(true);
    connect(button, &QToolButton::clicked, this, [this, view] { m_comparison.setView(view); });
    return button;
}

void CompareBar::setExtent(Extent extent)
{
    m_extent = extent;
    const bool isLine = extent == Extent::Line || extent == Extent::None;
    layout()->setContentsMargins(12, isLine ? 0 : 2, 8, isLine ? 0 : 4);
    m_legend->setNarrow(isLine);
    sync();
}

void CompareBar::sync()
{
    const CompareView view = m_comparison.view();
    setVisible(view != CompareView::Off && m_extent != Extent::None);
    m_text->setVisible(m_extent != Extent::Line);
    m_settings->setVisible(m_extent == Extent::Full);
    if (view == CompareView::Off)
        return;
    const QSignalBlocker blockedWith(m_with);
    const QSignalBlocker blockedFactor(m_amplification);
    m_with->setCurrentIndex(static_cast<int>(m_comparison.with()));
    if (auto* model = qobject_cast<QStandardItemModel*>(m_with->model()))
        model->item(static_cast<int>(CompareWith::Pinned))->setEnabled(m_comparison.hasPinned());
    m_amplification->setCurrentIndex(m_amplification->findData(m_comparison.amplification()));
    m_wipe->setChecked(view == CompareView::Wipe);
    m_blink->setChecked(view == CompareView::Blink);
    m_heat->setChecked(view == CompareView::Difference);
    const bool hasScale = view == CompareView::Difference && m_comparison.hasAmounts();
    // One line has no room for all of them beside the scale; the menu has the others.
    for (QWidget* part : {m_pin, m_swap})
        part->setVisible(!(hasScale && m_extent == Extent::Line));
    m_amplification->setVisible(hasScale && m_extent != Extent::Line);
    m_legend->setVisible(hasScale);
    m_legend->setAmplification(m_comparison.amplification());
    m_text->setText(m_comparison.text());
    constexpr std::size_t kRoom = 3;
    m_settings->setText(settingsText(kRoom));
    m_settings->setToolTip(settingsText(settingsFields().size()));
}

/// What A and B are, in words: the settings in which they differ. The tool-tip has the settings that find no room.
QString CompareBar::settingsText(std::size_t most) const
{
    const auto differences = m_comparison.settingsDifferences();
    if (differences.empty())
        return tr("A and B have the same settings: change one, or pin A and go on");
    QStringList a;
    QStringList b;
    for (std::size_t i = 0; i < std::min(most, differences.size()); ++i) {
        a << tr("%1: %2").arg(differences[i].title, differences[i].a).toHtmlEscaped();
        b << tr("%1: %2").arg(differences[i].title, differences[i].b).toHtmlEscaped();
    }
    if (differences.size() > most)
        b << tr("%1 more").arg(differences.size() - most);
    const QString dot = QStringLiteral(" \u00b7 ");
    return QStringLiteral("<b>A</b>&nbsp; %1<br/><b>B</b>&nbsp; %2").arg(a.join(dot), b.join(dot));
}

void CompareBar::retranslate()
{
    m_title->setText(QStringLiteral("A"));
    const QSignalBlocker blocked(m_with);
    m_with->setItemText(static_cast<int>(CompareWith::Right), tr("no mistakes"));
    m_with->setItemText(static_cast<int>(CompareWith::Scene), tr("scene's own"));
    m_with->setItemText(static_cast<int>(CompareWith::Pinned), tr("pinned"));
    m_with->setAccessibleName(tr("Picture A"));
    m_with->setToolTip(tr("Picture A; B is always the present one"));
    const auto name = [](QToolButton* button, const QString& text, const QString& toolTip) {
        button->setText(text);
        button->setToolTip(toolTip);
        button->setAccessibleName(toolTip);
    };
    name(m_pin, tr("Pin"), tr("Keep the present settings as A (A)"));
    name(m_swap, QStringLiteral("\u21c4"), tr("Exchange A and B (Shift+A)"));
    name(m_wipe, tr("Wipe"), tr("A left of the line, B right of it; drag the line (S)"));
    name(m_blink, tr("Blink"), tr("A and B in turn (B)"));
    name(m_heat, tr("Difference"), tr("Where A and B differ, and how much (D)"));
    name(m_close, QStringLiteral("\u00d7"), tr("Stop comparing"));
    m_amplification->setAccessibleName(tr("Amplification"));
    m_amplification->setToolTip(tr("Differences are multiplied by this before they are coloured"));
    sync();
}

void CompareBar::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace rasterlens
