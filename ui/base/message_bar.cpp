#include "ui/base/message_bar.h"

#include "ui/base/parts.h"
#include "ui/base/style_sheet.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLayoutItem>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace rasterlens
{
namespace
{

/// The first few, and how many more there are.
QString wordsOf(const Diagnostics& diagnostics)
{
    constexpr std::size_t kShown = 4;
    QStringList lines;
    for (std::size_t i = 0; i < std::min(kShown, diagnostics.size()); ++i)
        lines << diagnostics[i].text([](const char* text) { return QCoreApplication::translate("Diagnostic", text); });
    if (diagnostics.size() > kShown)
        lines << MessageBar::tr("and %n more", nullptr, static_cast<int>(diagnostics.size() - kShown));
    return lines.join(QLatin1Char('\n'));
}

} // namespace

MessageBar::MessageBar(QWidget* parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("messageBar"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 5, 6, 5);
    row->setSpacing(8);
    m_sign = new QLabel;
    m_text = new QLabel;
    m_text->setObjectName(QStringLiteral("messageText"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close = makeLink();
    m_close->setText(QStringLiteral("\u2715"));
    connect(m_close, &QToolButton::clicked, this, [this] {
        hide();
        Q_EMIT dismissed();
    });
    m_choices = new QHBoxLayout;
    row->addWidget(m_sign, 0, Qt::AlignTop);
    row->addWidget(m_text, 1);
    row->addLayout(m_choices);
    row->addWidget(m_close, 0, Qt::AlignTop);
    constexpr int kReadingTimeMs = 6000;
    m_farewell.setSingleShot(true);
    m_farewell.setInterval(kReadingTimeMs);
    connect(&m_farewell, &QTimer::timeout, this, &QWidget::hide);
    hide();
}

void MessageBar::setClosable(bool closable) { m_close->setVisible(closable); }

void MessageBar::show(MessageKind kind, const QString& text, const QObject* about)
{
    m_kind = kind;
    m_about = about;
    m_diagnostics.clear();
    setChoices({});
    m_text->setText(text);
    showKind();
    setVisible(true);
    if (kind == MessageKind::Info)
        m_farewell.start();
    else
        m_farewell.stop();
    Q_EMIT changed();
}

void MessageBar::retract(const QObject* about)
{
    if (about == m_about)
        hide();
}

int MessageBar::naturalWidth() const
{
    const int around = layout()->sizeHint().width() - m_text->sizeHint().width();
    return around + m_text->fontMetrics().size(0, m_text->text()).width() + 2;
}

void MessageBar::showEvent(QShowEvent* event)
{
    QFrame::showEvent(event);
    Q_EMIT changed();
}

void MessageBar::hideEvent(QHideEvent* event)
{
    QFrame::hideEvent(event);
    Q_EMIT changed();
}

void MessageBar::show(const Diagnostics& diagnostics)
{
    show(hasErrors(diagnostics) ? MessageKind::Error : MessageKind::Warning, wordsOf(diagnostics));
    m_diagnostics = diagnostics;
}

void MessageBar::offer(const QString& text, const std::vector<Choice>& choices)
{
    show(MessageKind::Info, text);
    m_farewell.stop();
    setChoices(choices);
}

void MessageBar::setChoices(const std::vector<Choice>& choices)
{
    while (QLayoutItem* item = m_choices->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // it may be the button that was just pressed
        delete item;
    }
    for (const Choice& choice : choices) {
        auto* button = new QPushButton(choice.text);
        button->setObjectName(QLatin1String(choice.id));
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QPushButton::clicked, this, [run = choice.run] { run(); });
        m_choices->addWidget(button);
    }
}

QString MessageBar::text() const { return m_text->text(); }

void MessageBar::showKind()
{
    const char* kind = m_kind == MessageKind::Error ? "error" : m_kind == MessageKind::Warning ? "warning" : "info";
    for (QWidget* part : {static_cast<QWidget*>(this), static_cast<QWidget*>(m_sign), static_cast<QWidget*>(m_text)})
        setStyleProperty(*part, "kind", QLatin1String(kind));
    m_sign->setText(m_kind == MessageKind::Info ? QStringLiteral("\u2139") : QStringLiteral("\u26a0"));
    m_close->setToolTip(tr("Close"));
}

void MessageBar::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        showKind();
    if (event->type() == QEvent::LanguageChange && !m_diagnostics.empty())
        m_text->setText(wordsOf(m_diagnostics));
    QFrame::changeEvent(event);
}

} // namespace rasterlens
