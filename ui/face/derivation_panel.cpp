#include "ui/face/derivation_panel.h"

#include "ui/base/field_row.h"
#include "ui/base/flow_layout.h"
#include "ui/base/inks.h"
#include "ui/base/theme.h"

#include <QCoreApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <span>

namespace rasterlens
{
namespace
{

QString translated(const char* text) { return QCoreApplication::translate("Derive", text); }

constexpr int kShownOfTopic = 18; ///< letters
constexpr QRgb kFigureInk = 0xff56b4e9;
constexpr QRgb kHoveredInk = 0xfff0e442;
constexpr double kSeam = 2; ///< wider on both sides together: keeps strokes in sight on any picture

const QString kSymbol = QStringLiteral("symbol:"); // schemes of links
const QString kLine = QStringLiteral("line:");
const QString kAnchor = QStringLiteral("l");

/// The number behind the scheme of a link of the text.
std::optional<std::size_t> numberOf(const QUrl& url, const QString& scheme)
{
    const QString text = url.toString();
    bool isNumber = false;
    const auto number = text.sliced(std::min(text.size(), scheme.size())).toULongLong(&isNumber);
    if (!text.startsWith(scheme) || !isNumber)
        return std::nullopt;
    return number;
}

void paintArrow(QPainter& painter, QPointF from, QPointF to)
{
    const QLineF line(to, from);
    painter.drawLine(line);
    constexpr double kHead = 11;
    if (line.length() < 1)
        return;
    for (const double turn : {-24.0, 24.0}) {
        QLineF head = line;
        head.setLength(std::min(kHead, line.length()));
        head.setAngle(line.angle() + turn);
        painter.drawLine(head);
    }
}

void paintPart(QPainter& painter, const CanvasPart& part, const CanvasTransform& transform)
{
    QPolygonF points;
    for (const glm::dvec2& point : part.points)
        points << transform.toCanvas(QPointF(point.x, point.y));
    if (points.isEmpty())
        return;
    switch (part.kind) {
    case CanvasKind::Vector:
        if (points.size() == 2)
            paintArrow(painter, points[0], points[1]);
        break;
    case CanvasKind::Area: {
        QColor fill = painter.pen().color();
        fill.setAlpha(60);
        painter.setBrush(fill);
        painter.drawPolygon(points);
        painter.setBrush(Qt::NoBrush);
        break;
    }
    case CanvasKind::Edge:
    case CanvasKind::Row:
    case CanvasKind::Column: painter.drawPolyline(points); break;
    case CanvasKind::Point:
    case CanvasKind::Corner:
    case CanvasKind::Sample:
        for (const QPointF& point : points)
            painter.drawEllipse(point, 5, 5);
        break;
    case CanvasKind::Nothing:
    case CanvasKind::Plane: break;
    }
}

} // namespace

void DerivationLayer::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                            const OverlayOptions& options) const
{
    painter.save();
    painter.setClipRect(canvas, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = options.thickLines ? 4 : 2;
    const auto paintParts = [&](std::span<const CanvasPart> parts, QRgb ink) {
        for (const QPen& pen : {QPen(QColor(kCanvasInk), width + kSeam), QPen(QColor(ink), width)}) {
            painter.setPen(pen);
            for (const CanvasPart& part : parts)
                paintPart(painter, part, transform);
        }
    };
    paintParts(m_marks, kFigureInk);
    paintParts({&m_hovered, 1}, kHoveredInk);
    painter.restore();
}

DerivationPanel::DerivationPanel(FaceSelection& selection, QWidget* parent)
    : QWidget(parent), m_topic(new PanelCombo), m_edge(new PanelCombo), m_place(new QLabel), m_view(new QTextBrowser)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 12, 8);
    column->setSpacing(6);
    auto* head = new FlowLayout(10);
    for (std::size_t i = 0; i < derivationTopics().size(); ++i)
        m_topic->addItem(QString());
    m_topic->setMinimumContentsLength(kShownOfTopic);
    m_topic->setCurrentIndex(static_cast<int>(DerivationTopic::EdgeFunction));
    head->addWidget(m_topic);
    head->addWidget(new FacePicker(selection));
    m_edge->addItems({QString(), QString(), QString()});
    head->addWidget(m_edge);
    column->addLayout(head);
    m_place->setObjectName(QStringLiteral("muted"));
    m_place->setWordWrap(true);
    column->addWidget(m_place);
    m_view->setOpenLinks(false);
    m_view->setMinimumHeight(160);
    m_view->installEventFilter(this);
    column->addWidget(m_view, 1);
    connect(m_topic, &QComboBox::currentIndexChanged, this, &DerivationPanel::asked);
    connect(m_edge, &QComboBox::currentIndexChanged, this, &DerivationPanel::asked);
    connect(m_view, &QTextBrowser::highlighted, this, [this](const QUrl& url) { hoverSymbol(numberOf(url, kSymbol)); });
    connect(m_view, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
        if (const auto line = numberOf(url, kLine))
            setLine(*line);
    });
    retranslate();
}

DerivationTopic DerivationPanel::topic() const { return static_cast<DerivationTopic>(m_topic->currentIndex()); }

int DerivationPanel::edge() const { return m_edge->currentIndex(); }

void DerivationPanel::setTopic(DerivationTopic topic) { m_topic->setCurrentIndex(static_cast<int>(topic)); }

const Derivation* DerivationPanel::derivation() const
{
    return m_derived && m_derived->derivation ? &*m_derived->derivation : nullptr;
}

void DerivationPanel::setDerived(std::shared_ptr<const Derived> derived)
{
    const std::shared_ptr<const Derived> before = std::exchange(m_derived, std::move(derived));
    const Derivation* now = derivation();
    const bool isSameTopic = now != nullptr && before && before->derivation && before->derivation->topic == now->topic;
    if (!isSameTopic || m_line >= now->lines.size())
        m_line = 0;
    showText();
    showFigure();
}

void DerivationPanel::setLine(std::size_t line)
{
    const Derivation* shown = derivation();
    if (shown == nullptr || line >= shown->lines.size() || line == m_line)
        return;
    m_line = line;
    showText();
    showFigure();
}

void DerivationPanel::hoverSymbol(std::optional<std::size_t> symbol)
{
    const Derivation* shown = derivation();
    const bool isShown = shown != nullptr && symbol && *symbol < shown->symbols.size();
    m_layer.setHovered(isShown ? shown->symbols[*symbol].canvas : CanvasPart{});
    Q_EMIT layerChanged();
}

void DerivationPanel::showFigure()
{
    const Derivation* shown = derivation();
    m_layer.setMarks(shown != nullptr && m_line < shown->lines.size() ? shown->lines[m_line].marks
                                                                      : std::vector<CanvasPart>{});
    m_layer.setHovered({});
    Q_EMIT layerChanged();
}

QString DerivationPanel::tokensHtml(const std::vector<DerivationToken>& tokens) const
{
    QString html;
    for (const DerivationToken& token : tokens) {
        const QString text = token.text.toHtmlEscaped();
        html += token.symbol < 0 ? text
                                 : QStringLiteral("<a href=\"%1\" style=\"text-decoration:none\">%2</a>")
                                       .arg(kSymbol + QString::number(token.symbol), text);
    }
    return html;
}

QString DerivationPanel::lineHtml(std::size_t i) const
{
    const DerivationLine& line = derivation()->lines[i];
    const QString formula = tokensHtml(line.formula);
    const QString numbers = tokensHtml(line.numbers);
    const QString math =
        line.isComparison()
            ? QStringLiteral("%1<br>%2: %3")
                  .arg(formula, numbers, line.holds() ? translated("holds") : translated("does not hold"))
            : QStringLiteral("%1 = %2<br>= %3<br>= <b>%4</b>")
                  .arg(tokensHtml(line.left), formula, numbers, line.result.toHtmlEscaped());
    const QString color = i == m_line ? palette().color(QPalette::AlternateBase).name() : QStringLiteral("transparent");
    const QString number = QString::number(i);
    return QStringLiteral("<table width=\"100%\" cellpadding=\"5\"><tr><td bgcolor=\"%1\">"
                          "<a name=\"%2\" href=\"%3\" style=\"text-decoration:none\"><b>%4</b></a> %5<br>%6"
                          "</td></tr></table>")
        .arg(color, kAnchor + number, kLine + number, QString::number(i + 1), math,
             textOf(line.words, translated).toHtmlEscaped());
}

void DerivationPanel::showText()
{
    const Derivation* shown = derivation();
    if (shown == nullptr) {
        m_place->setText(m_derived ? textOf(m_derived->refusal, translated) : QString());
        m_view->clear();
        return;
    }
    m_place->setText(textOf(shown->place, translated));
    QString html;
    for (std::size_t i = 0; i < shown->lines.size(); ++i)
        html += lineHtml(i);
    if (!shown->listing.empty()) {
        html += QStringLiteral("<pre>");
        for (const QString& line : shown->listing)
            html += line.toHtmlEscaped() + QLatin1Char('\n');
        html += QStringLiteral("</pre>");
    }
    const int at = m_view->verticalScrollBar()->value();
    m_view->setHtml(html);
    m_view->verticalScrollBar()->setValue(at);
    m_view->scrollToAnchor(kAnchor + QString::number(m_line));
}

bool DerivationPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_view && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Down) {
            setLine(m_line + 1);
            return true;
        }
        if (key == Qt::Key_Up) {
            if (m_line > 0)
                setLine(m_line - 1);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void DerivationPanel::retranslate()
{
    const QSignalBlocker blockedTopic(m_topic);
    const QSignalBlocker blockedEdge(m_edge);
    for (const DerivationTopicInfo& info : derivationTopics())
        m_topic->setItemText(static_cast<int>(info.topic), translated(info.title));
    m_topic->setAccessibleName(tr("Derivation"));
    m_edge->setItemText(0, tr("Edge AB"));
    m_edge->setItemText(1, tr("Edge BC"));
    m_edge->setItemText(2, tr("Edge CA"));
    m_edge->setAccessibleName(tr("Edge"));
    showText();
}

void DerivationPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace rasterlens
