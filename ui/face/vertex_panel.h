#pragma once
#include "core/questions/vertex_table.h"
#include "ui/document/document.h"
#include "ui/face/face_picker.h"

#include <QAbstractTableModel>
#include <QWidget>

#include <array>
#include <optional>

class QLabel;
class QTableView;

namespace rasterlens
{

/// Scenes of at most so many faces can be edited corner by corner.
constexpr std::size_t kMostEditableFaces = 4;

[[nodiscard]] bool isEditable(const Scene& scene);

/// A copy of the scene with one vertex elsewhere.
[[nodiscard]] std::shared_ptr<const Scene> withVertex(const Scene& scene, std::uint32_t vertex,
                                                      const glm::vec4& position);

/// The corners A, B, C of a face as columns; a row for each space they pass through.
class VertexTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Row {
        ObjectSpace,
        ViewSpace,
        ClipSpace,
        NdcSpace,
        ScreenSpace,
        SnappedSpace,
        DepthValue,
        OutsideOf,
        ScreenRegion,
        kRowCount
    };

    VertexTableModel(Document& document, const FaceSelection& selection, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// in  three numbers, or four, with blanks or commas between them
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

    /// Why a text cannot become a position, in the language in use; nothing where it can.
    [[nodiscard]] std::optional<QString> whyRefused(const QString& text) const;

    void refresh();
    [[nodiscard]] const std::optional<std::array<VertexRow, 3>>& corners() const { return m_corners; }

private:
    [[nodiscard]] QString cell(int row, const VertexRow& corner) const;

    Document& m_document;
    std::shared_ptr<const Scene> m_scene; ///< what the table shows; views ask for it until their end
    const FaceSelection& m_selection;
    std::optional<std::array<VertexRow, 3>> m_corners;
};

/// Each corner of the selected face in every space.
class VertexPanel : public QWidget
{
    Q_OBJECT

public:
    VertexPanel(Document& document, FaceSelection& selection, QWidget* parent = nullptr);

    [[nodiscard]] VertexTableModel& model() { return *m_model; }
    void refresh();
    QSize sizeHint() const override { return {640, 250}; }

Q_SIGNALS:
    void invalidInput(const QString& message);
    void inputMended(); ///< what invalidInput() spoke of

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    Document& m_document;
    VertexTableModel* m_model;
    QTableView* m_table;
    QLabel* m_hint;
};

} // namespace rasterlens
