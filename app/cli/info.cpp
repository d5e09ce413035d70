#include "app/cli/input.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/verbs.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace rasterlens::cli
{
namespace
{

Usage usage()
{
    const Option json{QStringLiteral("--json"), Option::Kind::Switch, {}, QStringLiteral("Print one JSON object.")};
    return {
        QStringLiteral("info"),
        QStringLiteral("rasterlens-cli info SCENE [options]"),
        QStringLiteral("Says what SCENE is made of: sizes, bounds and the remarks of the loader.\n\n") + sceneHelp(),
        {QStringLiteral("SCENE")},
        {{QStringLiteral("Options:"), QList<Option>{json} + inputOptions()}},
        QStringLiteral("A mesh is closed when each of its edges belongs to as many faces that run one way along it as "
                       "faces that run the other way; only then does back-face culling change nothing. Warnings go to "
                       "stderr.\n\n"
                       "Exit codes: 0 fine; 2 bad arguments; 3 input that cannot be read.")};
}

struct Box {
    glm::dvec3 min{0, 0, 0};
    glm::dvec3 max{0, 0, 0};
};

bool isFinite(const glm::vec4& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// The bounding box of the finite positions.
Box boundingBox(const Mesh& mesh)
{
    Box box;
    bool empty = true;
    for (const MeshVertex& vertex : mesh.vertices) {
        if (!isFinite(vertex.position))
            continue;
        const glm::dvec3 p(vertex.position);
        box.min = empty ? p : glm::min(box.min, p);
        box.max = empty ? p : glm::max(box.max, p);
        empty = false;
    }
    return box;
}

/// Gives vertices of equal position one number, whatever their other attributes are.
std::vector<std::uint32_t> weldPositions(const Mesh& mesh)
{
    const auto position = [&](std::uint32_t i) {
        const glm::vec4 p = mesh.vertices[i].position;
        return std::array{p.x, p.y, p.z, p.w};
    };
    std::vector<std::uint32_t> order(mesh.vertices.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::erase_if(order, [&](std::uint32_t i) { return !isFinite(mesh.vertices[i].position); });
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return position(a) < position(b); });
    std::vector<std::uint32_t> welded(mesh.vertices.size());
    for (std::uint32_t i = 0; i < welded.size(); ++i)
        welded[i] = i;
    for (std::size_t i = 1; i < order.size(); ++i)
        if (position(order[i]) == position(order[i - 1]))
            welded[order[i]] = welded[order[i - 1]];
    return welded;
}

/// Sides of faces for which no face runs the other way along the same edge.
std::size_t openSides(const Mesh& mesh)
{
    using Side = std::pair<std::uint32_t, std::uint32_t>;
    const std::vector<std::uint32_t> welded = weldPositions(mesh);
    std::vector<Side> forward;
    std::vector<Side> backward;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const Side side{welded[mesh.indices[i]], welded[mesh.indices[next]]};
        if (side.first == side.second)
            continue;
        (side.first < side.second ? forward : backward)
            .emplace_back(std::min(side.first, side.second), std::max(side.first, side.second));
    }
    std::sort(forward.begin(), forward.end());
    std::sort(backward.begin(), backward.end());
    std::vector<Side> open;
    std::set_symmetric_difference(forward.begin(), forward.end(), backward.begin(), backward.end(),
                                  std::back_inserter(open));
    return open.size();
}

QJsonArray toArray(glm::dvec3 v) { return {v.x, v.y, v.z}; }

QString toText(glm::dvec3 v) { return QStringLiteral("%1, %2, %3").arg(v.x).arg(v.y).arg(v.z); }

QString spaceName(SceneSpace space)
{
    return space == SceneSpace::Object ? QStringLiteral("object") : QStringLiteral("clip");
}

QString sizeText(QSize size) { return QStringLiteral("%1x%2").arg(size.width()).arg(size.height()); }

QJsonObject toJson(const Scene& scene, QSize size, const Diagnostics& diagnostics)
{
    const Box box = boundingBox(scene.mesh);
    const std::size_t open = openSides(scene.mesh);
    QJsonArray textures;
    for (const Texture& texture : scene.textures)
        textures << QJsonObject{{"name", texture.name}, {"width", texture.width}, {"height", texture.height}};
    QJsonArray remarks;
    for (const Diagnostic& diagnostic : diagnostics)
        remarks << diagnostic.text();
    return {{"scene", scene.id},
            {"title", scene.title},
            {"note", scene.note},
            {"space", spaceName(scene.space)},
            {"size", sizeText(size)},
            {"faces", static_cast<qint64>(scene.mesh.faceCount())},
            {"vertices", static_cast<qint64>(scene.mesh.vertices.size())},
            {"materials", static_cast<qint64>(scene.materials.size())},
            {"textures", textures},
            {"box", QJsonObject{{"min", toArray(box.min)}, {"max", toArray(box.max)}}},
            {"sphere", QJsonObject{{"center", toArray(scene.bounds.center)}, {"radius", scene.bounds.radius}}},
            {"closed", open == 0},
            {"open_sides", static_cast<qint64>(open)},
            {"diagnostics", remarks}};
}

QString toText(const Scene& scene, QSize size)
{
    const Box box = boundingBox(scene.mesh);
    const std::size_t open = openSides(scene.mesh);
    QStringList textures;
    for (const Texture& texture : scene.textures)
        textures << QStringLiteral("%1 (%2x%3)").arg(texture.name).arg(texture.width).arg(texture.height);
    const QList<std::pair<QString, QString>> rows{
        {QStringLiteral("scene"), scene.id},
        {QStringLiteral("title"), scene.title},
        {QStringLiteral("note"), scene.note},
        {QStringLiteral("space"), spaceName(scene.space)},
        {QStringLiteral("size"), sizeText(size)},
        {QStringLiteral("faces"), QString::number(scene.mesh.faceCount())},
        {QStringLiteral("vertices"), QString::number(scene.mesh.vertices.size())},
        {QStringLiteral("materials"), QString::number(scene.materials.size())},
        {QStringLiteral("textures"), textures.isEmpty() ? QStringLiteral("none") : textures.join(QStringLiteral(", "))},
        {QStringLiteral("box"), QStringLiteral("%1 to %2").arg(toText(box.min), toText(box.max))},
        {QStringLiteral("sphere"),
         QStringLiteral("centre %1, radius %2").arg(toText(scene.bounds.center)).arg(scene.bounds.radius)},
        {QStringLiteral("closed"), open == 0 ? QStringLiteral("yes") : QStringLiteral("no, %1 open sides").arg(open)},
    };
    QString text;
    for (const auto& [name, value] : rows)
        if (!value.isEmpty())
            text += name.leftJustified(11) + value + QLatin1Char('\n');
    return text;
}

} // namespace

ExitCode runInfo(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const Input input = openInput(arguments->operands.first(), *arguments);
    if (arguments->isOn(QStringLiteral("--json")))
        printText(
            QString::fromUtf8(QJsonDocument(toJson(input.scene, input.settings.size, input.diagnostics)).toJson()));
    else
        printText(toText(input.scene, input.settings.size));
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
