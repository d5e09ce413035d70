// Which mistake is mine? Pictures that another program, another algorithm or a lossy file made, and what they are taken
// for.
#include "core/io/npy.h"
#include "core/io/picture_input.h"
#include "core/questions/identify.h"
#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "tests/cli_support.h"
#include "tests/seed.h"
#include "tests/student_rasterizer.h"
#include "tests/worn_pictures.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <functional>
#include <random>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

const QTemporaryDir& folder()
{
    static const QTemporaryDir dir;
    return dir;
}

Scene sceneNamed(const QString& name) { return *makeBuiltinScene(name).scene; }

/// The settings of a scene in a size that many pictures can be drawn in.
Settings smallSettings(const Scene& scene)
{
    Settings settings = scene.defaults;
    const QSize most(480, 360);
    if (scene.space == SceneSpace::Object)
        settings.size = settings.size.scaled(most.boundedTo(settings.size), Qt::KeepAspectRatio);
    return settings;
}

QImage drawnBy(const Scene& scene, Settings settings, const QStringList& mistakes)
{
    settings.mistakes = mistakes;
    Frame frame;
    render(scene, settings, frame);
    return frame.image.copy();
}

QRgb backgroundOf(const Scene& scene)
{
    const auto channel = [](float c) { return int(std::lround(255 * c)); };
    return qRgb(channel(scene.background.r), channel(scene.background.g), channel(scene.background.b));
}

/// Writes the picture and reads it as the program does.
QImage throughFile(const QImage& image, const QString& suffix)
{
    const QString path = folder().filePath(QStringLiteral("picture.") + suffix);
    bool written = true;
    if (suffix == QLatin1String("tga"))
        writeFile(path, tgaBytes(image));
    else if (suffix == QLatin1String("npy"))
        writeFile(path, npyOf(image));
    else
        written = image.save(path, nullptr, suffix == QLatin1String("jpg") ? 90 : -1);
    const PictureLoad load = loadPicture(path);
    if (!written || load.problem)
        qFatal("%s: %s", qPrintable(path), load.problem ? qPrintable(textOf(*load.problem)) : "not written");
    return load.image;
}

/// A picture and the mistake that it shows.
struct Sample {
    QString name;
    QString scene;
    Settings settings;
    QString expected;
    QImage image;
};

/// What happens to a picture on its way.
struct Way {
    const char* name;
    QString suffix;
    std::function<QImage(const QImage&, QRgb background)> change;
};

const std::vector<Way>& ways()
{
    static const std::vector<Way> all{
        {"noise", QStringLiteral("png"), [](const QImage& i, QRgb) { return withNoise(i); }},
        {"JPEG", QStringLiteral("jpg"), [](const QImage& i, QRgb) { return i; }},
        {"border", QStringLiteral("bmp"), [](const QImage& i, QRgb) { return withBorder(i); }},
        {"one row down", QStringLiteral("tga"), oneRowDown},
        {"white background", QStringLiteral("npy"), onWhite},
        {"half the size", QStringLiteral("png"),
         [](const QImage& i, QRgb) { return i.width() >= 128 ? halfWithBorder(i) : withBorder(i); }},
    };
    return all;
}

/// Pixels of another colour.
int differing(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    return count;
}

/// What a mistake draws, by another algorithm where that one makes the mistake as well: where it does not draw what a
/// right program draws that computes in doubles.
QImage drawnOtherwise(const Scene& scene, const Settings& settings, const QString& mistake)
{
    const QImage right = drawnBy(scene, settings, {});
    const QImage usual = drawnBy(scene, settings, {mistake});
    Settings other = settings;
    other.numberType = NumberType::Float64;
    const QImage inDoubles = unsupported(scene, other) ? right : drawnBy(scene, other, {});
    const int changed = std::min(differing(usual, right), differing(usual, inDoubles));
    other = settings;
    other.mistakes = QStringList{mistake};
    for (const Algorithm algorithm : {Algorithm::EdgeWalking, Algorithm::Tiled}) {
        other.algorithm = algorithm;
        if (unsupported(scene, other))
            continue;
        const QImage drawn = drawnBy(scene, other, {mistake});
        if (10 * differing(drawn, usual) < changed)
            return drawn;
    }
    return usual;
}

/// The pictures of all mistakes in their scenes, changed on their way.
std::vector<Sample> lossySamples()
{
    std::vector<Sample> samples;
    std::size_t number = 0;
    for (const Mistake& mistake : mistakes()) {
        const QString id = QLatin1String(mistake.id);
        const Scene scene = sceneNamed(QLatin1String(mistake.scene));
        const Settings settings = smallSettings(scene);
        const Way& way = ways()[number++ % ways().size()];
        const QImage changed = way.change(drawnOtherwise(scene, settings, id), backgroundOf(scene));
        samples.push_back({QStringLiteral("%1, %2").arg(id, QLatin1String(way.name)), QLatin1String(mistake.scene),
                           settings, id, throughFile(changed, way.suffix)});
    }
    return samples;
}

Sample byStudent(const char* sceneName, const char* expected, const StudentMistakes& mistakes,
                 Shading shading = Shading::Gouraud)
{
    const Scene scene = sceneNamed(QLatin1String(sceneName));
    Settings settings = smallSettings(scene);
    settings.shading = shading;
    return {QStringLiteral("%1 by a student").arg(QLatin1String(expected)), QLatin1String(sceneName), settings,
            QLatin1String(expected), StudentRasterizer(scene, settings, mistakes).image()};
}

/// The pictures of another program.
std::vector<Sample> studentSamples()
{
    using S = StudentMistakes;
    return {
        byStudent("square-diagonal", "none", {}),
        byStudent("square-diagonal", "all-exclusive", {.tie = S::Tie::Exclusive}),
        byStudent("square-diagonal", "box-one-short", {.shortBox = true}),
        byStudent("square-diagonal", "weights-rotated", {.weights = S::Weights::Rotated}),
        byStudent("square-diagonal", "weights-exchanged", {.weights = S::Weights::Exchanged}),
        byStudent("square-diagonal", "y-flipped-once", {.upsideDown = true}),
        byStudent("triangle-600", "none", {}),
        byStudent("triangle-600", "corner-sampling", {.sample = 0}),
        byStudent("triangle-600", "weights-exchanged", {.weights = S::Weights::Exchanged}),
        byStudent("triangle-600", "y-flipped-once", {.upsideDown = true}),
        byStudent("two-windings", "none", {}),
        byStudent("two-windings", "one-winding", {.oneWinding = true}),
        byStudent("fan", "all-exclusive", {.tie = S::Tie::Exclusive}),
        byStudent("tiny-tiles", "none", {}),
        byStudent("tiny-tiles", "integer-vertices", {.wholeVertices = true}),
        byStudent("tiny-tiles", "small-area-dropped", {.smallestArea = 1}),
        byStudent("three-layers", "none", {}),
        byStudent("three-layers", "no-z-buffer", {.depth = S::Depth::None}),
        byStudent("three-layers", "depth-reversed", {.depth = S::Depth::Greater}),
        byStudent("three-layers", "depth-written-on-fail", {.depth = S::Depth::WrittenOnFail}),
        byStudent("three-layers", "depth-cleared-to-zero", {.depth = S::Depth::ClearedToZero}),
        byStudent("games101", "none", {}),
        byStudent("games101", "no-z-buffer", {.depth = S::Depth::None}),
        byStudent("games101", "depth-reversed", {.depth = S::Depth::Greater}),
        byStudent("tile-square", "none", {}, Shading::Texture),
        byStudent("tile-square", "affine", {.perspective = S::Perspective::Affine}, Shading::Texture),
        byStudent("tile-square", "w-not-inverted", {.perspective = S::Perspective::TimesW}, Shading::Texture),
        byStudent("tile-square", "corner-sampling", {.sample = 0}, Shading::Texture),
        byStudent("triangle", "y-flipped-once", {.upsideDown = true}),
        byStudent("games101-tilted", "affine", {.perspective = S::Perspective::Affine}),
        byStudent("painter-cycle", "corner-sampling", {.sample = 0}),
        byStudent("fan", "none", {.sample = 0.4997}), // as if vertices were rounded otherwise
        byStudent("fan", "none", {.sample = 0.5003}),
        byStudent("piercing", "no-z-buffer", {.depth = S::Depth::None}),
    };
}

Identification answerTo(const Sample& sample)
{
    return identify(sceneNamed(sample.scene), sample.settings, sample.image);
}

/// RASTERLENS_ALL_PICTURES asks for all of them, as the CTest `identify_long` does: a search takes seconds, in some
/// scenes minutes.
bool wantsAllPictures() { return qEnvironmentVariableIsSet("RASTERLENS_ALL_PICTURES"); }

/// Every third of a list, under the sanitizers every fifteenth, or all of it.
template <class T>
std::vector<T> someOfBuild(const std::vector<T>& all)
{
    const std::size_t step = wantsAllPictures() ? 1 : 3 * everyOfBuild();
    std::vector<T> some;
    for (std::size_t i = 0; i < all.size(); i += step)
        some.push_back(all[i]);
    return some;
}

/// Pictures of 8 x 8 pixels that look like another mistake, or like none, once they are changed on their way.
bool looksLikeAnother(const Sample& sample)
{
    const std::array names{
        // `whole-rows`, moved by a pixel to the left, draws seven of the eight pixels that are hit twice; the eighth
        // and one of two noisy pixels lie in the column that the move leaves out.
        QLatin1String("all-inclusive, noise"),
        // The row and the column without a face have the colour of a border; what it surrounds is the right picture.
        QLatin1String("viewport-one-short, white background"),
    };
    return std::ranges::find(names, sample.name) != names.end();
}

/// How many of the pictures asked for so far came out right first.
struct Tally {
    int asked = 0;
    int right = 0;

    /// Nineteen of twenty; of fewer, all but one.
    [[nodiscard]] bool isGood() const { return right + std::max(1, asked / 20) >= asked; }
};

/// Asks for a picture. It is right if the mistake that it was made with comes first, and missed if that is not even
/// named as drawing the very same picture.
void askFor(const Sample& sample, Tally& tally)
{
    const Identification found = answerTo(sample);
    const MistakeMatch& best = found.matches.front();
    const bool isFirst = best.mistake == sample.expected && found.fits();
    ++tally.asked;
    tally.right += isFirst ? 1 : 0;
    const bool isAlike = found.fits() && best.alike.contains(sample.expected);
    const auto own = std::ranges::find(found.matches, sample.expected, &MistakeMatch::mistake);
    qInfo("%s %-45s %s %.3f, %s %.3f%s", isFirst ? "ok  " : "MISS", qPrintable(sample.name), qPrintable(best.mistake),
          best.score, qPrintable(sample.expected), own == found.matches.end() ? -1 : own->score,
          isAlike ? ", the same picture" : "");
    QVERIFY2(isFirst || isAlike || looksLikeAnother(sample), qPrintable(best.mistake));
}

/// A row of a test for each sample: Qt's watchdog waits five minutes for a row.
void addRows(const std::vector<Sample>& samples)
{
    QTest::addColumn<int>("number");
    for (std::size_t i = 0; i < samples.size(); ++i)
        QTest::addRow("%zu %s, %s", i, qPrintable(samples[i].name), qPrintable(samples[i].scene)) << int(i);
}

} // namespace

class TestIdentify : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lossyPicturesFindTheirMistake_data();
    void lossyPicturesFindTheirMistake();
    void lossyPicturesAreRightFirst();
    void picturesOfAnotherProgramFindTheirMistake_data();
    void picturesOfAnotherProgramFindTheirMistake();
    void picturesOfAnotherProgramAreRightFirst();
    void theRightPictureIsNone_data();
    void theRightPictureIsNone();
    void whatNothingDrawsIsNoneOfThese();
    void twoMistakesAreBothNamed_data();
    void twoMistakesAreBothNamed();
    void sameColorsInAnotherPlaceAreNotTheSame();
    void matchesSayWhereTheyDiffer();
    void arraysAreReadAsPictures();
    void commandLineAnswers();
    void commandLineRefuses();

private:
    std::vector<Sample> m_lossy;
    std::vector<Sample> m_students;
    Tally m_lossyTally;
    Tally m_studentTally;
};

void TestIdentify::lossyPicturesFindTheirMistake_data()
{
    m_lossy = someOfBuild(lossySamples());
    QVERIFY(m_lossy.size() >= (wantsAllPictures() ? 40U : 5U));
    addRows(m_lossy);
}

void TestIdentify::lossyPicturesFindTheirMistake()
{
    QFETCH(const int, number);
    askFor(m_lossy[std::size_t(number)], m_lossyTally);
}

void TestIdentify::lossyPicturesAreRightFirst()
{
    qInfo("%d of %d right first", m_lossyTally.right, m_lossyTally.asked);
    QVERIFY(m_lossyTally.isGood());
}

void TestIdentify::picturesOfAnotherProgramFindTheirMistake_data()
{
    m_students = someOfBuild(studentSamples());
    addRows(m_students);
}

/// Another program rounds and shades in its own way, which looks like a mistake where the mistake changes little.
void TestIdentify::picturesOfAnotherProgramFindTheirMistake()
{
    QFETCH(const int, number);
    askFor(m_students[std::size_t(number)], m_studentTally);
}

void TestIdentify::picturesOfAnotherProgramAreRightFirst()
{
    qInfo("%d of %d right first", m_studentTally.right, m_studentTally.asked);
    QVERIFY(m_studentTally.isGood());
}

void TestIdentify::theRightPictureIsNone_data()
{
    QTest::addColumn<QString>("name");
    const std::vector<const char*> names{"square-diagonal", "triangle-600", "letter-f", "samples", "fan"};
    for (const char* name : someOfBuild(names))
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestIdentify::theRightPictureIsNone()
{
    QFETCH(const QString, name);
    const Scene scene = sceneNamed(name);
    const Settings settings = smallSettings(scene);
    const QImage right = drawnBy(scene, settings, {});
    const Identification exact = identify(scene, settings, right);
    QCOMPARE(exact.matches.front().mistake, QLatin1String("none"));
    QCOMPARE(exact.matches.front().score, 1.0);
    QCOMPARE(exact.matches.front().unlike, 0);
    QVERIFY(exact.matches.size() >= 5);
    for (const Way& way : ways()) {
        const QImage image = throughFile(way.change(right, backgroundOf(scene)), way.suffix);
        const Identification found = identify(scene, settings, image);
        QVERIFY2(found.fits(), way.name);
        QVERIFY2(found.matches.front().mistake == QLatin1String("none"), qPrintable(found.matches.front().mistake));
    }
}

void TestIdentify::whatNothingDrawsIsNoneOfThese()
{
    const Scene scene = sceneNamed(QStringLiteral("games101"));
    const Settings settings = smallSettings(scene);
    const QImage right = drawnBy(scene, settings, {});

    const QImage other = drawnBy(sceneNamed(QStringLiteral("fan")), smallSettings(scene), {});
    QVERIFY(!identify(scene, settings, other).fits());

    QImage gone = right; // a large square is missing that no mistake takes away
    for (int y = 100; y < 160; ++y)
        for (int x = 100; x < 160; ++x)
            gone.setPixel(x, y, qRgb(255, 0, 255));
    QVERIFY(!identify(scene, settings, gone).fits());

    QImage inverted = right;
    inverted.invertPixels();
    QVERIFY(!identify(scene, settings, inverted).fits());

    QImage noise(settings.size, QImage::Format_RGB32);
    std::mt19937 random(3);
    for (int y = 0; y < noise.height(); ++y)
        for (int x = 0; x < noise.width(); ++x)
            noise.setPixel(x, y, 0xff000000U | (random() & 0xffffffU));
    QVERIFY(!identify(scene, settings, noise).fits());
}

void TestIdentify::twoMistakesAreBothNamed_data()
{
    struct Pair {
        const char* scene;
        const char* one;
        const char* other;
    };
    const std::vector<Pair> pairs{
        {"square-diagonal", "all-exclusive", "weights-rotated"},
        {"square-diagonal", "all-exclusive", "box-one-short"},
        {"square-diagonal", "box-one-short", "weights-exchanged"},
        {"triangle-600", "corner-sampling", "weights-rotated"},
        {"triangle-600", "weights-exchanged", "y-flipped-once"},
        {"three-layers", "no-z-buffer", "y-flipped-once"},
        {"three-layers", "depth-written-on-fail", "box-one-short"},
        {"lines", "missing-octant", "integer-weight"},
        {"lines", "steep-step", "integer-weight"},
        {"tiny-tiles", "integer-vertices", "weights-rotated"},
        {"samples", "coverage-times-color", "one-depth-per-pixel"},
        {"fan", "all-exclusive", "y-flipped-once"},
        {"letter-f", "cull-reversed", "corner-sampling"},
        {"tile-square", "affine", "y-flipped-once"},
    };
    QTest::addColumn<QString>("sceneName");
    QTest::addColumn<QStringList>("both");
    for (const Pair& pair : someOfBuild(pairs))
        QTest::addRow("%s, %s, %s", pair.scene, pair.one, pair.other)
            << QString::fromLatin1(pair.scene)
            << QStringList{QString::fromLatin1(pair.one), QString::fromLatin1(pair.other)};
}

void TestIdentify::twoMistakesAreBothNamed()
{
    QFETCH(const QString, sceneName);
    QFETCH(const QStringList, both);
    const Scene scene = sceneNamed(sceneName);
    const Settings settings = smallSettings(scene);
    const QImage image = drawnBy(scene, settings, both);
    const Identification found = identify(scene, settings, image);
    const MistakeMatch& first = found.matches[0];
    const MistakeMatch& second = found.matches[1];
    const bool isHidden = image == drawnBy(scene, settings, both.mid(0, 1)); // the second one cannot be seen
    const bool named =
        isHidden ? first.mistake == both.first() && first.with.isEmpty()
                 : both.contains(first.mistake) && both.contains(second.mistake) && first.with == second.mistake;
    qInfo("%s %s: %s -> %s %.3f + %s %.3f", named ? "ok  " : "MISS", qPrintable(sceneName),
          qPrintable(both.join(QStringLiteral(" + "))), qPrintable(first.mistake), first.score,
          qPrintable(second.mistake), second.score);
    QVERIFY(named);
}

/// A score is about pixels, not about how many there are of a colour.
void TestIdentify::sameColorsInAnotherPlaceAreNotTheSame()
{
    const Scene scene = sceneNamed(QStringLiteral("square-diagonal"));
    const Settings settings = smallSettings(scene);
    QImage other = drawnBy(scene, settings, {}); // as many holes as on the diagonal, in two columns
    for (int y = 0; y < 8; ++y)
        other.setPixel(y < 4 ? 1 : 6, y, qRgb(0, 0, 0));
    const Identification found = identify(scene, settings, other);
    const auto match = std::ranges::find(found.matches, QLatin1String("all-exclusive"), &MistakeMatch::mistake);
    QVERIFY(match->score < 0.4);
}

void TestIdentify::matchesSayWhereTheyDiffer()
{
    const Scene scene = sceneNamed(QStringLiteral("square-diagonal"));
    const Settings settings = smallSettings(scene);
    const QImage right = drawnBy(scene, settings, {});
    const QImage wrong = drawnBy(scene, settings, {QStringLiteral("all-exclusive")});
    const Identification found = identify(scene, settings, wrong);
    const MistakeMatch& best = found.matches.front();
    int pixels = 0;
    QRect where;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            if (right.pixel(x, y) != wrong.pixel(x, y)) {
                ++pixels;
                where |= QRect(x, y, 1, 1);
            }
    QCOMPARE(best.mistake, QLatin1String("all-exclusive"));
    QCOMPARE(best.score, 1.0);
    QCOMPARE(best.pixels, pixels);
    QCOMPARE(best.where, where);
    QCOMPARE(best.unlike, 0);
    QCOMPARE(settingsOf(best, found).mistakes, QStringList{QStringLiteral("all-exclusive")});
    const auto none = std::ranges::find(found.matches, QLatin1String("none"), &MistakeMatch::mistake);
    QCOMPARE(none->unlike, pixels);
    QVERIFY(none->score < kLeastScore);
    for (std::size_t i = 1; i < found.matches.size(); ++i)
        QVERIFY(found.matches[i - 1].score >= found.matches[i].score);
}

void TestIdentify::arraysAreReadAsPictures()
{
    const QImage image = drawnBy(sceneNamed(QStringLiteral("square-diagonal")),
                                 smallSettings(sceneNamed(QStringLiteral("square-diagonal"))), {});
    QCOMPARE(throughFile(image, QStringLiteral("npy")).convertToFormat(QImage::Format_RGB32), image);
    QCOMPARE(throughFile(image, QStringLiteral("tga")).convertToFormat(QImage::Format_RGB32), image);

    const std::vector<float> grey{0.0F, 0.5F, 1.0F, 0.25F};
    const QString path = folder().filePath(QStringLiteral("grey.npy"));
    writeFile(path, npyBytes(std::span(grey), 2, 2));
    const QImage read = loadPicture(path).image;
    QCOMPARE(read.pixel(1, 0), qRgb(128, 128, 128));
    QCOMPARE(read.pixel(0, 1), qRgb(255, 255, 255));

    const std::vector<std::int32_t> ids{-1, 0, 1, 300};
    writeFile(path, npyBytes(std::span(ids), 2, 2));
    QVERIFY(loadPicture(path).problem);
}

void TestIdentify::commandLineAnswers()
{
    const QString program = QStringLiteral(RASTERLENS_CLI);
    const QString wrong = folder().filePath(QStringLiteral("wrong.png"));
    QCOMPARE(run({QStringLiteral("render"), QStringLiteral("builtin:square-diagonal"), QStringLiteral("--mistake"),
                  QStringLiteral("all-exclusive"), QStringLiteral("-o"), wrong},
                 folder().path())
                 .exitCode,
             0);
    const Run json = run({QStringLiteral("identify"), wrong, QStringLiteral("--scene"),
                          QStringLiteral("builtin:square-diagonal"), QStringLiteral("--json"), QStringLiteral("-")},
                         folder().path());
    QCOMPARE(json.exitCode, 0);
    const QJsonArray matches = QJsonDocument::fromJson(json.out).object()["matches"].toArray();
    QVERIFY(matches.size() >= 5);
    QCOMPARE(matches[0]["mistake"].toString(), QStringLiteral("all-exclusive"));
    QCOMPARE(matches[0]["score"].toDouble(), 1.0);
    QCOMPARE(matches[0]["where"].toArray().size(), 4);
    QVERIFY(matches[0]["pixels"].toInt() > 0);
    const Run text =
        run({QStringLiteral("identify"), wrong, QStringLiteral("--scene"), QStringLiteral("builtin:square-diagonal")},
            folder().path());
    QCOMPARE(text.exitCode, 0);
    QVERIFY(text.out.contains("100.0 %  all-exclusive"));
}

void TestIdentify::commandLineRefuses()
{
    const QString scene = QStringLiteral("builtin:square-diagonal");
    const auto asked = [](const QStringList& words) {
        return run(QStringList{QStringLiteral("identify")} + words, folder().path());
    };
    const Run missing = asked({QStringLiteral("there-is-none.png"), QStringLiteral("--scene"), scene});
    QCOMPARE(missing.exitCode, 3);
    QVERIFY2(missing.err.startsWith(QStringLiteral("there-is-none.png: ")), qPrintable(missing.err));
    writeFile(folder().filePath(QStringLiteral("text.png")), "this is no picture");
    const Run broken = asked({QStringLiteral("text.png"), QStringLiteral("--scene"), scene});
    QCOMPARE(broken.exitCode, 3);
    QVERIFY2(broken.err.startsWith(QStringLiteral("text.png: ")), qPrintable(broken.err));
    QCOMPARE(asked({QStringLiteral("text.png")}).exitCode, 2);
    QCOMPARE(asked({QStringLiteral("text.png"), QStringLiteral("--scene"), scene, QStringLiteral("--size"),
                    QStringLiteral("0x3")})
                 .exitCode,
             3); // the picture is read first
    filled(8, 8, qRgb(1, 2, 3)).save(folder().filePath(QStringLiteral("flat.png")));
    QCOMPARE(
        asked({QStringLiteral("flat.png"), QStringLiteral("--scene"), QStringLiteral("builtin:nonsense")}).exitCode, 3);
    QCOMPARE(asked({QStringLiteral("flat.png"), QStringLiteral("--scene"), scene, QStringLiteral("--size"),
                    QStringLiteral("0x3")})
                 .exitCode,
             2);
}

QTEST_GUILESS_MAIN(TestIdentify)
#include "test_identify.moc"
