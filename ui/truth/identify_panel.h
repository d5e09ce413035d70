#pragma once
#include "core/questions/identify.h"
#include "ui/base/latest_result.h"
#include "ui/document/document.h"

#include <QWidget>

#include <memory>
#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace rasterlens
{

class PictureStrip;

/// Which mistake is mine? Compares a picture from a file with what the present scene looks like, right and with each
/// mistake, on a background thread; lists the best matches and shows each beside the picture.
class IdentifyPanel : public QWidget
{
    Q_OBJECT

public:
    explicit IdentifyPanel(Document& document, QWidget* parent = nullptr);
    ~IdentifyPanel() override;

    /// Compares a file with the document's scene and settings; mistakes that are on do not count.
    ///
    /// errors  failed()
    void identifyFile(const QString& path);
    /// Stops; what was found before is gone.
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_result.isBusy(); }
    /// Whether the pictures of the chosen match are still drawn.
    [[nodiscard]] bool isBusy() const { return m_result.isBusy() || m_shown.isBusy(); }

    [[nodiscard]] const std::optional<Identification>& found() const { return m_found; }
    /// Shows a match beside the picture.
    void choose(int row);
    [[nodiscard]] PictureStrip& pictures() { return *m_pictures; }
    [[nodiscard]] QTreeWidget& list() { return *m_list; }
    /// The answer in a sentence.
    [[nodiscard]] QString answer() const;
    /// What the answer is to be taken with; empty: as it stands.
    [[nodiscard]] QString remark() const;

    QSize sizeHint() const override { return {440, 420}; }

Q_SIGNALS:
    void fileWanted(); ///< the user is to choose a picture
    void failed(const QString& text);

protected:
    void changeEvent(QEvent* event) override;

private:
    /// What the background thread brings.
    struct Turn {
        int done = 0;
        int total = 1;
        std::optional<Identification> found{};
        std::optional<Reason> problem{}; ///< with the file, in place of an answer
    };
    struct Shown {
        QImage drawn;
        QImage difference;
    };

    void buildControls();
    void start();
    void take(Turn turn);
    void show();
    void fillList();
    void drawChosen();
    void take(const Shown& shown);
    void apply();
    void sync();
    void retranslate();
    /// Whether the document shows another scene than the one compared with, or shows it otherwise.
    [[nodiscard]] bool isOld() const;
    [[nodiscard]] Settings compared() const;

    Document& m_document;
    QString m_file;
    std::shared_ptr<const Scene> m_scene; ///< compared with
    Settings m_settings;                  ///< compared with
    std::optional<Identification> m_found;
    int m_chosen = -1;
    QPushButton* m_open = nullptr;
    QPushButton* m_again = nullptr;
    QPushButton* m_apply = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_answer = nullptr;
    QTreeWidget* m_list = nullptr;
    PictureStrip* m_pictures = nullptr;
    LatestResult<Shown> m_shown;
    LatestResult<Turn> m_result; ///< last: its thread uses the members above
};

} // namespace rasterlens
