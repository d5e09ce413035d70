#include "ui/truth/experiment_panel.h"

#include "core/io/picture_file.h"
#include "core/opengl/opengl_renderers.h"
#include "core/truth/experiment_export.h"
#include "ui/base/field_row.h"
#include "ui/base/image_export.h"
#include "ui/base/parts.h"
#include "ui/base/turning.h"
#include "ui/truth/experiment_model.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kProgressMs = 100;
constexpr QSize kFigure(1000, 640);

/// What measurements are written as besides pictures.
const QStringList& tableFormats()
{
    static const QStringList formats{QStringLiteral("csv"), QStringLiteral("json"), QStringLiteral("svg")};
    return formats;
}

} // namespace

ExperimentPanel::ExperimentPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document),
      m_result([this](Measured measured) { take(std::move(measured)); }, [this](Lack lack) { giveUp(lack); })
{
    // Below a canvas height is what there is least of: there controls, plot and table lie side by side.
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 2, 12, 8);
    row->setSpacing(10);
    QWidget* controls = buildControls();
    row->addWidget(controls);
    auto* parts = new QSplitter(Qt::Horizontal);
    parts->setChildrenCollapsible(false);
    m_plot = new ExperimentPlot;
    parts->addWidget(m_plot);
    const QSortFilterProxyModel* sorted = buildTable();
    parts->addWidget(m_table);
    parts->setSizes({480, 520});
    row->addWidget(parts, 1);
    constexpr int kBeside = 780;
    new Turning(this, kBeside, [this, row, parts, controls](bool beside) {
        controls->setSizePolicy(beside ? QSizePolicy::Fixed : QSizePolicy::Preferred, QSizePolicy::Preferred);
        row->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
        constexpr int kLinesOfPlot = 10;
        m_plot->setMinimumHeight(beside ? 0 : kLinesOfPlot * fontMetrics().lineSpacing());
        parts->setOrientation(beside ? Qt::Horizontal : Qt::Vertical);
        m_table->setHorizontalScrollBarPolicy(beside ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
        for (const int column : {ExperimentModel::Ratio, ExperimentModel::Processor}) // tool-tips have them too
            m_table->setColumnHidden(column, !beside);
    });

    connect(m_plot, &ExperimentPlot::rowClicked, this, &ExperimentPanel::load);
    connect(m_plot, &ExperimentPlot::rowHovered, this, [this](int row, QPoint at) {
        if (row >= 0)
            QToolTip::showText(at, ExperimentModel::describe(m_rows[static_cast<std::size_t>(row)]), m_plot);
        else
            QToolTip::hideText();
    });
    const auto sourceRow = [sorted](const QModelIndex& index) { return sorted->mapToSource(index).row(); };
    connect(m_table, &QTableView::activated, this, [this, sourceRow](const QModelIndex& i) { load(sourceRow(i)); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this, sourceRow](const QModelIndex& i) {
                m_plot->setChosen(i.isValid() ? std::optional(sourceRow(i)) : std::nullopt);
            });
    retranslate();
}

/// out  the order in which the table has the model's rows
QSortFilterProxyModel* ExperimentPanel::buildTable()
{
    m_model = new ExperimentModel(this);
    auto* sorted = new QSortFilterProxyModel(this);
    sorted->setSourceModel(m_model);
    sorted->setSortRole(ExperimentModel::SortRole);
    m_table = new QTableView;
    m_table->setModel(sorted);
    m_table->setSortingEnabled(true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setWordWrap(false);
    m_table->setIconSize(dotMark({}).deviceIndependentSize().toSize());
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(ExperimentModel::Name, QHeaderView::Stretch);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setMinimumSize(200, 120);
    m_table->sortByColumn(ExperimentModel::Speed, Qt::AscendingOrder);
    return sorted;
}

ExperimentPanel::~ExperimentPanel() = default;

QWidget* ExperimentPanel::buildControls()
{
    m_run = new QPushButton;
    connect(m_run, &QPushButton::clicked, this, [this] { isRunning() ? cancel() : run(m_frames->value()); });
    m_frames = new PanelSpin;
    m_frames->setRange(1, 1000);
    m_frames->setValue(ExperimentOptions().frames);
    m_withOthers = new QCheckBox;
    m_progress = new QProgressBar;
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(8);
    m_errorBox = new PanelCombo;
    for (int i = 0; i < kErrorMeasures; ++i)
        m_errorBox->addItem(QString());
    m_errorBox->setCurrentIndex(static_cast<int>(ErrorMeasure::Color));
    m_speedBox = new PanelCombo;
    m_speedBox->addItems({QString(), QString()});
    for (QComboBox* box : {m_errorBox, m_speedBox})
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(m_errorBox, &QComboBox::currentIndexChanged, this, &ExperimentPanel::show);
    connect(m_speedBox, &QComboBox::currentIndexChanged, this, &ExperimentPanel::show);
    m_exportMenu = new QMenu(this);
    m_export = makeMenuLink(m_exportMenu);
    for (const char* suffix : {"csv", "json", "svg", "png"})
        connect(m_exportMenu->addAction(QString::fromLatin1(suffix).toUpper()), &QAction::triggered, this,
                [this, suffix] { chooseFile(QString::fromLatin1(suffix)); });
    QSizePolicy keepsItsPlace = m_progress->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(keepsItsPlace);
    m_note = new QLabel;
    m_note->setObjectName(QStringLiteral("muted"));
    m_note->setWordWrap(true);
    m_note->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_note->setAlignment(Qt::AlignTop);
    return arrangedControls();
}

QWidget* ExperimentPanel::arrangedControls()
{
    const auto rowOf = [](std::initializer_list<QWidget*> widgets) {
        auto* row = new QHBoxLayout;
        row->setSpacing(8);
        for (QWidget* widget : widgets)
            row->addWidget(widget);
        row->addStretch(1);
        return row;
    };
    auto* controls = new QWidget;
    auto* column = new QVBoxLayout(controls);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addLayout(rowOf({m_run, m_frames}));
    column->addWidget(m_progress);
    column->addWidget(m_note, 1);
    column->addLayout(rowOf({m_errorBox, m_speedBox}));
    column->addLayout(rowOf({m_withOthers, m_export}));
    controls->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    return controls;
}

void ExperimentPanel::run(int frames)
{
    const auto scene = m_document.scene();
    const Settings base = m_document.settings();
    const std::vector<const Variant*> supported = supportedVariants(*scene, base);
    m_rows.clear();
    m_notMeasured.clear();
    m_sceneTitle =
        scene->title.isEmpty() ? scene->id : QCoreApplication::translate("BuiltinScene", qPrintable(scene->title));
    m_frames->setValue(frames);
    m_progress->setRange(0, 0);
    show(); // before: where no thread starts, the note says so at once
    m_result.ask(
        [scene, base, supported, frames, withOthers = m_withOthers->isChecked()](const auto& turn) {
            std::vector<Reason> notMeasured;
            ExperimentOptions options{.frames = frames, .reference = true};
            if (withOthers) {
                options.others = [&] {
                    OtherRenderers found = openGlRenderers();
                    if (found.lack)
                        notMeasured.push_back(*found.lack);
                    return found;
                };
                options.refused = [&](const QString&, const Reason& reason) { notMeasured.push_back(reason); };
            }
            QElapsedTimer clock;
            clock.start();
            const auto progress = [&](const ExperimentProgress& now) {
                if (clock.elapsed() < kProgressMs)
                    return;
                turn.deliver({{now.rows.begin(), now.rows.end()}, notMeasured, now.done, now.total});
                clock.restart();
            };
            std::vector<ExperimentRow> rows = runExperiment(*scene, base, supported, options, progress, turn.stop());
            return Measured{std::move(rows), std::move(notMeasured)};
        },
        LatestJob::Running::Interrupt);
    syncState();
}

void ExperimentPanel::giveUp(Lack lack)
{
    take({m_rows, m_notMeasured});
    m_note->setText(lack == Lack::Memory ? tr("There is not enough memory for a picture of this size.")
                                         : tr("The system does not start so many threads."));
}

void ExperimentPanel::cancel()
{
    m_result.drop();
    take({m_rows, m_notMeasured});
}

void ExperimentPanel::take(Measured measured)
{
    m_rows = std::move(measured.rows);
    m_notMeasured = std::move(measured.notMeasured);
    m_progress->setRange(0, measured.total);
    m_progress->setValue(measured.done);
    show();
    syncState();
    if (!isRunning())
        Q_EMIT finished();
}

void ExperimentPanel::show()
{
    const auto error = static_cast<ErrorMeasure>(m_errorBox->currentIndex());
    const auto speed = static_cast<SpeedMeasure>(m_speedBox->currentIndex());
    markFrontier(m_rows, error);
    m_model->setRows(m_rows, error, speed);
    m_plot->setRows(m_rows, error, speed);
    m_note->setText((QStringList(ratioText()) + remarks()).join(QLatin1Char('\n')));
}

void ExperimentPanel::syncState()
{
    m_run->setEnabled(true);
    m_run->setText(runText());
    m_progress->setVisible(isRunning());
    m_export->setEnabled(!m_rows.empty());
}

QString ExperimentPanel::ratioText() const
{
    if (m_rows.empty())
        return tr("Every variant of the pipeline on the present scene: how fast, and how far from the exact picture.");
    const QString scene = QStringLiteral("%1, %2 \u00d7 %3")
                              .arg(m_sceneTitle)
                              .arg(m_rows.front().settings.size.width())
                              .arg(m_rows.front().settings.size.height());
    const auto advantage = walkingAdvantage(m_rows);
    if (m_plot->dotCount() == 0 && !isRunning())
        return tr("%1 \u00b7 no variant has this error here: colours need Gouraud or texture shading, "
                  "depths a depth test")
            .arg(scene);
    if (!advantage)
        return scene;
    return tr("%1 \u00b7 edge equation takes %2 times as long as edge walking (%3 to %4); a blog measured 1.36 or more")
        .arg(scene)
        .arg(advantage->median, 0, 'f', 2)
        .arg(advantage->p10, 0, 'f', 2)
        .arg(advantage->p90, 0, 'f', 2);
}

QStringList ExperimentPanel::remarks() const
{
    QStringList lines;
    if (!isRunning() && !m_rows.empty()) {
        const MachineNoise noise = noiseOf(m_rows);
        const QString spread = QString::number(100 * noise.spread, 'f', 0);
        lines
            << (noise.largestBatch == 1
                    ? tr("Frames vary by %1 %; times that overlap are not ranked.").arg(spread)
                    : tr("Frames vary by %1 %, those under %2 ms are timed in batches of up to %3; times that overlap "
                         "are not ranked.")
                          .arg(spread)
                          .arg(kShortestTiming)
                          .arg(noise.largestBatch));
    }
    const auto translated = [](const char* text) {
        const QString lack = QCoreApplication::translate("Experiment", text);
        return lack != QString::fromUtf8(text) ? lack : QCoreApplication::translate("Unsupported", text);
    };
    for (const Reason& reason : m_notMeasured)
        lines << tr("No other renderer: %1").arg(textOf(reason, translated));
    return lines;
}

void ExperimentPanel::choose(int row)
{
    const auto* sorted = static_cast<QSortFilterProxyModel*>(m_table->model());
    m_table->selectRow(sorted->mapFromSource(m_model->index(row, 0)).row());
    m_plot->setChosen(row);
}

void ExperimentPanel::load(int row)
{
    const ExperimentRow& chosen = m_rows[static_cast<std::size_t>(row)];
    choose(row);
    if (chosen.other) {
        Q_EMIT message(tr("%1 is another program: there is nothing to load").arg(titleOf(chosen)));
        return;
    }
    Settings settings = chosen.settings;
    settings.view = m_document.settings().view;
    m_document.setSettings(settings);
    Q_EMIT message(tr("Loaded: %1").arg(titleOf(chosen)));
}

std::optional<QString> ExperimentPanel::exportTo(const QString& path)
{
    const ExportTarget target{path, m_document.inputFiles()};
    const QString format = formatOf(path);
    if (format == QLatin1String("csv"))
        return saveBytes(experimentCsv(m_rows), target);
    if (format == QLatin1String("json"))
        return saveBytes(experimentJson(m_rows), target);
    if (format == QLatin1String("svg"))
        return saveSvg(kFigure, target, [this](QPainter& painter) { m_plot->paintTo(painter, kFigure); });
    constexpr int kSharper = 2;
    QImage image(kFigure * kSharper, QImage::Format_RGB32);
    {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(kSharper, kSharper);
        m_plot->paintTo(painter, kFigure);
    }
    return savePicture(image, target, tableFormats());
}

void ExperimentPanel::chooseFile(const QString& suffix)
{
    QFileDialog* dialog = newExportDialog(this, tr("Export the measurements"), QStringLiteral("speed-error.") + suffix,
                                          tableFormats() + pictureSuffixes());
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        if (const auto error = exportTo(path))
            Q_EMIT failed(*error);
        else
            Q_EMIT message(tr("Written: %1").arg(path));
    });
    dialog->open();
}

QString ExperimentPanel::runText() const { return isRunning() ? tr("Cancel") : tr("Measure"); }

/// The button keeps its width whether it starts or cancels.
void ExperimentPanel::keepRunWidth()
{
    int widest = 0;
    for (const QString& text : {tr("Cancel"), tr("Measure")}) {
        m_run->setText(text);
        widest = std::max(widest, m_run->sizeHint().width());
    }
    m_run->setMinimumWidth(widest);
    m_run->setText(runText());
}

void ExperimentPanel::retranslate()
{
    keepRunWidth();
    m_withOthers->setText(tr("Other renderers"));
    m_withOthers->setToolTip(tr("Measures what draws by OpenGL on this machine as well: Mesa's software renderer, and "
                                "graphics processors. The exact reference judges them as it judges ours."));
    m_note->setToolTip(
        tr("Ranges are the tenth and ninetieth percentile of pairs of frames, drawn one soon after the other. "
           "The blog, written for students: 72 frames in more than 8 s with edge equation, 71 in 5.8 s "
           "with edge walking; one model, one run, a debug build."));
    m_frames->setSuffix(QLatin1Char(' ') + tr("frames each"));
    m_frames->setToolTip(tr("Frames of each variant that count; one more warms up"));
    m_frames->setAccessibleName(m_frames->toolTip());
    const QSignalBlocker blockedError(m_errorBox);
    const QSignalBlocker blockedSpeed(m_speedBox);
    m_errorBox->setItemText(static_cast<int>(ErrorMeasure::Coverage), tr("Error: coverage"));
    m_errorBox->setItemText(static_cast<int>(ErrorMeasure::Depth), tr("Error: depth"));
    m_errorBox->setItemText(static_cast<int>(ErrorMeasure::Color), tr("Error: colour"));
    m_errorBox->setAccessibleName(tr("Error of the horizontal axis"));
    m_errorBox->setToolTip(m_errorBox->accessibleName());
    m_speedBox->setItemText(static_cast<int>(SpeedMeasure::NsPerCoveredPixel), tr("ns per pixel"));
    m_speedBox->setItemText(static_cast<int>(SpeedMeasure::MtriPerS), tr("Mtri/s"));
    m_speedBox->setAccessibleName(tr("Speed of the vertical axis"));
    m_speedBox->setToolTip(m_speedBox->accessibleName());
    m_export->setText(tr("Export") + QStringLiteral(" \u25be"));
    m_plot->setToolTip(QString());
    m_table->setToolTip(tr("Double-click or Enter loads the variant"));
    show();
    syncState();
}

void ExperimentPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange)
        keepRunWidth();
}

} // namespace rasterlens
