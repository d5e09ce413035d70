#include "core/questions/identify.h"

#include "core/questions/mistake_search.h"
#include "core/render/render.h"

#include <QJsonArray>

#include <memory>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr double kMostPixels = 4096 * 4096; ///< of a picture that is compared

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
    // All of the picture at the size of the scene, as a JPEG as well; parts of it; the scene at the size of the
    // picture.
    auto drawings = std::make_unique<SceneDrawings>(scene, settings, stop);
    auto search = std::make_unique<MistakeSearch>(*drawings, picture, 0, progress, stop);
    Identification found = search->single(MistakeSearch::Places::Whole);
    const auto isEnough = [&] { return stop.stop_requested() || search->isSure(); };
    const auto take = [&](std::unique_ptr<MistakeSearch> next, MistakeSearch::Places places) {
        Identification better = next->single(places);
        if (stop.stop_requested() || better.matches.front().score <= found.matches.front().score)
            return false;
        found = std::move(better);
        search = std::move(next);
        return true;
    };
    const int quality = isEnough() ? 0 : search->jpegQuality();
    if (quality > 0)
        take(std::make_unique<MistakeSearch>(*drawings, picture, quality, progress, stop),
             MistakeSearch::Places::Whole);
    if (!isEnough())
        take(std::make_unique<MistakeSearch>(*drawings, picture, 0, progress, stop), MistakeSearch::Places::All);
    Settings inItsSize = settings;
    inItsSize.mistakes.clear();
    inItsSize.size = picture.size();
    if (picture.size() != settings.size && !unsupported(scene, inItsSize) && !isEnough()) {
        auto others = std::make_unique<SceneDrawings>(scene, inItsSize, stop);
        if (take(std::make_unique<MistakeSearch>(*others, picture, 0, progress, stop), MistakeSearch::Places::Whole))
            drawings = std::move(others);
    }
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
