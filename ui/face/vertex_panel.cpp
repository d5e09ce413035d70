#include "ui/face/vertex_panel.h"

#include "core/base/typed_numbers.h"
#include "core/observe/step_log.h"
#include "core/observe/step_text.h"
#include "ui/base/theme.h"
#include "ui/base/typed_field.h"

#include <QAbstractItemView>
#include <QEvent>
#include <QFocusEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPalette>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlens
{
namespace
{

QString tuple(std::initializer_list<double> values)
{
    QStringList parts;
    for (const double value : values)
        parts << shortNumber(value);
    return parts.join(QStringLiteral(", ")).replace(QLatin1Char('-'), QChar(0x2212));
}

/// in   the mesh's origin: what is typed are coordinates of the file
std::optional<glm::vec4> positionFrom(const QString& text, const glm::vec4& former, const glm::dvec3& origin)
{
    const auto numbers = typedNumbers(text);
    if (!numbers || (numbers->size() != 3 && numbers->size() != 4))
        return std::nullopt;
    glm::vec4 position = former;
    for (std::size_t i = 0; i < numbers->size(); ++i) {
        const double typed = (*numbers)[i];
        const int k = static_cast<int>(i);
        position[k] = static_cast<float>(k < 3 ? typed - origin[k] : typed);
        if (!std::isfinite(position[k]))
            return std::nullopt;
    }
    return position;
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
            connect(edit, &QLineEdit::textEdited, &m_panel, [this, edit](const QString& text) {
                if (edit->property("refused").toBool() && !m_model.whyRefused(text))
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
            if (const auto why = m_model.whyRefused(edit->text())) {
                markRefused(*edit, true);
                Q_EMIT m_panel.invalidInput(*why);
                return event->type() == QEvent::KeyPress;
            }
            mend(*edit);
        }
        return QStyledItemDelegate::eventFilter(watched, event);
    }

private:
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

bool isEditable(const Scene& scene)
{
    const std::size_t faces = scene.mesh.faceCount();
    return faces > 0 && faces <= kMostEditableFaces;
}

std::shared_ptr<const Scene> withVertex(const Scene& scene, std::uint32_t vertex, const glm::vec4& position)
{
    // The bounding sphere stays: the camera is not to run after the corner.
    auto edited = std::make_shared<Scene>(scene);
    edited->mesh.vertices[vertex].position = position;
    return edited;
}

VertexTableModel::VertexTableModel(Document& document, const FaceSelection& selection, QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_scene(document.scene()), m_selection(selection)
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
    default: return {};
    }
}

QVariant VertexTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || !m_corners)
        return {};
    const VertexRow& corner = (*m_corners)[static_cast<std::size_t>(index.column())];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole: return cell(index.row(), corner);
    case Qt::FontRole: return numberFont();
    case Qt::ForegroundRole:
        return (flags(index) & Qt::ItemIsEditable) != 0 ? QVariant(QGuiApplication::palette().highlight()) : QVariant();
    case Qt::ToolTipRole:
        return (flags(index) & Qt::ItemIsEditable) != 0 ? tr("Double-click to type other numbers") : QVariant();
    default: return {};
    }
}

QVariant VertexTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (role == Qt::ToolTipRole && orientation == Qt::Vertical && section == ScreenRegion)
        return tr("One bit each: above, below, right, left of the screen");
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
    default: return {};
    }
}

Qt::ItemFlags VertexTableModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (index.isValid() && m_corners && index.row() == ObjectSpace && isEditable(*m_scene))
        flags |= Qt::ItemIsEditable;
    return flags;
}

std::optional<QString> VertexTableModel::whyRefused(const QString& text) const
{
    if (positionFrom(text, {}, m_scene->mesh.origin))
        return std::nullopt;
    return m_scene->space == SceneSpace::Clip ? tr("\"%1\" is not a position. Write x, y, z, w or x, y, z.").arg(text)
                                              : tr("\"%1\" is not a position. Write x, y, z.").arg(text);
}

bool VertexTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || (flags(index) & Qt::ItemIsEditable) == 0)
        return false;
    const std::uint32_t vertex = (*m_corners)[static_cast<std::size_t>(index.column())].meshVertex;
    const glm::vec4 former = m_document.scene()->mesh.vertices[vertex].position;
    const auto position = positionFrom(value.toString(), former, m_document.scene()->mesh.origin);
    if (!position)
        return false;
    if (*position != former)
        m_document.editScene(withVertex(*m_document.scene(), vertex, *position));
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

VertexPanel::VertexPanel(Document& document, FaceSelection& selection, QWidget* parent)
    : QWidget(parent), m_document(document), m_model(new VertexTableModel(document, selection, this)),
      m_table(new QTableView), m_hint(new QLabel)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 2, 8, 6);
    column->setSpacing(6);
    auto* head = new QHBoxLayout;
    head->setSpacing(14);
    head->addWidget(new FacePicker(selection));
    m_hint->setObjectName(QStringLiteral("muted"));
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    head->addWidget(m_hint, 1);
    column->addLayout(head);
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
    column->addWidget(m_table, 1);
    retranslate();
}

void VertexPanel::refresh()
{
    m_model->refresh();
    m_table->setRowHidden(VertexTableModel::ViewSpace, m_document.scene()->space == SceneSpace::Clip);
    constexpr int kRoom = 8;         ///< of the header's padding: letters keep their lower ends
    constexpr int kFullHeight = 250; ///< at the usual size of type all rows are in sight
    m_table->verticalHeader()->setMinimumSectionSize(fontMetrics().height() + kRoom);
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRoom);
    const int all = m_table->verticalHeader()->length() + m_table->horizontalHeader()->sizeHint().height() + kRoom;
    m_table->setMinimumHeight(std::min(all, kFullHeight));
    m_hint->setText(isEditable(*m_document.scene())
                        ? tr("Type over the blue numbers, or drag the corners on the canvas. Undo takes it back; the "
                             "scene's file stays as it is.")
                        : tr("Scenes of up to %1 faces can be edited here.").arg(kMostEditableFaces));
    m_hint->setToolTip(m_hint->text());
}

void VertexPanel::retranslate()
{
    refresh();
    m_table->setAccessibleName(tr("The corners of the face in every space"));
}

void VertexPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace rasterlens
