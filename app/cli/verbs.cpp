#include "app/cli/verbs.h"

namespace rasterlens::cli
{
namespace
{

constexpr Verb kVerbs[] = {
    {"render", "draw a scene into a picture, arrays and counters", runRender, renderUsage},
    {"info", "say what a scene is made of", runInfo, infoUsage},
    {"diff", "compare two pictures or arrays", runDiff, diffUsage},
    {"bench", "measure speed against error", runBench, benchUsage},
    {"cases", "draw the hard cases and compare with the exact reference", runCases, casesUsage},
    {"steps", "tell every step of the drawing", runSteps, stepsUsage},
    {"why", "say why a pixel is what it is", runWhy, whyUsage},
    {"derive", "derive a formula with the numbers of a face", runDerive, deriveUsage},
    {"figure", "write a figure with caption, formula and legend", runFigure, figureUsage},
    {"page", "write one HTML file that shows every step", runPage, pageUsage},
    {"identify", "say which mistake made a picture", runIdentify, identifyUsage},
    {"lesson", "list, print and check lessons", runLesson, lessonUsage},
    {"complete", "say how a command line may go on, for shells", runComplete, completeUsage},
};

} // namespace

std::span<const Verb> verbs() { return kVerbs; }

} // namespace rasterlens::cli
