#pragma once
#include "core/settings/mistakes.h"
#include "ui/base/latest_result.h"
#include "ui/document/render_worker.h"

#include <QWidget>

#include <stop_token>
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

    /// Shows the mistakes at once and their proofs when they are known: on a background thread the right picture is
    /// counted and held against this one.
    ///
    /// in  a counted frame
    void showFor(const FramePtr& frame);
    /// While another picture than the finished one is on the canvas the badge says that it speaks of that.
    void setSaysMoment(bool on);
    /// One line a mistake.
    [[nodiscard]] QStringList lines() const;
    [[nodiscard]] bool isCounting() const { return m_result.isBusy(); }

Q_SIGNALS:
    void counted();
    void clicked();
    /// The numbers are not known, for want of memory or threads.
    void failed(const QString& message);

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

    static void weigh(const RenderedFrame& shown, std::vector<Evidence>& evidence, const std::stop_token& stop);
    void fitToText();

    std::vector<Evidence> m_evidence;
    bool m_saysMoment = false;
    LatestResult<std::vector<Evidence>> m_result; ///< last: its thread uses the members above
};

} // namespace rasterlens
