#pragma once
#include "core/derive/derive.h"
#include "core/scenes/builtin_scenes.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace rasterlens::test
{

inline Scene builtin(const char* name) { return *makeBuiltinScene(QLatin1String(name)).scene; }

/// A derivation that must be there.
inline Derivation derived(DerivationTopic topic, const Scene& scene, const Settings& settings,
                          const DerivationPlace& place)
{
    Derived found = derive(topic, scene, settings, place);
    if (!found.derivation)
        throw std::runtime_error(textOf(found.refusal).toStdString());
    return *found.derivation;
}

inline double valueOf(const Derivation& derivation, const char* id)
{
    const DerivationSymbol* symbol = derivation.find(id);
    if (symbol == nullptr)
        throw std::runtime_error(std::string("no symbol ") + id);
    return symbol->value;
}

inline bool isNear(double value, double expected, double slack)
{
    if (!(std::abs(value - expected) <= slack))
        qWarning("%.17g is not %.17g", value, expected);
    return std::abs(value - expected) <= slack;
}

struct Question {
    DerivationTopic topic;
    DerivationPlace place;
};

/// Calls check(scene, settings, question) for the scenes of the list, for each topic and some faces, for the first face
/// all edges; scenes with a camera also for an orthographic one with a headlight.
template <class Check>
void forEachQuestion(Check&& check)
{
    for (const char* name :
         {"triangle-600", "square-diagonal", "games101", "tile-square", "behind-camera", "covering", "edge-guardband",
          "cube", "painter-cycle", "piercing", "four-z", "lines", "tunnel", "fan"}) {
        const Scene scene = builtin(name);
        Settings settings = scene.defaults;
        settings.size = settings.size.boundedTo(QSize(160, 160));
        const std::size_t faces = std::min<std::size_t>(scene.mesh.faceCount(), 3);
        const auto askAll = [&] {
            for (const DerivationTopicInfo& info : derivationTopics())
                for (std::uint32_t face = 0; face < faces; ++face)
                    for (int edge = 0; edge < (face == 0 ? 3 : 1); ++edge)
                        check(scene, settings, Question{info.topic, {face, {}, edge, 0.25, {}}});
        };
        askAll();
        if (scene.space == SceneSpace::Clip)
            continue;
        settings.projection = Projection::Orthographic;
        settings.light.towards.reset();
        askAll();
    }
}

} // namespace rasterlens::test
