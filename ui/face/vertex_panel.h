#pragma once
#include "core/questions/vertex_table.h"
#include "ui/document/document.h"
#include "ui/face/face_picker.h"
#include "ui/face/vertex_editing.h"

#include <QAbstractTableModel>
#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QTableView;

namespace rasterlens
{

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
        VertexColor,
        kRowCount
    };

    VertexTableModel(Document& document, const FaceSelection& selection, const VertexEditing& editing,
                     QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// in  a position, a place on the screen or a colour, as the row shows it
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

    /// Why a text cannot become what a row shows, in the language in use; nothing where it can.
    [[nodiscard]] std::optional<QString> whyRefused(int row, const QString& text) const;

    void refresh();
    /// How the cells are written, for a table that would be too wide else.
    struct Type {
        double delta = 0;           ///< points, added to the usual size
        bool hasBrokenRows = false; ///< numbers of one cell stand in two lines

        friend bool operator==(const Type&, const Type&) = default;
    };
    void setType(const Type& type);
    /// A cell as it is shown in a type.
    [[nodiscard]] static QString shownText(const QString& cell, const Type& type);
    [[nodiscard]] const std::optional<std::array<VertexRow, 3>>& corners() const { return m_corners; }

private:
    [[nodiscard]] QString cell(int row, const VertexRow& corner) const;
    [[nodiscard]] glm::vec3 colorOf(const VertexRow& corner) const;
    /// Whether a row shows the place on the screen of a corner that has none.
    [[nodiscard]] static bool isBehindEye(int row, const VertexRow& corner);
    /// The row that takes positions.
    [[nodiscard]] Row typedRow() const;
    [[nodiscard]] std::shared_ptr<const Scene> withPosition(std::uint32_t vertex, const glm::vec4& position) const;
    /// The scene with what was typed into a row; null where nothing can be made of the text.
    [[nodiscard]] std::shared_ptr<const Scene> edited(int row, std::uint32_t vertex, const QString& text) const;

    Document& m_document;
    std::shared_ptr<const Scene> m_scene; ///< what the table shows; views ask for it until their end
    const FaceSelection& m_selection;
    const VertexEditing& m_editing;
    std::optional<std::array<VertexRow, 3>> m_corners;
    Type m_type;
};

/// Each corner of the selected face in every space.
class VertexPanel : public QWidget
{
    Q_OBJECT

public:
    /// in  editing: what the switches of the panel change; to outlive it
    VertexPanel(Document& document, FaceSelection& selection, VertexEditing& editing, QWidget* parent = nullptr);

    [[nodiscard]] VertexTableModel& model() { return *m_model; }
    [[nodiscard]] QComboBox& typedBox() { return *m_typed; }
    [[nodiscard]] QComboBox& snapBox() { return *m_snap; }
    [[nodiscard]] QCheckBox& togetherBox() { return *m_together; }
    void refresh();
    QSize sizeHint() const override { return {640, 300}; }

Q_SIGNALS:
    void invalidInput(const QString& message);
    void inputMended(); ///< what invalidInput() spoke of

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void connectSwitches();
    void buildTable();
    void fitType();
    [[nodiscard]] int widthOfTable(const VertexTableModel::Type& type) const;
    void fitToRows();
    void syncSwitches();
    [[nodiscard]] QString hint() const;
    void retranslate();

    Document& m_document;
    VertexEditing& m_editing;
    VertexTableModel* m_model;
    QTableView* m_table;
    QComboBox* m_typed;
    QLabel* m_snapName;
    QComboBox* m_snap;
    QCheckBox* m_together;
    QLabel* m_hint;
};

} // namespace rasterlens
