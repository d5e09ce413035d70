#include "app/cli/handout.h"

#include "app/cli/output.h"
#include "app/cli/window_program.h"
#include "core/io/picture_file.h"
#include "core/io/reach.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QPageSize>
#include <QPdfWriter>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace rasterlens::cli
{
namespace
{

constexpr int kSlideHeading = 3; ///< the level of the headings of slides in a PDF

/// A slide as it is printed.
struct Page {
    QString question; ///< empty: none
    QString caption;
    QByteArray figure; ///< PNG
};

/// A slide as the window shows it.
QByteArray figureOf(const QString& lesson, std::size_t number, bool inChinese)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("figure.png"));
    QStringList words{QStringLiteral("--lesson"),   lesson,
                      QStringLiteral("--slide"),    QString::number(number),
                      QStringLiteral("--figure"),   file,
                      QStringLiteral("--caption"),  QString(),
                      QStringLiteral("--language"), inChinese ? QStringLiteral("zh") : QStringLiteral("en")};
    if (Consent::reachOf(lesson).outside == Outside::Allow)
        words << QStringLiteral("--allow-outside");
    const ExitCode code = runWindowProgram(words);
    QFile figure(file);
    if (code != ExitCode::Fine || !figure.open(QIODevice::ReadOnly))
        failInput(QStringLiteral("%1: slide %2 could not be drawn").arg(lesson).arg(number));
    return figure.readAll();
}

std::vector<Page> pagesOf(const Lesson& lesson, bool inChinese)
{
    const auto chosen = [inChinese](const TwoTexts& texts) { return inChinese ? texts.zh : texts.en; };
    // A built-in lesson goes by its id.
    const QString name =
        lesson.file.startsWith(QLatin1Char(':')) ? lesson.id : QFileInfo(lesson.file).absoluteFilePath();
    std::vector<Page> pages;
    for (const Slide& slide : lesson.slides) {
        Page& page = pages.emplace_back();
        page.caption = chosen(textWithNumbers(slide.moment.caption, slide));
        if (slide.question)
            page.question = chosen(textWithNumbers(slide.question->text, slide));
        page.figure = figureOf(name, pages.size(), inChinese);
    }
    return pages;
}

/// `F-01.png` for the first of at most 99 slides.
QString pictureName(const QString& path, std::size_t number, std::size_t count)
{
    const int digits = std::max(2, int(QString::number(count).size()));
    return QStringLiteral("%1-%2.png")
        .arg(QFileInfo(path).completeBaseName())
        .arg(number, digits, 10, QLatin1Char('0'));
}

void writeMarkdown(const QString& title, const std::vector<Page>& pages, const QString& path)
{
    OutputFiles files;
    QString text = QStringLiteral("# %1\n").arg(title);
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const QString picture = pictureName(path, i + 1, pages.size());
        text += QStringLiteral("\n## %1\n").arg(i + 1);
        if (!pages[i].question.isEmpty())
            text += QStringLiteral("\n> %1\n").arg(pages[i].question);
        text += QStringLiteral("\n![%1](%2)\n\n%3\n").arg(i + 1).arg(picture, pages[i].caption);
        files.add(QFileInfo(path).dir().filePath(picture), pages[i].figure);
    }
    files.add(path, text.toUtf8());
    files.write();
}

/// A slide that has room on one page begins a new one rather than go on there: no heading stands alone.
///
/// in  blocks as pdfOf() makes them
void keepSlidesTogether(QTextDocument& document, QPdfWriter& writer)
{
    const std::unique_ptr<QTextDocument> measured(document.clone()); // laid out as QTextDocument::print() does it
    constexpr int kMargin = int(2 / 2.54 * 96);                      // 2 cm, in pixels of the document
    QTextFrameFormat frame = measured->rootFrame()->frameFormat();
    frame.setMargin(kMargin);
    measured->rootFrame()->setFrameFormat(frame);
    measured->documentLayout()->setPaintDevice(&writer);
    const QSizeF page = writer.pageLayout().paintRectPixels(writer.resolution()).size();
    measured->setPageSize(page);
    const auto isHeading = [](const QTextBlock& block) { return block.blockFormat().headingLevel() == kSlideHeading; };
    const auto boxOf = [&](const QTextBlock& block) { return measured->documentLayout()->blockBoundingRect(block); };
    for (QTextBlock first = measured->begin(); first.isValid(); first = first.next()) {
        if (!isHeading(first))
            continue;
        QTextBlock last = first;
        while (last.next().isValid() && !isHeading(last.next()))
            last = last.next();
        const double top = boxOf(first).top();
        const double bottom = boxOf(last).bottom();
        if (int(top / page.height()) == int((bottom - 1) / page.height()))
            continue;
        for (QTextDocument* one : {measured.get(), &document}) {
            QTextCursor cursor(one->findBlockByNumber(first.blockNumber()));
            QTextBlockFormat format = cursor.blockFormat();
            format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
            cursor.setBlockFormat(format);
        }
    }
}

QByteArray pdfOf(const QString& title, const std::vector<Page>& pages)
{
    // Fonts need an application; this one asks for no display.
    char program[] = "rasterlens-cli";
    char option[] = "-platform";
    char platform[] = "offscreen";
    char* words[] = {program, option, platform, nullptr};
    int count = 3;
    const QGuiApplication application(count, words);

    constexpr int kWidth = 560; // of a line of A4, in pixels of the document
    constexpr int kHeight = 620;
    QTextDocument document;
    QString html = QStringLiteral("<h1>%1</h1>").arg(title.toHtmlEscaped());
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const QUrl address(QStringLiteral("slide:%1").arg(i));
        const QImage image = QImage::fromData(pages[i].figure, "png");
        document.addResource(QTextDocument::ImageResource, address, image);
        const double scale = std::min({1.0, double(kWidth) / image.width(), double(kHeight) / image.height()});
        html += QStringLiteral("<h%1>%2</h%1>").arg(kSlideHeading).arg(i + 1);
        if (!pages[i].question.isEmpty())
            html += QStringLiteral("<p><i>%1</i></p>").arg(pages[i].question.toHtmlEscaped());
        html += QStringLiteral("<p><img src=\"%1\" width=\"%2\" height=\"%3\"/></p><p>%4</p>")
                    .arg(address.toString())
                    .arg(std::lround(image.width() * scale))
                    .arg(std::lround(image.height() * scale))
                    .arg(pages[i].caption.toHtmlEscaped());
    }
    document.setHtml(html);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(title);
    writer.setPageSize(QPageSize(QPageSize::A4));
    keepSlidesTogether(document, writer);
    document.print(&writer);
    return bytes;
}

} // namespace

void writeHandout(const Lesson& lesson, const QString& path, bool inChinese)
{
    const QStringList formats{QStringLiteral("md"), QStringLiteral("pdf")};
    if (!formats.contains(formatOf(path)))
        failArguments(QStringLiteral("%1: a handout is written as F.md or F.pdf").arg(path));
    checkOutputs({path});
    checkInputsStay({path}, {lesson.file});
    const std::vector<Page> pages = pagesOf(lesson, inChinese);
    const QString title = inChinese ? lesson.title.zh : lesson.title.en;
    if (formatOf(path) == formats[0])
        return writeMarkdown(title, pages, path);
    OutputFiles files;
    files.add(path, pdfOf(title, pages));
    files.write();
}

} // namespace rasterlens::cli
