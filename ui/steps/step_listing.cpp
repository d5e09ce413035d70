#include "ui/steps/step_listing.h"

#include "ui/base/theme.h"
#include "ui/steps/step_session.h"

#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr int kFormulaLines = 2;
constexpr int kCompactBelow = 560; ///< height of the canvas card from which on the whole listing has room

/// The line that is run; where it is a mistake's, the right one stands beside it, struck through.
QString lineHtml(const ListingLine& line)
{
    const auto html = [](const QString& code) {
        return code.toHtmlEscaped().replace(QLatin1Char(' '), QStringLiteral("&nbsp;"));
    };
    return html(line.code) + QStringLiteral("&nbsp;&nbsp;&nbsp;<s>%1</s>").arg(html(line.right.trimmed()));
}

} // namespace

StepListing::StepListing(const StepSession& session, QWidget* parent) : QFrame(parent), m_session(session)
{
    setObjectName(QStringLiteral("stepListing"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 3, 10, 3);
    column->setSpacing(0);
    const auto addLabel = [&] {
        auto* label = new QLabel;
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        column->addWidget(label);
        return label;
    };
    for (std::size_t i = 0; i < std::tuple_size_v<Listing>; ++i)
        m_lines.push_back(addLabel());
    m_formula = addLabel();
    m_formula->setTextFormat(Qt::PlainText);
    m_formula->setContentsMargins(4, 2, 0, 0);
    m_formula->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_formula->setFocusPolicy(Qt::NoFocus);
    connect(&session, &StepSession::positionChanged, this, &StepListing::sync);
    connect(&session, &StepSession::openChanged, this, [this](bool open) {
        setVisible(open);
        sync();
    });
    hide();
}

void StepListing::sync()
{
    m_explanation = {};
    if (m_session.isOpen() && m_session.log() && m_session.position() > 0)
        m_explanation = explainStep(*m_session.log(), m_session.position() - 1);
    const bool isCompact = parentWidget()->height() < kCompactBelow;
    const QFont font = numberFont(-0.5);
    const QString accent = palette().color(QPalette::AlternateBase).name();
    // The canvas above keeps its height: there are as many lines at every step, all of one height.
    const int kept = std::clamp(m_explanation.line, 0, int(m_lines.size()) - 1);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const bool now = int(i) == m_explanation.line;
        m_lines[i]->setFont(font);
        m_lines[i]->setFixedHeight(lineHeight());
        m_lines[i]->setVisible(int(i) == kept || !isCompact);
        const ListingLine& line = m_explanation.listing[i];
        m_lines[i]->setTextFormat(line.right.isEmpty() ? Qt::PlainText : Qt::RichText);
        m_lines[i]->setText(line.right.isEmpty() ? line.code : lineHtml(line));
        m_lines[i]->setStyleSheet(
            QStringLiteral("padding: 0 4px; border-radius: 3px; %1")
                .arg(now ? QStringLiteral("background: %1;").arg(accent)
                         : QStringLiteral("color: %1;").arg(palette().color(QPalette::PlaceholderText).name())));
    }
    m_formula->setStyleSheet(QStringLiteral("color: %1;").arg(palette().color(QPalette::Link).name()));
    fitFormula();
}

/// Room for digits and for the taller signs of other scripts.
int StepListing::lineHeight()
{
    constexpr int kAir = 2;
    return std::max(QFontMetrics(numberFont(-0.5)).height(), QFontMetrics(textFont(-0.5)).height()) + kAir;
}

/// Long numbers first make the formula smaller, then leave dots in its middle; the tool tip has all of it.
void StepListing::fitFormula()
{
    constexpr double kSmallest = 0.8;
    const QMargins around = layout()->contentsMargins() + m_formula->contentsMargins();
    const int room = width() - around.left() - around.right();
    QStringList lines = m_explanation.formula.split(QLatin1Char('\n'));
    while (lines.size() > kFormulaLines) {
        const QString last = lines.takeLast();
        lines.last() += QStringLiteral("   ") + last;
    }
    while (lines.size() < kFormulaLines)
        lines << QString();
    QFont font = numberFont(-0.5);
    int longest = 1;
    for (const QString& line : lines)
        longest = std::max(longest, QFontMetrics(font).horizontalAdvance(line));
    font.setPointSizeF(font.pointSizeF() * std::clamp(double(room) / longest, kSmallest, 1.0));
    for (QString& line : lines)
        line = QFontMetrics(font).elidedText(line, Qt::ElideMiddle, room);
    m_formula->setFont(font);
    m_formula->setFixedHeight(kFormulaLines * lineHeight() + 2);
    m_formula->setText(lines.join(QLatin1Char('\n')));
    m_formula->setToolTip(m_explanation.formula);
}

void StepListing::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    fitFormula();
}

QSize StepListing::minimumSizeHint() const
{
    int shown = 0;
    for (const QLabel* line : m_lines)
        shown += line->isHidden() ? 0 : 1;
    return QFrame::minimumSizeHint() - QSize(0, std::max(shown - 1, 0) * m_lines.front()->sizeHint().height());
}

void StepListing::showEvent(QShowEvent* event)
{
    parentWidget()->installEventFilter(this);
    QFrame::showEvent(event);
}

bool StepListing::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        sync();
    return QFrame::eventFilter(watched, event);
}

void StepListing::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        sync();
    QFrame::changeEvent(event);
}

} // namespace rasterlens
