#include "ui/truth/referee_bar.h"

#include "ui/base/parts.h"

#include <QBuffer>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace rasterlens
{
namespace
{

/// The sign of a verdict for rich text.
QString signOf(PixelVerdict verdict, int side)
{
    constexpr int kSharper = 2;
    QPixmap sign(side * kSharper, side * kSharper);
    QPainter painter(&sign);
    paintVerdictSign(painter, QRectF(sign.rect()), verdict);
    painter.end();
    QByteArray png;
    QBuffer buffer(&png);
    sign.save(&buffer, "PNG");
    return QStringLiteral("<img src='data:image/png;base64,%1' width='%2' height='%2'/>")
        .arg(QString::fromLatin1(png.toBase64()))
        .arg(side);
}

} // namespace

RefereeBar::RefereeBar(Referee& referee, QWidget* parent)
    : QFrame(parent), m_referee(referee), m_title(new QLabel), m_text(new QLabel), m_space(makeLink()),
      m_next(makeLink()), m_close(makeLink()), m_detail(new QLabel)
{
    setObjectName(QStringLiteral("toolRow"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 8, 2);
    column->setSpacing(0);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    column->addLayout(row);
    m_title->setObjectName(QStringLiteral("groupHeading"));
    m_text->setTextFormat(Qt::RichText);
    m_text->setWordWrap(true);
    constexpr QMargins kOnALineWithButtons(0, 3, 0, 0);
    m_title->setContentsMargins(kOnALineWithButtons);
    m_text->setContentsMargins(kOnALineWithButtons);
    row->addWidget(m_title, 0, Qt::AlignTop);
    row->addWidget(m_text, 1, Qt::AlignTop);
    row->addWidget(m_space, 0, Qt::AlignTop);
    row->addWidget(m_next, 0, Qt::AlignTop);
    row->addWidget(m_close, 0, Qt::AlignTop);
    m_detail->setObjectName(QStringLiteral("muted"));
    m_detail->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    column->addWidget(m_detail);
    connect(m_space, &QToolButton::clicked, this, [this] {
        m_referee.setSpace(m_referee.space() == ReferenceSpace::Clip ? ReferenceSpace::Object : ReferenceSpace::Clip);
    });
    connect(m_next, &QToolButton::clicked, this, &RefereeBar::nextRequested);
    connect(m_close, &QToolButton::clicked, this, [this] { m_referee.setOn(false); });
    connect(&referee, &Referee::changed, this, &RefereeBar::sync);
    sync();
}

QString RefereeBar::richText() const
{
    const Judgement* judgement = m_referee.judgement();
    QString text = m_referee.text().toHtmlEscaped();
    if (!judgement)
        return text;
    if (judgement->wrong.empty())
        text.prepend(QStringLiteral("<b>\u2713</b> "));
    const int side = fontMetrics().ascent(); // the line is no higher, and stands where the title does
    for (const PixelVerdict verdict : kVerdicts)
        if (const std::uint64_t count = countOf(judgement->difference, verdict); count > 0) {
            const QString plain = countText(verdict, count);
            text.replace(plain, QStringLiteral("%1&nbsp;<b>%2</b>").arg(signOf(verdict, side), plain));
        }
    return text;
}

void RefereeBar::setBrief(bool brief)
{
    m_brief = brief;
    m_text->setWordWrap(!brief); // a label that may wrap asks for two lines
    m_text->setSizePolicy(brief ? QSizePolicy::Ignored : QSizePolicy::Preferred, QSizePolicy::Preferred);
    layout()->setContentsMargins(12, brief ? 0 : 2, 8, brief ? 0 : 2);
    sync();
}

void RefereeBar::sync()
{
    setVisible(m_referee.isOn());
    if (!m_referee.isOn())
        return;
    m_title->setText(tr("Referee"));
    m_title->setToolTip(tr("Every sample against the exact reference: integers of any length, no rounding anywhere"));
    m_text->setText(richText());
    m_text->setAccessibleName(m_referee.text());
    syncSpace();
    m_detail->setVisible(!m_brief); // also while the referee is at work: the canvas below stays where it is
    m_detail->setText(m_referee.detail());
    m_detail->setToolTip(m_referee.detail());
    const Judgement* judgement = m_referee.judgement();
    m_next->setVisible(judgement && !judgement->wrong.empty());
    m_next->setText(tr("Next \u203a"));
    m_next->setToolTip(tr("Show the next wrong pixel (Shift+V)"));
    m_close->setText(QStringLiteral("\u00d7"));
    m_close->setToolTip(tr("Send the referee off (V)"));
}

void RefereeBar::syncSpace()
{
    const bool fromObject = m_referee.space() == ReferenceSpace::Object;
    m_space->setText(fromObject ? tr("from object space") : tr("from clip space"));
    m_space->setEnabled(m_referee.hasSpaces());
    if (!m_referee.hasSpaces())
        m_space->setToolTip(tr("The corners of this scene are given in clip space: there is no vertex stage to judge"));
    else if (fromObject)
        m_space->setToolTip(tr("The truth starts from the mesh and the camera: what float32 loses in the vertex stage "
                               "counts as well. Click to take that stage's results as given (Ctrl+Shift+V)"));
    else
        m_space->setToolTip(tr("The truth starts from the clip-space positions that the vertex stage has made: that "
                               "stage itself is not judged. Click to judge it as well (Ctrl+Shift+V)"));
}

void RefereeBar::changeEvent(QEvent* event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::PaletteChange)
        sync();
}

} // namespace rasterlens
