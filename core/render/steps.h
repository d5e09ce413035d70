#pragma once
#include "core/observe/step_cursor.h"
#include "core/observe/step_log.h"
#include "core/observe/step_record.h"
#include "core/scene/scene.h"

#include <memory>
#include <stop_token>

namespace rasterlens
{

/// The settings that a record of these shows: `tiled` is recorded as edge-equation.
[[nodiscard]] Settings recordedAs(Settings settings);

/// Draws one frame with the very stages of render() and writes down what happens, up to filter.cap events.
///
/// in      settings for which unsupported() is empty
/// out     never null
/// covers  every algorithm; `tiled` is recorded as edge-equation, which draws the same pixels
/// cost    two to three times that of render(); the drawing ends where the cap is reached
/// errors  std::bad_alloc; `stop` ends the work after the present row, and the log then says so
[[nodiscard]] std::shared_ptr<const StepLog> renderSteps(const Scene& scene, const Settings& settings,
                                                         const StepFilter& filter = {}, std::stop_token stop = {});

/// Draws one frame as renderSteps() does and keeps what it takes to make any of its events anew. filter.cap is ignored:
/// the record holds the whole frame.
///
/// in      settings for which unsupported() is empty
/// out     never null
/// cost    two to three times that of render()
/// errors  std::bad_alloc; `stop` ends the work after the present row, and the record then says so
[[nodiscard]] std::shared_ptr<const StepRecord> recordSteps(std::shared_ptr<const Scene> scene,
                                                            const Settings& settings, const StepFilter& filter = {},
                                                            std::stop_token stop = {}, const RecordMemory& memory = {});

/// recordSteps() of as many events of the frame as filter.cap. The record is truncated() if there are more; its
/// positions are those of the whole record.
[[nodiscard]] std::shared_ptr<const StepRecord> recordBeginning(std::shared_ptr<const Scene> scene,
                                                                const Settings& settings, const StepFilter& filter,
                                                                std::stop_token stop = {});

} // namespace rasterlens
