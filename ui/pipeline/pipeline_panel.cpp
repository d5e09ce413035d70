#include "ui/pipeline/pipeline_panel.h"

#include "core/base/typed_numbers.h"
#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"
#include "ui/base/applicability.h"
#include "ui/base/case_note.h"
#include "ui/base/field_row.h"
#include "ui/base/parts.h"
#include "ui/pipeline/light_fields.h"
#include "ui/pipeline/mistakes_section.h"
#include "ui/pipeline/number_dial.h"
#include "ui/pipeline/numbers_row.h"
#include "ui/pipeline/plane_fields.h"
#include "ui/pipeline/scene_words.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/pipeline/unchanged_notes.h"

#include <QAbstractItemView>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace rasterlens
{
namespace
{

constexpr int kNarrowest = 222; ///< names still have room, in two lines; the usual width is the window's to choose

constexpr std::array kGroups{Stage::Clip,  Stage::Screen, Stage::Cull, Stage::Cover,
                             Stage::Depth, Stage::Shade,  Stage::Image};

constexpr std::array kSizePresets{QSize(8, 8),       QSize(16, 16),    QSize(64, 64),   QSize(256, 256),
                                  QSize(320, 240),   QSize(640, 480),  QSize(800, 600), QSize(1280, 720),
                                  QSize(1920, 1080), QSize(3840, 2160)};

QString sizeText(QSize size) { return QStringLiteral("%1 \u00d7 %2").arg(size.width()).arg(size.height()); }

} // namespace

PipelinePanel::PipelinePanel(Document& document, const Language& language, QWidget* parent)
    : QWidget(parent), m_document(document), m_language(language)
{
    setMinimumWidth(kNarrowest);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 2, 0, 6);
    outer->setSpacing(4);

    outer->addLayout(buildHead());
    m_scroll = makePanelScroll();
    m_scroll->setWidget(buildSwitches());
    outer->addWidget(m_scroll, 1);
    // Below what scrolls: which mistakes are on is always in sight.
    m_mistakes = new MistakesSection(document, language);
    connect(m_mistakes, &MistakesSection::opened, this,
            [this, outer](bool open) { outer->setStretchFactor(m_mistakes, open ? 1 : 0); });
    outer->addWidget(m_mistakes);
    m_notes = new UnchangedNotes(document, m_rows, this);
    connect(m_notes, &UnchangedNotes::failed, this, &PipelinePanel::failed);
    connect(m_notes, &UnchangedNotes::shown, this, &PipelinePanel::keepInSight);

    connect(&document, &Document::sceneChanged, this, &PipelinePanel::syncScene);
    connect(&document, &Document::settingsChanged, this, &PipelinePanel::syncSettings);
    connect(&document, &Document::loadingChanged, this, [this](bool loading) {
        if (!loading)
            syncScene(); // the box may name a scene that was not opened
    });
    retranslate();
}

/// The scene, and how many settings differ from what it asks for.
QVBoxLayout* PipelinePanel::buildHead()
{
    auto* head = new QVBoxLayout;
    head->setContentsMargins(12, 0, 12, 0);
    head->setSpacing(4);
    addScene(head);
    auto* row = new QHBoxLayout;
    m_heading = new QLabel;
    m_heading->setObjectName(QStringLiteral("title"));
    m_reset = makeLink();
    connect(m_reset, &QToolButton::clicked, this, [this] { m_document.resetSettings(); });
    row->addWidget(m_heading, 1);
    row->addWidget(m_reset);
    head->addLayout(row);
    return head;
}

/// The switches of all stages, a group a stage.
QWidget* PipelinePanel::buildSwitches()
{
    QWidget* content = makePanelContent();
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(2, 0, 6, 8);
    column->setSpacing(4);
    for (const Stage stage : kGroups) {
        QVBoxLayout* group = addGroup(stage);
        column->addLayout(group);
        if (stage == Stage::Image)
            addSize(group);
        if (stage == Stage::Screen)
            addNumberDial(group);
        if (stage == Stage::Clip)
            addPlanes(group);
        for (const SettingsField& field : settingsFields())
            if (field.stage == stage)
                group->addWidget(addRow(field));
        for (const NumbersField& field : numbersFields())
            if (field.stage == stage)
                group->addWidget(addRow(field));
        if (stage == Stage::Shade)
            addLight(group);
    }
    column->addStretch(1);
    return content;
}

FieldRow* PipelinePanel::addRow(const SettingsField& field)
{
    auto* row = new FieldRow(field, m_language);
    connect(row, &FieldRow::chosen, this, [this, &field](int value) {
        Settings next = m_document.settings();
        field.set(next, value);
        m_document.setSettings(next);
    });
    connect(row, &FieldRow::resetRequested, this, [this, &field] {
        Settings next = m_document.settings();
        field.set(next, field.get(m_document.defaults()));
        m_document.setSettings(next);
    });
    connect(row, &FieldRow::popupOpening, this, [this, row, &field] {
        row->setValueReasons([this, &field](int value) {
            Settings candidate = m_document.settings();
            field.set(candidate, value);
            const auto reason = unsupported(*m_document.scene(), candidate);
            return reason ? whyUnsupported(*reason) : QString();
        });
    });
    m_rows.push_back(row);
    return row;
}

NumbersRow* PipelinePanel::addRow(const NumbersField& field)
{
    auto* row = new NumbersRow(field, m_document);
    connect(row, &NumbersRow::invalidInput, this, &PipelinePanel::invalidInput);
    connect(row, &NumbersRow::inputMended, this, &PipelinePanel::inputMended);
    m_numbers.push_back(row);
    return row;
}

QVBoxLayout* PipelinePanel::addGroup(Stage stage)
{
    auto* group = new QVBoxLayout;
    group->setContentsMargins(0, 0, 0, 4);
    group->setSpacing(3);
    auto* heading = new QLabel;
    heading->setContentsMargins(10, 2, 0, 0);
    heading->setObjectName(QStringLiteral("groupHeading"));
    group->addWidget(heading);
    m_groupHeadings[stage] = heading;
    return group;
}

void PipelinePanel::addScene(QVBoxLayout* group)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    m_sceneBox = new PanelCombo;
    m_sceneBox->setObjectName(QStringLiteral("sceneBox"));
    m_sceneBox->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(m_sceneBox, &QComboBox::activated, this,
            [this](int index) { Q_EMIT sceneChosen(m_sceneBox->itemData(index).toString()); });
    m_open = makeLink();
    connect(m_open, &QToolButton::clicked, this, &PipelinePanel::openRequested);
    row->addWidget(m_sceneBox, 1);
    row->addWidget(m_open);
    group->addLayout(row);
    m_sceneNote = new QLabel;
    m_sceneNote->setObjectName(QStringLiteral("muted"));
    m_sceneNote->setWordWrap(true);
    m_sceneNote->setTextInteractionFlags(Qt::TextSelectableByMouse);
    group->addWidget(m_sceneNote);
}

void PipelinePanel::addNumberDial(QVBoxLayout* group)
{
    m_dial = new NumberDial(m_document);
    group->addWidget(m_dial);
    m_failureMenu = new QMenu(this);
    m_floatFailures = makeMenuLink(m_failureMenu);
    group->addWidget(m_floatFailures, 0, Qt::AlignHCenter);
    connect(m_failureMenu, &QMenu::triggered, this,
            [this](const QAction* action) { Q_EMIT floatFailureChosen(action->data().toString()); });
}

void PipelinePanel::addPlanes(QVBoxLayout* group)
{
    m_planes = new PlaneFields(m_document);
    connect(m_planes, &PlaneFields::invalidInput, this, &PipelinePanel::invalidInput);
    connect(m_planes, &PlaneFields::inputMended, this, &PipelinePanel::inputMended);
    group->addWidget(m_planes);
}

void PipelinePanel::addLight(QVBoxLayout* group)
{
    m_light = new LightFields(m_document);
    connect(m_light, &LightFields::invalidInput, this, &PipelinePanel::invalidInput);
    connect(m_light, &LightFields::inputMended, this, &PipelinePanel::inputMended);
    group->addWidget(m_light);
}

/// Scenes in which coverage by float32 edge functions is wrong and that by fixed point is right.
void PipelinePanel::fillFailureMenu()
{
    m_floatFailures->setText(tr("Where float32 fails") + QStringLiteral(" \u25be"));
    m_floatFailures->setToolTip(tr("Opens a scene with float32 and has the referee check it"));
    m_failureMenu->clear();
    for (const BuiltinScene& scene : builtinScenes())
        if (std::ranges::find(kFloatFailures, QLatin1String(scene.name)) != kFloatFailures.end())
            m_failureMenu->addAction(QCoreApplication::translate("BuiltinScene", scene.title))
                ->setData(QStringLiteral("builtin:") + QLatin1String(scene.name));
}

void PipelinePanel::addSize(QVBoxLayout* group)
{
    auto* dot = new ChangeDot;
    connect(dot, &ChangeDot::clicked, this, [this] {
        Settings next = m_document.settings();
        next.size = m_document.defaults().size;
        m_document.setSettings(next);
    });
    m_sizeDot = dot;
    m_sizeLabel = new QLabel;
    m_sizeLabel->setObjectName(QStringLiteral("muted"));
    m_sizeBox = new PanelCombo;
    m_sizeBox->setObjectName(QStringLiteral("sizeBox"));
    m_sizeBox->setEditable(true);
    m_sizeBox->setInsertPolicy(QComboBox::NoInsert);
    m_sizeBox->setCompleter(nullptr);
    m_sizeBox->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    for (const QSize& size : kSizePresets)
        m_sizeBox->addItem(sizeText(size));
    m_sizeField = new TypedField(
        m_sizeBox->lineEdit(),
        [this](const QString& text, TypedField::Attempt attempt) { return readSize(text, attempt); }, m_sizeBox);
    connect(m_sizeField, &TypedField::refused, this, &PipelinePanel::invalidInput);
    connect(m_sizeField, &TypedField::mended, this, &PipelinePanel::inputMended);
    connect(m_sizeBox, &QComboBox::activated, this, [this](int index) {
        Settings next = m_document.settings();
        next.size = kSizePresets[static_cast<std::size_t>(index)];
        m_sizeField->setValue({}); // a text typed before is given up
        m_document.setSettings(next);
        syncSettings();
        m_sizeBox->clearFocus();
    });
    group->addLayout(makeFieldLine(dot, m_sizeLabel, m_sizeBox));
}

std::optional<QString> PipelinePanel::readSize(const QString& text, TypedField::Attempt attempt)
{
    const auto size = typedSize(text, kMaxViewport);
    if (!size)
        return tr("\"%1\" is not a size. Write WIDTH x HEIGHT with 1 to %2 each.").arg(text).arg(kMaxViewport);
    if (attempt == TypedField::Attempt::Look)
        return std::nullopt;
    Settings next = m_document.settings();
    next.size = *size;
    m_document.setSettings(next);
    m_sizeField->setValue(sizeText(*size));
    return std::nullopt;
}

void PipelinePanel::setKeyHint(const QString& fieldId, const QString& key)
{
    for (FieldRow* row : m_rows)
        if (fieldId == QLatin1String(row->field().id))
            row->setKeyHint(key);
}

void PipelinePanel::scrollTo(Stage stage)
{
    if (stage == Stage::Scene) {
        m_scroll->verticalScrollBar()->setValue(0);
        m_sceneBox->setFocus(Qt::OtherFocusReason);
        return;
    }
    m_scroll->verticalScrollBar()->setValue(m_groupHeadings[stage]->y() - 2);
}

QWidget* PipelinePanel::editor(const QString& fieldId) const
{
    for (FieldRow* row : m_rows)
        if (fieldId == QLatin1String(row->field().id))
            return row->editor();
    for (NumbersRow* row : m_numbers)
        if (fieldId == QLatin1String(row->numbers().id))
            return &row->edit();
    return nullptr;
}

QString PipelinePanel::note(const QString& fieldId) const
{
    for (const FieldRow* row : m_rows)
        if (fieldId == QLatin1String(row->field().id))
            return row->note();
    return {};
}

bool PipelinePanel::isBusy() const { return m_notes->isBusy(); }

int PipelinePanel::changedCount() const
{
    const Settings& now = m_document.settings();
    const Settings& defaults = m_document.defaults();
    int changed = (now.size != defaults.size) + !(now.view == defaults.view) + (now.light != defaults.light) +
                  (now.mistakes != defaults.mistakes);
    for (const SettingsField& field : settingsFields())
        changed += field.get(now) != field.get(defaults);
    for (const NumbersField& field : numbersFields())
        changed += !isEqual(field, now, defaults);
    return changed;
}

void PipelinePanel::syncScene()
{
    const Scene& scene = *m_document.scene();
    const QSignalBlocker blocked(m_sceneBox);
    m_sceneBox->clear();
    for (const BuiltinScene& builtin : builtinScenes())
        m_sceneBox->addItem(QCoreApplication::translate("BuiltinScene", builtin.title),
                            QStringLiteral("builtin:") + QLatin1String(builtin.name));
    m_sceneBox->insertSeparator(m_sceneBox->count());
    for (const StressScene& stress : stressScenes())
        m_sceneBox->addItem(QCoreApplication::translate("StressScene", stress.title),
                            QStringLiteral("stress:") + QLatin1String(stress.name));
    int index = m_sceneBox->findData(scene.id);
    const QString note = sceneNote(scene);
    if (index < 0 && !scene.id.isEmpty()) {
        m_sceneBox->insertItem(0, sceneTitle(scene), scene.id);
        m_sceneBox->insertSeparator(1);
        index = 0;
    }
    m_sceneBox->setCurrentIndex(index);
    m_sceneBox->setToolTip(scene.id);
    m_note = note;
    showNote();
}

/// What to look at in the scene, what stands for a texture that it does not have, and why lines may lie beside edges.
void PipelinePanel::showNote()
{
    const Settings& settings = m_document.settings();
    QStringList notes{m_note};
    const bool drawsLines = settings.fill == Fill::Wireframe || !m_document.scene()->mesh.lines.empty();
    if (drawsLines && settings.lineRule != LineRule::DiamondExit)
        notes << tr(
            "Lines run from the pixel of one corner to that of the next, up to half a pixel beside the edge. With "
            "the line rule \"Diamond exit\" the edge itself decides.");
    if (settings.shading == Shading::Texture && m_document.scene()->textures.empty())
        notes << tr("No material of this scene has a texture: a checkerboard stands for it.");
    notes.removeAll(QString());
    m_sceneNote->setText(notes.join(QLatin1Char('\n')));
    m_sceneNote->setVisible(!notes.isEmpty());
}

void PipelinePanel::syncSettings()
{
    m_inSight = nullptr;
    const Settings& settings = m_document.settings();
    const Settings& defaults = m_document.defaults();
    const bool refused = unsupported(*m_document.scene(), settings).has_value();
    const bool hasLines = !m_document.scene()->mesh.lines.empty();
    showNote();
    for (FieldRow* row : m_rows)
        row->sync(settings, defaults, refused, hasLines);
    for (NumbersRow* row : m_numbers)
        row->sync();
    m_notes->refresh();
    m_planes->sync();
    m_light->sync();
    {
        const QSignalBlocker blocked(m_sizeBox);
        const QString text = sizeText(settings.size);
        const QString typed = m_sizeBox->lineEdit()->text();
        m_sizeBox->setCurrentIndex(m_sizeBox->findText(text));
        m_sizeBox->lineEdit()->setText(typed); // which the former line changed
        m_sizeField->setValue(text);
    }
    static_cast<ChangeDot*>(m_sizeDot)->setChanged(settings.size != defaults.size);
    const int changed = changedCount();
    m_reset->setText(changed == 0 ? tr("as the scene asks") : tr("%n changed \u00b7 reset", nullptr, changed));
    m_reset->setEnabled(changed != 0);
}

void PipelinePanel::bringInSight(const QString& fieldId)
{
    m_inSight = nullptr;
    for (FieldRow* row : m_rows)
        if (fieldId == QLatin1String(row->field().id))
            m_inSight = row;
    keepInSight();
}

/// Once the layout knows how high the row is.
void PipelinePanel::keepInSight()
{
    QTimer::singleShot(0, this, [this] {
        constexpr int kMargin = 8;
        if (m_inSight == nullptr)
            return;
        QCoreApplication::sendPostedEvents(m_scroll, QEvent::LayoutRequest);
        QCoreApplication::sendPostedEvents(m_scroll->widget(), QEvent::LayoutRequest);
        m_scroll->ensureWidgetVisible(m_inSight, 0, kMargin);
    });
}

void PipelinePanel::retranslate()
{
    m_heading->setText(tr("Pipeline"));
    m_open->setText(tr("Open\u2026"));
    fillFailureMenu();
    m_reset->setToolTip(tr("Put back every value to what the scene asks for"));
    m_sizeLabel->setText(tr("Size in pixels"));
    m_sizeBox->setToolTip(
        tr("Width and height of the picture, 1 to %1 each. The window only magnifies it.").arg(kMaxViewport));
    for (const auto& [stage, heading] : m_groupHeadings) {
        heading->setText(stageTitle(stage));
    }
    for (FieldRow* row : m_rows)
        row->retranslate();
    for (NumbersRow* row : m_numbers)
        row->retranslate();
    m_planes->retranslate();
    m_light->retranslate();
    syncScene();
    syncSettings();
}

void PipelinePanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace rasterlens
