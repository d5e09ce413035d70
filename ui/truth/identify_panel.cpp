#include "ui/truth/identify_panel.h"

#include "core/io/picture_input.h"
#include "core/render/render.h"
#include "core/settings/mistakes.h"
#include "core/truth/difference.h"
#include "ui/truth/picture_strip.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kProgressMs = 100;
enum Column { kScore, kMistake, kPixels, kWhere, kColumns };

QString titleOf(const QString& id)
{
    const Mistake* mistake = findMistake(id);
    return mistake ? QStringLiteral("%1  %2").arg(QLatin1String(mistake->number),
                                                  QCoreApplication::translate("Mistake", mistake->title))
                   : IdentifyPanel::tr("The right picture");
}

QString percent(double score) { return QStringLiteral("%1 %").arg(100 * score, 0, 'f', 1); }

QString whereText(const QRect& where)
{
    return where.isEmpty() ? QString()
                           : QStringLiteral("(%1, %2)  %3 \u00d7 %4")
                                 .arg(where.x())
                                 .arg(where.y())
                                 .arg(where.width())
                                 .arg(where.height());
}

} // namespace

IdentifyPanel::IdentifyPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document),
      m_shown([this](const Shown& shown) { take(shown); }, [this](Lack lack) { Q_EMIT failed(lackText(lack)); }),
      m_result([this](Turn turn) { take(std::move(turn)); },
               [this](Lack lack) {
                   Q_EMIT failed(tr("The picture cannot be compared: %1.").arg(lackText(lack)));
                   show();
               })
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 12, 8);
    column->setSpacing(6);
    buildControls();
    m_list = new QTreeWidget;
    m_list->setColumnCount(kColumns);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAlternatingRowColors(true);
    m_list->setMinimumHeight(84);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(kMistake, QHeaderView::Stretch);
    connect(m_list, &QTreeWidget::currentItemChanged, this,
            [this](QTreeWidgetItem* item) { choose(m_list->indexOfTopLevelItem(item)); });
    connect(m_list, &QTreeWidget::itemActivated, this, &IdentifyPanel::apply);
    column->addWidget(m_list, 2);
    m_pictures = new PictureStrip;
    column->addWidget(m_pictures, 3);
    connect(&document, &Document::settingsChanged, this, &IdentifyPanel::sync);
    retranslate();
}

IdentifyPanel::~IdentifyPanel() = default;

void IdentifyPanel::buildControls()
{
    auto* column = static_cast<QVBoxLayout*>(layout());
    auto* row = new QHBoxLayout;
    m_open = new QPushButton;
    m_again = new QPushButton;
    m_apply = new QPushButton;
    connect(m_open, &QPushButton::clicked, this, [this] { isRunning() ? cancel() : fileWanted(); });
    connect(m_again, &QPushButton::clicked, this, &IdentifyPanel::start);
    connect(m_apply, &QPushButton::clicked, this, &IdentifyPanel::apply);
    for (QPushButton* button : {m_open, m_again, m_apply})
        row->addWidget(button);
    row->addStretch(1);
    column->addLayout(row);
    m_progress = new QProgressBar;
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(8);
    QSizePolicy keepsItsPlace = m_progress->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(keepsItsPlace);
    column->addWidget(m_progress);
    m_answer = new QLabel;
    m_answer->setWordWrap(true);
    column->addWidget(m_answer);
}

Settings IdentifyPanel::compared() const
{
    Settings settings = m_document.settings();
    settings.mistakes.clear();
    return settings;
}

bool IdentifyPanel::isOld() const { return m_found && (m_scene != m_document.scene() || !(m_settings == compared())); }

void IdentifyPanel::identifyFile(const QString& path)
{
    m_file = path;
    start();
}

void IdentifyPanel::start()
{
    if (m_file.isEmpty())
        return;
    m_scene = m_document.scene();
    m_settings = compared();
    if (unsupported(*m_scene, m_settings)) {
        Q_EMIT failed(tr("The present settings cannot be drawn, so that there is nothing to compare with."));
        return;
    }
    m_found.reset();
    m_shown.drop();
    m_result.ask(
        [file = m_file, scene = m_scene, settings = m_settings](const auto& turn) {
            PictureLoad picture = loadPicture(file);
            if (!picture.problem)
                picture.problem = whyNotIdentified(picture.image, settings);
            if (picture.problem)
                return Turn{.problem = std::move(picture.problem)};
            QElapsedTimer clock;
            clock.start();
            const auto progress = [&](int done, int total) {
                if (clock.elapsed() < kProgressMs)
                    return;
                turn.deliver({.done = done, .total = total});
                clock.restart();
            };
            return Turn{.done = 1, .found = identify(*scene, settings, picture.image, progress, turn.stop())};
        },
        LatestJob::Running::Interrupt);
    m_progress->setRange(0, 0);
    show();
}

void IdentifyPanel::cancel()
{
    m_result.drop();
    show();
}

void IdentifyPanel::take(Turn turn)
{
    m_progress->setRange(0, turn.total);
    m_progress->setValue(turn.done);
    if (turn.problem)
        Q_EMIT failed(QStringLiteral("%1: %2").arg(m_file, textOf(*turn.problem, [](const char* text) {
                                                       return QCoreApplication::translate("Diagnostic", text);
                                                   })));
    m_found = std::move(turn.found);
    if (!isRunning())
        show();
}

void IdentifyPanel::show()
{
    fillList();
    m_chosen = -1;
    m_pictures->setPictures({}, {});
    sync();
    if (m_found && !m_found->matches.empty())
        m_list->setCurrentItem(m_list->topLevelItem(0));
}

void IdentifyPanel::fillList()
{
    const QSignalBlocker blocked(m_list);
    m_list->clear();
    if (!m_found)
        return;
    for (const MistakeMatch& match : m_found->matches) {
        auto* item = new QTreeWidgetItem(m_list);
        item->setText(kScore, percent(match.score));
        item->setTextAlignment(kScore, Qt::AlignRight | Qt::AlignVCenter);
        QString title = titleOf(match.mistake);
        if (!match.with.isEmpty())
            title = tr("%1, together with %2").arg(title, titleOf(match.with));
        item->setText(kMistake, title);
        item->setText(kPixels, match.pixels > 0 ? QString::number(match.pixels) : QString());
        item->setTextAlignment(kPixels, Qt::AlignRight | Qt::AlignVCenter);
        item->setText(kWhere, whereText(match.where));
        QStringList lines{title};
        if (!match.alike.isEmpty()) {
            QStringList titles;
            for (const QString& id : match.alike)
                titles << titleOf(id);
            lines << tr("Draws the same picture here:") << titles;
            item->setText(kMistake, QStringLiteral("= ") + title);
        }
        for (int i = 0; i < kColumns; ++i)
            item->setToolTip(i, lines.join(QLatin1Char('\n')));
    }
}

void IdentifyPanel::choose(int row)
{
    if (!m_found || row < 0 || row >= static_cast<int>(m_found->matches.size()) || row == m_chosen)
        return;
    m_chosen = row;
    if (m_list->indexOfTopLevelItem(m_list->currentItem()) != row)
        m_list->setCurrentItem(m_list->topLevelItem(row));
    drawChosen();
    sync();
}

void IdentifyPanel::drawChosen()
{
    const MistakeMatch& match = m_found->matches[static_cast<std::size_t>(m_chosen)];
    m_shown.ask(
        [scene = m_scene, settings = settingsOf(match, *m_found), picture = m_found->picture](const auto& turn) {
            Frame frame;
            rasterlens::render(*scene, settings, frame, {}, turn.stop());
            if (turn.stop().stop_requested())
                return Shown{};
            return Shown{frame.image, heatMap(picture, frame.image)};
        },
        LatestJob::Running::Interrupt);
}

void IdentifyPanel::take(const Shown& shown)
{
    if (!m_found || m_chosen < 0)
        return;
    const MistakeMatch& match = m_found->matches[static_cast<std::size_t>(m_chosen)];
    m_pictures->setPictures(
        {{tr("Yours"), m_found->picture},
         {match.mistake == QLatin1String(kNoMistake) ? tr("The right picture") : tr("With the mistake"), shown.drawn},
         {tr("Where they differ"), shown.difference}},
        match.where);
}

/// Switches the chosen mistake on in the window.
void IdentifyPanel::apply()
{
    if (!m_found || m_chosen < 0 || isOld())
        return;
    Settings settings = m_document.settings();
    settings.size = m_found->settings.size;
    settings.mistakes = settingsOf(m_found->matches[static_cast<std::size_t>(m_chosen)], *m_found).mistakes;
    m_settings.size = settings.size;
    m_document.setSettings(settings);
}

QString IdentifyPanel::answer() const
{
    if (isRunning())
        return tr("Comparing with each mistake\u2026");
    if (!m_found)
        return tr(
            "Drop a picture that your own program drew of this scene, or choose it: it is compared with the right "
            "picture and with what each mistake draws.");
    if (!m_found->fits())
        return tr("%1: none of these. No mistake explains the picture.").arg(QFileInfo(m_file).fileName());
    const MistakeMatch& best = m_found->matches.front();
    QString what = titleOf(best.mistake);
    if (!best.with.isEmpty())
        what = tr("%1, together with %2").arg(what, titleOf(best.with));
    return QStringLiteral("%1: %2 (%3)").arg(QFileInfo(m_file).fileName(), what, percent(best.score));
}

QString IdentifyPanel::remark() const
{
    if (isOld())
        return tr("The scene or its settings have changed since.");
    if (m_found && m_found->settings.shading != m_document.scene()->defaults.shading)
        return tr("It was compared with what the window showed, which is not the view that the scene asks for.");
    return {};
}

void IdentifyPanel::sync()
{
    m_open->setText(isRunning() ? tr("Cancel") : tr("Choose a picture\u2026"));
    m_again->setVisible(!isRunning() && !m_file.isEmpty());
    m_again->setEnabled(isOld() || !m_found);
    m_apply->setVisible(m_found.has_value());
    m_apply->setEnabled(m_chosen >= 0 && !isOld());
    m_progress->setVisible(isRunning());
    const QString note = remark();
    m_answer->setText(note.isEmpty() ? answer() : answer() + QLatin1Char('\n') + note);
}

void IdentifyPanel::retranslate()
{
    m_again->setText(tr("Compare again"));
    m_apply->setText(tr("Show in the window"));
    m_apply->setToolTip(tr("Switches this mistake on; a double click does so as well"));
    m_list->setHeaderLabels({tr("Fits"), tr("Mistake"), tr("Pixels") + QStringLiteral("   "), tr("Where")});
    const int chosen = m_chosen;
    fillList();
    if (chosen >= 0) {
        const QSignalBlocker blocked(m_list);
        m_list->setCurrentItem(m_list->topLevelItem(chosen));
        drawChosen();
    }
    sync();
}

void IdentifyPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace rasterlens
