#pragma once
#include "core/observe/recorder.h"

#include <utility>

namespace rasterlens
{

/// A stage whose calls a StepRecorder counts, so that the drawing of a triangle can begin and end at any of them.
template <class Stage>
class CountedStage
{
    /// Multi-sampling: samples are only noted, always, and what counts are the pixels that are drawn of them.
    static constexpr bool kDrawsPixels = requires(Stage & stage) { stage.beginSample(0); };

public:
    CountedStage(Stage stage, StepRecorder& recorder) : m_stage(std::move(stage)), m_recorder(&recorder) {}

    void begin(const ScreenTriangle& triangle) { m_stage.begin(triangle); }

    /// A sample, in one of the forms that the stage knows.
    template <class... Sample>
    void operator()(int x, int y, const Sample&... sample)
    {
        if (kDrawsPixels || m_recorder->takeCall())
            m_stage(x, y, sample...);
    }

    void beginSample(int sample) requires kDrawsPixels
    {
        m_recorder->beginPass(sample);
        m_stage.beginSample(sample);
    }

    void finish()
    {
        m_recorder->endTriangle();
        if constexpr (kDrawsPixels)
            m_stage.finish([this](int x, int y) { return m_recorder->takePixel(x, y); });
        else
            m_stage.finish();
    }

    [[nodiscard]] bool skipsLine(int line) { return !kDrawsPixels && m_recorder->skipsLine(line); }
    [[nodiscard]] bool stopped() const { return m_stage.stopped(); }

private:
    Stage m_stage;
    StepRecorder* m_recorder;
};

} // namespace rasterlens
