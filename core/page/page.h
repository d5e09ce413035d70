#pragma once
#include "core/lessons/lesson.h"
#include "core/observe/step_log.h"
#include "core/page/page_words.h"
#include "core/scene/scene.h"

#include <QByteArray>
#include <QPoint>

#include <optional>

namespace rasterlens
{

/// Most steps of a scene that a page holds unless another number is asked for: some four megabytes.
constexpr std::size_t kUsualPageSteps = 10'000;
/// Most steps of the scene of a page with a lesson, which has runs of its slides beside it: less than two megabytes.
constexpr std::size_t kUsualLessonPageSteps = 2'000;

/// What a page is made of.
struct PageRequest {
    const Scene& scene;
    Settings settings;                ///< for which unsupported() is empty
    StepFilter filter;                ///< with the largest number of steps
    const Lesson* lesson = nullptr;   ///< null: none
    std::optional<std::size_t> start; ///< the position of the scene's run that is shown first; nothing: its beginning
    std::optional<QPoint> pixel;      ///< the pixel that is chosen first
};

struct PageResult {
    QByteArray html;         ///< empty where diagnostics hold an error
    Diagnostics diagnostics; ///< slides that cannot be drawn
};

/// Makes a page that shows a run step by step: one HTML file with everything in it.
///
/// in      `words`: what is said of steps and pixels; both languages are asked for
/// out     UTF-8; the events are the objects of stepJson() for the log of renderSteps(scene, settings, filter)
/// covers  a slide whose run has more steps than kMostSlideSteps gets its picture and its one step
/// cost    that of drawing each run; cards of pixels as long as kMostCardWork allows
/// errors  in the diagnostics, with file and line: a slide that cannot be drawn, a step that its run does not have, a
///         question without an answer
[[nodiscard]] PageResult makePage(const PageRequest& request, PageWords& words);

/// JSON that can stand in a <script> element whatever its texts are: with `<` and the line ends of JavaScript escaped.
[[nodiscard]] QByteArray embeddable(const QJsonObject& object);

} // namespace rasterlens
