#pragma once
#include "core/truth/judgement.h"
#include "ui/base/latest_result.h"
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
    [[nodiscard]] bool isChecking() const { return m_result.isBusy(); }
    /// Where the truth is to start: from clip space, or from object space, which judges the vertex stage as well.
    void setSpace(ReferenceSpace space);
    /// The space in use: scenes without a camera are judged from clip space.
    [[nodiscard]] ReferenceSpace space() const;
    /// Whether the scene leaves a choice.
    [[nodiscard]] bool hasSpaces() const;
    /// The verdict on the present picture; null while it is off, checking or does not judge.
    [[nodiscard]] const Judgement* judgement() const { return m_judgement.get(); }
    /// `3 extra, 1 missing of 40,000 samples`, or why there is no verdict; empty while it is off.
    [[nodiscard]] QString text() const;
    /// How far depths and colours are from the truth; empty without a verdict.
    [[nodiscard]] QString detail() const;
    /// The wrong pixel after this one, round and round.
    [[nodiscard]] std::optional<QPoint> nextWrong(std::optional<QPoint> after) const;

Q_SIGNALS:
    void changed(); ///< on or off, checking, verdict, space

private:
    /// How far a check is, or what it found.
    struct Check {
        int percent = 0;
        std::shared_ptr<const Judgement> judgement; ///< null before the end
    };
    using Turn = LatestResult<Check>::Turn;

    void check();
    [[nodiscard]] static Check run(const Scene& scene, const Settings& settings, ReferenceSpace space,
                                   const Turn& turn);
    [[nodiscard]] QString whyNot() const;

    Document& m_document;
    bool m_on = false;
    ReferenceSpace m_space = ReferenceSpace::Clip; ///< asked for
    std::shared_ptr<const Judgement> m_judgement;
    std::optional<Lack> m_lack; ///< for which there is no verdict
    int m_percent = 0;
    LatestResult<Check> m_result; ///< last: its thread uses the members above
};

/// The verdicts in the order in which they are named, and how many pixels are of each.
constexpr PixelVerdict kVerdicts[] = {PixelVerdict::Extra, PixelVerdict::Missing, PixelVerdict::HitTwice,
                                      PixelVerdict::HitLess, PixelVerdict::OtherFace};
[[nodiscard]] std::uint64_t countOf(const CoverageDifference& difference, PixelVerdict verdict);
/// `3 extra`, in the language in use.
[[nodiscard]] QString countText(PixelVerdict verdict, std::uint64_t count);

/// The colour of a verdict, in which its glyph stands on kCanvasInk.
[[nodiscard]] QRgb verdictColor(PixelVerdict verdict);
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
