#include "ui/steps/code_line.h"

#include "ui/base/theme.h"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr int kPadding = 4;
constexpr int kGap = 18; ///< between the code that is run and the right one

QFont codeFont(double scale)
{
    QFont font = numberFont(-0.5);
    font.setPointSizeF(font.pointSizeF() * scale);
    return font;
}

/// Breaks code before the last statement that has no room, else before the last such word; the rows that follow the
/// first are indented.
QStringList wrappedCode(QString code, const QFontMetrics& metrics, int room)
{
    const auto start = std::ranges::find_if_not(code, [](QChar c) { return c == QLatin1Char(' '); }) - code.begin();
    const QString indent = QString(start + 4, QLatin1Char(' '));
    QStringList rows;
    while (metrics.horizontalAdvance(code) > room) {
        const qsizetype first = rows.isEmpty() ? start : indent.size(); // of the letters
        qsizetype end = -1;
        for (qsizetype at = code.indexOf(QLatin1Char(' '), first);
             at > 0 && metrics.horizontalAdvance(code.left(at)) <= room; at = code.indexOf(QLatin1Char(' '), at + 1))
            end = at;
        if (end < 0)
            break;
        if (const qsizetype statement = code.lastIndexOf(QLatin1String(";  "), end); statement > (first + end) / 2)
            end = statement + 1;
        rows << code.left(end).trimmed().prepend(rows.isEmpty() ? QString(start, QLatin1Char(' ')) : indent);
        code = indent + code.sliced(end).trimmed();
    }
    return rows << code;
}

} // namespace

CodeLine::CodeLine(QWidget* parent) : QWidget(parent) { setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); }

void CodeLine::setLine(const ListingLine& line, bool isPresent)
{
    m_line = {line.code, line.right.trimmed()};
    m_isPresent = isPresent;
    QStringList whole{m_line.code.trimmed(), m_line.right};
    whole.removeAll(QString());
    setToolTip(whole.join(QLatin1Char('\n')));
    update();
}

void CodeLine::setScale(double scale)
{
    m_scale = scale;
    update();
}

void CodeLine::setWrapped(bool on)
{
    m_isWrapped = on;
    update();
}

CodeLine::Rows CodeLine::rowsFor(int width) const
{
    const QFontMetrics metrics(codeFont(m_scale));
    const int room = width - 2 * kPadding;
    Rows rows{wrappedCode(m_line.code, metrics, room), {}};
    if (!m_line.right.isEmpty())
        rows.right = wrappedCode(m_line.right, metrics, room);
    return rows;
}

double CodeLine::scaleFor(const QString& code, int width, double least)
{
    const int needed = QFontMetrics(codeFont(1)).horizontalAdvance(code) + 2 * kPadding;
    return std::clamp(0.98 * width / std::max(needed, 1), least, 1.0);
}

CodeLine::Shown CodeLine::shown() const
{
    const QFontMetrics metrics(codeFont(m_scale));
    const int room = width() - 2 * kPadding;
    if (m_line.right.isEmpty())
        return {metrics.elidedText(m_line.code, Qt::ElideRight, room), {}};
    // The code that is run has the room it needs as long as a quarter of the line is left for the right one.
    const int wanted = metrics.horizontalAdvance(m_line.right);
    const int left = room - kGap - metrics.horizontalAdvance(m_line.code);
    const int rightRoom = std::min(wanted, std::max(left, (room - kGap) / 4));
    return {metrics.elidedText(m_line.code, Qt::ElideRight, room - kGap - rightRoom),
            metrics.elidedText(m_line.right, Qt::ElideRight, rightRoom)};
}

void CodeLine::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    if (m_isPresent) {
        constexpr double kCorner = 3;
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette().color(QPalette::AlternateBase));
        painter.drawRoundedRect(rect(), kCorner, kCorner);
    }
    QFont font = codeFont(m_scale);
    painter.setFont(font);
    painter.setPen(palette().color(m_isPresent ? QPalette::Text : QPalette::PlaceholderText));
    if (m_isWrapped) {
        paintRows(painter, font);
        return;
    }
    const Shown texts = shown();
    const QRect room = rect().adjusted(kPadding, 0, -kPadding, 0);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, texts.code);
    if (texts.right.isEmpty())
        return;
    const int code = QFontMetrics(font).horizontalAdvance(texts.code);
    font.setStrikeOut(true);
    painter.setFont(font);
    painter.drawText(room.adjusted(code + kGap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, texts.right);
}

void CodeLine::paintRows(QPainter& painter, QFont font) const
{
    const Rows rows = rowsFor(width());
    const double high = double(height()) / double(rows.code.size() + rows.right.size());
    QRectF row(kPadding, 0, width() - 2 * kPadding, high);
    for (const QStringList& part : {rows.code, rows.right}) {
        for (const QString& text : part) {
            painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, text);
            row.translate(0, high);
        }
        font.setStrikeOut(true);
        painter.setFont(font);
    }
}

} // namespace rasterlens
