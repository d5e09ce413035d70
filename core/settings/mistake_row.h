#pragma once
#include "core/settings/rules.h"
#include "core/settings/step_kind.h"

#include <QCoreApplication>

#include <span>

namespace rasterlens
{

enum class Proof;  // mistakes.h
enum class Change; // mistakes.h

/// A mistake, and the steps it shows at: what the tables are written in.
struct MistakeRow {
    const char* id;
    const char* number;
    const char* title;
    const char* symptom;
    const char* wrongLine;
    const char* seed;
    const char* scene;
    Proof proof;
    Change change;
    StepKinds steps;
    void (*apply)(Rules&);
};

/// A set of steps, for a row of a table.
[[nodiscard]] constexpr StepKinds at(auto... kinds) { return (kindBit(kinds) | ...); }

// Tables by the stage where the wrong line stands; mistakes.cpp has those of the course's list.
[[nodiscard]] std::span<const MistakeRow> cameraMistakes();   ///< camera, clipping
[[nodiscard]] std::span<const MistakeRow> coverageMistakes(); ///< which samples
[[nodiscard]] std::span<const MistakeRow> textureMistakes();  ///< texels, light, depth

} // namespace rasterlens
