#pragma once
#include "core/scene/scene.h"
#include "core/settings/mistakes.h"
#include "ui/base/latest_task.h"

#include <QWidget>

#include <memory>
#include <vector>

namespace rasterlens
{

/// The name of what proves a mistake, translated: `hit twice`.
[[nodiscard]] QString proofTitle(Proof proof);

/// Over the canvas while a mistake is on: which one, and the number that proves it.
class MistakeBadge : public QWidget
{
    Q_OBJECT

public:
    explicit MistakeBadge(QWidget* canvas);

    /// Shows the mistakes at once and their proofs when they are counted, on a background thread.
    ///
    /// in  settings for which unsupported() is empty
    void showFor(const std::shared_ptr<const Scene>& scene, const Settings& settings);
    /// One line a mistake.
    [[nodiscard]] QStringList lines() const;
    [[nodiscard]] bool isCounting() const { return m_counting; }

Q_SIGNALS:
    void counted();
    void clicked();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Evidence {
        const Mistake* mistake;
        bool known = false;
        double shown = 0;
        double right = 0;
    };

    static void weigh(const Scene& scene, const Settings& settings, std::vector<Evidence>& evidence);
    void fitToText();

    std::vector<Evidence> m_evidence;
    quint64 m_serial = 0;
    bool m_counting = false;
    LatestTask m_task; ///< last: its thread uses the members above
};

} // namespace rasterlens
