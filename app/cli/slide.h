#pragma once
#include "app/cli/input.h"
#include "core/lessons/lesson.h"

#include <optional>

namespace rasterlens::cli
{

/// Opens a built-in lesson or a file. Warnings go to stderr.
///
/// errors  throws Failure: the diagnostics of the loader
[[nodiscard]] Lesson openLesson(const QString& name);

/// A slide as a scene to be drawn.
struct SlideInput {
    Input input;                   ///< with the settings of the slide, changed by the command line
    std::optional<StepPlace> step; ///< the place in the record at which the slide stands
};

/// Whether the words ask for a slide: they hold `--lesson`.
[[nodiscard]] bool asksForSlide(const QStringList& words);

/// `--lesson` and `--step`.
[[nodiscard]] QList<Option> slideOptions();

/// Opens the slide that `--lesson NAME --step N` names.
///
/// errors  throws Failure: no such lesson or slide, what is wrong with the lesson's file, a scene that cannot be opened
[[nodiscard]] SlideInput openSlide(const Arguments& arguments);

/// The picture at a place of the record.
///
/// errors  throws Failure where the record does not have the place
[[nodiscard]] QImage pictureAt(const Input& input, const StepPlace& step);

} // namespace rasterlens::cli
