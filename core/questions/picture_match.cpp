#include "core/questions/picture_match.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr double kUnseen = 12.0 * 12.0; ///< the square of a difference that is not looked at
constexpr double kNear = 24.0 * 24.0;   ///< the square of a difference within which colours count as one
constexpr int kFarOffset = 2;           ///< pixels, in both directions
constexpr double kOffsetPrice = 0.02;   ///< a pixel of offset costs this part of a score
constexpr int kMostBlocks = 16;         ///< across and down
constexpr int kSmallestBlock = 4;       ///< pixels across and down
constexpr std::size_t kSearched = 8000; ///< pixels of a change that are looked at for each offset
constexpr int kSameColor = 40;          ///< difference of a channel up to which a border has one colour

/// The square of the distance of two colours, the mean of the three channels.
double squared(QRgb a, QRgb b)
{
    const int red = qRed(a) - qRed(b);
    const int green = qGreen(a) - qGreen(b);
    const int blue = qBlue(a) - qBlue(b);
    return (red * red + green * green + blue * blue) / 3.0;
}

/// The squared difference as it is counted: none where it cannot be seen, and no pixel for more than one.
double energy(QRgb a, QRgb b)
{
    const double square = squared(a, b);
    return square < kUnseen ? 0 : std::min(square, kWholePixel);
}

/// The squared difference, small ones too.
double capped(QRgb a, QRgb b) { return std::min(squared(a, b), kWholePixel); }

/// All offsets, the nearest first.
const std::vector<QPoint>& offsets()
{
    static const std::vector<QPoint> all = [] {
        std::vector<QPoint> found;
        for (int y = -kFarOffset; y <= kFarOffset; ++y)
            for (int x = -kFarOffset; x <= kFarOffset; ++x)
                found.emplace_back(x, y);
        std::ranges::stable_sort(found, {}, [](QPoint p) { return p.manhattanLength(); });
        return found;
    }();
    return all;
}

const QRgb* rowOf(const QImage& image, int y) { return reinterpret_cast<const QRgb*>(image.constScanLine(y)); }

QImage inSize(const QImage& image, QSize size)
{
    const QImage opaque = image.convertToFormat(QImage::Format_RGB32);
    return size == image.size() ? opaque
                                : opaque.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                                      .convertToFormat(QImage::Format_RGB32);
}

/// The picture on the background, without transparency.
QImage flattened(const QImage& image, QRgb background)
{
    if (!image.hasAlphaChannel())
        return image.convertToFormat(QImage::Format_RGB32);
    QImage flat = image.convertToFormat(QImage::Format_ARGB32);
    for (int y = 0; y < flat.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(flat.scanLine(y));
        for (int x = 0; x < flat.width(); ++x) {
            const int alpha = qAlpha(row[x]);
            const auto mixed = [alpha](int over, int under) {
                return (over * alpha + under * (255 - alpha) + 127) / 255;
            };
            row[x] = qRgb(mixed(qRed(row[x]), qRed(background)), mixed(qGreen(row[x]), qGreen(background)),
                          mixed(qBlue(row[x]), qBlue(background)));
        }
    }
    return flat.convertToFormat(QImage::Format_RGB32);
}

/// Colours that are nearly equal have one key.
QRgb roughly(QRgb color) { return color & 0x00f0f0f0U; }

/// The most frequent colour: the mean of those that are nearly it.
class ColorCount
{
public:
    void add(QRgb color)
    {
        ++m_total;
        Sum& sum = m_sums[roughly(color)];
        ++sum.count;
        sum.red += qRed(color);
        sum.green += qGreen(color);
        sum.blue += qBlue(color);
    }
    [[nodiscard]] QRgb color() const
    {
        const Sum& most = largest();
        return most.count == 0
                   ? qRgb(0, 0, 0)
                   : qRgb(int(most.red / most.count), int(most.green / most.count), int(most.blue / most.count));
    }
    [[nodiscard]] double share() const { return m_total == 0 ? 0 : double(largest().count) / double(m_total); }
    [[nodiscard]] std::int64_t total() const { return m_total; }

private:
    struct Sum {
        std::int64_t count = 0;
        std::int64_t red = 0;
        std::int64_t green = 0;
        std::int64_t blue = 0;
    };
    [[nodiscard]] const Sum& largest() const
    {
        static const Sum none;
        const auto most = std::ranges::max_element(m_sums, {}, [](const auto& entry) { return entry.second.count; });
        return most == m_sums.end() ? none : most->second;
    }
    std::map<QRgb, Sum> m_sums;
    std::int64_t m_total = 0;
};

QRgb borderColor(const QImage& image)
{
    ColorCount count;
    for (int x = 0; x < image.width(); ++x) {
        count.add(image.pixel(x, 0));
        count.add(image.pixel(x, image.height() - 1));
    }
    for (int y = 0; y < image.height(); ++y) {
        count.add(image.pixel(0, y));
        count.add(image.pixel(image.width() - 1, y));
    }
    return count.color();
}

bool isNearly(QRgb a, QRgb b)
{
    return std::abs(qRed(a) - qRed(b)) <= kSameColor && std::abs(qGreen(a) - qGreen(b)) <= kSameColor &&
           std::abs(qBlue(a) - qBlue(b)) <= kSameColor;
}

/// The rows and columns of which more than `allowed` of the pixels have another colour than the border.
QRect withoutBorder(const QImage& image, double allowed)
{
    const QRgb color = borderColor(image);
    std::vector<int> inRow(static_cast<std::size_t>(image.height()));
    std::vector<int> inColumn(static_cast<std::size_t>(image.width()));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (!isNearly(image.pixel(x, y), color)) {
                ++inRow[static_cast<std::size_t>(y)];
                ++inColumn[static_cast<std::size_t>(x)];
            }
    const auto span = [allowed](const std::vector<int>& counts, int length) {
        const auto isContent = [limit = allowed * length](int count) { return count > limit; };
        const auto first = std::ranges::find_if(counts, isContent);
        const auto last = std::find_if(counts.rbegin(), counts.rend(), isContent);
        return std::pair(int(first - counts.begin()), int(counts.rend() - last) - 1);
    };
    const auto [top, bottom] = span(inRow, image.width());
    const auto [left, right] = span(inColumn, image.height());
    return top > bottom || left > right ? QRect() : QRect(QPoint(left, top), QPoint(right, bottom));
}

/// The place at which the content of the picture handed in covers that of the right one, where one is about 1, 1/2 or 2
/// times as large as the other.
std::optional<QRect> contentPlace(const QRect& shown, const QRect& right, QSize size)
{
    if (shown.isEmpty() || right.isEmpty())
        return std::nullopt;
    for (const double scale : {1.0, 0.5, 2.0}) {
        const auto fits = [scale](int is, int should) {
            return std::abs(is - scale * should) <= std::max(2.0, 0.03 * scale * should);
        };
        if (fits(shown.width(), right.width()) && fits(shown.height(), right.height()))
            return QRect(shown.topLeft() - (QPointF(right.topLeft()) * scale).toPoint(),
                         (QSizeF(size) * scale).toSize());
    }
    return std::nullopt;
}

QRect centred(QSize size, QSize outer)
{
    return {QPoint((outer.width() - size.width()) / 2, (outer.height() - size.height()) / 2), size};
}

/// The value that this part of the values stays below; 0 without any.
double quantile(std::vector<double> values, double part)
{
    if (values.empty())
        return 0;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * double(values.size()));
    std::ranges::nth_element(values, place);
    return *place;
}

} // namespace

double offsetFactor(QPoint offset) { return 1 - kOffsetPrice * offset.manhattanLength(); }

PictureComparison::PictureComparison(const QImage& handedIn, const QRect& place, const QImage& right, QRgb background)
    : m_background(background)
{
    const QSize size = place.size().boundedTo(right.size()).expandedTo({1, 1});
    m_right = inSize(right, size);
    // What lies outside of the picture is transparent in the copy.
    const QImage shown = handedIn.rect().contains(place) ? handedIn.copy(place)
                                                         : handedIn.convertToFormat(QImage::Format_ARGB32).copy(place);
    m_picture = inSize(flattened(shown, background), size);
    m_blocksAcross = std::clamp(std::min(size.width(), size.height()) / kSmallestBlock, 1, kMostBlocks);
    m_blocks.resize(offsets().size());
    m_means.resize(offsets().size());
    markEdges();
}

void PictureComparison::markEdges()
{
    const int width = m_right.width();
    const int height = m_right.height();
    m_edge.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    const auto mark = [&](int x, int y) {
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i)
                m_edge[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)] = 1;
    };
    for (int y = 0; y < height; ++y) {
        const QRgb* row = rowOf(m_right, y);
        const QRgb* below = y + 1 < height ? rowOf(m_right, y + 1) : nullptr;
        for (int x = 0; x < width; ++x) {
            if (x + 1 < width && squared(row[x], row[x + 1]) >= kUnseen) {
                mark(x, y);
                mark(x + 1, y);
            }
            if (below && squared(row[x], below[x]) >= kUnseen) {
                mark(x, y);
                mark(x, y + 1);
            }
        }
    }
}

/// The colour that most pixels have which should be background. Where the right picture has no background but this one
/// may show some, as behind faces that are missing: its most frequent colour, if the right picture has it nowhere.
std::optional<QRgb> PictureComparison::ownBackground() const
{
    constexpr double kMost = 0.5;
    constexpr double kLeastPart = 0.03; // of the picture
    const double least = kLeastPart * m_right.width() * m_right.height();
    const auto forEach = [&](auto&& use) {
        for (int y = 0; y < m_right.height(); ++y)
            for (int x = 0; x < m_right.width(); ++x)
                use(rowOf(m_picture, y)[x], rowOf(m_right, y)[x]);
    };
    ColorCount behind;
    forEach([&](QRgb color, QRgb right) {
        if (squared(right, m_background) < 1)
            behind.add(color);
    });
    if (double(behind.total()) >= least)
        return behind.share() > kMost ? std::optional(behind.color()) : std::nullopt;
    ColorCount everywhere;
    forEach([&](QRgb color, QRgb) { everywhere.add(color); });
    const QRgb frequent = everywhere.color();
    bool isOfTheScene = everywhere.share() * double(everywhere.total()) < least;
    forEach([&](QRgb, QRgb right) { isOfTheScene = isOfTheScene || squared(right, frequent) < kNear; });
    return isOfTheScene ? std::nullopt : std::optional(frequent);
}

std::optional<PictureComparison> PictureComparison::withOwnBackground() const
{
    const std::optional<QRgb> other = ownBackground();
    if (!other || squared(*other, m_background) < kUnseen)
        return std::nullopt;
    PictureComparison comparison = *this;
    for (int y = 0; y < m_right.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(comparison.m_picture.scanLine(y));
        const QRgb* right = rowOf(m_right, y);
        for (int x = 0; x < m_right.width(); ++x)
            if (squared(row[x], *other) < kNear && squared(row[x], right[x]) >= kNear)
                row[x] = m_background;
    }
    return comparison;
}

PictureComparison PictureComparison::withRight(const QImage& right) const
{
    PictureComparison comparison = *this;
    comparison.m_right = inSize(right, size());
    std::ranges::fill(comparison.m_blocks, std::nullopt);
    std::ranges::fill(comparison.m_means, std::nullopt);
    return comparison;
}

double PictureComparison::leaves(const QImage& other) const
{
    const QImage picture = inSize(other, size());
    double sum = 0;
    for (int y = 0; y < m_right.height(); ++y)
        for (int x = 0; x < m_right.width(); ++x)
            sum += capped(rowOf(m_picture, y)[x], rowOf(picture, y)[x]);
    return sum;
}

QImage PictureComparison::nearest(const std::vector<QImage>& pictures, QPoint offset) const
{
    QImage result = inSize(pictures.front(), size());
    const QRect both = m_right.rect() & m_right.rect().translated(-offset);
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        if (pictures[i].isNull())
            continue;
        const QImage other = inSize(pictures[i], size());
        for (int y = both.top(); y <= both.bottom(); ++y) {
            auto* row = reinterpret_cast<QRgb*>(result.scanLine(y));
            const QRgb* shown = rowOf(m_picture, y + offset.y());
            const QRgb* otherRow = rowOf(other, y);
            for (int x = both.left(); x <= both.right(); ++x)
                if (row[x] != otherRow[x] &&
                    capped(shown[x + offset.x()], otherRow[x]) < capped(shown[x + offset.x()], row[x]))
                    row[x] = otherRow[x];
        }
    }
    return result;
}

std::size_t PictureComparison::blockOf(int x, int y) const
{
    const int column = x * m_blocksAcross / m_right.width();
    const int row = y * m_blocksAcross / m_right.height();
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_blocksAcross) + static_cast<std::size_t>(column);
}

std::optional<QRgb> PictureComparison::pictureAt(std::uint32_t index, QPoint offset) const
{
    const auto width = static_cast<std::uint32_t>(m_right.width());
    const int x = static_cast<int>(index % width) + offset.x();
    const int y = static_cast<int>(index / width) + offset.y();
    if (x < 0 || y < 0 || x >= m_picture.width() || y >= m_picture.height())
        return std::nullopt;
    return rowOf(m_picture, y)[x];
}

PictureChange PictureComparison::changeTo(const QImage& other) const
{
    const QImage picture = inSize(other, size());
    PictureChange change;
    for (int y = 0; y < m_right.height(); ++y) {
        const QRgb* right = rowOf(m_right, y);
        const QRgb* changed = rowOf(picture, y);
        for (int x = 0; x < m_right.width(); ++x)
            if ((right[x] ^ changed[x]) & 0xffffffU) {
                change.pixels.push_back({static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(m_right.width()) +
                                             static_cast<std::uint32_t>(x),
                                         changed[x]});
                change.box |= QRect(x, y, 1, 1);
            }
    }
    return change;
}

const PictureComparison::Blocks& PictureComparison::blocksAt(std::size_t offset) const
{
    std::optional<Blocks>& known = m_blocks[offset];
    if (known)
        return *known;
    Blocks blocks;
    const std::size_t blockCount = static_cast<std::size_t>(m_blocksAcross) * static_cast<std::size_t>(m_blocksAcross);
    for (std::size_t kind = 0; kind < 2; ++kind) {
        blocks.energy[kind].assign(blockCount, 0);
        blocks.count[kind].assign(blockCount, 0);
    }
    const QPoint move = offsets()[offset];
    const QRect both = m_right.rect() & m_right.rect().translated(-move);
    for (int y = both.top(); y <= both.bottom(); ++y) {
        const QRgb* right = rowOf(m_right, y);
        const QRgb* shown = rowOf(m_picture, y + move.y());
        const std::size_t start = static_cast<std::size_t>(y) * static_cast<std::size_t>(m_right.width());
        for (int x = both.left(); x <= both.right(); ++x) {
            const std::size_t kind = m_edge[start + static_cast<std::size_t>(x)];
            const double wrong = energy(shown[x + move.x()], right[x]);
            const std::size_t block = blockOf(x, y);
            blocks.energy[kind][block] += wrong;
            blocks.count[kind][block] += 1;
            blocks.energySum[kind] += wrong;
            blocks.countSum[kind] += 1;
            blocks.residual += capped(shown[x + move.x()], right[x]);
            blocks.unlike += wrong > 0 ? 1 : 0;
        }
    }
    return known.emplace(std::move(blocks));
}

/// What the picture leaves of the right one at an offset, a pixel.
const PictureComparison::Mean& PictureComparison::meanAt(std::size_t offset) const
{
    std::optional<Mean>& known = m_means[offset];
    if (known)
        return *known;
    const QPoint move = offsets()[offset];
    const QRect both = m_right.rect() & m_right.rect().translated(-move);
    double sum = 0;
    for (int y = both.top(); y <= both.bottom(); ++y) {
        const QRgb* right = rowOf(m_right, y);
        const QRgb* shown = rowOf(m_picture, y + move.y());
        for (int x = both.left(); x <= both.right(); ++x)
            sum += capped(shown[x + move.x()], right[x]);
    }
    const double pixels = double(both.width()) * both.height();
    return known.emplace(Mean{pixels > 0 ? sum / pixels : kWholePixel, pixels});
}

/// How far the picture is from another one at an offset, a pixel; from every `stride`th pixel of the change.
double PictureComparison::distance(const PictureChange& change, std::size_t offset, std::size_t stride) const
{
    const QPoint move = offsets()[offset];
    const Mean& mean = meanAt(offset);
    double changed = 0;
    for (std::size_t i = 0; i < change.pixels.size(); i += stride) {
        const ChangedPixel& pixel = change.pixels[i];
        if (const auto shown = pictureAt(pixel.index, move)) {
            const QRgb right = reinterpret_cast<const QRgb*>(m_right.constBits())[pixel.index];
            changed += capped(*shown, pixel.color) - capped(*shown, right);
        }
    }
    return mean.pixels > 0 ? mean.left + changed * double(stride) / mean.pixels : kWholePixel;
}

PictureFit PictureComparison::fit(const PictureChange& change) const
{
    constexpr std::size_t kFinalists = 4; // of which all pixels are looked at
    std::size_t stride = std::max<std::size_t>(1, change.pixels.size() / kSearched);
    std::vector<std::size_t> order(offsets().size());
    std::iota(order.begin(), order.end(), 0);
    const auto near = [&](std::size_t offset) {
        return distance(change, offset, stride) / offsetFactor(offsets()[offset]);
    };
    const auto sortFirst = [&](std::size_t count) {
        std::vector<std::pair<double, std::size_t>> found;
        for (std::size_t i = 0; i < count; ++i)
            found.emplace_back(near(order[i]), order[i]);
        // Offsets that are equally near but for the last digits stay in their order.
        std::ranges::sort(found, {}, [](const auto& f) { return std::pair(std::round(f.first * 1e6), f.second); });
        for (std::size_t i = 0; i < count; ++i)
            order[i] = found[i].second;
    };
    sortFirst(order.size());
    if (stride > 1) {
        stride = 1;
        sortFirst(kFinalists);
    }
    return fitAt(change, order.front());
}

PictureFit PictureComparison::fitAt(const PictureChange& change, std::size_t offset) const
{
    const Blocks& blocks = blocksAt(offset);
    PictureFit fit;
    fit.offset = offsets()[offset];
    fit.excess = blocks.energySum;
    fit.count = blocks.countSum;
    fit.residual = blocks.residual;
    fit.unlike = blocks.unlike;
    std::array<std::vector<double>, 2> left = blocks.energy; // what the other picture does not have
    for (const ChangedPixel& pixel : change.pixels) {
        const auto shown = pictureAt(pixel.index, fit.offset);
        if (!shown)
            continue;
        const QRgb right = reinterpret_cast<const QRgb*>(m_right.constBits())[pixel.index];
        const double contrast = squared(pixel.color, right);
        const double way = (squared(*shown, right) - squared(*shown, pixel.color)) / contrast;
        const double weight = std::min(contrast, kWholePixel);
        const double fromRight = energy(*shown, right);
        const double fromOther = energy(*shown, pixel.color);
        const std::size_t kind = m_edge[pixel.index];
        const int x = static_cast<int>(pixel.index) % m_right.width();
        const int y = static_cast<int>(pixel.index) / m_right.width();
        fit.weight += weight;
        // Nearer to the other colour, but far from both, is neither.
        const double like = way > 0 ? 1 - fromOther / kWholePixel : 1;
        fit.gain += weight * like * std::clamp(way, -1.0, 1.0);
        fit.excess[kind] += std::min(fromRight, fromOther) - fromRight;
        fit.residual += capped(*shown, pixel.color) - capped(*shown, right);
        fit.unlike += (fromOther > 0 ? 1 : 0) - (fromRight > 0 ? 1 : 0);
        left[kind][blockOf(x, y)] += fromOther - fromRight;
    }
    if (const double count = fit.count[0] + fit.count[1]; count > 0) // as if no pixel lay outside
        fit.residual *= double(m_right.width()) * m_right.height() / count;
    for (std::size_t kind = 0; kind < 2; ++kind) {
        std::vector<double> means;
        for (std::size_t block = 0; block < left[kind].size(); ++block)
            if (blocks.count[kind][block] >= kSmallestBlock)
                means.push_back(left[kind][block] / blocks.count[kind][block]);
        fit.typical[kind] = quantile(std::move(means), 0.5);
    }
    // Where few pixels are hit, most small blocks have none of them. What is in all flat areas is at edges too.
    std::vector<double> wide = left[0];
    std::vector<double> count = blocks.count[0];
    if (fit.count[0] < fit.count[1]) // hardly any flat areas
        for (std::size_t block = 0; block < wide.size(); ++block) {
            wide[block] += left[1][block];
            count[block] += blocks.count[1][block];
        }
    fit.typical[0] = std::max(fit.typical[0], spread(wide, count));
    fit.typical[1] = std::max(fit.typical[1], fit.typical[0]);
    return fit;
}

/// What three of four large blocks have at least, a pixel: four blocks across and down.
double PictureComparison::spread(const std::vector<double>& energy, const std::vector<double>& count) const
{
    constexpr std::size_t kAcross = 4;
    constexpr double kPart = 0.25;
    constexpr double kLeastCount = 4.0 * kSmallestBlock * kSmallestBlock;
    const auto across = static_cast<std::size_t>(m_blocksAcross);
    std::array<double, kAcross * kAcross> sums{};
    std::array<double, kAcross * kAcross> counts{};
    for (std::size_t block = 0; block < energy.size(); ++block) {
        const std::size_t large = block / across * kAcross / across * kAcross + block % across * kAcross / across;
        sums[large] += energy[block];
        counts[large] += count[block];
    }
    std::vector<double> means;
    for (std::size_t large = 0; large < sums.size(); ++large)
        if (counts[large] >= kLeastCount)
            means.push_back(sums[large] / counts[large]);
    return quantile(std::move(means), kPart);
}

std::vector<QRect> placesIn(const QImage& handedIn, const QImage& right)
{
    std::vector<QRect> places;
    const auto add = [&places](const QRect& place) {
        if (!place.isEmpty() && std::ranges::find(places, place) == places.end())
            places.push_back(place);
    };
    const QSize outer = handedIn.size();
    const QSize size = right.size();
    add(handedIn.rect());
    if (outer != size && outer.width() >= size.width() && outer.height() >= size.height()) {
        add(centred(size, outer));
        add(QRect(QPoint(0, 0), size));
    }
    const QImage shown = flattened(handedIn, qRgb(0, 0, 0));
    constexpr double kNoisy = 0.1; // more pixels of a row than noise would change
    for (const double allowed : {0.0, kNoisy}) {
        const QRect inner = withoutBorder(shown, allowed);
        add(inner);
        if (const auto place = contentPlace(inner, withoutBorder(right, allowed), size))
            add(*place);
    }
    add(centred(outer / 2, outer));
    return places;
}

} // namespace rasterlens
