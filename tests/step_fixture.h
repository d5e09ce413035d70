#pragma once
// A main window with the square that its diagonal cuts, and its step mode.
#include "tests/window_fixture.h"
#include "ui/steps/step_mode.h"

namespace rasterlens::test
{

class StepFixture : public WindowFixture
{
protected:
    StepMode& mode() { return m_window->stepMode(); }
    StepSession& session() { return mode().session(); }
    const StepLog& log() { return *session().log(); }

    bool record()
    {
        session().open();
        return settle() && session().log();
    }
    void setAlgorithm(Algorithm algorithm)
    {
        Settings next = settings();
        next.algorithm = algorithm;
        document().setSettings(next);
    }
    void openSquare()
    {
        openWindow();
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    }
};

} // namespace rasterlens::test
