#pragma once
#include "core/lessons/moment.h"
#include "ui/document/document.h"

#include <QObject>

#include <functional>
#include <optional>

namespace rasterlens
{

class ActionTable;
class Cards;
class PipelinePanel;
class StepMode;
class TruthMode;
class ViewportWidget;

/// What the window shows, as one value: a moment is read from its parts, and shown by them. Nothing else in the window
/// knows all of them.
class WindowMoment : public QObject
{
    Q_OBJECT

public:
    struct Parts {
        Document& document;
        ViewportWidget& viewport;
        StepMode& steps;
        TruthMode& truth;
        Cards& cards;
        PipelinePanel& pipeline;
        const ActionTable& actions;
        std::function<bool()> isSettled;   ///< of the window: the picture is there, and the record
        std::function<bool()> hasFewDocks; ///< the pixel card is open only while it is asked for
        std::function<bool()> hasRoom;     ///< for panels: they would leave the canvas too little of a small stage
    };

    explicit WindowMoment(Parts parts, QObject* parent = nullptr);

    /// Opens the scene of a moment as one undo step, and then shows all the rest of it.
    ///
    /// order  shown() or refused() follows; the latest moment wins
    void show(const Moment& moment, Document::GivingUp former);
    /// Shows what a moment says besides scene, size, settings and camera, which are there already.
    void showView(const Moment& moment);
    /// What the window shows now. Its scene has the vertices of the file: those that were moved belong to the session.
    [[nodiscard]] Moment present() const;
    /// Whether a moment is still being shown.
    [[nodiscard]] bool isPending() const { return m_wanted.has_value(); }
    /// Whether anything that counts was changed since the last moment was shown.
    [[nodiscard]] bool isChanged() const;
    /// Does what needs the picture; the window calls it whenever it has settled.
    void finish();

Q_SIGNALS:
    void shown();
    void refused(); ///< what was shown stays
    void changed(); ///< perhaps: isChanged()

private:
    void begin(const Moment& moment);
    void showPanels(const Moment& moment);
    void showOverlays(const Moment& moment);
    void showPlace(const Moment& moment);
    [[nodiscard]] QStringList presentPanels() const;
    [[nodiscard]] QStringList presentOverlays() const;

    /// What isChanged() compares.
    struct Mark {
        std::shared_ptr<const Scene> scene;
        Settings settings;
        std::optional<std::size_t> step;
        int compareView = 0;

        friend bool operator==(const Mark&, const Mark&) = default;
    };
    [[nodiscard]] Mark mark() const;

    Parts m_parts;
    std::optional<Moment> m_wanted;
    bool m_isOpen = false;  ///< the scene of the wanted moment is open
    bool m_isSlide = false; ///< the wanted moment is a lesson's, not what the user had before
    Mark m_mark;
};

} // namespace rasterlens
