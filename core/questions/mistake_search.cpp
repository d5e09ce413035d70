#include "core/questions/mistake_search.h"

#include "core/settings/mistakes.h"

#include <QBuffer>
#include <QCryptographicHash>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace rasterlens
{
namespace
{

constexpr std::size_t kLeastMatches = 5;
constexpr std::size_t kFirstOfPair = 4; ///< the best single mistakes are tried with others
constexpr double kPairPixels = 6e7;     ///< of all pictures with two mistakes
constexpr double kMostPairs = 400;
constexpr double kLargePicture = 20000; ///< pixels
constexpr int kBestQuality = 98;        ///< of a JPEG that differs from the picture it was made of
constexpr int kLeastQuality = 50;
constexpr double kRoundedScore = 0.95; ///< of the right picture, if pixels had to be rounded otherwise
constexpr double kRoundedPrice = 0.2;  ///< what such a pixel costs, of a wrong one

QByteArray fingerprint(const QImage& image)
{
    QCryptographicHash hash(QCryptographicHash::Md5);
    for (int y = 0; y < image.height(); ++y)
        hash.addData(QByteArrayView(image.constScanLine(y), qsizetype(image.width()) * 4));
    return hash.result();
}

QRgb backgroundOf(const Scene& scene)
{
    const auto channel = [](float value) { return static_cast<int>(std::lround(255 * std::clamp(value, 0.0F, 1.0F))); };
    return qRgb(channel(scene.background.r), channel(scene.background.g), channel(scene.background.b));
}

/// The picture after it has been a JPEG.
QImage throughJpeg(const QImage& image, int quality)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    const bool isWritten = image.save(&buffer, "jpg", quality);
    const QImage read = QImage::fromData(bytes, "jpg");
    return isWritten && read.size() == image.size() ? read.convertToFormat(QImage::Format_RGB32) : image;
}

struct Difference {
    int pixels = 0;
    QRect box;
};

Difference differenceOf(const QImage& a, const QImage& b)
{
    Difference difference;
    for (int y = 0; y < a.height(); ++y) {
        const auto* rowA = reinterpret_cast<const QRgb*>(a.constScanLine(y));
        const auto* rowB = reinterpret_cast<const QRgb*>(b.constScanLine(y));
        int first = -1;
        int last = -1;
        for (int x = 0; x < a.width(); ++x)
            if ((rowA[x] ^ rowB[x]) & 0xffffffU) {
                ++difference.pixels;
                first = first < 0 ? x : first;
                last = x;
            }
        if (first >= 0)
            difference.box |= QRect(QPoint(first, y), QPoint(last, y));
    }
    return difference;
}

} // namespace

MistakeSearch::MistakeSearch(SceneDrawings& drawings, const QImage& picture, int quality,
                             const IdentifyProgress& progress, std::stop_token stop)
    : m_drawings(drawings), m_picture(picture), m_quality(quality), m_progress(progress), m_stop(std::move(stop))
{
}

void MistakeSearch::report()
{
    ++m_done;
    if (m_progress)
        m_progress(std::min(m_done, m_total), m_total);
}

bool MistakeSearch::isOwnScene(const QString& id) const
{
    const Mistake* mistake = findMistake(id);
    return mistake && m_drawings.scene().id == QStringLiteral("builtin:") + QLatin1String(mistake->scene);
}

/// What is drawn, as the picture handed in would show it.
QImage MistakeSearch::worn(const QImage& image) const
{
    return m_quality > 0 && !image.isNull() ? throughJpeg(image, m_quality) : image;
}

int MistakeSearch::jpegQuality() const
{
    constexpr double kLess = 0.6; // of what a picture leaves that has been no JPEG
    const auto leaves = [](const Candidate& candidate) { return leavesOf(candidate.fits.front()); };
    const Candidate& best = *std::ranges::min_element(m_candidates, {}, leaves);
    const bool isRight = &best == &m_candidates.front();
    const QImage image = m_drawings.of(isRight ? QStringList() : best.mistakes.mid(0, 1));
    if (image.size() != m_picture.size())
        return 0;
    // The middle of the picture tells as much, if it is cut where blocks of a JPEG begin.
    constexpr int kBlock = 16;
    constexpr int kMost = 256;
    const auto start = [](int length) { return std::max(0, (length - kMost) / 2 / kBlock * kBlock); };
    const QRect middle = image.rect() & QRect(start(image.width()), start(image.height()), kMost, kMost);
    const QImage part = image.copy(middle);
    const PictureComparison comparison(m_picture.copy(middle), part.rect(), part, backgroundOf(m_drawings.scene()));
    double least = kLess * comparison.leaves(part);
    int found = 0;
    for (int quality = kBestQuality; quality >= kLeastQuality && !m_stop.stop_requested(); --quality) {
        const double left = comparison.leaves(throughJpeg(part, quality));
        if (left < least) {
            least = left;
            found = quality;
        }
    }
    return found;
}

void MistakeSearch::comparePlaces(Places places)
{
    const std::vector<QImage>& rights = m_drawings.rights();
    const std::vector<QRect> all =
        places == Places::All ? placesIn(m_picture, rights.front()) : std::vector<QRect>{m_picture.rect()};
    const auto add = [&](const QRect& place, PictureComparison comparison) {
        m_places.push_back(place);
        std::vector<PictureComparison>& ofPlace = m_comparisons.emplace_back();
        for (std::size_t i = 1; i < rights.size(); ++i)
            ofPlace.push_back(comparison.withRight(worn(rights[i])));
        ofPlace.insert(ofPlace.begin(), std::move(comparison));
    };
    for (const QRect& place : all) {
        PictureComparison comparison(m_picture, place, worn(rights.front()), backgroundOf(m_drawings.scene()));
        auto other = comparison.withOwnBackground();
        add(place, std::move(comparison));
        if (other)
            add(place, std::move(*other));
    }
    Candidate none{{QLatin1String(kNoMistake)}, Program::Own, fingerprint(rights.front()), 0, {}, {}};
    for (const std::vector<PictureComparison>& ofPlace : m_comparisons) {
        std::vector<PictureFit> fits;
        for (const PictureComparison& comparison : ofPlace)
            fits.push_back(comparison.fit({}));
        none.fits.push_back(*std::ranges::min_element(fits, {}, &PictureFit::residual));
    }
    m_candidates.push_back(std::move(none));
}

std::size_t MistakeSearch::nearestRight(const QImage& image) const
{
    const std::vector<QImage>& rights = m_drawings.rights();
    const auto distance = [&image](const QImage& right) { return differenceOf(image, right).pixels; };
    return rights.size() == 1 ? 0 : std::size_t(std::ranges::min_element(rights, {}, distance) - rights.begin());
}

/// What a picture changes is counted against that right picture which it is most like.
std::vector<PictureFit> MistakeSearch::fitsOf(const QImage& image, Program program) const
{
    PictureFit unknown;
    unknown.residual = std::numeric_limits<double>::infinity();
    unknown.typical = {unknown.residual, unknown.residual};
    const std::size_t right = nearestRight(image);
    const QImage shown = worn(image);
    std::vector<PictureFit> fits;
    for (std::size_t place = 0; place < m_places.size(); ++place) {
        const PictureComparison& comparison = m_comparisons[place][right];
        const bool isLooked = program == Program::Own || place == 0 || place == m_place;
        fits.push_back(isLooked ? comparison.fit(comparison.changeTo(shown)) : unknown);
    }
    return fits;
}

void MistakeSearch::addPicture(const QString& id, const QImage& image, Program program)
{
    const std::vector<QImage>& rights = m_drawings.rights();
    if (std::ranges::find(rights, image) != rights.end()) {
        if (program == Program::Own)
            m_candidates.front().mistakes << id;
        return;
    }
    QByteArray print = fingerprint(image);
    const auto same = std::ranges::find(m_candidates, print, &Candidate::print);
    if (same != m_candidates.end()) {
        // A mistake that is shown by this very scene stands first.
        const bool first = isOwnScene(id) && !isOwnScene(same->mistakes.first());
        if (same->program == program)
            same->mistakes.insert(first ? 0 : same->mistakes.size(), id);
        return;
    }
    const Difference difference = differenceOf(image, rights.front());
    m_candidates.push_back(
        {{id}, program, std::move(print), difference.pixels, difference.box, fitsOf(image, program)});
}

void MistakeSearch::drawMistakes(Program program)
{
    m_total = m_done + static_cast<int>(mistakes().size());
    for (const Mistake& mistake : mistakes()) {
        if (m_stop.stop_requested())
            return;
        const QString id = QLatin1String(mistake.id);
        if (const QImage image = m_drawings.of({id}, program); !image.isNull())
            addPicture(id, image, program);
        report();
    }
}

PictureNoise MistakeSearch::noiseAt(std::size_t place) const
{
    std::vector<PictureFit> fits;
    for (const Candidate& candidate : m_candidates)
        fits.push_back(candidate.fits[place]);
    if (const PictureFit* rounded = roundedAt(place))
        fits.push_back(*rounded);
    return PictureNoise::of(fits);
}

const PictureFit* MistakeSearch::roundedAt(std::size_t place) const
{
    return m_rounded && m_rounded->place == place ? &m_rounded->fit : nullptr;
}

/// What the right picture leaves; a pixel that had to be rounded otherwise costs something.
double MistakeSearch::rightLeaves(std::size_t place) const
{
    const double plain = leavesOf(m_candidates.front().fits[place]);
    const PictureFit* rounded = roundedAt(place);
    return rounded ? std::min(plain, leavesOf(*rounded) + kRoundedPrice * m_rounded->freedom) : plain;
}

/// The score of the right picture by itself.
double MistakeSearch::scoreOfRightAt(std::size_t place, const PictureNoise& noise) const
{
    double smallest = 8 * kWholePixel;
    for (std::size_t i = 1; i < m_candidates.size(); ++i)
        if (const double weight = m_candidates[i].fits[place].weight; weight >= kWholePixel)
            smallest = std::min(smallest, weight);
    const double plain = scoreOfRight(m_candidates.front().fits[place], noise, smallest);
    const PictureFit* rounded = roundedAt(place);
    return rounded ? std::max(plain, kRoundedScore * scoreOfRight(*rounded, noise, smallest)) : plain;
}

/// The score of a candidate beside the others. Where the right picture leaves more than a mistake, or a mistake more
/// than the right picture, it has at most what the other one lacks; a mistake that leaves more fits less than half.
double MistakeSearch::scoreAt(const Candidate& candidate, std::size_t place, const PictureNoise& noise) const
{
    const double rightResidual = rightLeaves(place);
    const double right = scoreOfRightAt(place, noise);
    if (&candidate != &m_candidates.front()) {
        const double score = candidate.trust * scoreOf(candidate.fits[place], noise);
        const double leaves = leavesOf(candidate.fits[place]);
        return leaves > rightResidual ? std::min({score, 1 - right, rightResidual / leaves / 2}) : score;
    }
    double best = 0; // of the mistakes that leave less
    for (std::size_t i = 1; i < m_candidates.size(); ++i)
        if (leavesOf(m_candidates[i].fits[place]) < rightResidual)
            best = std::max(best, m_candidates[i].trust * scoreOf(m_candidates[i].fits[place], noise));
    return std::min(right, 1 - best);
}

void MistakeSearch::choosePlace()
{
    constexpr double kBetter = 0.02; // than a place that is likelier by itself
    double best = -1;
    for (std::size_t place = 0; place < m_places.size(); ++place) {
        const PictureNoise noise = noiseAt(place);
        double score = 0;
        for (const Candidate& candidate : m_candidates)
            score = std::max(score, scoreAt(candidate, place, noise));
        if (score > best + std::min(kBetter, (1 - best) / 2)) {
            best = score;
            m_place = place;
            m_noise = noise;
        }
    }
}

/// Lets each pixel be as any right program draws it, also one that rounds by a hundredth of a pixel otherwise.
void MistakeSearch::roundRight()
{
    const PictureFit& plain = m_candidates.front().fits[m_place];
    if (plain.residual <= 0 || m_stop.stop_requested())
        return;
    std::vector<QImage> pictures;
    for (const std::vector<QImage>& images : {m_drawings.rights(), m_drawings.nudged({})})
        for (const QImage& image : images)
            pictures.push_back(worn(image));
    const PictureComparison& comparison = m_comparisons[m_place].front();
    QImage picture = comparison.nearest(pictures, plain.offset);
    const PictureFit fit = comparison.withRight(picture).fit({});
    m_rounded = Rounded{std::move(picture), fit, std::max(0.0, plain.residual - fit.residual), m_place};
    m_noise = noiseAt(m_place);
}

/// Lets the pixels of the likeliest mistakes be rounded otherwise, as those of the right picture.
void MistakeSearch::roundMistakes()
{
    constexpr std::size_t kMost = 4;
    constexpr double kLeast = 0.3;
    constexpr double kOtherScene = 0.99; // a mistake that the scene was made for is likelier by a little
    if (!roundedAt(m_place))
        return;
    const auto score = [this](const Candidate& candidate) { return scoreAt(candidate, m_place, m_noise); };
    std::vector<std::pair<double, Candidate*>> best;
    for (std::size_t i = 1; i < m_candidates.size(); ++i)
        best.emplace_back(-score(m_candidates[i]), &m_candidates[i]);
    std::ranges::sort(best);
    best.resize(std::min(best.size(), kMost));
    const PictureComparison comparison = m_comparisons[m_place].front().withRight(m_rounded->picture);
    for (const auto& [negative, candidate] : best) {
        if (-negative < kLeast || m_stop.stop_requested())
            break;
        const QStringList ids = candidate->mistakes.mid(0, 1);
        std::vector<QImage> pictures{worn(m_drawings.of(ids, candidate->program))};
        for (const QImage& image : m_drawings.nudged(ids))
            pictures.push_back(worn(image));
        PictureFit& fit = candidate->fits[m_place];
        PictureFit rounded = comparison.fit(comparison.changeTo(comparison.nearest(pictures, fit.offset)));
        rounded.residual += kRoundedPrice * std::max(0.0, fit.residual - rounded.residual);
        const double trust = kRoundedScore * (isOwnScene(ids.first()) ? 1 : kOtherScene);
        if (trust * scoreOf(rounded, m_noise) > scoreOf(fit, m_noise)) {
            fit = rounded;
            candidate->trust = trust;
        }
    }
    m_noise = noiseAt(m_place);
}

std::vector<MistakeMatch> MistakeSearch::matches() const
{
    std::vector<MistakeMatch> found;
    for (const Candidate& candidate : m_candidates) {
        const bool isRight = &candidate == &m_candidates.front();
        const double score = scoreAt(candidate, m_place, m_noise);
        for (const QString& id : candidate.mistakes) {
            if (isRight && id != QLatin1String(kNoMistake))
                break; // mistakes that change nothing here
            QStringList alike = candidate.mistakes;
            alike.removeAll(id);
            MistakeMatch match{
                id, score, candidate.pixels, candidate.where, candidate.fits[m_place].unlike, std::move(alike), {}};
            const auto known = std::ranges::find(found, id, &MistakeMatch::mistake); // as another program draws it
            if (known == found.end())
                found.push_back(std::move(match));
            else if (known->score < score)
                *known = std::move(match);
        }
    }
    if (const PictureFit* rounded = roundedAt(m_place))
        found.front().unlike = std::min(found.front().unlike, rounded->unlike);
    std::ranges::stable_sort(found, std::ranges::greater{}, &MistakeMatch::score);
    return found;
}

/// Mistakes that change nothing fill the list.
void MistakeSearch::pad(std::vector<MistakeMatch>& matches) const
{
    const Candidate& right = m_candidates.front();
    for (qsizetype i = 1; i < right.mistakes.size() && matches.size() < kLeastMatches; ++i) {
        const bool isNamed = std::ranges::find(matches, right.mistakes[i], &MistakeMatch::mistake) != matches.end();
        if (isNamed)
            continue;
        MistakeMatch& match = matches.emplace_back();
        match.mistake = right.mistakes[i];
        match.unlike = right.fits[m_place].unlike;
        match.alike = right.mistakes;
        match.alike.removeAll(match.mistake);
    }
}

/// The fit of the candidate that scores highest.
const PictureFit& MistakeSearch::bestFit() const
{
    const auto best = std::ranges::max_element(
        m_candidates, {}, [this](const Candidate& candidate) { return scoreAt(candidate, m_place, m_noise); });
    const PictureFit* rounded = roundedAt(m_place);
    return best == m_candidates.begin() && rounded ? *rounded : best->fits[m_place];
}

double MistakeSearch::bestScore() const
{
    double best = 0;
    for (const Candidate& candidate : m_candidates)
        best = std::max(best, scoreAt(candidate, m_place, m_noise));
    return best;
}

bool MistakeSearch::isSure() const
{
    constexpr double kGood = 0.9;
    return bestScore() >= kGood && leavesOnlyNoise(bestFit(), m_noise, m_candidates.front().fits[m_place].unlike);
}

double MistakeSearch::leastResidual() const
{
    double least = rightLeaves(m_place);
    for (const Candidate& candidate : m_candidates)
        least = std::min(least, candidate.fits[m_place].residual);
    return least;
}

/// Pairs of candidates, the most promising first: one of the best, and one that the picture has much of.
std::vector<std::pair<std::size_t, std::size_t>> MistakeSearch::pairsToTry() const
{
    std::vector<std::size_t> byScore;
    std::vector<std::size_t> byShare;
    for (std::size_t i = 1; i < m_candidates.size(); ++i)
        if (m_candidates[i].program == Program::Own) {
            byScore.push_back(i);
            byShare.push_back(i);
        }
    std::ranges::stable_sort(byScore, std::ranges::greater{},
                             [this](std::size_t i) { return scoreAt(m_candidates[i], m_place, m_noise); });
    std::ranges::stable_sort(byShare, std::ranges::greater{}, [this](std::size_t i) {
        const PictureFit& fit = m_candidates[i].fits[m_place];
        return fit.weight > 0 ? fit.gain / fit.weight : -1;
    });
    const QSize size = m_drawings.settings().size;
    const double most = std::min(kMostPairs, kPairPixels / (double(size.width()) * size.height()));
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const std::size_t second : byShare)
        for (std::size_t k = 0; k < std::min(kFirstOfPair, byScore.size()); ++k) {
            const std::pair<std::size_t, std::size_t> pair(byScore[k], second);
            const bool isKnown = std::ranges::find(pairs, std::pair(pair.second, pair.first)) != pairs.end();
            if (pair.first != pair.second && !isKnown && double(pairs.size()) < most)
                pairs.push_back(pair);
        }
    return pairs;
}

/// The two mistakes that leave least at the present place.
std::optional<MistakeSearch::Pair> MistakeSearch::bestPair()
{
    const double alone = leastResidual();
    constexpr double kMuch = 0.6; // of what one mistake leaves, or less, two have to leave
    double least = std::min(kMuch * alone, alone - 2 * kWholePixel);
    const auto pairs = pairsToTry();
    m_total = m_done + static_cast<int>(pairs.size());
    const PictureComparison& comparison = m_comparisons[m_place].front();
    std::optional<Pair> best;
    for (const auto& [first, second] : pairs) {
        if (m_stop.stop_requested())
            return best;
        const QStringList ids{m_candidates[first].mistakes.first(), m_candidates[second].mistakes.first()};
        if (const QImage image = m_drawings.of(ids); !image.isNull()) {
            const PictureFit fit = comparison.fit(comparison.changeTo(worn(image)));
            if (fit.residual < least) {
                least = fit.residual;
                best = Pair{ids, fit, fit.residual / alone};
            }
        }
        report();
    }
    return best;
}

void MistakeSearch::lookForPairs(Identification& found)
{
    const std::size_t place = m_place;
    std::optional<Pair> best = bestPair();
    const QSize size = m_drawings.settings().size;
    if (place != 0 && double(size.width()) * size.height() <= kLargePicture) {
        // In small pictures a border is easily seen where there is none.
        m_place = 0;
        m_noise = noiseAt(m_place);
        std::optional<Pair> whole = bestPair();
        if (whole && (!best || whole->share < best->share)) {
            best = std::move(whole);
        } else {
            m_place = place;
            m_noise = noiseAt(m_place);
        }
    }
    if (best && !m_stop.stop_requested()) {
        fill(found);
        nameTogether(std::move(*best), found);
    }
}

/// Puts two mistakes first; what the others leave beyond these two counts against them.
void MistakeSearch::nameTogether(Pair pair, Identification& found)
{
    m_noise.least = pair.fit.residual;
    for (std::size_t kind = 0; kind < 2; ++kind)
        m_noise.typical[kind] = std::min(m_noise.typical[kind], pair.fit.typical[kind]);
    found.matches = matches();
    found.offset = pair.fit.offset;
    const double score = scoreOf(pair.fit, m_noise);
    const auto matchOf = [&found](const QString& id) {
        return std::ranges::find(found.matches, id, &MistakeMatch::mistake);
    };
    std::ranges::stable_sort(pair.mistakes, std::ranges::greater{},
                             [&](const QString& id) { return matchOf(id)->score; });
    for (MistakeMatch& match : found.matches)
        match.score = std::min(match.score, score);
    for (qsizetype i = pair.mistakes.size() - 1; i >= 0; --i) {
        const auto match = matchOf(pair.mistakes[i]);
        match->score = score;
        match->unlike = pair.fit.unlike;
        match->with = pair.mistakes[1 - i];
        std::rotate(found.matches.begin(), match, match + 1);
    }
}

/// Writes down what has been found at the best place.
void MistakeSearch::fill(Identification& found) const
{
    found.matches = matches();
    found.settings = m_drawings.settings();
    found.place = m_places[m_place];
    found.offset = bestFit().offset;
    const QImage& picture = m_comparisons[m_place].front().picture();
    found.picture = picture.size() == found.settings.size ? picture : picture.scaled(found.settings.size);
}

Identification MistakeSearch::single(Places places)
{
    comparePlaces(places);
    drawMistakes(Program::Own);
    Identification found;
    if (m_stop.stop_requested())
        return found;
    choosePlace();
    roundRight();
    fill(found);
    return found;
}

void MistakeSearch::finish(Identification& found)
{
    if (!isSure()) {
        drawMistakes(Program::Doubles);
        if (m_stop.stop_requested())
            return;
        choosePlace();
        if (!roundedAt(m_place))
            roundRight();
        roundMistakes();
        fill(found);
        if (!isSure())
            lookForPairs(found);
    }
    pad(found.matches);
}

} // namespace rasterlens
