#pragma once
#include <QtGlobal>

#include <algorithm>

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

/// How many of `all` random cases this build draws: under the sanitizers, which are ten times slower, a fifth. The
/// kinds of cases stay: what is repeated to meet rarer numbers is repeated less.
constexpr int casesOfBuild(int all) { return RASTERLENS_SANITIZED ? std::max(1, all / 5) : all; }
/// Which rows of a long table this build tests: each, or every fifth.
constexpr std::size_t everyOfBuild() { return RASTERLENS_SANITIZED ? 5 : 1; }

} // namespace rasterlens::test
