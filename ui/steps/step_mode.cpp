#include "ui/steps/step_mode.h"

#include "core/lessons/step_run.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/steps/step_listing.h"
#include "ui/steps/transport_dock.h"

#include <QFileDialog>
#include <QInputDialog>
#include <QMainWindow>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace rasterlens
{
namespace
{

template <class T, class Step>
void copyEvery(const T* from, Step step, int count, T* to)
{
    for (int i = 0; i < count; ++i)
        to[i] = from[i * step];
}

/// Writes what the pixels of a row have in a plane of the samples: that of the sample nearest their centres.
template <class T>
void copyRow(const StepCursor& cursor, std::span<const T> samples, int y, StepCursor::RowRange pixels, T* to)
{
    const int grid = cursor.log().grid();
    const T* from = samples.data() + std::size_t(y * grid + grid / 2) * std::size_t(cursor.log().columns()) + grid / 2;
    T* row = to + std::size_t(y) * std::size_t(cursor.image().width());
    const int count = pixels.right - pixels.left + 1;
    if (grid == 1)
        std::copy_n(from + pixels.left, count, row + pixels.left);
    else if (grid == 2) // known to the compiler, which then takes several at once
        copyEvery(from + 2 * pixels.left, std::integral_constant<int, 2>(), count, row + pixels.left);
    else
        copyEvery(from + grid * pixels.left, grid, count, row + pixels.left);
}

/// Brings the picture, depths and owners of a frame up to the cursor, where these have changed since `turn`.
void copyChanges(const StepCursor& cursor, std::uint32_t turn, Frame& frame)
{
    const QImage& image = cursor.image();
    const auto pixels = std::size_t(image.width()) * std::size_t(image.height());
    if (frame.image.size() != image.size())
        frame.image = QImage(image.size(), image.format());
    float* const depths = frame.depth.write(pixels);
    frame.ids.resize(pixels);
    auto* const colors = reinterpret_cast<QRgb*>(frame.image.bits()); // rows follow each other without gaps
    const FramePlanes& samples = cursor.firstSamples();
    StepCursor::forEachRow(cursor.changedSince(turn), [&](int y, StepCursor::RowRange changed) {
        std::copy_n(reinterpret_cast<const QRgb*>(image.constScanLine(y)) + changed.left,
                    changed.right - changed.left + 1,
                    colors + std::size_t(y) * std::size_t(image.width()) + changed.left);
        copyRow<float>(cursor, samples.depth, y, changed, depths);
        copyRow<std::int32_t>(cursor, samples.owners, y, changed, frame.ids.data());
    });
}

} // namespace

StepMode::StepMode(Document& document, ViewportWidget& viewport, QMainWindow& window, ActionTable& actions)
    : m_session(document), m_viewport(viewport), m_transport(new TransportDock(m_session, actions, &window)),
      m_listing(new StepListing(m_session)), m_window(window)
{
    window.addDockWidget(Qt::BottomDockWidgetArea, m_transport);
    viewport.addLayer(&m_sampleLens);
    m_lens.setCoverage(
        [this](const StepTriangle& triangle, const PixelRect& pixels) { return m_session.coverage(triangle, pixels); });
    viewport.addLayer(&m_lens);
    viewport.addLayer(&m_geometry);
    connect(&m_session, &StepSession::logChanged, this, &StepMode::syncLens);
    connect(&m_session, &StepSession::positionChanged, this, [this] {
        syncLens();
        followStep();
        Q_EMIT frameChanged();
    });
    connect(&m_session, &StepSession::openChanged, this, [this](bool open) {
        if (open)
            m_transport->show();
        else
            m_wanted.reset();
        syncLens();
        Q_EMIT frameChanged();
    });
    connect(&m_session, &StepSession::selectionChanged, this, &StepMode::syncSelection);
    connect(&m_session, &StepSession::recordingChanged, this, [this](bool recording) {
        syncLens();
        Q_EMIT frameChanged();
        if (!recording && m_wanted && m_session.isOpen())
            showPlace(*std::exchange(m_wanted, std::nullopt));
        if (!recording && m_wantedFace) {
            const auto [face, pixel] = *std::exchange(m_wantedFace, std::nullopt);
            showFace(face, pixel);
        }
    });
    connect(&viewport, &ViewportWidget::pixelChanged, this,
            [this] { m_session.selectPixel(m_viewport.selectedPixel()); });
    connect(m_transport, &TransportDock::rectangleWanted, this, [this] {
        if (!m_viewport.frame())
            return;
        const QRect seen = m_viewport.transform().pixelsIn(m_viewport.pane(), m_viewport.frame()->frame.image.size());
        m_session.setRectangle(PixelRect{seen.x(), seen.y(), seen.width(), seen.height()});
    });
    connect(m_listing, &StepListing::roomChanged, this, &StepMode::syncLegend);
    connect(&viewport, &ViewportWidget::viewChanged, this, &StepMode::syncLegend);
    connect(&m_session, &StepSession::stopMissed, this,
            [this] { Q_EMIT message(tr("The record ends without another such event.")); });
}

StepMode::~StepMode()
{
    m_viewport.removeLayer(&m_lens);
    m_viewport.removeLayer(&m_sampleLens);
    m_viewport.removeLayer(&m_geometry);
}

/// While geometry is stepped the canvas shows the polygon of that moment, else the triangle that is looked at. The lens
/// reads the log, which is kept for it: others who hear of the step before may lay the window out anew, which asks the
/// lens for its legend. The sample lens reads the cursor and must not outlive it.
void StepMode::syncLens()
{
    m_sampleLens.setCursor(m_session.isReady() ? m_session.cursor() : nullptr);
    std::unique_ptr<LensModel> model;
    std::optional<FaceMoment> moment;
    const std::shared_ptr<const StepLog> log = m_session.log();
    if (m_session.isReady() && log)
        moment = faceMomentAt(*log, m_session.positionInLog());
    if (moment && m_session.face() != moment->face)
        moment.reset(); // another face is selected
    const StepSession::LookedAt& lookedAt = m_session.lookedAt();
    if (lookedAt.log && !moment && m_session.isReady())
        model = std::make_unique<LensModel>(*lookedAt.log, *lookedAt.begin, lookedAt.position, m_session.event());
    if (model)
        model->setSecret(m_secret);
    m_lens.setModel(std::move(model));
    m_lensLog = lookedAt.log;
    m_geometry.setMoment(std::move(moment), log ? log->rules() : Rules());
    syncLegend();
    m_viewport.update();
}

/// Beside the code the legend covers nothing.
void StepMode::syncLegend()
{
    const int grid = m_lens.model() ? m_lens.model()->log().grid() : 1;
    const double cell = m_viewport.transform().zoom / grid;
    m_lens.setLegendBeside(m_listing->hasRoomForLegend());
    m_listing->setLegend(cell >= kGlyphsFromCell ? m_lens.legendAt(cell) : std::nullopt);
}

void StepMode::setSecret(const std::optional<LensSecret>& secret)
{
    if (std::exchange(m_secret, secret) != secret)
        syncLens();
}

void StepMode::syncSelection() { m_viewport.selectPixel(m_session.selectedPixel()); }

/// In a close-up the present sample is kept in sight.
void StepMode::followStep()
{
    const StepEvent* now = m_session.event();
    if (now && now->x >= 0 && now->y >= 0 && m_viewport.transform().zoom >= kGridFromZoom)
        m_viewport.showPixel({now->x / m_session.log()->grid(), now->y / m_session.log()->grid()});
}

FramePtr StepMode::frame()
{
    const StepCursor* cursor = m_session.cursor();
    if (!cursor || !m_session.isReady())
        return nullptr;
    // The picture before the last is not shown any more, and little of it is out of date.
    std::swap(m_shown, m_formerShown);
    if (!m_shown.frame || m_shown.frame.use_count() > 1)
        m_shown = {std::make_shared<RenderedFrame>()};
    if (std::exchange(m_shown.record, m_session.recordNumber()) != m_session.recordNumber())
        m_shown.turn = 0;
    RenderedFrame& frame = *m_shown.frame;
    frame.scene = m_session.document().scene();
    frame.settings = m_session.settings();
    copyChanges(*cursor, std::exchange(m_shown.turn, cursor->turn()), frame.frame);
    frame.statistics = cursor->counters();
    frame.counted = true;
    return m_shown.frame;
}

std::optional<std::size_t> StepMode::moment() const
{
    const bool isFinished = m_session.position() == m_session.size() && !m_session.isBeginning();
    const bool isShown = m_session.isReady() && m_session.log() && !isFinished;
    return isShown ? std::optional(m_session.position()) : std::nullopt;
}

bool StepMode::isPlace(const QString& where) { return stepPlaceFromText(where).has_value(); }

void StepMode::showStep(const QString& where) { showPlace(*stepPlaceFromText(where)); }

void StepMode::showPlace(const StepPlace& place)
{
    m_session.open();
    m_wanted.reset();
    m_wantedFace.reset();
    if (m_session.isRecording()) {
        m_wanted = place;
        return;
    }
    if (!m_session.record())
        return;
    const auto position = positionOf(place, m_session.record());
    m_session.moveTo(position.value_or(m_session.size()));
    if (position)
        return;
    Q_EMIT message(tr("The record has no step \"%1\": this is its end.").arg(textOf(place)));
    Q_EMIT placeMissed(textOf(place));
}

void StepMode::showFace(quint32 face, QPoint pixel)
{
    m_session.open();
    m_wanted.reset();
    if (m_session.isRecording()) {
        m_wantedFace = {face, pixel};
        return;
    }
    if (const auto event = m_session.firstEventOf(face, pixel))
        m_session.moveTo(*event + 1);
    else
        Q_EMIT message(tr("The record holds no step of face %1.").arg(face));
}

RunExport& StepMode::exportRun(const QString& folder, RunExport::Run run)
{
    auto* files = new RunExport(m_session, m_viewport, folder, run, &m_window);
    connect(files, &RunExport::finished, this, [this, folder](const QString& error) {
        Q_EMIT message(error.isEmpty() ? tr("Written: %1").arg(folder) : error);
    });
    return *files;
}

void StepMode::chooseRunToExport(std::optional<int> zoom)
{
    chooseRun(tr("Export a run of steps"), [this, zoom](std::size_t first, std::size_t last) {
        auto* folder = new QFileDialog(&m_window, tr("Folder for the pictures"));
        folder->setAttribute(Qt::WA_DeleteOnClose);
        folder->setFileMode(QFileDialog::Directory);
        folder->setOption(QFileDialog::ShowDirsOnly);
        connect(folder, &QFileDialog::fileSelected, this, [=, this](const QString& path) {
            exportRun(path, {first, last, zoom});
        });
        folder->open();
    });
}

void StepMode::chooseRun(const QString& title, std::function<void(std::size_t first, std::size_t last)> chosen)
{
    if (!m_session.log()) {
        Q_EMIT message(tr("Nothing is recorded."));
        return;
    }
    constexpr std::size_t kSuggested = 50;
    auto* range = new QInputDialog(&m_window);
    range->setAttribute(Qt::WA_DeleteOnClose);
    range->setWindowTitle(title);
    range->setLabelText(tr("First and last step, for example 10-60:"));
    const std::size_t first = m_session.position();
    range->setTextValue(QStringLiteral("%1-%2").arg(first).arg(std::min(first + kSuggested, m_session.size())));
    connect(range, &QInputDialog::textValueSelected, this, [this, chosen = std::move(chosen)](const QString& text) {
        const auto run = stepRunFromText(text);
        if (run && run->second <= m_session.size())
            chosen(run->first, run->second);
        else
            Q_EMIT message(tr("\"%1\" is no run of steps 0 to %2.").arg(text).arg(m_session.size()));
    });
    range->open();
}

} // namespace rasterlens
