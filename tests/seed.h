#pragma once
#include <QtGlobal>

namespace rasterlens::test
{

/// RASTERLENS_SEED, 1 if there is none: a run can be repeated, and another one tried. Prints it.
inline unsigned seedOfRun()
{
    bool given = false;
    const int value = qEnvironmentVariableIntValue("RASTERLENS_SEED", &given);
    const unsigned seed = given ? static_cast<unsigned>(value) : 1U;
    qInfo("RASTERLENS_SEED=%u", seed);
    return seed;
}

} // namespace rasterlens::test
