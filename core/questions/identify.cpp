#include "core/questions/identify.h"

#include "core/questions/picture_match.h"
#include "core/render/render.h"
#include "core/settings/mistakes.h"

#include <QCryptographicHash>
#include <QJsonArray>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr std::size_t kLeastMatches = 5;
constexpr std::size_t kFirstOfPair = 4; ///< the best single mistakes are tried with others
constexpr double kPairPixels = 1.5e8;   ///< of all pictures with two mistakes
constexpr double kMostPairs = 400;
constexpr double kLargePicture = 20000;     ///< pixels
constexpr double kMostPixels = 4096 * 4096; ///< of a picture that is compared
constexpr double kSureScore = 0.985;        ///< no second mistake is looked for beyond, where there is no noise

QImage drawn(const Scene& scene, const Settings& settings, const std::stop_token& stop)
{
    Frame frame;
    render(scene, settings, frame, {}, stop);
    return frame.image;
}

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

/// A picture that some mistakes draw, and how it fits at each place of the scene in the picture handed in.
struct Candidate {
    QStringList mistakes; ///< ids; those after the first draw the very same picture
    QByteArray print;
    int pixels = 0;
    QRect where;
    std::vector<PictureFit> fits; ///< by place
};

/// The search at one size of the scene.
class Search
{
public:
    enum class Places { Whole, All }; ///< where the scene is looked for in the picture handed in

    Search(const Scene& scene, Settings settings, const QImage& picture, const IdentifyProgress& progress,
           std::stop_token stop)
        : m_scene(scene), m_settings(std::move(settings)), m_picture(picture), m_progress(progress),
          m_stop(std::move(stop))
    {
        m_settings.mistakes.clear();
    }

    /// What one mistake, or none, explains.
    [[nodiscard]] Identification single(Places places);
    /// Tries two mistakes at once where single() has found none that fits, and fills the list.
    void finish(Identification& found);

private:
    void comparePlaces(Places places);
    void drawMistakes();
    void addPicture(const QString& id, const QImage& image);
    void choosePlace();
    void lookForPairs(Identification& found);
    void nameTogether(QStringList pair, const PictureFit& fit, Identification& found);
    [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> pairsToTry() const;
    [[nodiscard]] std::vector<MistakeMatch> matches() const;
    void pad(std::vector<MistakeMatch>& matches) const;
    [[nodiscard]] PictureNoise noiseAt(std::size_t place) const;
    [[nodiscard]] double scoreAt(const Candidate& candidate, std::size_t place, const PictureNoise& noise) const;
    [[nodiscard]] bool isOwnScene(const QString& id) const;
    [[nodiscard]] Settings with(const QStringList& mistakes) const;
    void report();

    const Scene& m_scene;
    Settings m_settings;
    const QImage& m_picture;
    const IdentifyProgress& m_progress;
    std::stop_token m_stop;

    QImage m_right;
    std::vector<QRect> m_places;
    std::vector<PictureComparison> m_comparisons; ///< by place
    std::vector<Candidate> m_candidates;          ///< the right picture first
    std::size_t m_place = 0;                      ///< the best of m_places
    PictureNoise m_noise;                         ///< there
    int m_done = 0;
    int m_total = 0;
};

Settings Search::with(const QStringList& mistakes) const
{
    Settings settings = m_settings;
    settings.mistakes = mistakes;
    return settings;
}

void Search::report()
{
    ++m_done;
    if (m_progress)
        m_progress(std::min(m_done, m_total), m_total);
}

bool Search::isOwnScene(const QString& id) const
{
    const Mistake* mistake = findMistake(id);
    return mistake && m_scene.id == QStringLiteral("builtin:") + QLatin1String(mistake->scene);
}

void Search::comparePlaces(Places places)
{
    m_right = drawn(m_scene, m_settings, m_stop);
    const std::vector<QRect> all =
        places == Places::All ? placesIn(m_picture, m_right) : std::vector<QRect>{m_picture.rect()};
    for (const QRect& place : all) {
        m_places.push_back(place);
        m_comparisons.emplace_back(m_picture, place, m_right, backgroundOf(m_scene));
        if (auto other = m_comparisons.back().withOwnBackground()) {
            m_places.push_back(place);
            m_comparisons.push_back(std::move(*other));
        }
    }
    addPicture(QLatin1String(kNoMistake), m_right);
}

void Search::addPicture(const QString& id, const QImage& image)
{
    QByteArray print = fingerprint(image);
    const auto same = std::ranges::find(m_candidates, print, &Candidate::print);
    if (same != m_candidates.end()) {
        // A mistake that is shown by this very scene stands first.
        const bool first = same != m_candidates.begin() && isOwnScene(id) && !isOwnScene(same->mistakes.first());
        same->mistakes.insert(first ? 0 : same->mistakes.size(), id);
        return;
    }
    Candidate candidate{{id}, std::move(print), 0, {}, {}};
    for (const PictureComparison& comparison : m_comparisons) {
        const PictureChange change = comparison.changeTo(image);
        if (candidate.fits.empty() || comparison.size() == m_right.size()) {
            candidate.pixels = static_cast<int>(change.pixels.size());
            candidate.where = change.box;
        }
        candidate.fits.push_back(comparison.fit(change));
    }
    m_candidates.push_back(std::move(candidate));
}

void Search::drawMistakes()
{
    for (const Mistake& mistake : mistakes()) {
        if (m_stop.stop_requested())
            return;
        const QString id = QLatin1String(mistake.id);
        const Settings settings = with({id});
        if (!unsupported(m_scene, settings))
            addPicture(id, drawn(m_scene, settings, m_stop));
        report();
    }
}

PictureNoise Search::noiseAt(std::size_t place) const
{
    std::vector<PictureFit> fits;
    for (const Candidate& candidate : m_candidates)
        fits.push_back(candidate.fits[place]);
    return PictureNoise::of(fits);
}

double Search::scoreAt(const Candidate& candidate, std::size_t place, const PictureNoise& noise) const
{
    if (&candidate != &m_candidates.front())
        return scoreOf(candidate.fits[place], noise);
    double smallest = 8 * kWholePixel;
    double best = 0; // of the mistakes that leave less
    for (const Candidate& other : m_candidates) {
        if (&other == &candidate)
            continue;
        if (other.fits[place].weight >= kWholePixel)
            smallest = std::min(smallest, other.fits[place].weight);
        if (other.fits[place].residual < candidate.fits[place].residual)
            best = std::max(best, scoreOf(other.fits[place], noise));
    }
    // A mistake of low contrast may be all there is.
    return std::min(scoreOfRight(candidate.fits[place], noise, smallest), 1 - best);
}

void Search::choosePlace()
{
    constexpr double kBetter = 0.02; // than a place that is likelier by itself
    double best = -1;
    for (std::size_t place = 0; place < m_places.size(); ++place) {
        const PictureNoise noise = noiseAt(place);
        double score = 0;
        for (const Candidate& candidate : m_candidates)
            score = std::max(score, scoreAt(candidate, place, noise));
        if (score > best + kBetter) {
            best = score;
            m_place = place;
            m_noise = noise;
        }
    }
}

std::vector<MistakeMatch> Search::matches() const
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
            found.push_back(
                {id, score, candidate.pixels, candidate.where, candidate.fits[m_place].unlike, std::move(alike), {}});
        }
    }
    std::ranges::stable_sort(found, std::ranges::greater{}, &MistakeMatch::score);
    return found;
}

/// Mistakes that change nothing fill the list.
void Search::pad(std::vector<MistakeMatch>& matches) const
{
    const Candidate& right = m_candidates.front();
    for (qsizetype i = 1; i < right.mistakes.size() && matches.size() < kLeastMatches; ++i) {
        MistakeMatch& match = matches.emplace_back();
        match.mistake = right.mistakes[i];
        match.unlike = right.fits[m_place].unlike;
        match.alike = right.mistakes;
        match.alike.removeAll(match.mistake);
    }
}

/// Pairs of candidates, the most promising first: one of the best, and one that the picture has much of.
std::vector<std::pair<std::size_t, std::size_t>> Search::pairsToTry() const
{
    std::vector<std::size_t> byScore;
    std::vector<std::size_t> byShare;
    for (std::size_t i = 1; i < m_candidates.size(); ++i) {
        byScore.push_back(i);
        byShare.push_back(i);
    }
    std::ranges::stable_sort(byScore, std::ranges::greater{},
                             [this](std::size_t i) { return scoreAt(m_candidates[i], m_place, m_noise); });
    std::ranges::stable_sort(byShare, std::ranges::greater{}, [this](std::size_t i) {
        const PictureFit& fit = m_candidates[i].fits[m_place];
        return fit.weight > 0 ? fit.gain / fit.weight : -1;
    });
    const double most = std::min(kMostPairs, kPairPixels / (double(m_right.width()) * m_right.height()));
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

void Search::lookForPairs(Identification& found)
{
    const auto residualOf = [this](const Candidate& candidate) { return candidate.fits[m_place].residual; };
    const double alone = residualOf(*std::ranges::min_element(m_candidates, {}, residualOf));
    // Noise takes its part of the change as well. In small pictures it cannot be told from a second mistake.
    const double noisy = 1.5 * std::max(m_noise.typical[0], m_noise.typical[1]) / kWholePixel;
    const bool isSure = found.matches.front().score >= (kSureScore - noisy) * offsetFactor(found.offset);
    const bool isLarge = double(m_right.width()) * m_right.height() > kLargePicture;
    if (alone < 2 * kWholePixel || (isSure && isLarge))
        return;
    const auto pairs = pairsToTry();
    m_total = m_done + static_cast<int>(pairs.size());
    const PictureComparison& comparison = m_comparisons[m_place];
    constexpr double kMuch = 0.6; // of what one mistake leaves, or less, two have to leave
    double least = std::min(kMuch * alone, alone - 2 * kWholePixel);
    QStringList bestPair;
    PictureFit bestFit;
    for (const auto& [first, second] : pairs) {
        if (m_stop.stop_requested())
            return;
        const QStringList ids{m_candidates[first].mistakes.first(), m_candidates[second].mistakes.first()};
        const Settings settings = with(ids);
        if (!unsupported(m_scene, settings)) {
            const PictureFit fit = comparison.fit(comparison.changeTo(drawn(m_scene, settings, m_stop)));
            if (fit.residual < least) {
                least = fit.residual;
                bestPair = ids;
                bestFit = fit;
            }
        }
        report();
    }
    if (!bestPair.isEmpty())
        nameTogether(bestPair, bestFit, found);
}

/// Puts two mistakes first; what the others leave beyond these two counts against them.
void Search::nameTogether(QStringList pair, const PictureFit& fit, Identification& found)
{
    m_noise.least = fit.residual;
    for (std::size_t kind = 0; kind < 2; ++kind)
        m_noise.typical[kind] = std::min(m_noise.typical[kind], fit.typical[kind]);
    found.matches = matches();
    found.offset = fit.offset;
    const double score = scoreOf(fit, m_noise);
    const auto matchOf = [&found](const QString& id) {
        return std::ranges::find(found.matches, id, &MistakeMatch::mistake);
    };
    std::ranges::stable_sort(pair, std::ranges::greater{}, [&](const QString& id) { return matchOf(id)->score; });
    for (MistakeMatch& match : found.matches)
        match.score = std::min(match.score, score);
    for (qsizetype i = pair.size() - 1; i >= 0; --i) {
        const auto match = matchOf(pair[i]);
        match->score = score;
        match->unlike = fit.unlike;
        match->with = pair[1 - i];
        std::rotate(found.matches.begin(), match, match + 1);
    }
}

Identification Search::single(Places places)
{
    m_total = static_cast<int>(mistakes().size());
    comparePlaces(places);
    drawMistakes();
    Identification found;
    if (m_stop.stop_requested())
        return found;
    choosePlace();
    found.matches = matches();
    found.settings = m_settings;
    found.place = m_places[m_place];
    const auto best = std::ranges::find_if(m_candidates, [&](const Candidate& candidate) {
        return candidate.mistakes.contains(found.matches.front().mistake);
    });
    found.offset = best->fits[m_place].offset;
    const QImage& picture = m_comparisons[m_place].picture();
    found.picture = picture.size() == m_right.size() ? picture : picture.scaled(m_right.size());
    return found;
}

void Search::finish(Identification& found)
{
    lookForPairs(found);
    pad(found.matches);
}

QJsonArray jsonOf(const QRect& rect)
{
    return rect.isEmpty() ? QJsonArray{0, 0, 0, 0} : QJsonArray{rect.x(), rect.y(), rect.width(), rect.height()};
}

} // namespace

std::optional<Reason> whyNotIdentified(const QImage& picture, const Settings& settings)
{
    for (const QSize& size : {picture.size(), settings.size})
        if (double(size.width()) * size.height() > kMostPixels)
            return Reason{QT_TRANSLATE_NOOP("Diagnostic", "%1 x %2 pixels are too many to compare; at most %3 million"),
                          {size.width(), size.height(), static_cast<int>(kMostPixels / 1e6)}};
    return std::nullopt;
}

Identification identify(const Scene& scene, const Settings& settings, const QImage& picture,
                        const IdentifyProgress& progress, const std::stop_token& stop)
{
    // All of the picture at the size of the scene; parts of it; the scene at the size of the picture.
    constexpr double kGood = 0.9;
    auto search = std::make_unique<Search>(scene, settings, picture, progress, stop);
    Identification found = search->single(Search::Places::Whole);
    const auto tryOther = [&](const Settings& other, Search::Places places) {
        if (stop.stop_requested() || found.matches.front().score >= kGood || unsupported(scene, other))
            return;
        auto next = std::make_unique<Search>(scene, other, picture, progress, stop);
        Identification better = next->single(places);
        if (stop.stop_requested() || better.matches.front().score <= found.matches.front().score)
            return;
        found = std::move(better);
        search = std::move(next);
    };
    tryOther(settings, Search::Places::All);
    Settings inItsSize = settings;
    inItsSize.mistakes.clear();
    inItsSize.size = picture.size();
    if (picture.size() != settings.size)
        tryOther(inItsSize, Search::Places::Whole);
    if (!stop.stop_requested())
        search->finish(found);
    return found;
}

Settings settingsOf(const MistakeMatch& match, const Identification& found)
{
    Settings settings = found.settings;
    if (match.mistake != QLatin1String(kNoMistake))
        settings.mistakes = QStringList{match.mistake};
    if (!match.with.isEmpty())
        settings.mistakes << match.with;
    return settings;
}

QJsonObject toJson(const Identification& found)
{
    QJsonArray matches;
    for (const MistakeMatch& match : found.matches) {
        QJsonObject row{{"mistake", match.mistake}, {"score", match.score},
                        {"pixels", match.pixels},   {"where", jsonOf(match.where)},
                        {"unlike", match.unlike},   {"alike", QJsonArray::fromStringList(match.alike)}};
        if (!match.with.isEmpty())
            row["with"] = match.with;
        matches.append(row);
    }
    return {{"matches", matches},
            {"fits", found.fits()},
            {"size", QJsonArray{found.settings.size.width(), found.settings.size.height()}},
            {"place", jsonOf(found.place)},
            {"offset", QJsonArray{found.offset.x(), found.offset.y()}}};
}

} // namespace rasterlens
