#pragma once
#include "core/settings/settings.h"
#include "ui/document/render_worker.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace rasterlens
{

class StageChip;

/// The pipeline as a row of chips, with a live figure under each name. A click asks for that stage's switches.
class StageStrip : public QWidget
{
    Q_OBJECT

public:
    explicit StageStrip(QWidget* parent = nullptr);

    void setScene(const Scene& scene);
    void setSettings(const Settings& settings);
    void setFrame(const FramePtr& frame);
    /// The stage the present step belongs to; none outside the step mode.
    void setCurrent(std::optional<Stage> stage);
    [[nodiscard]] std::optional<Stage> current() const { return m_current; }

    /// Names alone, in a thin row: the picture below has the room.
    void setBrief(bool brief);

    /// The figure shown under a stage; a dash where nothing is counted yet.
    [[nodiscard]] QString figure(Stage stage) const;
    /// The figure as there is room for it.
    [[nodiscard]] QString shown(Stage stage) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    [[nodiscard]] int heightForWidth(int width) const override;

Q_SIGNALS:
    void stageClicked(rasterlens::Stage stage);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] static int chipsInARow(int width);
    [[nodiscard]] QString shortFigure(Stage stage) const;
    void updateTexts();

    std::vector<StageChip*> m_chips;
    std::size_t m_faceCount = 0;
    Settings m_settings;
    std::optional<Statistics> m_counted;
    std::optional<Stage> m_current;
    bool m_textsAreOld = false; ///< something changed while the strip could not be seen
};

/// The name of a stage in the language in use.
[[nodiscard]] QString stageTitle(Stage stage);

} // namespace rasterlens

Q_DECLARE_METATYPE(rasterlens::Stage)
