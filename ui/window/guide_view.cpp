#include "ui/window/guide_view.h"

#include "ui/base/theme.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QEvent>
#include <QFile>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextTable>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr double kInch = 96;      ///< canvas pixels of usual size
constexpr double kUsualType = 10; ///< points; with larger letters pictures grow as well
constexpr double kMargin = 24;
constexpr int kMostColumn = 900; ///< wider lines are hard to read

QString pathOf(const QString& name) { return QStringLiteral(":/rasterlens/docs/") + name; }

bool isPicture(const QTextBlock& block)
{
    for (auto part = block.begin(); !part.atEnd(); ++part)
        if (part.fragment().charFormat().isImageFormat())
            return true;
    return false;
}

} // namespace

GuideView::GuideView(QWidget* parent) : QTextBrowser(parent)
{
    setObjectName(QStringLiteral("guide"));
    setOpenLinks(false);
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_layOutSoon.setSingleShot(true);
    m_layOutSoon.setInterval(0);
    connect(&m_layOutSoon, &QTimer::timeout, this, [this] {
        const auto heading = headingInSight();
        layOut();
        if (heading)
            showHeading(*heading);
    });
}

bool GuideView::hasPage(const QString& name)
{
    return name.endsWith(QLatin1String(".md")) && QFile::exists(pathOf(name));
}

void GuideView::setPage(const QString& name)
{
    QFile file(pathOf(name));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("the document %s is missing in the resources of this program", qPrintable(name));
    m_page = name;
    m_text = QString::fromUtf8(file.readAll());
    layOut();
    verticalScrollBar()->setValue(0);
}

/// Qt lays out what is in sight alone, and knows no place below it before.
void GuideView::finishLayout() const { static_cast<void>(document()->size()); }

/// Makes the document anew, with the look that Markdown does not tell, in the present fonts and colours. It is shown
/// when it is whole: a document in sight breaks its lines with every change.
void GuideView::layOut()
{
    m_layOutSoon.stop();
    const QTextDocument* former = m_document;
    m_document = new QTextDocument(this);
    m_document->setUndoRedoEnabled(false);
    m_document->setDefaultFont(font());
    m_document->setDocumentMargin(kMargin);
    m_document->setMarkdown(m_text);
    layOutBlocks();
    layOutCode();
    layOutTables();
    addPictures();
    setDocument(m_document);
    delete former;
    finishLayout();
}

void GuideView::layOutBlocks()
{
    constexpr double kLine = 125; // percent
    const double line = fontMetrics().lineSpacing();
    m_headings.clear();
    for (QTextBlock block = m_document->begin(); block.isValid(); block = block.next()) {
        const int level = block.blockFormat().headingLevel();
        QTextCursor cursor(block);
        if (level > 0)
            m_headings.push_back({level, block.text(), block.position()});
        if (cursor.currentTable())
            continue;
        QTextBlockFormat format;
        format.setTopMargin(level > 1 ? 1.6 * line : level > 0 ? 0 : 0.35 * line);
        format.setBottomMargin(0.35 * line);
        if (!isPicture(block))
            format.setLineHeight(kLine, QTextBlockFormat::ProportionalHeight);
        if (block.blockFormat().hasProperty(QTextFormat::BlockCodeFence)) {
            format.setBackground(palette().color(QPalette::AlternateBase));
            format.setTopMargin(0);
            format.setBottomMargin(0);
            format.setNonBreakableLines(false);
        }
        cursor.mergeBlockFormat(format);
    }
}

/// Code in the font of the window's numbers, whose families have the Chinese forms.
void GuideView::layOutCode()
{
    QTextCharFormat format;
    format.setFontFamilies(numberFont().families());
    format.setBackground(palette().color(QPalette::AlternateBase));
    std::vector<std::pair<int, int>> places;
    for (QTextBlock block = m_document->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part)
            if (part.fragment().charFormat().hasProperty(QTextFormat::FontFamilies)) // nothing but code has any
                places.emplace_back(part.fragment().position(), part.fragment().length());
    QTextCursor cursor(m_document);
    for (const auto& [position, length] : places) {
        cursor.setPosition(position);
        cursor.setPosition(position + length, QTextCursor::KeepAnchor);
        QTextCharFormat whole = cursor.charFormat();
        whole.clearProperty(QTextFormat::FontPointSize); // it would not follow that of the window
        whole.clearProperty(QTextFormat::FontPixelSize);
        whole.merge(format);
        cursor.setCharFormat(whole);
    }
}

void GuideView::layOutTables()
{
    for (QTextFrame* frame : m_document->rootFrame()->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame)) {
            QTextTableFormat format = table->format();
            format.setBorder(1);
            format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
            format.setBorderBrush(palette().color(QPalette::Mid));
            format.setBorderCollapse(true);
            format.setCellSpacing(0);
            format.setCellPadding(4);
            format.setBottomMargin(fontMetrics().lineSpacing());
            table->setFormat(format);
        }
}

int GuideView::columnWidth() const { return std::max(1, viewport()->width() - 2 * static_cast<int>(kMargin)); }

QImage GuideView::fitted(const QImage& picture, int columnWidth) const
{
    if (picture.isNull())
        return picture;
    const double ratio = devicePixelRatioF();
    const double usual = picture.width() * kInch / (picture.dotsPerMeterX() * 0.0254);
    const double grown = usual * std::max(1.0, QApplication::font().pointSizeF() / kUsualType);
    const double width = std::min({grown, double(columnWidth), picture.width() / ratio});
    const int pixels = std::max(1, static_cast<int>(std::lround(width * ratio)));
    QImage image = pixels == picture.width()
                       ? picture
                       : picture.convertToFormat(QImage::Format_RGB32).scaledToWidth(pixels, Qt::SmoothTransformation);
    image.setDevicePixelRatio(ratio);
    return image;
}

QImage GuideView::original(const QString& name)
{
    const auto [place, isNew] = m_pictures.try_emplace(name);
    if (isNew)
        place->second = QImage(pathOf(name));
    return place->second;
}

/// Pictures for the present width of the column and the present screen.
void GuideView::addPictures()
{
    for (QTextBlock block = m_document->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            const QTextCharFormat format = part.fragment().charFormat();
            if (!format.isImageFormat())
                continue;
            const QString name = format.toImageFormat().name();
            m_document->addResource(QTextDocument::ImageResource, QUrl(name), fitted(original(name), columnWidth()));
        }
}

void GuideView::resizeEvent(QResizeEvent* event)
{
    const auto heading = headingInSight();
    QTextBrowser::resizeEvent(event);
    const int spare = width() - kMostColumn - 2 * static_cast<int>(kMargin);
    setViewportMargins(std::max(0, spare / 2), 0, std::max(0, spare / 2), 0);
    if (!m_document || event->oldSize().width() == event->size().width())
        return;
    addPictures();
    m_document->markContentsDirty(0, m_document->characterCount());
    if (heading)
        showHeading(*heading);
}

void GuideView::changeEvent(QEvent* event)
{
    QTextBrowser::changeEvent(event);
    const bool isLook = event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange;
    if (isLook && m_document)
        m_layOutSoon.start();
}

QString GuideView::anchorOf(const QString& heading)
{
    QString anchor;
    for (const QChar sign : heading.toLower())
        if (sign.isLetterOrNumber() || sign == QLatin1Char('-') || sign == QLatin1Char('_'))
            anchor += sign;
        else if (sign.isSpace())
            anchor += QLatin1Char('-');
    return anchor;
}

std::optional<std::size_t> GuideView::headingNamed(const QString& anchor) const
{
    const auto found = std::ranges::find_if(
        m_headings, [&](const Heading& heading) { return anchorOf(heading.text) == anchor.toLower(); });
    return found == m_headings.end() ? std::nullopt : std::optional(std::size_t(found - m_headings.begin()));
}

std::optional<std::size_t> GuideView::headingInSight() const
{
    const int top = verticalScrollBar()->value() + static_cast<int>(kMargin);
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < m_headings.size(); ++i) {
        const QTextBlock block = document()->findBlock(m_headings[i].position);
        if (document()->documentLayout()->blockBoundingRect(block).top() > top)
            break;
        found = i;
    }
    return found;
}

void GuideView::showHeading(std::size_t index)
{
    finishLayout();
    const QTextBlock block = document()->findBlock(m_headings[index].position);
    const double top = document()->documentLayout()->blockBoundingRect(block).top();
    verticalScrollBar()->setValue(index == 0 ? 0 : static_cast<int>(top) - static_cast<int>(kMargin) / 2);
}

} // namespace rasterlens
