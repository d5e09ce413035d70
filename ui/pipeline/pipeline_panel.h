#pragma once
#include "core/settings/settings.h"
#include "ui/base/language.h"
#include "ui/base/typed_field.h"
#include "ui/document/document.h"

#include <QComboBox>
#include <QWidget>

#include <array>
#include <map>
#include <optional>
#include <vector>

class QLabel;
class QMenu;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace rasterlens
{

class FieldRow;
class LightFields;
class MistakesSection;
class NumberDial;
class NumbersRow;
struct NumbersField;
class PlaneFields;
class UnchangedNotes;

/// Built-in scenes in which float32 edge functions, stepped, cover other samples than they should.
constexpr std::array<QLatin1String, 5> kFloatFailures{QLatin1String("slivers"), QLatin1String("edge-guardband"),
                                                      QLatin1String("tile-square"), QLatin1String("cube"),
                                                      QLatin1String("two-windings")};

/// The scene and every switch of the pipeline, in pipeline order, made from the field table.
class PipelinePanel : public QWidget
{
    Q_OBJECT

public:
    PipelinePanel(Document& document, const Language& language, QWidget* parent = nullptr);

    /// Shows the key that steps a field beside its switch.
    void setKeyHint(const QString& fieldId, const QString& key);
    void scrollTo(Stage stage);
    [[nodiscard]] NumberDial& numberDial() { return *m_dial; }
    [[nodiscard]] MistakesSection& mistakes() { return *m_mistakes; }

    /// The switch of a field: a QComboBox, QSpinBox or QCheckBox.
    [[nodiscard]] QWidget* editor(const QString& fieldId) const;
    [[nodiscard]] QComboBox* sceneBox() const { return m_sceneBox; }
    [[nodiscard]] QComboBox* sizeBox() const { return m_sizeBox; }
    [[nodiscard]] PlaneFields& planes() { return *m_planes; }
    [[nodiscard]] LightFields& light() { return *m_light; }
    /// What is said about a field's value below its switch; empty where there is nothing to say.
    [[nodiscard]] QString note(const QString& fieldId) const;
    /// A switch that was turned by its key comes in sight, with what is said about its value.
    void bringInSight(const QString& fieldId);
    /// Whether something that is said about a value is still being computed.
    [[nodiscard]] bool isBusy() const;
    /// How many settings differ from what the scene asks for.
    [[nodiscard]] int changedCount() const;

Q_SIGNALS:
    void sceneChosen(const QString& name);
    void openRequested();
    void invalidInput(const QString& message);
    void inputMended(); ///< what invalidInput() spoke of
    /// Something that the panel says is not known, for want of memory or threads.
    void failed(const QString& message);
    /// A built-in scene that float32 decides wrongly is to be shown.
    void floatFailureChosen(const QString& name);

protected:
    void changeEvent(QEvent* event) override;

private:
    QVBoxLayout* buildHead();
    QWidget* buildSwitches();
    QVBoxLayout* addGroup(Stage stage);
    FieldRow* addRow(const SettingsField& field);
    NumbersRow* addRow(const NumbersField& field);
    void addScene(QVBoxLayout* group);
    void addSize(QVBoxLayout* group);
    void addNumberDial(QVBoxLayout* group);
    void addPlanes(QVBoxLayout* group);
    void addLight(QVBoxLayout* group);
    void fillFailureMenu();
    void syncScene();
    void showNote();
    void syncSettings();
    void keepInSight();
    std::optional<QString> readSize(const QString& text, TypedField::Attempt attempt);
    void retranslate();

    Document& m_document;
    const Language& m_language;
    QScrollArea* m_scroll = nullptr;
    FieldRow* m_inSight = nullptr; ///< stays in sight when its note comes
    QLabel* m_heading = nullptr;
    QToolButton* m_reset = nullptr;
    QComboBox* m_sceneBox = nullptr;
    QLabel* m_sceneNote = nullptr;
    QString m_note; ///< of the scene, in the language in use
    QToolButton* m_open = nullptr;
    QComboBox* m_sizeBox = nullptr;
    TypedField* m_sizeField = nullptr;
    QLabel* m_sizeLabel = nullptr;
    QWidget* m_sizeDot = nullptr;
    std::map<Stage, QLabel*> m_groupHeadings;
    std::vector<FieldRow*> m_rows;
    std::vector<NumbersRow*> m_numbers;
    NumberDial* m_dial = nullptr;
    PlaneFields* m_planes = nullptr;
    LightFields* m_light = nullptr;
    UnchangedNotes* m_notes = nullptr;
    QToolButton* m_floatFailures = nullptr;
    QMenu* m_failureMenu = nullptr;
    MistakesSection* m_mistakes = nullptr;
};

} // namespace rasterlens
