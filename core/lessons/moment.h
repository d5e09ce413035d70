#pragma once
#include "core/io/json_fields.h"
#include "core/lessons/step_place.h"
#include "core/scene/scene.h"

#include <QDir>
#include <QJsonObject>
#include <QPoint>
#include <QPointF>
#include <QSize>
#include <QStringList>

#include <optional>
#include <span>

namespace rasterlens
{

/// A text in both languages of the program.
struct TwoTexts {
    QString en;
    QString zh;

    friend bool operator==(const TwoTexts&, const TwoTexts&) = default;
};

/// How a moment is compared, and with which other picture of the scene.
struct MomentCompare {
    enum class View { Off, Wipe, Blink, Difference };
    enum class With {
        Right, ///< the moment's settings without its mistakes
        Scene, ///< what the scene asks for, in the moment's size and from its camera
    };

    View view = View::Off;
    With with = With::Right;

    friend bool operator==(const MomentCompare&, const MomentCompare&) = default;
};

/// What the window shows, as a value: lessons are lists of moments, and sessions may keep one.
struct Moment {
    QString scene;                 ///< as loadScene() takes it; a path is absolute or a resource's
    std::optional<QSize> size;     ///< pixels; none: what the scene asks for
    QJsonObject settings;          ///< those that differ from the scene's, mistakes among them; no size, no view
    QJsonObject view;              ///< what differs from the scene's camera
    std::optional<StepPlace> step; ///< none: the finished picture, not the step mode
    std::optional<QPoint> pixel;   ///< the selected one
    std::optional<double> zoom;    ///< canvas pixels for a pixel; none: the whole picture fits
    std::optional<QPointF> centre; ///< the point of the picture in the middle of the canvas, in pixels
    QStringList panels;            ///< ids of panelIds()
    QStringList overlays;          ///< ids of overlayIds(); empty: the usual ones
    MomentCompare compare;
    TwoTexts caption; ///< `{name}` in it stands for a number that the slide expects

    friend bool operator==(const Moment&, const Moment&) = default;
};

/// The panels that a moment may open; `rasterlens --panel` takes these names.
[[nodiscard]] std::span<const char* const> panelIds();

/// What a moment may lay over the picture: `grid`, `samples`, `numbers`, which are the usual ones; `referee`, the marks
/// of the exact reference; and `none`, where nothing else is named.
[[nodiscard]] std::span<const char* const> overlayIds();

/// The keys of a moment in a JSON object.
[[nodiscard]] QStringList momentKeys();

/// Reads the keys of a moment; other keys of the object are not looked at.
///
/// in      `folder`: scenes are named relative to it; `before`: a moment without a scene takes scene, size and view of
///         this one, if there is one; `caption`: whether there must be one
/// errors  into the sink of `fields`, with file and line: values of a wrong type, scenes, settings, mistakes, panels,
///         overlays and steps that do not exist
[[nodiscard]] Moment readMoment(const JsonFields& fields, const QDir& folder, const Moment* before = nullptr,
                                JsonFields::Need caption = JsonFields::Need::Required);

/// A text in which the two numbers of a place, `(3, 4)`, and what stands beside the signs of a formula, `p = -2`, stay
/// on one line: with no-break spaces.
[[nodiscard]] QString unbroken(QString text);

/// Reads `{"en": .., "zh": ..}`, both of which are required, as unbroken() has them.
[[nodiscard]] TwoTexts readTexts(const JsonFields& fields, const QString& key, JsonFields::Need need);

/// What readMoment() reads; keys with nothing to say are left out.
///
/// in  `folder`: the scene is named relative to it
[[nodiscard]] QJsonObject toJson(const Moment& moment, const QDir& folder);

/// What a session keeps of the window besides scene and settings, as a moment without these.
struct SessionViewLoad {
    Moment moment;
    Diagnostics diagnostics; ///< warnings: what is not understood is left out
};
/// in  the values under sessionViewKeys(), and the session's file for messages
[[nodiscard]] SessionViewLoad sessionView(const QJsonObject& view, const QString& file);
/// What sessionView() reads.
[[nodiscard]] QJsonObject toSessionView(const Moment& moment);

/// A moment that can be drawn.
struct OpenMoment {
    Scene scene;
    Settings settings; ///< those of the scene, changed by the moment
    Settings other;    ///< those of the picture that it is compared with
};

struct OpenMomentLoad {
    std::optional<OpenMoment> moment;
    Diagnostics diagnostics; ///< of the scene's loader, and why the settings cannot be drawn
};

/// Loads the scene and puts the moment's settings over those of the scene.
///
/// errors  the scene cannot be loaded, the settings contradict each other or cannot be drawn
[[nodiscard]] OpenMomentLoad openMoment(const Moment& moment);

} // namespace rasterlens
