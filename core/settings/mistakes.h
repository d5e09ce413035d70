#pragma once
#include "core/settings/rules.h"
#include "core/settings/step_kind.h"

#include <span>

namespace rasterlens
{

/// What proves a mistake. Counters are those of Statistics; measures compare a picture with the right one.
enum class Proof {
    CoveredTwice,
    Covered,
    Tested,
    DepthPassed,
    DepthFailed,
    Rejected,
    CulledBack,
    Degenerate,
    Rasterized,
    Holes,        ///< pixels that no face is seen at, though one should be
    Strays,       ///< pixels that a face is seen at, though none should be
    WrongFaces,   ///< pixels at which another face is seen than should be
    WrongPixels,  ///< pixels of another colour
    DepthError,   ///< largest difference of the depth of a pixel at which the right face is seen
    Colors,       ///< different colours in the picture
    MissingLight, ///< brightness that the right picture has more, in white pixels
};

enum class Change { Rises, Falls };

/// A mistake that people make in a rasterizer: a wrong value of a rule. The texts are marked with
/// QT_TRANSLATE_NOOP("Mistake", ...).
struct Mistake {
    const char* id;     ///< stable: command line, sessions
    const char* number; ///< of the course's list; several mistakes may share one
    const char* title;
    const char* symptom;   ///< what one sees
    const char* wrongLine; ///< the wrong line of code, in words
    const char* seed;      ///< why people write it
    const char* scene;     ///< built-in scene that shows it with its default settings
    Proof proof;           ///< what changes in that scene
    Change change;         ///< and how
    void (*apply)(Rules&); ///< makes the mistake
};

/// All mistakes: the course's list by number, then those of other stages.
[[nodiscard]] std::span<const Mistake> mistakes();

/// The mistake of that id, or null.
[[nodiscard]] const Mistake* findMistake(const QString& id);

/// The steps that the wrong line of a mistake is run at.
///
/// in   one of mistakes()
[[nodiscard]] StepKinds stepsOf(const Mistake& mistake);

} // namespace rasterlens
