#include "ui/window/figure_export.h"

#include "core/io/picture_file.h"
#include "core/truth/mistake_proof.h"
#include "ui/base/image_export.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/steps/motion_mode.h"
#include "ui/steps/step_formula.h"
#include "ui/steps/step_mode.h"

#include <QPainter>

#include <utility>

namespace rasterlens
{
namespace
{

const QString kSvg = QStringLiteral("svg");
const QString kPdf = QStringLiteral("pdf");

LegendEntry lineEntry(const EdgeLook& look, const QString& text)
{
    return {[look](QPainter& painter, const QRectF& box) {
                painter.setPen(QPen(QColor(look.color), 3, look.style, Qt::FlatCap));
                painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
            },
            text};
}

LegendEntry glyphEntry(EdgeSign sign, const QString& text)
{
    return {[sign](QPainter& painter, const QRectF& box) {
                paintGlyph(painter, box.center(), box.width() - 2, sign, 0, false);
            },
            text};
}

LegendEntry frameEntry(const QString& text)
{
    return {[](QPainter& painter, const QRectF& box) {
                painter.setRenderHint(QPainter::Antialiasing, false);
                painter.setBrush(Qt::NoBrush);
                painter.setPen(QPen(QColor(10, 12, 16), 3, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
                painter.drawRect(box.adjusted(2, 2, -2, -2));
            },
            text};
}

LegendEntry dotEntry(const QString& text)
{
    return {[](QPainter& painter, const QRectF& box) {
                painter.setPen(Qt::NoPen);
                painter.setBrush(QColor(20, 24, 30));
                painter.drawEllipse(box.center(), 3, 3);
            },
            text};
}

} // namespace

FigureExport::FigureExport(const Document& document, const ViewportWidget& viewport, StepMode& steps,
                           MotionMode& motion, std::function<QString()> words)
    : m_document(document), m_viewport(viewport), m_steps(steps), m_motion(motion), m_words(std::move(words)),
      m_right(
          [this](const FramePtr& right) {
              Q_EMIT finished(m_path, save(beforeAfter(right), m_path).value_or(QString()));
          },
          [this](Lack lack) { Q_EMIT finished(m_path, tr("%1 could not be written: %2").arg(m_path, lackText(lack))); })
{
}

QStringList FigureExport::formats() { return pictureSuffixes() + QStringList{kSvg, kPdf}; }

std::optional<ViewportWidget::FigurePart> FigureExport::partOfSheet() const
{
    return m_part ? m_part : m_viewport.partInSight(m_zoom, m_region);
}

/// Without texts, a figure at a zoom is the whole picture.
std::optional<ViewportWidget::FigurePart> FigureExport::partWithoutTexts() const
{
    return m_part ? m_part : m_viewport.figurePart(m_zoom);
}

std::vector<LegendEntry> FigureExport::legend() const
{
    std::vector<LegendEntry> entries;
    const auto part = partOfSheet();
    if (!part)
        return entries;
    const double zoom = part->transform.zoom;
    const LensModel* lens = m_steps.lens().model();
    if (lens) {
        const char* names[] = {"AB", "BC", "CA"};
        for (std::size_t i = 0; i < kEdgeLooks.size(); ++i)
            entries.push_back(lineEntry(kEdgeLooks[i], tr("edge %1").arg(QLatin1String(names[i]))));
        if (lens->hasSetup() && zoom / lens->log().grid() >= kGlyphsFromCell) {
            entries.push_back(glyphEntry(EdgeSign::Plus, tr("inside of the edge")));
            entries.push_back(glyphEntry(EdgeSign::Minus, tr("outside")));
            entries.push_back(glyphEntry(EdgeSign::Zero, tr("on the edge: a tie")));
        }
    } else if (m_viewport.overlays().sampleDots && zoom >= kSampleDotsFromZoom) {
        entries.push_back(dotEntry(tr("sample")));
    }
    if (const auto pixel = m_viewport.selectedPixel())
        entries.push_back(frameEntry(tr("pixel (%1, %2)").arg(pixel->x()).arg(pixel->y())));
    return entries;
}

FigureTexts FigureExport::texts() const
{
    if (!m_texts)
        return {};
    FigureTexts texts{m_caption.value_or(QString()), {}, legend()};
    const StepSession& session = m_steps.session();
    const bool isStep = session.log() != nullptr && session.isReady();
    if (!m_caption) {
        texts.caption = m_words();
        if (isStep)
            texts.caption += QLatin1Char('\n') + tr("Step %1 of %2").arg(session.position()).arg(session.size());
        for (const QString& line : m_motion.words())
            texts.caption += QLatin1Char('\n') + line;
    }
    if (!isStep || session.positionInLog() == 0)
        return texts;
    const std::size_t event = session.positionInLog() - 1;
    if (!m_caption)
        texts.caption += QStringLiteral(": ") + stepTitle(*session.log(), event);
    const StepExplanation explained = explainStep(*session.log(), event);
    if (explained.line >= 0)
        texts.formula << explained.listing[static_cast<std::size_t>(explained.line)].code.trimmed();
    if (!explained.formula.isEmpty())
        texts.formula << explained.formula.split(QLatin1Char('\n'));
    return texts;
}

FigureSheet FigureExport::sheet() const
{
    const auto part = partOfSheet();
    FigurePanel panel;
    if (part)
        panel = {{}, part->size, [this, part](QPainter& painter) { m_viewport.paintFigure(painter, *part); }};
    return {{std::move(panel)}, texts()};
}

FigureSheet FigureExport::beforeAfter(const FramePtr& right) const
{
    const auto part = partOfSheet();
    if (!part)
        return {{FigurePanel()}, {}};
    const FramePtr wrong = m_viewport.frame();
    const auto panelOf = [&](const QString& title, const FramePtr& frame) {
        return FigurePanel{title, part->size, [this, part, frame](QPainter& painter) {
                               m_viewport.paintFigure(painter, *part, frame.get());
                           }};
    };
    return {{panelOf(tr("Right"), right), panelOf(tr("With the mistake"), wrong)}, texts()};
}

QImage FigureExport::image() const { return imageOn(size()); }

QSize FigureExport::size() const
{
    if (m_texts)
        return sheet().size();
    const auto part = partWithoutTexts();
    return part ? part->size : QSize();
}

QImage FigureExport::imageWithoutTexts() const
{
    const auto part = partWithoutTexts();
    QImage image(part ? part->size : QSize(), QImage::Format_RGB32);
    if (image.isNull())
        return {};
    QPainter painter(&image);
    m_viewport.paintFigure(painter, *part);
    return image;
}

QImage FigureExport::imageOn(QSize size) const
{
    const QImage figure = m_texts ? sheet().image() : imageWithoutTexts();
    if (figure.isNull() || figure.size() == size)
        return figure;
    QImage image(size, QImage::Format_RGB32);
    if (image.isNull())
        return {};
    image.fill(Qt::white);
    QPainter(&image).drawImage(0, 0, figure);
    return image;
}

std::optional<QString> FigureExport::save(const FigureSheet& sheet, const QString& path) const
{
    const ExportTarget target{path, m_document.inputFiles()};
    if (auto problem = formatProblem(path, formats()))
        return problem;
    const auto paint = [&sheet](QPainter& painter) { sheet.paint(painter); };
    if (formatOf(path) == kSvg)
        return saveSvg(sheet.size(), target, paint);
    if (formatOf(path) == kPdf)
        return savePdf(sheet.size(), target, paint);
    return savePicture(sheet.image(), target);
}

std::optional<QString> FigureExport::exportTo(const QString& path) const
{
    const ExportTarget target{path, m_document.inputFiles()};
    if (m_texts || formatOf(path) == kPdf)
        return save(sheet(), path);
    if (auto problem = formatProblem(path, formats()))
        return problem;
    return formatOf(path) == kSvg ? m_viewport.saveSvgFigure(m_zoom, target)
                                  : savePicture(m_viewport.figure(m_zoom), target);
}

void FigureExport::exportRun(const QString& path, const RunAnimation::Run& run, QWidget* window)
{
    StepSession& session = m_steps.session();
    animate(path, run,
            {[&session](std::size_t position) { session.moveTo(position); },
             [&session, before = session.position()] { session.moveTo(before); }},
            window);
}

void FigureExport::exportMotion(const QString& path, Motion motion, const RunAnimation::Run& run, QWidget* window)
{
    m_motion.setPlate(!m_texts); // the caption says it
    const auto goBack = [this] {
        m_motion.stop();
        m_motion.setPlate(true);
    };
    animate(path, run, {[this, motion](std::size_t frame) { m_motion.showFrame(motion, frame); }, goBack}, window);
}

void FigureExport::animate(const QString& path, const RunAnimation::Run& run, RunAnimation::Moments moments,
                           QWidget* window)
{
    m_part = m_texts ? partOfSheet() : partWithoutTexts();
    const RunAnimation::Figure figure{[this] { return size(); }, [this](QSize sheet) { return imageOn(sheet); }};
    auto* animation = new RunAnimation(figure, std::move(moments), run, {path, m_document.inputFiles()}, window);
    connect(animation, &RunAnimation::finished, this, [this, path](const QString& error, bool stopped) {
        m_part.reset();
        if (!stopped)
            Q_EMIT finished(path, error);
    });
}

void FigureExport::exportBeforeAfter(const QString& path)
{
    m_path = path;
    Settings settings = m_document.settings();
    settings.mistakes.clear();
    m_right.ask(
        [scene = m_document.scene(), settings](const auto& turn) {
            auto frame = std::make_shared<RenderedFrame>();
            frame->scene = scene;
            frame->settings = settings;
            static_cast<CountedPicture&>(*frame) =
                drawCounted(*scene, settings, {.depth = true, .ids = true}, turn.stop());
            frame->counted = true;
            return FramePtr(frame);
        },
        LatestJob::Running::Interrupt);
}

} // namespace rasterlens
