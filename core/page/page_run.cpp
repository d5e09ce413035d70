#include "core/page/page_run.h"

#include "core/observe/step_text.h"
#include "core/questions/empty_picture.h"
#include "core/questions/why.h"

#include <QByteArray>
#include <QImage>

#include <cmath>

namespace rasterlens
{
namespace
{

/// Faces times pixels for which cards are made, of all pixels or of none but those asked for: some seconds.
constexpr std::size_t kMostCardWork = 400'000;
constexpr std::size_t kMostCards = 4096;

/// JSON knows no infinities: those are text.
QJsonValue number(double value) { return std::isfinite(value) ? QJsonValue(value) : QJsonValue(fullNumber(value)); }

QJsonArray stepWordsJson(const StepLog& log, std::size_t i, PageWords& words, PageTables& tables)
{
    const auto [english, chinese] = inBothLanguages(words, [&] { return words.step(log, i); });
    return {tables.texts.add({english.title, chinese.title}), tables.texts.add({english.sentence, chinese.sentence}),
            tables.texts.add({english.formula, chinese.formula}), tables.addCode(english, chinese), english.line};
}

/// What a step of a run counts up to: tested, covered, passed, failed, written, hit twice.
QJsonArray countsAt(const StepLog& log, std::size_t position)
{
    const Statistics::Pixels pixels = log.countersAt(position).pixels;
    QJsonArray counts;
    for (const std::uint64_t count :
         {pixels.tested, pixels.covered, pixels.depthPassed, pixels.depthFailed, pixels.written, pixels.coveredTwice})
        counts << static_cast<qint64>(count);
    return counts;
}

/// A pair of [event, sample, colour, depth] for each change of a sample.
QJsonArray changesJson(const StepLog& log)
{
    QJsonArray changes;
    for (std::size_t i = 0; i < log.size(); ++i)
        for (std::size_t e = log.effectsAt(i); e < log.effectsAt(i + 1); ++e) {
            const StepEffect& effect = log.effects()[e];
            changes << QJsonArray{static_cast<qint64>(i), static_cast<qint64>(effect.sample),
                                  colorText(effect.after.pixel.color), number(double(effect.after.pixel.depth))};
        }
    return changes;
}

QJsonObject cardJson(const WhyReport& report, PageWords& words, PageTables& tables)
{
    const auto [english, chinese] = inBothLanguages(words, [&] { return words.card(report); });
    TextTable& texts = tables.texts;
    QJsonArray faces;
    for (std::size_t i = 0; i < english.faces.size(); ++i) {
        const PageFaceWords& en = english.faces[i];
        const PageFaceWords& zh = chinese.faces[i];
        faces << QJsonObject{{"name", texts.add({en.name, zh.name})},
                             {"verdict", texts.add({en.verdict, zh.verdict})},
                             {"seen", en.seen},
                             {"details", texts.add(en.details, zh.details)}};
    }
    return {{"answer", texts.add({english.answer, chinese.answer})},
            {"samples", texts.add(english.samples, chinese.samples)},
            {"faces", faces}};
}

/// The cards of all pixels of a small picture, else of those that are asked for.
QJsonObject cardsJson(const Scene& scene, const Settings& settings, const std::optional<QPoint>& asked,
                      PageWords& words, PageTables& tables)
{
    QJsonObject cards;
    const auto add = [&](int x, int y) {
        cards.insert(QStringLiteral("%1,%2").arg(x).arg(y), cardJson(why(scene, settings, x, y), words, tables));
    };
    const auto pixels = static_cast<std::size_t>(settings.size.width()) * std::size_t(settings.size.height());
    const bool hasAll = pixels <= kMostCards && pixels * (1 + scene.mesh.faceCount()) <= kMostCardWork;
    if (hasAll)
        for (int y = 0; y < settings.size.height(); ++y)
            for (int x = 0; x < settings.size.width(); ++x)
                add(x, y);
    else if (asked)
        add(asked->x(), asked->y());
    return cards;
}

/// What all runs have.
QJsonObject frameJson(const Scene& scene, const Settings& settings, const StepLog& log, PageWords& words,
                      PageTables& tables)
{
    QJsonArray mistakes;
    for (const Mistake* mistake : log.mistakes())
        mistakes << tables.texts.add(textInBoth(words, [&] { return words.mistake(*mistake); }));
    return {{"scene", tables.texts.add(textInBoth(words, [&] { return words.sceneTitle(scene); }))},
            {"note", tables.texts.add(textInBoth(words, [&] { return words.sceneNote(scene); }))},
            {"width", settings.size.width()},
            {"height", settings.size.height()},
            {"columns", log.columns()},
            {"rows", log.rows()},
            {"grid", log.grid()},
            {"pattern", log.rules().patternSamples},
            {"linear", log.rules().resolveLight == ResolveLight::Linear},
            {"samples", static_cast<qint64>(log.sampleCount())},
            {"clear", QJsonArray{colorText(log.clear().color), number(double(log.clear().depth))}},
            {"mistakes", mistakes}};
}

QJsonObject filterJson(const StepFilter& filter)
{
    QJsonObject object;
    if (filter.face)
        object.insert(QStringLiteral("face"), static_cast<qint64>(*filter.face));
    if (filter.pixels)
        object.insert(QStringLiteral("pixel"), QJsonArray{filter.pixels->x, filter.pixels->y});
    return object;
}

} // namespace

int PageTables::addCode(const PageStepWords& english, const PageStepWords& chinese)
{
    QJsonArray listing;
    for (std::size_t i = 0; i < english.code.size(); ++i)
        listing << QJsonArray{texts.add({english.code[i].code, chinese.code[i].code}),
                              texts.add({english.code[i].right, chinese.code[i].right})};
    for (qsizetype i = 0; i < codes.size(); ++i)
        if (codes[i].toArray() == listing)
            return static_cast<int>(i);
    codes << listing;
    return static_cast<int>(codes.size() - 1);
}

QString packedPicture(const QImage& image)
{
    constexpr int kChannels = 3;
    constexpr qsizetype kLength = 4; // bytes that qCompress() puts before the stream
    QByteArray bytes;
    bytes.reserve(kChannels * qsizetype(image.width()) * image.height());
    QRgb former = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QRgb color = image.pixel(x, y);
            for (const int shift : {16, 8, 0})
                bytes += static_cast<char>((color >> shift) - (former >> shift));
            former = color;
        }
    constexpr int kSmallest = 9;
    return QString::fromLatin1(qCompress(bytes, kSmallest).mid(kLength).toBase64());
}

QJsonObject runJson(const Scene& scene, const Settings& settings, const StepLog& log, const QImage& other,
                    PageWords& words, PageTables& tables)
{
    QJsonArray events;
    QJsonArray steps;
    QJsonArray counts;
    QJsonArray resolved;
    for (std::size_t i = 0; i < log.size(); ++i) {
        events << stepJson(log, i);
        steps << stepWordsJson(log, i, words, tables);
        counts << countsAt(log, i + 1);
        if (!log.finishedImage().isNull())
            resolved << static_cast<qint64>(log.resolvedPixels(i + 1));
    }
    QJsonObject run = frameJson(scene, settings, log, words, tables);
    run.insert(QStringLiteral("first"), 0);
    run.insert(QStringLiteral("events"), events);
    run.insert(QStringLiteral("steps"), steps);
    run.insert(QStringLiteral("counts"), counts);
    run.insert(QStringLiteral("changes"), changesJson(log));
    if (!log.finishedImage().isNull()) {
        run.insert(QStringLiteral("finished"), packedPicture(log.finishedImage()));
        run.insert(QStringLiteral("resolved"), resolved);
    }
    if (log.truncated())
        run.insert(QStringLiteral("limit"), static_cast<qint64>(log.filter().cap));
    if (const QJsonObject filter = filterJson(log.filter()); !filter.isEmpty())
        run.insert(QStringLiteral("filter"), filter);
    if (!other.isNull())
        run.insert(QStringLiteral("other"), packedPicture(other));
    if (const auto empty = whyEmpty(scene, settings)) {
        const Reason sentence = sentenceOf(*empty, empty->option);
        run.insert(QStringLiteral("empty"),
                   tables.texts.add(textInBoth(words, [&] { return words.remark(sentence); })));
    }
    std::optional<QPoint> asked;
    if (log.filter().pixels)
        asked = QPoint(log.filter().pixels->x, log.filter().pixels->y);
    run.insert(QStringLiteral("cards"), cardsJson(scene, settings, asked, words, tables));
    return run;
}

QJsonObject stillJson(const Scene& scene, const Settings& settings, const PageStill& still, PageWords& words,
                      PageTables& tables)
{
    QJsonObject run = frameJson(scene, settings, *still.log, words, tables);
    QJsonArray events;
    QJsonArray steps;
    if (still.event) {
        events << stepJson(*still.log, *still.event);
        steps << stepWordsJson(*still.log, *still.event, words, tables);
        run.insert(QStringLiteral("first"), static_cast<qint64>(still.log->numberOf(*still.event)));
    } else {
        run.insert(QStringLiteral("first"), 0);
    }
    run.insert(QStringLiteral("base"), packedPicture(still.picture));
    run.insert(QStringLiteral("events"), events);
    run.insert(QStringLiteral("steps"), steps);
    run.insert(QStringLiteral("counts"), QJsonArray());
    run.insert(QStringLiteral("changes"), QJsonArray());
    if (!still.other.isNull())
        run.insert(QStringLiteral("other"), packedPicture(still.other));
    QJsonObject cards;
    if (still.pixel) {
        const WhyReport report = why(scene, settings, still.pixel->x(), still.pixel->y());
        cards.insert(QStringLiteral("%1,%2").arg(report.x).arg(report.y), cardJson(report, words, tables));
    }
    run.insert(QStringLiteral("cards"), cards);
    return run;
}

} // namespace rasterlens
