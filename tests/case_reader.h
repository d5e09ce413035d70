#pragma once
// A small reader of `.case` files for tests of the truth.
#include "core/scene.h"
#include "core/truth/exact_reference.h"

#include <QFile>
#include <QFileInfo>
#include <QStringList>

#include <cstdlib>
#include <optional>

namespace rasterlens
{

/// A case as a clip-space scene, or nothing when a line is not understood.
inline std::optional<Scene> readCase(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    Scene scene;
    scene.id = path;
    scene.title = QFileInfo(path).completeBaseName();
    scene.space = SceneSpace::Clip;
    scene.lit = false;
    scene.defaults.culling = Culling::None;
    const auto number = [](const QString& text) { return std::strtof(text.toLatin1().constData(), nullptr); };
    while (!file.atEnd()) {
        const QString line = QString::fromUtf8(file.readLine());
        QStringList words = line.section(QLatin1Char('#'), 0, 0).simplified().split(QLatin1Char(' '));
        const QString key = words.takeFirst();
        if (key.isEmpty())
            continue;
        if (key == QLatin1String("size"))
            scene.defaults.size = {words[0].toInt(), words[1].toInt()};
        else if (key == QLatin1String("subpixel_bits"))
            scene.defaults.subpixelBits = words[0].toInt();
        else if (key == QLatin1String("exact"))
            scene.exact = true;
        else if (key == QLatin1String("window"))
            scene.window = PixelRect{words[0].toInt(), words[1].toInt(), words[2].toInt(), words[3].toInt()};
        else if (key == QLatin1String("ssaa"))
            scene.defaults.samples = static_cast<Samples>(words[0].toInt() - 1);
        else if (key == QLatin1String("zrange"))
            scene.defaults.clipZ = words[0] == QLatin1String("d3d") ? ClipZ::D3d : ClipZ::Gl;
        else if (key == QLatin1String("clear"))
            scene.background = {number(words[0]), number(words[1]), number(words[2])};
        else if (key == QLatin1String("note"))
            scene.note = words.join(QLatin1Char(' '));
        else if (key == QLatin1String("expect"))
            scene.expectations.push_back({words[0], words.mid(1).join(QLatin1Char(' '))});
        else if (key == QLatin1String("tri") && words.size() == 21)
            for (int corner = 0; corner < 3; ++corner) {
                const auto value = [&](int i) { return number(words[7 * corner + i]); };
                MeshVertex vertex;
                vertex.position = {value(0), value(1), value(2), value(3)};
                vertex.color = {value(4), value(5), value(6)};
                scene.mesh.indices.push_back(static_cast<std::uint32_t>(scene.mesh.vertices.size()));
                scene.mesh.vertices.push_back(vertex);
            }
        else if (key == QLatin1String("cull") || key == QLatin1String("depth_test") ||
                 key == QLatin1String("depth_format")) {
            const QString id =
                key == QLatin1String("cull") ? QStringLiteral("culling") : QString(key).replace('_', '-');
            if (setFromText(*findSettingsField(id), words[0], scene.defaults))
                return std::nullopt;
        } else
            return std::nullopt;
    }
    return scene;
}

} // namespace rasterlens
