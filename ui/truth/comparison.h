#pragma once
#include "core/truth/difference.h"
#include "ui/base/latest_result.h"
#include "ui/document/document.h"
#include "ui/document/render_worker.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rasterlens
{

/// What picture A is; picture B is the present one.
enum class CompareWith {
    Right,  ///< the present settings without their mistakes
    Scene,  ///< what the scene asks for
    Pinned, ///< settings that were kept
};

enum class CompareView { Off, Wipe, Blink, Difference };

/// The colours of one pixel in both pictures.
struct ComparedPixel {
    QRgb a;
    QRgb b;
};

/// Compares the present picture with that of other settings of the same scene, seen from the same place: A is drawn on
/// a background thread whenever the present picture is a new one, the latest wins.
///
/// order   what is shown is always a pair that belongs together; until the next pair is there, the former stays
class Comparison : public QObject
{
    Q_OBJECT

public:
    explicit Comparison(Document& document, QObject* parent = nullptr);

    void setView(CompareView view);
    [[nodiscard]] CompareView view() const { return m_view; }
    void setWith(CompareWith with);
    [[nodiscard]] CompareWith with() const { return m_with; }
    /// Keeps the present settings as A.
    void pin();
    [[nodiscard]] bool hasPinned() const { return m_pinned.has_value(); }
    /// A becomes the present settings, the present settings become A.
    void swap();
    /// in   1..kMostAmplification: by how much differences are multiplied before they are coloured
    void setAmplification(int factor);
    [[nodiscard]] int amplification() const { return m_amplification; }
    static constexpr int kMostAmplification = 128;

    /// The settings of A for these settings of B: size and view are always those of B.
    [[nodiscard]] Settings other(const Settings& present) const;

    /// A finished picture of the document.
    void takeFrame(const FramePtr& present);
    /// What is to be shown in its place; null: nothing.
    [[nodiscard]] FramePtr frame() const;
    /// Picture A where the left of the canvas is to show it; null otherwise.
    [[nodiscard]] FramePtr wiped() const;
    /// `A` or `B` where the canvas shows only one of them; empty otherwise.
    [[nodiscard]] QString tag() const;
    [[nodiscard]] bool isBusy() const { return m_result.isBusy(); }

    [[nodiscard]] const std::optional<Difference>& difference() const { return m_difference; }
    /// Whether it matters how far apart two colours are; in a picture of faces, counts or directions they are codes.
    [[nodiscard]] bool hasAmounts() const;
    /// `1,234 of 40,000 pixels differ ..`, or why there is nothing to compare.
    [[nodiscard]] QString text() const;
    /// Nothing while there is no pair of pictures.
    [[nodiscard]] std::optional<ComparedPixel> at(QPoint pixel) const;

    /// One setting in which A and B differ, in the language in use.
    struct SettingsDifference {
        QString title;
        QString a;
        QString b;
    };
    [[nodiscard]] std::vector<SettingsDifference> settingsDifferences() const;

Q_SIGNALS:
    void changed();      ///< anything but the picture to be shown
    void frameChanged(); ///< another picture is to be shown

private:
    struct Pair {
        FramePtr a;
        FramePtr b;
        FramePtr heat; ///< only for CompareView::Difference
        int amplification = 1;
        Difference difference;
    };

    void compare();
    void drop();
    [[nodiscard]] Pair draw(Pair pair, const Settings& other, bool withHeat, const std::stop_token& stop);
    void take(const Pair& pair);
    void refuse(std::function<QString()> why);
    [[nodiscard]] bool mustInterrupt(const Settings& other) const;

    Document& m_document;
    CompareView m_view = CompareView::Off;
    CompareWith m_with = CompareWith::Scene;
    std::optional<Settings> m_pinned;
    int m_amplification = 1;

    FramePtr m_present;
    Pair m_pair; ///< a is null: none
    std::optional<Difference> m_difference;
    std::function<QString()> m_refusal; ///< why there is no A, in the language in use
    Settings m_askedFor;                ///< of A
    QTimer m_blink;
    bool m_showsA = false;
    std::shared_ptr<TiledContext> m_context; ///< of the background thread
    LatestResult<Pair> m_result;             ///< last: its thread uses the members above
};

} // namespace rasterlens
