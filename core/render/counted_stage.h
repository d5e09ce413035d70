#pragma once
#include "core/observe/recorder.h"

#include <utility>

namespace rasterlens
{

/// A stage whose calls a StepRecorder counts, so that the drawing of a triangle can begin and end at any of them.
template <class Stage>
class CountedStage
{
public:
    CountedStage(Stage stage, StepRecorder& recorder) : m_stage(std::move(stage)), m_recorder(&recorder) {}

    void begin(const ScreenTriangle& triangle) { m_stage.begin(triangle); }

    /// A sample, in one of the forms that the stage knows.
    template <class... Sample>
    void operator()(int x, int y, const Sample&... sample)
    {
        if (m_recorder->takeCall())
            m_stage(x, y, sample...);
    }

    void finish()
    {
        m_recorder->endTriangle();
        m_stage.finish();
    }

    [[nodiscard]] bool skipsLine(int line) { return m_recorder->skipsLine(line); }
    [[nodiscard]] bool stopped() const { return m_stage.stopped(); }

private:
    Stage m_stage;
    StepRecorder* m_recorder;
};

} // namespace rasterlens
