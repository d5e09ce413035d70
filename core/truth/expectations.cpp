#include "core/truth/expectations.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <map>

namespace rasterlens
{
namespace
{

using Numbers = std::vector<double>;

std::optional<Numbers> numbersOf(const QString& text)
{
    Numbers numbers;
    for (const QString& word : text.simplified().split(QLatin1Char(' '))) {
        bool good = false;
        numbers.push_back(word == QLatin1String("true") ? 1 : word.toDouble(&good));
        if (!good && word != QLatin1String("true"))
            return std::nullopt;
    }
    return numbers;
}

std::size_t countCovered(const Outcome& o, std::uint32_t atLeast)
{
    return static_cast<std::size_t>(
        std::count_if(o.cover.begin(), o.cover.end(), [=](std::uint32_t n) { return n >= atLeast; }));
}

/// First and last covered index along every row (or column).
struct Extent {
    int first = -1;
    int last = -1;

    void add(int i)
    {
        first = first < 0 ? i : std::min(first, i);
        last = std::max(last, i);
    }
    [[nodiscard]] bool encloses(int i) const { return first >= 0 && first < i && i < last; }
};

std::size_t countHoles(const Outcome& o)
{
    std::vector<Extent> rows(static_cast<std::size_t>(o.window.height));
    std::vector<Extent> columns(static_cast<std::size_t>(o.window.width));
    const auto forEach = [&](auto&& visit) {
        std::size_t i = 0;
        for (int y = 0; y < o.window.height; ++y)
            for (int x = 0; x < o.window.width; ++x)
                visit(x, y, o.cover[i++] > 0);
    };
    forEach([&](int x, int y, bool covered) {
        if (covered) {
            rows[static_cast<std::size_t>(y)].add(x);
            columns[static_cast<std::size_t>(x)].add(y);
        }
    });
    std::size_t holes = 0;
    forEach([&](int x, int y, bool covered) {
        holes += !covered && rows[static_cast<std::size_t>(y)].encloses(x) &&
                 columns[static_cast<std::size_t>(x)].encloses(y);
    });
    return holes;
}

/// Strips of four faces in which nothing but the last two is seen.
int countFrontWins(const Outcome& o)
{
    std::map<int, bool> strips;
    for (const std::int32_t id : o.id)
        if (id >= 0) {
            const auto strip = strips.try_emplace(id / 4, true).first;
            strip->second = strip->second && id % 4 >= 2;
        }
    return static_cast<int>(std::count_if(strips.begin(), strips.end(), [](const auto& s) { return s.second; }));
}

/// The index of a pixel of the viewport, if the window holds it.
std::optional<std::size_t> pixelIndex(const Outcome& o, double x, double y)
{
    const int column = static_cast<int>(x) - o.window.x;
    const int row = static_cast<int>(y) - o.window.y;
    if (column < 0 || row < 0 || column >= o.window.width || row >= o.window.height)
        return std::nullopt;
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(o.window.width) + static_cast<std::size_t>(column);
}

bool equals(Numbers found, const Numbers& wanted, double tolerance = 0)
{
    return std::equal(found.begin(), found.end(), wanted.end() - static_cast<std::ptrdiff_t>(found.size()),
                      wanted.end(), [=](double a, double b) { return std::abs(a - b) <= tolerance; });
}

/// How one key is read: how many numbers follow, which of them name a place, and what is found there.
struct Key {
    const char* name;
    const char* words;
    std::size_t numbers;
    double tolerance;
    std::optional<Numbers> (*find)(const Outcome&, const Numbers& wanted);
};

template <class Value>
Numbers one(Value value)
{
    return {static_cast<double>(value)};
}

template <class Read>
std::optional<Numbers> atPixel(const Outcome& o, const Numbers& wanted, Read read)
{
    const auto i = pixelIndex(o, wanted[0], wanted[1]);
    if (!i)
        return std::nullopt;
    return read(*i);
}

template <class T>
std::optional<Numbers> ifKnown(const std::optional<T>& value, const Numbers& wanted)
{
    return value ? one(*value) : wanted;
}

const Key kKeys[] = {
    {"covered", QT_TRANSLATE_NOOP("HardCase", "%1 pixels are covered"), 1, 0,
     [](const Outcome& o, const Numbers&) -> std::optional<Numbers> { return one(countCovered(o, 1)); }},
    {"watertight", QT_TRANSLATE_NOOP("HardCase", "every pixel is covered exactly once"), 1, 0,
     [](const Outcome& o, const Numbers&) -> std::optional<Numbers> {
         return one(countCovered(o, 1) == o.cover.size() && countCovered(o, 2) == 0);
     }},
    {"holes", QT_TRANSLATE_NOOP("HardCase", "%1 holes"), 1, 0,
     [](const Outcome& o, const Numbers&) -> std::optional<Numbers> { return one(countHoles(o)); }},
    {"hit_twice", QT_TRANSLATE_NOOP("HardCase", "%1 pixels are covered by two faces or more"), 1, 0,
     [](const Outcome& o, const Numbers&) -> std::optional<Numbers> { return one(countCovered(o, 2)); }},
    {"max_count", QT_TRANSLATE_NOOP("HardCase", "no pixel is covered by more than %1 faces"), 1, 0,
     [](const Outcome& o, const Numbers&) -> std::optional<Numbers> {
         return one(o.cover.empty() ? 0 : *std::max_element(o.cover.begin(), o.cover.end()));
     }},
    {"covers", QT_TRANSLATE_NOOP("HardCase", "%3 faces cover pixel (%1, %2)"), 3, 0,
     [](const Outcome& o, const Numbers& wanted) {
         return atPixel(o, wanted, [&](std::size_t i) { return one(o.cover[i]); });
     }},
    {"winner", QT_TRANSLATE_NOOP("HardCase", "face %1 is seen in %2 pixels"), 2, 0,
     [](const Outcome& o, const Numbers& wanted) -> std::optional<Numbers> {
         return one(std::count(o.id.begin(), o.id.end(), static_cast<std::int32_t>(wanted[0])));
     }},
    {"pixel", QT_TRANSLATE_NOOP("HardCase", "face %3 is seen at (%1, %2)"), 3, 0,
     [](const Outcome& o, const Numbers& wanted) {
         return atPixel(o, wanted, [&](std::size_t i) { return one(o.id[i]); });
     }},
    {"front_wins", QT_TRANSLATE_NOOP("HardCase", "in %1 strips only the front is seen"), 1, 0,
     [](const Outcome& o, const Numbers&) -> std::optional<Numbers> { return one(countFrontWins(o)); }},
    {"depth", QT_TRANSLATE_NOOP("HardCase", "the depth at (%1, %2) is %3"), 3, 0x1p-22,
     [](const Outcome& o, const Numbers& wanted) {
         return atPixel(o, wanted, [&](std::size_t i) { return one(o.depth[i]); });
     }},
    {"color", QT_TRANSLATE_NOOP("HardCase", "the colour at (%1, %2) is %3 %4 %5"), 5, 1.01,
     [](const Outcome& o, const Numbers& wanted) {
         return atPixel(o, wanted, [&](std::size_t i) -> Numbers {
             return {o.color[i].r, o.color[i].g, o.color[i].b};
         });
     }},
    {"nonfinite", QT_TRANSLATE_NOOP("HardCase", "%1 faces are dropped for a position that is no number"), 1, 0,
     [](const Outcome& o, const Numbers& wanted) { return ifKnown(o.nonFinite, wanted); }},
    {"clip_vertices", QT_TRANSLATE_NOOP("HardCase", "clipping makes %1 corners of a face"), 1, 0,
     [](const Outcome& o, const Numbers& wanted) { return ifKnown(o.clipVertices, wanted); }},
};

const Key* findKey(const QString& name)
{
    const auto* key = std::ranges::find_if(kKeys, [&](const Key& k) { return name == QLatin1String(k.name); });
    return key == std::end(kKeys) ? nullptr : key;
}

Expectation check(const QString& name, const QString& value, const Outcome& outcome)
{
    Expectation result{name, value, false, {}};
    const Key* key = findKey(name);
    if (!key) {
        result.found = QStringLiteral("not a key");
        return result;
    }
    const std::optional<Numbers> wanted = numbersOf(value);
    if (!wanted || wanted->size() != key->numbers) {
        result.found = QStringLiteral("%1 numbers expected").arg(key->numbers);
        return result;
    }
    const std::optional<Numbers> found = key->find(outcome, *wanted);
    if (!found) {
        result.found = QStringLiteral("no such pixel in the window");
        return result;
    }
    result.holds = equals(*found, *wanted, key->tolerance);
    QStringList words;
    for (const double number : *found)
        words << QString::number(number, 'g', 10);
    result.found = words.join(QLatin1Char(' '));
    return result;
}

} // namespace

Outcome outcomeOf(const ExactFrame& frame, glm::vec3 background)
{
    Outcome o;
    o.window = frame.window;
    o.nonFinite = frame.nonFinite;
    o.clipVertices = frame.maxClipVertices;
    for (int y = 0; y < frame.window.height; ++y)
        for (int x = 0; x < frame.window.width; ++x) {
            const std::size_t i = frame.sampleNearestCentre(x, y);
            o.cover.push_back(frame.cover[i]);
            o.id.push_back(frame.id[i]);
            o.depth.push_back(frame.depth[i]);
            o.color.push_back(255.0 * frame.pixelColor(x, y, background));
        }
    return o;
}

Outcome outcomeOf(const Frame& frame, const Scene& scene, const Statistics* statistics)
{
    Outcome o;
    const int width = frame.image.width();
    o.window = scene.window.value_or(PixelRect{0, 0, width, frame.image.height()});
    if (statistics)
        o.nonFinite = static_cast<int>(statistics->faces.nonFinite);
    for (int y = o.window.y; y < o.window.y + o.window.height; ++y) {
        const QRgb* line = reinterpret_cast<const QRgb*>(frame.image.constScanLine(y));
        for (int x = o.window.x; x < o.window.x + o.window.width; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            o.cover.push_back(frame.coverage[i]);
            o.id.push_back(frame.ids[i]);
            o.depth.push_back(static_cast<double>(frame.depth[i]));
            o.color.emplace_back(qRed(line[x]), qGreen(line[x]), qBlue(line[x]));
        }
    }
    return o;
}

QString wordsOf(const QString& key, const QString& value, QString (*translate)(const char*))
{
    const auto translated = [translate](const char* text) {
        return translate ? translate(text) : QString::fromUtf8(text);
    };
    const Key* found = findKey(key);
    const QStringList numbers = value.simplified().split(QLatin1Char(' '));
    if (!found || static_cast<std::size_t>(numbers.size()) != found->numbers)
        return QStringLiteral("%1 %2").arg(key, value);
    if (key == QLatin1String("pixel") && numbers[2] == QLatin1String("-1"))
        return translated(QT_TRANSLATE_NOOP("HardCase", "no face is seen at (%1, %2)")).arg(numbers[0], numbers[1]);
    QString words = translated(found->words);
    // watertight has a value, and no place for it
    for (qsizetype i = 0; i < numbers.size() && words.contains(QLatin1Char('%')); ++i)
        words = words.arg(numbers[i]);
    return words;
}

std::vector<Expectation> checkExpectations(const std::vector<std::pair<QString, QString>>& lines,
                                           const Outcome& outcome)
{
    std::vector<Expectation> results;
    for (const auto& [key, value] : lines)
        results.push_back(check(key, value, outcome));
    return results;
}

} // namespace rasterlens
