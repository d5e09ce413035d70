#pragma once
#include "core/base/reason.h"
#include "core/scene/scene.h"
#include "core/settings/mistakes.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace rasterlens
{

/// What the samples of a frame have in common. It decides whether ties and depths matter.
struct SampleFacts {
    bool noTies = false; ///< no sample lies exactly on an edge of a face that it is not outside of
    /// No sample is covered twice, and all depths lie between those of near and far: each passes against the cleared
    /// one.
    bool coveredOnce = false;
    bool noEqualDepths = false; ///< no depth is exactly the one that it is compared with
};

/// What the faces of a frame have in common before they are covered. It decides which switches change nothing.
struct FrameFacts {
    /// The w that occur, ascending and each once, at most kMostNamed of them; empty if a face has corners with
    /// different w, or if there is no face.
    std::vector<double> equalW;
    bool equalWEverywhere = false; ///< all corners of a face have one w
    bool noneOutside = false;      ///< no corner of a face lies outside of the view volume, nor at w <= 1e-5
    bool allFront = false;         ///< each face that has an area is a front face
    bool allBack = false;          ///< each face that has an area is a back face
    bool noMask = false;           ///< no material has a mask
    bool noTexture = false;        ///< no material has a texture
    bool hasLines = false;         ///< some faces are lines
    bool noCamera = false;         ///< the scene is given in clip space
    bool orthographic = false;     ///< the camera is

    /// Nothing where they were not asked for, or not known: where no areas are covered by centres, and where floats or
    /// attributes carried along edges may decide otherwise than edge equation.
    std::optional<SampleFacts> samples;

    static constexpr std::size_t kMostNamed = 3;
};

/// What facts are about.
enum class FactsOf { Faces, Samples };

/// The facts of a frame without its mistakes.
///
/// in    settings that can be drawn; FactsOf::Samples for all facts, of faces too
/// cost  the vertex stage and the stages of the faces once; for samples, drawing once without colours
[[nodiscard]] FrameFacts frameFacts(const Scene& scene, const Settings& settings, FactsOf what = FactsOf::Faces,
                                    const std::stop_token& stop = {});

/// Whether whyUnchanged() knows a reason for a field in some scene.
[[nodiscard]] bool canBeUnchanged(const SettingsField& field);
/// The facts that such a reason needs.
[[nodiscard]] FactsOf factsFor(const SettingsField& field);
[[nodiscard]] FactsOf factsFor(const Mistake& mistake);

/// Why two values of a field give the same picture, by the facts of the frame: a text of the context "Diagnostic";
/// nothing where they may differ.
///
/// in  the settings with the one value and with the other
[[nodiscard]] std::optional<Reason> whyUnchanged(const SettingsField& field, const Settings& one, const Settings& other,
                                                 const FrameFacts& facts);

/// Why another light gives the same picture: a text of the context "Diagnostic"; nothing where it may differ.
[[nodiscard]] std::optional<Reason> whyLightUnchanged(const Scene& scene, const Settings& settings);

/// Why a mistake does not change the picture; nothing where it may.
///
/// in  the settings it is made with; whether it is among theirs does not matter
[[nodiscard]] std::optional<Reason> whyUnchanged(const Mistake& mistake, const Settings& settings,
                                                 const FrameFacts& facts);

} // namespace rasterlens
