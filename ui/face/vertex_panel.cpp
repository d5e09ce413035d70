#include "ui/face/vertex_panel.h"

#include "core/observe/step_log.h"
#include "core/observe/step_text.h"
#include "ui/base/theme.h"
#include "ui/face/clip_theatre.h"

#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPalette>
#include <QRegularExpression>
#include <QTableView>
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

/// Bits in the order above, below, right, left: the way the figure of the nine regions writes them.
QString regionText(unsigned region)
{
    QString bits;
    for (const unsigned bit : {kRegionAbove, kRegionBelow, kRegionRight, kRegionLeft})
        bits += QLatin1Char((region & bit) != 0 ? '1' : '0');
    return bits;
}

std::optional<glm::vec4> positionFrom(const QString& text, const glm::vec4& former)
{
    static const QRegularExpression between(QStringLiteral("[\\s,;]+"));
    const QStringList parts = text.split(between, Qt::SkipEmptyParts);
    if (parts.size() != 3 && parts.size() != 4)
        return std::nullopt;
    glm::vec4 position = former;
    for (qsizetype i = 0; i < parts.size(); ++i) {
        bool good = false;
        position[static_cast<int>(i)] = QString(parts[i]).replace(QChar(0x2212), QLatin1Char('-')).toFloat(&good);
        if (!good || !std::isfinite(position[static_cast<int>(i)]))
            return std::nullopt;
    }
    return position;
}

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
    case ObjectSpace: return inClipSpace ? tuple({o.x, o.y, o.z, o.w}) : tuple({o.x, o.y, o.z});
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
    case OutsideOf: return corner.outside == 0 ? tr("inside") : clipPlaneSigns(corner.outside);
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
    case ObjectSpace: return m_scene->space == SceneSpace::Clip ? tr("given  x, y, z, w") : tr("object  x, y, z");
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

bool VertexTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || (flags(index) & Qt::ItemIsEditable) == 0)
        return false;
    const std::uint32_t vertex = (*m_corners)[static_cast<std::size_t>(index.column())].meshVertex;
    const glm::vec4 former = m_document.scene()->mesh.vertices[vertex].position;
    const auto position = positionFrom(value.toString(), former);
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
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
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
    constexpr int kRoom = 4;
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
