#pragma once
#include "core/base/reason.h"
#include "core/settings/mistakes.h"
#include "ui/base/latest_result.h"
#include "ui/document/render_worker.h"

#include <QWidget>

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
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

    /// Shows the mistakes at once and their proofs when they are known: on a background thread this picture is held
    /// against the right one. The last two right ones are kept: while a mistake is switched on and off, or a setting to
    /// and fro, each is drawn once.
    ///
    /// in  a counted frame, also one without mistakes
    void showFor(const FramePtr& frame);
    /// While another picture than the finished one is on the canvas the badge says that it speaks of that.
    void setSaysMoment(bool on);
    /// Hides what would answer a question: which mistake it is.
    void setConcealed(bool on);
    /// One line a mistake, and one more for a mistake that changes nothing.
    [[nodiscard]] QStringList lines() const;
    [[nodiscard]] bool isCounting() const { return m_result.isBusy(); }
    /// How many right pictures have been drawn, finished or not.
    [[nodiscard]] std::uint64_t rightPicturesDrawn() const { return m_drawn; }

Q_SIGNALS:
    void counted();
    void clicked();
    void placed(const QRect& place); ///< on the canvas; empty while it is hidden
    /// The numbers are not known, for want of memory or threads.
    void failed(const QString& message);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Evidence {
        const Mistake* mistake;
        bool known = false;
        double shown = 0;
        double right = 0;
        std::optional<Reason> unchanged{}; ///< why the picture is the right one all the same
    };
    /// A picture without mistakes, which those with mistakes are held against.
    struct Right {
        std::shared_ptr<const Scene> scene;
        Settings settings;
        Outputs has;
        std::shared_ptr<const CountedPicture> picture; ///< null: not drawn yet, or these settings cannot be drawn
    };
    struct Weighed {
        std::vector<Evidence> evidence;
        Right right;
    };

    [[nodiscard]] Right rightFor(const RenderedFrame& shown) const;
    [[nodiscard]] Weighed weigh(const RenderedFrame& shown, Weighed known, const std::stop_token& stop);
    void keep(Right right);
    [[nodiscard]] int room() const;
    void fitToText();

    std::vector<Evidence> m_evidence;
    std::vector<Right> m_kept; ///< the latest last; of one scene, with their pictures
    bool m_saysMoment = false;
    bool m_isConcealed = false;
    std::atomic<std::uint64_t> m_drawn = 0;
    LatestResult<Weighed> m_result; ///< last: its thread uses the members above
};

} // namespace rasterlens
