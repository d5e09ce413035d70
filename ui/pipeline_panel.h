#pragma once
#include "core/settings.h"
#include "ui/document.h"
#include "ui/language.h"

#include <QComboBox>
#include <QWidget>

#include <map>
#include <vector>

class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace rasterlens
{

class FieldRow;
class MistakesSection;

/// The scene and every switch of the pipeline, in pipeline order, made from the field table.
class PipelinePanel : public QWidget
{
    Q_OBJECT

public:
    PipelinePanel(Document& document, const Language& language, QWidget* parent = nullptr);

    /// Shows the key that steps a field beside its switch.
    void setKeyHint(const QString& fieldId, const QString& key);
    void scrollTo(Stage stage);
    [[nodiscard]] MistakesSection& mistakes() { return *m_mistakes; }

    /// The switch of a field: a QComboBox, QSpinBox or QCheckBox.
    [[nodiscard]] QWidget* editor(const QString& fieldId) const;
    [[nodiscard]] QComboBox* sceneBox() const { return m_sceneBox; }
    [[nodiscard]] QString sceneNote() const;
    [[nodiscard]] QComboBox* sizeBox() const { return m_sizeBox; }
    /// How many settings differ from what the scene asks for.
    [[nodiscard]] int changedCount() const;

Q_SIGNALS:
    void sceneChosen(const QString& name);
    void openRequested();
    void invalidInput(const QString& message);

protected:
    void changeEvent(QEvent* event) override;

private:
    QVBoxLayout* addGroup(Stage stage);
    void addScene(QVBoxLayout* group);
    void addSize(QVBoxLayout* group);
    void syncScene();
    void syncSettings();
    void applySize();
    void retranslate();

    Document& m_document;
    const Language& m_language;
    QScrollArea* m_scroll = nullptr;
    QLabel* m_heading = nullptr;
    QToolButton* m_reset = nullptr;
    QComboBox* m_sceneBox = nullptr;
    QLabel* m_sceneNote = nullptr;
    QToolButton* m_open = nullptr;
    QComboBox* m_sizeBox = nullptr;
    QLabel* m_sizeLabel = nullptr;
    QWidget* m_sizeDot = nullptr;
    std::map<Stage, QLabel*> m_groupHeadings;
    std::vector<FieldRow*> m_rows;
    MistakesSection* m_mistakes = nullptr;
};

} // namespace rasterlens
