#pragma once
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <QImage>
#include <QStringList>

#include <map>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace rasterlens
{

/// How the program works that a picture is drawn as.
enum class Program {
    Own, ///< as the settings say
    /// In double precision, without cutting at the borders of the screen, and without culling where culling changes
    /// nothing in the right picture: as first programs do.
    Doubles,
};

/// The pictures of one scene with one size: with mistakes and without, and drawn by programs that round otherwise.
///
/// cost  a picture is drawn once and then kept, as long as all of them have room in 256 MB
class SceneDrawings
{
public:
    /// in  settings for which unsupported() is empty; mistakes among them are not looked at
    SceneDrawings(const Scene& scene, Settings settings, std::stop_token stop);

    /// What these mistakes draw; a null image where they cannot be drawn.
    [[nodiscard]] QImage of(const QStringList& mistakes, Program program = Program::Own);

    /// The right picture as different programs draw it, each picture once. The first is that of the settings.
    [[nodiscard]] const std::vector<QImage>& rights();

    /// What these mistakes draw moved by a hundredth of a pixel in four directions: a pixel that looks otherwise there
    /// has its centre so close to an edge that rounding decides whose it is. A null image where they cannot be drawn.
    [[nodiscard]] std::vector<QImage> nudged(const QStringList& mistakes) const;

    /// Without mistakes.
    [[nodiscard]] const Settings& settings() const { return m_settings; }
    [[nodiscard]] const Scene& scene() const { return m_scene; }

private:
    [[nodiscard]] QImage drawn(const Scene& scene, const Settings& settings) const;
    [[nodiscard]] const Settings& doubles();

    const Scene& m_scene;
    Settings m_settings;
    std::optional<Settings> m_doubles; ///< of Program::Doubles
    std::stop_token m_stop;
    std::map<std::pair<QStringList, Program>, QImage> m_kept;
    std::vector<QImage> m_rights;
};

} // namespace rasterlens
