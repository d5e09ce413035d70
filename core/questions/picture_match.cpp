#include "core/questions/picture_match.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

namespace rasterlens
{
namespace
{

constexpr double kUnseen = 12.0 * 12.0;          ///< the square of a difference that is not looked at
constexpr double kLeastWeight = kWholePixel / 4; ///< of a change: below it, rounding could look like it
/// Noise by flat areas and edges, in whole pixels a pixel: what differs more is another picture.
constexpr std::array<double, 2> kMostNoise{0.05, 0.15};
constexpr int kFarOffset = 2;            ///< pixels, in both directions
constexpr double kOffsetPrice = 0.02;    ///< a pixel of offset costs this part of a score
constexpr int kMostBlocks = 16;          ///< across and down
constexpr int kSmallestBlock = 4;        ///< pixels across and down
constexpr std::size_t kSearched = 30000; ///< pixels of a change that are looked at for each offset
constexpr int kSameColor = 40;           ///< difference of a channel up to which a border has one colour

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

/// The middle of the values; 0 without any.
double median(std::vector<double> values)
{
    if (values.empty())
        return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
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

std::optional<PictureComparison> PictureComparison::withOwnBackground() const
{
    ColorCount count;
    for (int y = 0; y < m_right.height(); ++y)
        for (int x = 0; x < m_right.width(); ++x)
            if (squared(rowOf(m_right, y)[x], m_background) < 1)
                count.add(rowOf(m_picture, y)[x]);
    constexpr double kMost = 0.5;
    constexpr double kLeastPart = 0.03; // of the picture
    const double pixels = double(m_right.width()) * m_right.height();
    const QRgb other = count.color();
    const bool isKnown = double(count.total()) >= kLeastPart * pixels && count.share() > kMost;
    if (!isKnown || squared(other, m_background) < kUnseen)
        return std::nullopt;
    constexpr double kNear = 24.0 * 24.0;
    PictureComparison comparison = *this;
    for (int y = 0; y < m_right.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(comparison.m_picture.scanLine(y));
        const QRgb* right = rowOf(m_right, y);
        for (int x = 0; x < m_right.width(); ++x)
            if (squared(row[x], other) < kNear && squared(row[x], right[x]) >= kNear)
                row[x] = m_background;
    }
    return comparison;
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

/// How far the picture is from another one at an offset, a pixel; from every `stride`th pixel of the change.
double PictureComparison::distance(const PictureChange& change, std::size_t offset, std::size_t stride) const
{
    const QPoint move = offsets()[offset];
    const Blocks& blocks = blocksAt(offset);
    double changed = 0;
    for (std::size_t i = 0; i < change.pixels.size(); i += stride) {
        const ChangedPixel& pixel = change.pixels[i];
        if (const auto shown = pictureAt(pixel.index, move)) {
            const QRgb right = reinterpret_cast<const QRgb*>(m_right.constBits())[pixel.index];
            changed += capped(*shown, pixel.color) - capped(*shown, right);
        }
    }
    const double count = blocks.countSum[0] + blocks.countSum[1];
    return count > 0 ? (blocks.residual + changed * double(stride)) / count : kWholePixel;
}

PictureFit PictureComparison::fit(const PictureChange& change) const
{
    const std::size_t stride = std::max<std::size_t>(1, change.pixels.size() / kSearched);
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t offset = 0; offset < offsets().size(); ++offset) {
        const double near = distance(change, offset, stride) / offsetFactor(offsets()[offset]);
        if (near < least - 1e-9) {
            best = offset;
            least = near;
        }
    }
    return fitAt(change, best);
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
        fit.gain += weight * std::clamp(way, -1.0, 1.0);
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
        fit.typical[kind] = median(std::move(means));
    }
    return fit;
}

PictureNoise PictureNoise::of(const std::vector<PictureFit>& fits)
{
    PictureNoise noise;
    const auto best = std::ranges::min_element(fits, {}, &PictureFit::residual);
    noise.least = best == fits.end() ? 0 : best->residual;
    for (std::size_t kind = 0; kind < 2; ++kind) {
        const auto least =
            std::ranges::min_element(fits, {}, [kind](const PictureFit& fit) { return fit.typical[kind]; });
        noise.typical[kind] =
            least == fits.end() ? 0 : std::clamp(least->typical[kind], 0.0, kMostNoise[kind] * kWholePixel);
    }
    return noise;
}

namespace
{

/// The standard deviation of the sum over `count` pixels, at most: noise of whole pixels deviates most.
double deviation(double count, double typical) { return std::sqrt(count * typical * kWholePixel); }

} // namespace

double unexplained(const PictureFit& fit, const PictureNoise& noise)
{
    constexpr double kSure = 3; // standard deviations
    double sum = 0;
    for (std::size_t kind = 0; kind < 2; ++kind)
        sum += std::max(0.0, fit.excess[kind] - fit.count[kind] * noise.typical[kind] -
                                 kSure * deviation(fit.count[kind], noise.typical[kind]));
    // No more than the best picture leaves is noise.
    return std::max(sum, fit.residual - noise.least);
}

double scoreOf(const PictureFit& fit, const PictureNoise& noise)
{
    const double whole = fit.weight + unexplained(fit, noise);
    // Where there is noise, some pixels look like anything.
    const double noisy = std::min(1.0, 20 * std::max(noise.typical[0], noise.typical[1]) / kWholePixel);
    const double seen = std::min(1.0, fit.weight / (kLeastWeight + 4 * kWholePixel * noisy));
    return whole > 0 ? std::clamp(offsetFactor(fit.offset) * seen * fit.gain / whole, 0.0, 1.0) : 0;
}

double scoreOfRight(const PictureFit& fit, const PictureNoise& noise, double smallest)
{
    double half = std::min(smallest, 8 * kWholePixel) / 2;
    for (std::size_t kind = 0; kind < 2; ++kind)
        half += deviation(fit.count[kind], noise.typical[kind]) / 2;
    return offsetFactor(fit.offset) * half / (half + unexplained(fit, noise));
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
