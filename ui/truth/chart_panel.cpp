#include "ui/truth/chart_panel.h"

#include "core/io/picture_file.h"
#include "ui/base/field_row.h"
#include "ui/base/image_export.h"
#include "ui/base/parts.h"
#include "ui/base/turning.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace rasterlens
{
namespace
{

constexpr QSize kFigure(1000, 640);
constexpr int kControlsWidth = 320;

/// What charts are written as besides pictures.
const QStringList& tableFormats()
{
    static const QStringList formats{QStringLiteral("csv"), QStringLiteral("json"), QStringLiteral("svg")};
    return formats;
}

QString translated(const char* text) { return QCoreApplication::translate("Chart", text); }

QString words(const Reason& reason) { return textOf(reason, translated); }

} // namespace

ChartPanel::ChartPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document),
      m_result([this](Chart chart) { take(std::move(chart)); }, [this](Lack lack) { giveUp(lack); })
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 2, 12, 8);
    row->setSpacing(10);
    buildControls();
    auto* controls = new QWidget;
    auto* column = new QVBoxLayout(controls);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(m_box);
    column->addWidget(m_note, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_again);
    buttons->addWidget(m_export);
    buttons->addStretch(1);
    column->addLayout(buttons);
    row->addWidget(controls);
    m_plot = new ChartPlot;
    row->addWidget(m_plot, 1);
    constexpr int kBeside = 700;
    new Turning(this, kBeside, [row, controls](bool beside) {
        row->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
        controls->setFixedWidth(beside ? kControlsWidth : QWIDGETSIZE_MAX);
        controls->setMinimumWidth(beside ? kControlsWidth : 0);
    });
    const auto changed = [this] {
        m_isOld = m_isOld || (m_isDrawn && info().aboutScene);
        syncNote();
    };
    connect(&document, &Document::sceneChanged, this, changed);
    connect(&document, &Document::settingsChanged, this, changed);
    retranslate();
}

ChartPanel::~ChartPanel() = default;

void ChartPanel::buildControls()
{
    m_box = new PanelCombo;
    for (const ChartInfo& info : chartInfos())
        m_box->addItem(QString(), QLatin1String(info.id));
    m_box->setMinimumContentsLength(12);
    m_box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(m_box, &QComboBox::currentIndexChanged, this, &ChartPanel::draw);
    m_again = new QPushButton;
    connect(m_again, &QPushButton::clicked, this, &ChartPanel::draw);
    m_exportMenu = new QMenu(this);
    m_export = makeMenuLink(m_exportMenu);
    for (const char* suffix : {"csv", "json", "svg", "png"})
        connect(m_exportMenu->addAction(QString::fromLatin1(suffix).toUpper()), &QAction::triggered, this,
                [this, suffix] { chooseFile(QString::fromLatin1(suffix)); });
    m_note = new QLabel;
    m_note->setObjectName(QStringLiteral("muted"));
    m_note->setWordWrap(true);
    m_note->setAlignment(Qt::AlignTop);
    m_note->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

const ChartInfo& ChartPanel::info() const
{
    return chartInfos()[static_cast<std::size_t>(std::max(m_box->currentIndex(), 0))];
}

void ChartPanel::choose(const QString& id)
{
    const int index = m_box->findData(id);
    if (index == m_box->currentIndex())
        draw();
    else if (index >= 0)
        m_box->setCurrentIndex(index);
}

std::optional<Reason> ChartPanel::refusal() const
{
    return whyNoChart(info(), *m_document.scene(), m_document.settings());
}

void ChartPanel::draw()
{
    m_isDrawn = false;
    m_isOld = false;
    m_failure.clear();
    m_chart = {};
    m_plot->setChart(nullptr, m_chart);
    if (refusal()) {
        m_result.drop();
    } else {
        m_result.ask([scene = m_document.scene(), settings = m_document.settings(),
                      make = info().make](const auto& turn) { return make(*scene, settings, turn.stop()); },
                     LatestJob::Running::Interrupt);
    }
    syncNote();
}

void ChartPanel::take(Chart chart)
{
    m_chart = std::move(chart);
    m_isDrawn = true;
    m_plot->setChart(&info(), m_chart);
    syncNote();
}

void ChartPanel::giveUp(Lack lack)
{
    m_failure = lack == Lack::Memory ? tr("There is not enough memory for this chart.")
                                     : tr("The system does not start so many threads.");
    syncNote();
}

QString ChartPanel::note() const { return m_note->text(); }

void ChartPanel::syncNote()
{
    QStringList lines{translated(info().explains)};
    const auto reason = refusal();
    if (m_isDrawn)
        for (const Reason& note : m_chart.notes)
            lines << words(note);
    if (m_isOld)
        lines << tr("The scene or its settings have changed since.");
    else if (reason && !m_isDrawn)
        lines << words(*reason);
    else if (isBusy())
        lines << tr("Being drawn \u2026");
    if (!m_failure.isEmpty())
        lines << m_failure;
    m_note->setText(lines.join(QLatin1Char('\n')));
    m_again->setEnabled(info().aboutScene && !reason && !isBusy());
    m_export->setEnabled(m_isDrawn);
}

std::optional<QString> ChartPanel::exportTo(const QString& path)
{
    const ExportTarget target{path, m_document.inputFiles()};
    const QString format = formatOf(path);
    if (format == QLatin1String("csv"))
        return saveBytes(chartCsv(m_chart), target);
    if (format == QLatin1String("json"))
        return saveBytes(chartJson(info(), m_chart), target);
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

void ChartPanel::chooseFile(const QString& suffix)
{
    QFileDialog* dialog =
        newExportDialog(this, tr("Export the chart"), QLatin1String(info().id) + QLatin1Char('.') + suffix,
                        tableFormats() + pictureSuffixes());
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        if (const auto error = exportTo(path))
            Q_EMIT failed(*error);
        else
            Q_EMIT message(tr("Written: %1").arg(path));
    });
    dialog->open();
}

void ChartPanel::retranslate()
{
    for (int i = 0; i < m_box->count(); ++i)
        m_box->setItemText(i, translated(chartInfos()[static_cast<std::size_t>(i)].title));
    m_box->setAccessibleName(tr("Chart"));
    m_again->setText(tr("Draw again"));
    m_export->setText(tr("Export") + QStringLiteral(" \u25be"));
    syncNote();
}

void ChartPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

void ChartPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!m_isDrawn && !isBusy())
        draw();
}

} // namespace rasterlens
