#include "app/cli/input.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/verbs.h"
#include "core/io/color_tags.h"
#include "core/io/text_input.h"
#include "core/questions/empty_picture.h"
#include "core/scene/origin.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <numeric>
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
                       "faces that run the other way; only then does back-face culling change nothing. Warnings and "
                       "notes go to stderr.\n\n"
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
        const glm::dvec3 p = glm::dvec3(vertex.position) + mesh.origin;
        box.min = empty ? p : glm::min(box.min, p);
        box.max = empty ? p : glm::max(box.max, p);
        empty = false;
    }
    return box;
}

/// Gives vertices of equal position one number, whatever their other attributes are.
std::vector<std::uint32_t> weldPositions(const Mesh& mesh)
{
    constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
    const std::size_t slots = std::bit_ceil(2 * mesh.vertices.size() + 1);
    std::vector<std::uint32_t> table(slots, kFree);
    std::vector<std::uint32_t> welded(mesh.vertices.size());
    for (std::uint32_t i = 0; i < welded.size(); ++i) {
        welded[i] = i;
        const glm::vec4 p = mesh.vertices[i].position;
        if (!isFinite(p))
            continue;
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 4; ++axis) // + 0: the two zeros are one place
            hash = (hash ^ std::bit_cast<std::uint32_t>(p[axis] + 0.0F)) * 0x9E3779B97F4A7C15U;
        std::size_t slot = hash >> 20 & (slots - 1);
        while (table[slot] != kFree && mesh.vertices[table[slot]].position != p)
            slot = (slot + 1) & (slots - 1);
        if (table[slot] == kFree)
            table[slot] = i;
        welded[i] = table[slot];
    }
    return welded;
}

/// Sides of faces for which no face runs the other way along the same edge.
std::size_t openSides(const Mesh& mesh)
{
    const std::vector<std::uint32_t> welded = weldPositions(mesh);
    const auto forEachSide = [&](auto&& visit) {
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const std::uint32_t from = welded[mesh.indices[i]];
            const std::uint32_t to = welded[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
            if (from != to)
                visit(std::min(from, to), std::uint64_t{std::max(from, to)} << 1 | std::uint64_t{from > to});
        }
    };
    // The sides by their smaller vertex; each as its larger one and a bit for the direction.
    std::vector<std::size_t> ends(mesh.vertices.size() + 1, 0);
    forEachSide([&](std::uint32_t smaller, std::uint64_t) { ++ends[smaller + 1]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::uint64_t> sides(ends.back());
    forEachSide([&](std::uint32_t smaller, std::uint64_t side) { sides[ends[smaller]++] = side; });
    std::size_t open = 0;
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        std::sort(sides.begin() + std::ptrdiff_t(begin), sides.begin() + std::ptrdiff_t(end));
        for (std::size_t i = begin; i < end;) {
            std::int64_t balance = 0;
            const std::uint64_t larger = sides[i] >> 1;
            for (; i < end && sides[i] >> 1 == larger; ++i)
                balance += (sides[i] & 1U) != 0 ? 1 : -1;
            open += static_cast<std::size_t>(std::abs(balance));
        }
        begin = end;
    }
    return open;
}

QJsonArray toArray(glm::dvec3 v) { return {v.x, v.y, v.z}; }

/// Six digits tell places near 0 apart; far from it, where a mesh has an origin of its own, only all digits do.
QString toText(glm::dvec3 v, const Mesh& mesh)
{
    if (mesh.origin != glm::dvec3(0))
        return worldText(glm::vec4(objectFromWorld(v, mesh.origin), 1), mesh.origin);
    return QStringLiteral("%1, %2, %3").arg(v.x).arg(v.y).arg(v.z);
}

/// In the file's coordinates.
glm::dvec3 centerOf(const Scene& scene) { return scene.bounds.center + scene.mesh.origin; }

QString spaceName(SceneSpace space)
{
    return space == SceneSpace::Object ? QStringLiteral("object") : QStringLiteral("clip");
}

QString sizeText(QSize size) { return QStringLiteral("%1x%2").arg(size.width()).arg(size.height()); }

/// What a person should know before drawing the scene with these settings: why nothing would be seen.
QString hintOf(const Scene& scene, const Settings& settings)
{
    const auto empty = whyEmpty(scene, settings);
    return empty ? textOf(sentenceOf(*empty, empty->option)) : QString();
}

QJsonObject toJson(const Scene& scene, const Settings& settings, const Diagnostics& diagnostics)
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
            {"size", sizeText(settings.size)},
            {"faces", static_cast<qint64>(scene.mesh.faceCount())},
            {"vertices", static_cast<qint64>(scene.mesh.vertices.size())},
            {"materials", static_cast<qint64>(scene.materials.size())},
            {"textures", textures},
            {"box", QJsonObject{{"min", toArray(box.min)}, {"max", toArray(box.max)}}},
            {"sphere", QJsonObject{{"center", toArray(centerOf(scene))}, {"radius", scene.bounds.radius}}},
            {"origin", toArray(scene.mesh.origin)},
            {"closed", open == 0},
            {"open_sides", static_cast<qint64>(open)},
            {"hint", hintOf(scene, settings)},
            {"diagnostics", remarks}};
}

QString toText(const Scene& scene, const Settings& settings)
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
        {QStringLiteral("size"), sizeText(settings.size)},
        {QStringLiteral("faces"), QString::number(scene.mesh.faceCount())},
        {QStringLiteral("vertices"), QString::number(scene.mesh.vertices.size())},
        {QStringLiteral("materials"), QString::number(scene.materials.size())},
        {QStringLiteral("textures"), textures.isEmpty() ? QStringLiteral("none") : textures.join(QStringLiteral(", "))},
        {QStringLiteral("box"),
         QStringLiteral("%1 to %2").arg(toText(box.min, scene.mesh), toText(box.max, scene.mesh))},
        {QStringLiteral("sphere"),
         QStringLiteral("centre %1, radius %2").arg(toText(centerOf(scene), scene.mesh)).arg(scene.bounds.radius)},
        {QStringLiteral("origin"),
         scene.mesh.origin == glm::dvec3(0) ? QString() : toText(scene.mesh.origin, scene.mesh)},
        {QStringLiteral("closed"), open == 0 ? QStringLiteral("yes") : QStringLiteral("no, %1 open sides").arg(open)},
        {QStringLiteral("hint"), hintOf(scene, settings)},
    };
    QString text;
    for (const auto& [name, value] : rows)
        if (!value.isEmpty())
            text += name.leftJustified(11) + value + QLatin1Char('\n');
    return text;
}

/// What the textures say of their colours and is not applied.
Diagnostics colorRemarks(const Input& input)
{
    Diagnostics remarks;
    const QStringList texts{QStringLiteral("obj"), QStringLiteral("mtl"), QStringLiteral("case"),
                            QStringLiteral("json")};
    for (const QString& path : input.files) {
        if (texts.contains(QFileInfo(path).suffix().toLower()))
            continue;
        const InputBytes file = readInput(path);
        if (const auto remark = colorTagRemark(file.bytes))
            remarks.push_back({Severity::Warning, path, 0, *remark});
    }
    return remarks;
}

} // namespace

Usage infoUsage() { return usage(); }

ExitCode runInfo(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    Input input = openInput(arguments->operands.first(), *arguments);
    for (const Diagnostic& diagnostic : input.diagnostics)
        if (diagnostic.severity == Severity::Note)
            std::fprintf(stderr, "%s\n", qUtf8Printable(diagnostic.text()));
    for (const Diagnostic& remark : colorRemarks(input)) {
        std::fprintf(stderr, "%s\n", qUtf8Printable(remark.text()));
        input.diagnostics.push_back(remark);
    }
    if (arguments->isOn(QStringLiteral("--json")))
        printText(QString::fromUtf8(QJsonDocument(toJson(input.scene, input.settings, input.diagnostics)).toJson()));
    else
        printText(toText(input.scene, input.settings));
    return ExitCode::Fine;
}

} // namespace rasterlens::cli
