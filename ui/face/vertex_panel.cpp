#include "ui/face/vertex_panel.h"

#include "core/observe/step_log.h"
#include "core/observe/step_text.h"
#include "core/questions/vertex_place.h"
#include "ui/base/field_row.h"
#include "ui/base/flow_layout.h"
#include "ui/base/theme.h"
#include "ui/base/typed_field.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QEvent>
#include <QFocusEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QIcon>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPalette>
#include <QPixmap>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kRowRoom = 8; ///< of the header's padding: letters keep their lower ends

QString tuple(std::initializer_list<double> values)
{
    QStringList parts;
    for (const double value : values)
        parts << shortNumber(value);
    return parts.join(QStringLiteral(", ")).replace(QLatin1Char('-'), QChar(0x2212));
}

QColor asColor(const glm::vec3& color)
{
    const glm::vec3 held = glm::clamp(color, 0.0F, 1.0F);
    return QColor::fromRgbF(held.r, held.g, held.b);
}

/// A patch of a colour that is not tinted where its cell is selected.
QIcon swatch(const QColor& color)
{
    constexpr int kSide = 16;
    QPixmap patch(kSide, kSide);
    patch.fill(color);
    QIcon icon;
    for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected})
        icon.addPixmap(patch, mode);
    return icon;
}

/// A choice and the name of what is chosen, which stay together where the row of switches goes on in the next line.
QWidget* namedBox(QLabel* name, QComboBox* box)
{
    auto* pair = new QWidget;
    auto* row = new QHBoxLayout(pair);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(5);
    row->addWidget(name);
    row->addWidget(box);
    name->setBuddy(box);
    return pair;
}

/// Keeps a cell open whose text is refused, and says why.
class VertexDelegate : public QStyledItemDelegate
{
public:
    VertexDelegate(VertexPanel& panel, VertexTableModel& model)
        : QStyledItemDelegate(&panel), m_panel(panel), m_model(model)
    {
    }

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
        if (auto* edit = qobject_cast<QLineEdit*>(editor)) {
            edit->setProperty(kRow, index.row());
            connect(edit, &QLineEdit::textEdited, &m_panel, [this, edit](const QString& text) {
                if (edit->property("refused").toBool() && !m_model.whyRefused(edit->property(kRow).toInt(), text))
                    mend(*edit);
            });
            connect(edit, &QObject::destroyed, &m_panel, &VertexPanel::inputMended);
        }
        return editor;
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        auto* edit = qobject_cast<QLineEdit*>(watched);
        if (edit && takesText(*event)) {
            if (const auto why = m_model.whyRefused(edit->property(kRow).toInt(), edit->text())) {
                markRefused(*edit, true);
                Q_EMIT m_panel.invalidInput(*why);
                return event->type() == QEvent::KeyPress;
            }
            mend(*edit);
        }
        return QStyledItemDelegate::eventFilter(watched, event);
    }

private:
    static constexpr const char* kRow = "row"; ///< property of an editor: the row of the table it stands in

    /// By Return, by Tab, or by the choice of another widget.
    static bool takesText(const QEvent& event)
    {
        if (event.type() == QEvent::FocusOut) {
            const auto reason = static_cast<const QFocusEvent&>(event).reason();
            return reason != Qt::PopupFocusReason && reason != Qt::ActiveWindowFocusReason;
        }
        if (event.type() != QEvent::KeyPress)
            return false;
        constexpr std::array kKeys{Qt::Key_Return, Qt::Key_Enter, Qt::Key_Tab, Qt::Key_Backtab};
        return std::ranges::find(kKeys, static_cast<const QKeyEvent&>(event).key()) != kKeys.end();
    }

    void mend(QLineEdit& edit) const
    {
        markRefused(edit, false);
        Q_EMIT m_panel.inputMended();
    }

    VertexPanel& m_panel;
    VertexTableModel& m_model;
};

} // namespace

VertexTableModel::VertexTableModel(Document& document, const FaceSelection& selection, const VertexEditing& editing,
                                   QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_scene(document.scene()), m_selection(selection),
      m_editing(editing)
{
}

int VertexTableModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kRowCount; }

int VertexTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 3; }

QString VertexTableModel::cell(int row, const VertexRow& corner) const
{
    const bool inClipSpace = m_scene->space == SceneSpace::Clip;
    const auto& o = corner.object;
    switch (row) {
    case ObjectSpace:
        if (!corner.world.isEmpty())
            return QString(corner.world).replace(QLatin1Char('-'), QChar(0x2212));
        return inClipSpace ? tuple({o.x, o.y, o.z, o.w}) : tuple({o.x, o.y, o.z});
    case ViewSpace:
        return inClipSpace ? QStringLiteral("\u2013") : tuple({corner.view.x, corner.view.y, corner.view.z});
    case ClipSpace: return tuple({corner.clip.x, corner.clip.y, corner.clip.z, corner.clip.w});
    case NdcSpace: return tuple({corner.ndc.x, corner.ndc.y, corner.ndc.z});
    case ScreenSpace: return tuple({corner.screen.x, corner.screen.y});
    case SnappedSpace:
        return QStringLiteral("%1, %2")
            .arg(fullNumber(corner.snapped.x), fullNumber(corner.snapped.y))
            .replace(QLatin1Char('-'), QChar(0x2212));
    case DepthValue: return shortNumber(corner.depth);
    case OutsideOf: return corner.outside == 0 ? tr("inside") : planeSigns(corner.outside);
    case ScreenRegion: return regionText(corner.screenRegion);
    case VertexColor: {
        const glm::vec3 color = colorOf(corner);
        return tuple({color.r, color.g, color.b});
    }
    default: return {};
    }
}

glm::vec3 VertexTableModel::colorOf(const VertexRow& corner) const
{
    return m_scene->mesh.vertices[corner.meshVertex].color;
}

VertexTableModel::Row VertexTableModel::typedRow() const
{
    return m_editing.typed == VertexEditing::Typed::Pixels ? ScreenSpace : ObjectSpace;
}

QVariant VertexTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || !m_corners)
        return {};
    const VertexRow& corner = (*m_corners)[static_cast<std::size_t>(index.column())];
    switch (role) {
    case Qt::DisplayRole: return shownText(cell(index.row(), corner), m_type);
    case Qt::EditRole: return cell(index.row(), corner);
    case Qt::FontRole: return numberFont(m_type.delta);
    case Qt::DecorationRole:
        return index.row() == VertexColor ? QVariant(swatch(asColor(colorOf(corner)))) : QVariant();
    case Qt::ForegroundRole:
        return (flags(index) & Qt::ItemIsEditable) != 0 ? QVariant(QGuiApplication::palette().highlight()) : QVariant();
    case Qt::ToolTipRole:
        return (flags(index) & Qt::ItemIsEditable) != 0 ? tr("Double-click to type other numbers")
               : isBehindEye(index.row(), corner)       ? tr("Behind the eye a corner has no place on the screen.")
                                                        : QVariant();
    default: return {};
    }
}

QVariant VertexTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (role == Qt::ToolTipRole && orientation == Qt::Vertical && section == ScreenRegion)
        return tr("One bit each: above, below, right, left of the screen");
    if (role == Qt::FontRole)
        return textFont(m_type.delta, orientation == Qt::Horizontal);
    if (role != Qt::DisplayRole)
        return {};
    if (orientation == Qt::Horizontal)
        return m_corners && section < 3 ? tr("%1, vertex %2")
                                              .arg(QLatin1Char(static_cast<char>('A' + section)))
                                              .arg((*m_corners)[static_cast<std::size_t>(section)].meshVertex)
                                        : QVariant();
    switch (section) {
    case ObjectSpace:
        if (m_scene->space == SceneSpace::Clip)
            return tr("given  x, y, z, w");
        return m_scene->mesh.origin == glm::dvec3(0) ? tr("object  x, y, z") : tr("world  x, y, z");
    case ViewSpace: return tr("view  x, y, z");
    case ClipSpace: return tr("clip  x, y, z, w");
    case NdcSpace: return tr("NDC  clip / w");
    case ScreenSpace: return tr("screen  pixels");
    case SnappedSpace: return tr("snapped  pixels");
    case DepthValue: return tr("depth  0..1");
    case OutsideOf: return tr("outside of");
    case ScreenRegion: return tr("outcode");
    case VertexColor: return tr("colour  r, g, b");
    default: return {};
    }
}

bool VertexTableModel::isBehindEye(int row, const VertexRow& corner)
{
    return row == ScreenSpace && !(corner.clip.w > 0);
}

Qt::ItemFlags VertexTableModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (!index.isValid() || !m_corners || !isEditable(*m_scene))
        return flags;
    const VertexRow& corner = (*m_corners)[static_cast<std::size_t>(index.column())];
    const bool takesText = index.row() == typedRow() || index.row() == VertexColor;
    if (takesText && !isBehindEye(index.row(), corner))
        flags |= Qt::ItemIsEditable;
    return flags;
}

std::optional<QString> VertexTableModel::whyRefused(int row, const QString& text) const
{
    switch (row) {
    case ScreenSpace:
        return typedPlace(text)
                   ? std::nullopt
                   : std::optional(tr("\"%1\" is not a place on the screen. Write x, y in pixels.").arg(text));
    case VertexColor:
        return typedColor(text)
                   ? std::nullopt
                   : std::optional(tr("\"%1\" is not a colour. Write r, g, b from 0 to 1, or #rrggbb.").arg(text));
    default: break;
    }
    if (typedPosition(text, {}, m_scene->mesh.origin))
        return std::nullopt;
    return m_scene->space == SceneSpace::Clip ? tr("\"%1\" is not a position. Write x, y, z, w or x, y, z.").arg(text)
                                              : tr("\"%1\" is not a position. Write x, y, z.").arg(text);
}

std::shared_ptr<const Scene> VertexTableModel::withPosition(std::uint32_t vertex, const glm::vec4& position) const
{
    const Scene& scene = *m_document.scene();
    return m_editing.together ? withCorner(scene, vertex, position) : withVertex(scene, vertex, position);
}

std::shared_ptr<const Scene> VertexTableModel::edited(int row, std::uint32_t vertex, const QString& text) const
{
    const Scene& scene = *m_document.scene();
    if (row == VertexColor) {
        const auto color = typedColor(text);
        return color ? withColor(scene, vertex, *color) : nullptr;
    }
    if (row == ScreenSpace) {
        const auto place = typedPlace(text);
        const auto position = place ? positionAtPixel(scene, m_document.settings(), vertex, *place) : std::nullopt;
        return position ? withPosition(vertex, *position) : nullptr;
    }
    const auto position = typedPosition(text, scene.mesh.vertices[vertex].position, scene.mesh.origin);
    return position ? withPosition(vertex, *position) : nullptr;
}

bool VertexTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || (flags(index) & Qt::ItemIsEditable) == 0)
        return false;
    const VertexRow& corner = (*m_corners)[static_cast<std::size_t>(index.column())];
    if (value.toString() == cell(index.row(), corner))
        return true; // the numbers of a cell are rounded: taken over untouched they would move the corner
    auto scene = edited(index.row(), corner.meshVertex, value.toString());
    if (!scene)
        return false;
    const MeshVertex& now = scene->mesh.vertices[corner.meshVertex];
    const MeshVertex& former = m_document.scene()->mesh.vertices[corner.meshVertex];
    if (now.position != former.position || now.color != former.color)
        m_document.editScene(std::move(scene));
    return true;
}

void VertexTableModel::refresh()
{
    m_scene = m_document.scene();
    if (m_selection.face() < m_scene->mesh.faceCount())
        m_corners = vertexTable(*m_scene, m_document.settings(), m_selection.face());
    else
        m_corners.reset();
    Q_EMIT dataChanged(index(0, 0), index(kRowCount - 1, 2));
    Q_EMIT headerDataChanged(Qt::Vertical, 0, kRowCount - 1);
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, 2);
}

void VertexTableModel::setType(const Type& type)
{
    if (std::exchange(m_type, type) == type)
        return;
    Q_EMIT dataChanged(index(0, 0), index(kRowCount - 1, 2));
    Q_EMIT headerDataChanged(Qt::Vertical, 0, kRowCount - 1);
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, 2);
}

QString VertexTableModel::shownText(const QString& cell, const Type& type)
{
    const QString comma = QStringLiteral(", ");
    QStringList parts = cell.split(comma);
    if (!type.hasBrokenRows || parts.size() < 2)
        return cell;
    const qsizetype half = (parts.size() + 1) / 2;
    return parts.first(half).join(comma) + QStringLiteral(",\n") + parts.sliced(half).join(comma);
}

VertexPanel::VertexPanel(Document& document, FaceSelection& selection, VertexEditing& editing, QWidget* parent)
    : QWidget(parent), m_document(document), m_editing(editing),
      m_model(new VertexTableModel(document, selection, editing, this)), m_table(new QTableView),
      m_typed(new PanelCombo), m_snapName(new QLabel), m_snap(new PanelCombo), m_together(new QCheckBox),
      m_hint(new QLabel)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 8, 6);
    column->setSpacing(6);
    constexpr int kSpacing = 8;
    auto* head = new FlowLayout(kSpacing);
    head->addWidget(new FacePicker(selection));
    head->addWidget(m_typed);
    column->addLayout(head);
    buildTable();
    column->addWidget(m_table, 1);
    auto* foot = new FlowLayout(kSpacing);
    foot->addWidget(namedBox(m_snapName, m_snap));
    foot->addWidget(m_together);
    column->addLayout(foot);
    m_hint->setObjectName(QStringLiteral("muted"));
    m_hint->setWordWrap(true);
    column->addWidget(m_hint);
    connectSwitches();
    retranslate();
}

void VertexPanel::connectSwitches()
{
    m_typed->setObjectName(QStringLiteral("typedBox"));
    m_snap->setObjectName(QStringLiteral("snapBox"));
    for (const int value : {int(VertexEditing::Typed::Pixels), int(VertexEditing::Typed::Given)})
        m_typed->addItem(QString(), value);
    for (const int value : {int(VertexEditing::Snap::PixelGrid), int(VertexEditing::Snap::PixelCentre),
                            int(VertexEditing::Snap::SubpixelGrid)})
        m_snap->addItem(QString(), value);
    for (QComboBox* box : {m_typed, m_snap})
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(m_typed, &QComboBox::activated, this, [this] {
        m_editing.typed = static_cast<VertexEditing::Typed>(m_typed->currentData().toInt());
        refresh();
    });
    connect(m_snap, &QComboBox::activated, this,
            [this] { m_editing.snap = static_cast<VertexEditing::Snap>(m_snap->currentData().toInt()); });
    connect(m_together, &QCheckBox::toggled, this, [this](bool on) { m_editing.together = on; });
}

void VertexPanel::buildTable()
{
    m_table->setModel(m_model);
    auto* delegate = new VertexDelegate(*this, *m_model);
    m_table->setItemDelegate(delegate);
    connect(delegate, &QAbstractItemDelegate::closeEditor, this,
            [this](const QWidget*, QAbstractItemDelegate::EndEditHint hint) {
                if (hint == QAbstractItemDelegate::EditNextItem || hint == QAbstractItemDelegate::EditPreviousItem)
                    return;
                QTimer::singleShot(0, m_table, [this] { m_table->clearFocus(); }); // the table takes it first
            });
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents); // scrolls where it is too narrow
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
}

/// In the large type of the stage the table would be cut: there it has the largest type, down to that of the window, in
/// which its cells have room in one line, or the larger one in which they have it in two lines.
void VertexPanel::fitType()
{
    constexpr double kLeastPoints = 9.5;
    constexpr double kReadable = 14;
    constexpr double kStep = 0.5;
    const double usual = textFont(0).pointSizeF();
    const QMargins around = layout()->contentsMargins();
    const int room = width() - around.left() - around.right(); // the layout follows later
    const auto largest = [&](bool hasBrokenRows, double least) {
        VertexTableModel::Type type{0, hasBrokenRows};
        while (usual + type.delta > least && widthOfTable(type) > room)
            type.delta = std::max(type.delta - kStep, least - usual);
        return type;
    };
    VertexTableModel::Type type = largest(false, std::min(usual, kReadable));
    if (usual > kReadable && widthOfTable(type) > room)
        type = largest(true, kLeastPoints);
    m_model->setType(type);
    const int line = QFontMetrics(numberFont(type.delta)).lineSpacing();
    const int height = std::max(QFontMetrics(textFont(type.delta)).height(), line) + kRowRoom;
    m_table->verticalHeader()->setMinimumSectionSize(height);
    m_table->verticalHeader()->setDefaultSectionSize(height);
    for (int row = 0; row < VertexTableModel::kRowCount; ++row) {
        bool isBroken = false;
        for (int column = 0; column < m_model->columnCount(); ++column)
            isBroken = isBroken || m_model->index(row, column).data().toString().contains(QLatin1Char('\n'));
        if (!m_table->isRowHidden(row))
            m_table->setRowHeight(row, height + (isBroken ? line : 0));
    }
}

int VertexPanel::widthOfTable(const VertexTableModel::Type& type) const
{
    constexpr int kPadding = 22; // of a cell, with what the style adds
    constexpr int kSwatch = 24;
    const QFontMetrics numbers(numberFont(type.delta));
    const QFontMetrics names(textFont(type.delta, true));
    int width = 0;
    for (int row = 0; row < VertexTableModel::kRowCount; ++row)
        if (!m_table->isRowHidden(row))
            width = std::max(
                width, names.horizontalAdvance(m_model->headerData(row, Qt::Vertical, Qt::DisplayRole).toString()));
    width += kPadding;
    for (int column = 0; column < m_model->columnCount(); ++column) {
        int widest = names.horizontalAdvance(m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
        for (int row = 0; row < VertexTableModel::kRowCount; ++row) {
            const QString cell = m_model->index(row, column).data(Qt::EditRole).toString();
            const int swatch = row == VertexTableModel::VertexColor ? kSwatch : 0;
            if (!m_table->isRowHidden(row))
                for (const QString& line : VertexTableModel::shownText(cell, type).split(QLatin1Char('\n')))
                    widest = std::max(widest, numbers.horizontalAdvance(line) + swatch);
        }
        width += widest + kPadding;
    }
    return width;
}

/// The table has all its rows in sight; what is higher than the dock scrolls as a whole.
void VertexPanel::fitToRows()
{
    fitType();
    m_table->setMinimumHeight(m_table->verticalHeader()->length() + m_table->horizontalHeader()->sizeHint().height() +
                              m_table->horizontalScrollBar()->sizeHint().height() + kRowRoom);
}

void VertexPanel::syncSwitches()
{
    const Scene& scene = *m_document.scene();
    const QSignalBlocker typed(m_typed);
    const QSignalBlocker snap(m_snap);
    m_typed->setItemText(m_typed->findData(int(VertexEditing::Typed::Pixels)), tr("pixels"));
    m_typed->setItemText(m_typed->findData(int(VertexEditing::Typed::Given)),
                         scene.space == SceneSpace::Clip      ? tr("clip")
                         : scene.mesh.origin == glm::dvec3(0) ? tr("object")
                                                              : tr("world"));
    m_typed->setCurrentIndex(m_typed->findData(int(m_editing.typed)));
    const int units = 1 << m_document.settings().subpixelBits;
    m_snap->setItemText(m_snap->findData(int(VertexEditing::Snap::PixelGrid)), tr("pixel grid"));
    m_snap->setItemText(m_snap->findData(int(VertexEditing::Snap::PixelCentre)), tr("pixel centre"));
    m_snap->setItemText(m_snap->findData(int(VertexEditing::Snap::SubpixelGrid)), tr("1/%1 pixel").arg(units));
    m_snap->setCurrentIndex(m_snap->findData(int(m_editing.snap)));
    m_together->setChecked(m_editing.together);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_typed, m_snap, m_together, m_snapName})
        widget->setEnabled(isEditable(scene));
}

QString VertexPanel::hint() const
{
    const Scene& scene = *m_document.scene();
    if (!isEditable(scene))
        return tr("Scenes of up to %1 faces can be edited here.").arg(kMostEditableFaces);
    const bool inPixels = m_editing.typed == VertexEditing::Typed::Pixels;
    const auto& corners = m_model->corners();
    if (inPixels && corners && std::ranges::any_of(*corners, [](const VertexRow& c) { return !(c.clip.w > 0); }))
        return tr("A corner with w \u2264 0 lies behind the eye and has no place on the screen: type the coordinates "
                  "that the scene gives.");
    if (inPixels && scene.space == SceneSpace::Object)
        return tr("Typed or dragged in pixels, a corner keeps its distance from the camera: depth and w stay.");
    return tr("Type over the blue numbers, or drag the corners on the canvas. Undo takes it back; the scene's file "
              "stays as it is.");
}

void VertexPanel::refresh()
{
    m_model->refresh();
    m_table->setRowHidden(VertexTableModel::ViewSpace, m_document.scene()->space == SceneSpace::Clip);
    fitToRows();
    syncSwitches();
    m_hint->setText(hint());
}

void VertexPanel::retranslate()
{
    m_typed->setAccessibleName(tr("type in"));
    m_snapName->setText(tr("drag to"));
    m_together->setText(tr("shared corners move together"));
    m_snap->setAccessibleName(m_snapName->text());
    m_typed->setToolTip(tr("What the numbers of a corner are that you type"));
    m_snap->setToolTip(tr("The places that a dragged corner goes to"));
    m_together->setToolTip(tr("Vertices of other faces that lie at the same place go with a corner"));
    refresh();
    m_table->setAccessibleName(tr("The corners of the face in every space"));
}

void VertexPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        fitToRows();
    QWidget::changeEvent(event);
}

void VertexPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitToRows();
}

} // namespace rasterlens
