#include "ui/base/image_export.h"

#include "core/io/file_writer.h"
#include "core/io/picture_file.h"
#include "ui/base/theme.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontMetricsF>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <cmath>
#include <cstring>
#include <utility>

namespace rasterlens
{
namespace
{

QString inWords(const Reason& reason)
{
    return textOf(reason, [](const char* text) { return QCoreApplication::translate("Diagnostic", text); });
}

/// The line of a file dialog for the format with that suffix.
QString filterOf(const QString& format)
{
    const QString patterns =
        format == QLatin1String("jpg") ? QStringLiteral("*.jpg *.jpeg") : QStringLiteral("*.") + format;
    return QStringLiteral("%1 (%2)").arg(format.toUpper(), patterns);
}

/// The drawing with its size in pixels. Qt writes rounded millimetres, and cells then end between pixels.
QByteArray inPixels(QByteArray svg, QSize size)
{
    const qsizetype tag = svg.indexOf("<svg ");
    const qsizetype end = svg.indexOf('>', tag);
    for (const auto& [name, length] : {std::pair(" width=\"", size.width()), std::pair(" height=\"", size.height())}) {
        const qsizetype at = svg.indexOf(name, tag);
        if (at < 0 || at > end)
            continue;
        const qsizetype value = at + static_cast<qsizetype>(std::strlen(name));
        svg.replace(value, svg.indexOf('"', value) - value, QByteArray::number(length));
    }
    return svg;
}

/// The value of an attribute of a tag that begins at `from` and ends at `to`.
QString attributeOf(const QByteArray& svg, qsizetype from, qsizetype to, const char* name)
{
    const QByteArray key = QByteArray(" ") + name + "=\"";
    const qsizetype at = svg.indexOf(key, from);
    if (at < 0 || at > to)
        return {};
    const qsizetype value = at + key.size();
    return QString::fromUtf8(svg.mid(value, svg.indexOf('"', value) - value));
}

/// What QString::toHtmlEscaped() was given.
QString unescaped(QString text)
{
    return text.replace(QLatin1String("&lt;"), QLatin1String("<"))
        .replace(QLatin1String("&gt;"), QLatin1String(">"))
        .replace(QLatin1String("&quot;"), QLatin1String("\""))
        .replace(QLatin1String("&amp;"), QLatin1String("&"));
}

/// How wide a text is that Qt has written with one family.
double widthOf(const QString& text, const QString& family, double pixels, bool bold)
{
    constexpr int kPixels = 100; // for sizes that a font cannot have
    const bool isWhole = pixels == std::floor(pixels);
    QFont font(QStringList{family} + textFont(0).families().mid(1));
    font.setPixelSize(isWhole ? int(pixels) : kPixels);
    font.setBold(bold);
    const double width = QFontMetricsF(font).horizontalAdvance(text);
    return isWhole ? width : width * pixels / kPixels;
}

/// Pixels are squares beside each other. Programs that scale a drawing soften the sides of each, and the paper would
/// show through between two of one colour.
QByteArray withCrispSquares(QByteArray svg)
{
    return svg.replace("<defs>", "<defs><style>rect{shape-rendering:crispEdges}</style>");
}

/// The drawing with all families of each font. Qt names the first alone, and a viewer draws Chinese texts with what it
/// finds then.
QByteArray withFamilies(QByteArray svg)
{
    const QByteArray name("font-family=\"");
    QByteArray others;
    for (const QString& family : textFont(0).families().mid(1))
        others += ", " + family.toUtf8();
    for (qsizetype at = svg.indexOf(name); at >= 0; at = svg.indexOf(name, at + 1))
        svg.insert(svg.indexOf('"', at + name.size()), others);
    return svg;
}

/// The drawing with the width of each text: another font of a viewer, or another rounding, would run over its border.
QByteArray withMeasuredTexts(QByteArray svg)
{
    constexpr int kReadable = 4; // letters; shorter texts need no width
    for (qsizetype tag = svg.indexOf("<text "); tag >= 0; tag = svg.indexOf("<text ", tag + 1)) {
        const qsizetype end = svg.indexOf('>', tag);
        const QString text = unescaped(QString::fromUtf8(svg.mid(end + 1, svg.indexOf('<', end) - end - 1)));
        const double pixels = attributeOf(svg, tag, end, "font-size").toDouble();
        if (pixels <= 0 || text.size() < kReadable)
            continue;
        const bool bold = attributeOf(svg, tag, end, "font-weight").toInt() >= QFont::DemiBold;
        const double width = widthOf(text, attributeOf(svg, tag, end, "font-family"), pixels, bold);
        svg.insert(end, " textLength=\"" + QByteArray::number(width, 'f', 1) + "\" lengthAdjust=\"spacingAndGlyphs\"");
    }
    return svg;
}

} // namespace

QString notWritten(const QString& path, const Reason& why)
{
    return QCoreApplication::translate("ImageExport", "%1 could not be written: %2").arg(path, inWords(why));
}

std::optional<QString> saveBytes(const QByteArray& bytes, const ExportTarget& target)
{
    if (const auto why = whyNotOver(target.path, target.inputs))
        return notWritten(target.path, *why);
    if (const auto why = writeFile(target.path, bytes, target.waits ? NoReader::Wait : NoReader::Refuse))
        return notWritten(target.path, *why);
    return std::nullopt;
}

std::optional<QString> savePicture(const QImage& image, const ExportTarget& target, const QStringList& otherFormats)
{
    if (auto problem = formatProblem(target.path, pictureSuffixes() + otherFormats))
        return problem;
    const PictureBytes picture = pictureBytes(image, formatOf(target.path));
    return picture.problem ? notWritten(target.path, *picture.problem) : saveBytes(picture.bytes, target);
}

std::optional<QString> saveSvg(QSize size, const ExportTarget& target, const std::function<void(QPainter&)>& paint)
{
    if (size.isEmpty())
        return notWritten(target.path, QT_TRANSLATE_NOOP("Diagnostic", "the picture is empty or too large"));
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator drawing;
    drawing.setOutputDevice(&buffer);
    drawing.setResolution(96); // one unit is one pixel of CSS
    drawing.setSize(size);
    drawing.setViewBox(QRect(QPoint(0, 0), size));
    drawing.setTitle(QStringLiteral("RasterLens"));
    QPainter painter;
    const bool begun = painter.begin(&drawing);
    if (begun)
        paint(painter);
    if (!begun || !painter.end())
        return notWritten(target.path, QT_TRANSLATE_NOOP("Diagnostic", "the picture is empty or too large"));
    return saveBytes(withCrispSquares(withFamilies(withMeasuredTexts(inPixels(std::move(bytes), size)))), target);
}

std::optional<QString> savePdf(QSize size, const ExportTarget& target, const std::function<void(QPainter&)>& paint)
{
    if (size.isEmpty())
        return notWritten(target.path, QT_TRANSLATE_NOOP("Diagnostic", "the picture is empty or too large"));
    constexpr double kPerInch = 96;
    constexpr double kPointsPerInch = 72;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter page(&buffer);
    page.setResolution(int(kPerInch));
    page.setPageSize(QPageSize(QSizeF(size) * (kPointsPerInch / kPerInch), QPageSize::Point));
    page.setPageMargins(QMarginsF(0, 0, 0, 0));
    page.setTitle(QStringLiteral("RasterLens"));
    QPainter painter;
    const bool begun = painter.begin(&page);
    if (begun)
        paint(painter);
    if (!begun || !painter.end())
        return notWritten(target.path, QT_TRANSLATE_NOOP("Diagnostic", "the picture is empty or too large"));
    return saveBytes(bytes, target);
}

std::optional<QString> formatProblem(const QString& path, const QStringList& formats)
{
    const auto why = whyNotFormat(path, formats);
    return why ? std::optional(notWritten(path, *why)) : std::nullopt;
}

QFileDialog* newExportDialog(QWidget* parent, const QString& title, const QString& suggestion,
                             const QStringList& formats)
{
    auto* dialog = new QFileDialog(parent, title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    QStringList filters;
    for (const QString& format : formats)
        if (format != QLatin1String("jpeg")) // shares the line of jpg
            filters << filterOf(format);
    dialog->setNameFilters(filters);
    const QString suggested = QFileInfo(suggestion).suffix();
    dialog->selectNameFilter(filterOf(suggested));
    dialog->setDefaultSuffix(suggested);
    dialog->selectFile(suggestion);
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, formats](const QString& filter) {
        for (const QString& format : formats)
            if (filterOf(format) == filter) {
                const QFileInfo chosen(dialog->selectedFiles().value(0));
                dialog->setDefaultSuffix(format);
                dialog->selectFile(chosen.dir().filePath(chosen.completeBaseName() + QLatin1Char('.') + format));
            }
    });
    return dialog;
}

} // namespace rasterlens
