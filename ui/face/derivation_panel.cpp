#include "ui/face/derivation_panel.h"

#include "core/observe/names.h"
#include "ui/base/distances.h"
#include "ui/base/field_row.h"
#include "ui/base/flow_layout.h"
#include "ui/base/inks.h"
#include "ui/base/parts.h"
#include "ui/base/theme.h"
#include "ui/face/figure_view.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSlider>
#include <QTextBlock>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>

namespace rasterlens
{
namespace
{

QString translated(const char* text) { return QCoreApplication::translate("Derive", text); }

constexpr int kShownOfTopic = 24; ///< letters
constexpr int kSliderSteps = 1000;

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

/// How far a point of the picture is from a part; 0 inside an area.
double distanceTo(const CanvasPart& part, QPointF point)
{
    QPolygonF points;
    for (const glm::dvec2& at : part.points)
        points << QPointF(at.x, at.y);
    if (part.kind == CanvasKind::Area && points.containsPoint(point, Qt::OddEvenFill))
        return 0;
    double distance = std::numeric_limits<double>::infinity();
    for (qsizetype i = 0; i < points.size(); ++i)
        distance = std::min(distance, distanceToSegment(point, {points[std::max<qsizetype>(i, 1) - 1], points[i]}));
    return distance;
}

} // namespace

DerivationPanel::DerivationPanel(FaceSelection& selection, QWidget* parent)
    : QWidget(parent), m_topic(new PanelCombo), m_edge(new PanelCombo), m_mName(new QLabel),
      m_m(new QSlider(Qt::Horizontal)), m_depthName(new QLabel), m_depth(new QSlider(Qt::Horizontal)),
      m_place(new QLabel), m_figures{new FigureView, new FigureView}, m_view(new QTextBrowser)
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
    constexpr int kSliderWidth = 120;
    for (const auto& [name, slider] : {std::pair(m_mName, m_m), std::pair(m_depthName, m_depth)}) {
        slider->setRange(1, kSliderSteps - 1);
        slider->setValue(kSliderSteps / 2);
        slider->setPageStep(kSliderSteps / 20);
        slider->setFixedWidth(kSliderWidth);
        head->addWidget(makeTogether(name, slider));
        connect(slider, &QSlider::valueChanged, this, &DerivationPanel::asked);
    }
    column->addLayout(head);
    m_place->setObjectName(QStringLiteral("muted"));
    m_place->setWordWrap(true);
    column->addWidget(m_place);
    auto* figures = new QHBoxLayout;
    figures->setSpacing(8);
    for (FigureView* figure : m_figures) {
        figures->addWidget(figure);
        connect(figure, &FigureView::symbolHovered, this, &DerivationPanel::hoverSymbol);
    }
    column->addLayout(figures);
    m_view->setOpenLinks(false);
    m_view->setMinimumHeight(80);
    m_view->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // the text keeps the width it is broken at
    m_view->installEventFilter(this);
    column->addWidget(m_view, 1);
    connect(m_topic, &QComboBox::currentIndexChanged, this, &DerivationPanel::asked);
    connect(m_edge, &QComboBox::currentIndexChanged, this, [this] {
        m_edgeIsChosen = true;
        Q_EMIT asked();
    });
    connect(m_view, &QTextBrowser::highlighted, this, [this](const QUrl& url) { hoverSymbol(numberOf(url, kSymbol)); });
    connect(m_view, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
        if (const auto line = numberOf(url, kLine))
            setLine(*line);
    });
    retranslate();
}

DerivationTopic DerivationPanel::topic() const { return static_cast<DerivationTopic>(m_topic->currentIndex()); }

std::optional<int> DerivationPanel::edge() const
{
    return m_edgeIsChosen ? std::optional(m_edge->currentIndex()) : std::nullopt;
}

double DerivationPanel::m() const { return double(m_m->value()) / kSliderSteps; }

std::optional<double> DerivationPanel::depthPart() const
{
    const int value = m_depth->value();
    return value == kSliderSteps / 2 ? std::nullopt : std::optional(double(value) / kSliderSteps);
}

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
    m_line = followedLine().value_or(m_line);
    if (m_derived && m_derived->edge) {
        const QSignalBlocker blocked(m_edge);
        m_edge->setCurrentIndex(*m_derived->edge);
    }
    showFields();
    showFigures();
    showText();
    showFigure();
}

void DerivationPanel::followSymbol(const QString& id)
{
    m_followed = id;
    if (const auto line = followedLine())
        setLine(*line);
}

/// The first line that computes the symbol that is followed.
std::optional<std::size_t> DerivationPanel::followedLine() const
{
    const Derivation* shown = derivation();
    if (shown == nullptr || m_followed.isEmpty())
        return std::nullopt;
    for (std::size_t i = 0; i < shown->lines.size(); ++i)
        for (const DerivationToken& token : shown->lines[i].left)
            if (token.symbol >= 0 && shown->symbols[std::size_t(token.symbol)].id == m_followed)
                return i;
    return std::nullopt;
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
    if (shown == nullptr || (symbol && *symbol >= shown->symbols.size()))
        symbol.reset();
    if (symbol == m_hovered)
        return;
    m_hovered = symbol;
    m_layer.setHovered(symbol ? shown->symbols[*symbol].canvas : CanvasPart{});
    for (FigureView* figure : m_figures)
        figure->setHovered(symbol);
    lightSymbols();
    Q_EMIT layerChanged();
}

std::optional<std::size_t> DerivationPanel::symbolAt(QPointF point, double reach) const
{
    const Derivation* shown = derivation();
    if (shown == nullptr)
        return std::nullopt;
    const std::vector<int> present = presentSymbols();
    std::optional<std::size_t> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < shown->symbols.size(); ++i) {
        const CanvasPart& part = shown->symbols[i].canvas;
        const double distance = distanceTo(part, point);
        if (distance > reach)
            continue;
        // Points lie on edges, and edges around areas: the smaller thing is meant.
        const double order = part.kind == CanvasKind::Area ? 2 : part.points.size() > 1 ? 1 : 0;
        const bool isPresent = std::ranges::find(present, static_cast<int>(i)) != present.end();
        const double rank = (isPresent ? 0 : 4) + order + distance / (reach + distance);
        if (rank < least) {
            least = rank;
            nearest = i;
        }
    }
    return nearest;
}

std::vector<int> DerivationPanel::presentSymbols() const
{
    const Derivation* shown = derivation();
    std::vector<int> symbols;
    if (shown == nullptr || m_line >= shown->lines.size())
        return symbols;
    for (const auto* tokens : {&shown->lines[m_line].left, &shown->lines[m_line].formula})
        for (const DerivationToken& token : *tokens)
            if (token.symbol >= 0)
                symbols.push_back(token.symbol);
    return symbols;
}

void DerivationPanel::showFigure()
{
    const Derivation* shown = derivation();
    std::vector<CanvasPart> marks;
    std::vector<CanvasPart> named;
    if (shown != nullptr && m_line < shown->lines.size()) {
        marks = shown->lines[m_line].marks;
        for (const int symbol : presentSymbols())
            named.push_back(shown->symbols[std::size_t(symbol)].canvas);
        if (marks.empty()) // the symbols themselves are the figure
            marks = named;
        std::erase_if(named, [](const CanvasPart& part) { return part.kind != CanvasKind::Corner; });
    }
    m_layer.setMarks(std::move(marks));
    m_layer.setNamed(std::move(named));
    m_layer.setHovered({});
    m_hovered.reset();
    for (FigureView* figure : m_figures) {
        figure->setPresent(presentSymbols());
        figure->setHovered(std::nullopt);
    }
    lightSymbols();
    Q_EMIT layerChanged();
}

void DerivationPanel::showFigures()
{
    const Derivation* shown = derivation();
    for (std::size_t i = 0; i < m_figures.size(); ++i) {
        const bool isThere = shown != nullptr && i < shown->figures.size();
        m_figures[i]->setVisible(isThere);
        if (isThere)
            m_figures[i]->setFigure(shown->figures[i], textOf(shown->figures[i].title, translated));
    }
}

void DerivationPanel::showFields()
{
    const bool hasM = topic() == DerivationTopic::Perspective || topic() == DerivationTopic::DepthCurve;
    const bool hasDepth = topic() == DerivationTopic::DepthCurve;
    m_edge->setVisible(infoOf(topic()).edge != TopicEdge::None);
    m_m->parentWidget()->setVisible(hasM);
    m_depth->parentWidget()->setVisible(hasDepth);
    m_mName->setText(QStringLiteral("m = %1").arg(m(), 0, 'f', 3));
    const Derivation* shown = derivation();
    const DerivationSymbol* z = hasDepth && shown != nullptr ? shown->find("z") : nullptr;
    m_depthName->setText(z != nullptr ? QStringLiteral("z = ") + shortNumber(z->value) : QStringLiteral("z"));
    for (const QSlider* slider : {m_m, m_depth})
        slider->parentWidget()->layout()->activate(); // the row has room for the new texts at once
    layout()->activate();
}

/// Where each symbol stands in the text.
void DerivationPanel::findSymbols()
{
    m_symbols.clear();
    for (QTextBlock block = m_view->document()->begin(); block.isValid(); block = block.next())
        for (auto it = block.begin(); !it.atEnd(); ++it) {
            const QTextFragment fragment = it.fragment();
            if (const auto symbol = numberOf(QUrl(fragment.charFormat().anchorHref()), kSymbol))
                m_symbols.push_back({*symbol, fragment.position(), fragment.position() + fragment.length()});
        }
}

/// Symbols of edges have the hue and the stroke of their edge; the one under the mouse a ground of its own.
void DerivationPanel::lightSymbols()
{
    const Derivation* shown = derivation();
    QList<QTextEdit::ExtraSelection> selections;
    if (shown != nullptr) {
        constexpr QTextCharFormat::UnderlineStyle kStyles[] = {
            QTextCharFormat::SingleUnderline, QTextCharFormat::DashUnderline, QTextCharFormat::DotLine};
        const std::array<QColor, 3> inks = edgeInksFor(palette());
        for (const SymbolPlace& place : m_symbols) {
            const std::optional<std::size_t> look = edgeLookOf(shown->symbols[place.symbol].canvas);
            const bool isHovered = m_hovered == place.symbol;
            if (!look && !isHovered)
                continue;
            QTextEdit::ExtraSelection selection;
            selection.cursor = QTextCursor(m_view->document());
            selection.cursor.setPosition(place.begin);
            selection.cursor.setPosition(place.end, QTextCursor::KeepAnchor);
            if (look) {
                selection.format.setForeground(inks[*look]);
                selection.format.setUnderlineStyle(kStyles[*look]);
                selection.format.setUnderlineColor(inks[*look]);
            }
            if (isHovered) {
                selection.format.setBackground(QColor(kHoveredInk));
                selection.format.setForeground(QColor(kCanvasInk));
            }
            selections << selection;
        }
    }
    m_view->setExtraSelections(selections);
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
        m_symbols.clear();
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
    m_view->setExtraSelections({});
    m_view->setHtml(html);
    findSymbols();
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
    m_m->setAccessibleName(tr("Part of the way along the edge"));
    m_depth->setAccessibleName(tr("Part of the way from near to far"));
    for (QSlider* slider : {m_m, m_depth})
        slider->setToolTip(slider->accessibleName());
    showFields();
    showFigures();
    showText();
    showFigure();
}

void DerivationPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        lightSymbols();
    QWidget::changeEvent(event);
}

} // namespace rasterlens
