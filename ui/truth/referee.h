#pragma once
#include "core/truth/judgement.h"
#include "ui/base/latest_task.h"
#include "ui/canvas/pixel_overlay.h"
#include "ui/document/document.h"

#include <QObject>

#include <memory>
#include <optional>

namespace rasterlens
{

/// Holds the picture of the document against the exact reference while it is on: on a background thread, anew with
/// every change, the latest wins.
class Referee : public QObject
{
    Q_OBJECT

public:
    explicit Referee(Document& document, QObject* parent = nullptr);

    void setOn(bool on);
    [[nodiscard]] bool isOn() const { return m_on; }
    [[nodiscard]] bool isChecking() const { return m_asked != m_delivered; }
    /// The verdict on the present picture; null while it is off, checking or does not judge.
    [[nodiscard]] const Judgement* judgement() const { return m_judgement.get(); }
    /// `3 extra, 1 missing of 40,000 samples`, or why there is no verdict; empty while it is off.
    [[nodiscard]] QString text() const;
    /// How far depths and colours are from the truth; empty without a verdict.
    [[nodiscard]] QString detail() const;
    /// The wrong pixel after this one, round and round.
    [[nodiscard]] std::optional<QPoint> nextWrong(std::optional<QPoint> after) const;

Q_SIGNALS:
    void changed(); ///< on or off, checking, verdict

private:
    void check();
    void run(quint64 serial, const Scene& scene, const Settings& settings, const std::stop_token& stop);
    template <class Deliver>
    void post(quint64 serial, Deliver deliver);
    [[nodiscard]] QString whyNot() const;

    Document& m_document;
    bool m_on = false;
    std::shared_ptr<const Judgement> m_judgement;
    QString m_failure;
    int m_percent = 0;
    quint64 m_asked = 0;
    quint64 m_delivered = 0;
    LatestTask m_task; ///< last: its thread uses the members above
};

/// The verdicts in the order in which they are named, and how many pixels are of each.
constexpr PixelVerdict kVerdicts[] = {PixelVerdict::Extra, PixelVerdict::Missing, PixelVerdict::HitTwice,
                                      PixelVerdict::HitLess, PixelVerdict::OtherFace};
[[nodiscard]] std::uint64_t countOf(const CoverageDifference& difference, PixelVerdict verdict);
/// `3 extra`, in the language in use.
[[nodiscard]] QString countText(PixelVerdict verdict, std::uint64_t count);

/// One wrong pixel: colour, hatching, frame and glyph differ with the verdict; a halo makes it glow.
void paintVerdict(QPainter& painter, const QRectF& cell, PixelVerdict verdict, bool thick);
/// Its glyph alone, as a legend shows it.
void paintVerdictSign(QPainter& painter, const QRectF& box, PixelVerdict verdict);

/// Lets the wrong pixels glow, at every zoom.
///
/// cost  linear in the wrong pixels in sight; below 8x in the canvas
class RefereeLayer : public CanvasLayer
{
public:
    explicit RefereeLayer(const Referee& referee) : m_referee(referee) {}

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return false; }

private:
    const Referee& m_referee;
};

} // namespace rasterlens
