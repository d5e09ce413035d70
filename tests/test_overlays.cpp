// The overlays of the canvas: numbers are those of the cards, lines lie where the stages have put the corners, and all
// of it shows on any picture.
#include "core/questions/vertex_table.h"
#include "core/render/render.h"
#include "core/settings/mistakes.h"
#include "tests/seed.h"
#include "ui/canvas/barycentric_layer.h"
#include "ui/canvas/overlay_inks.h"
#include "ui/face/cards.h"
#include "ui/face/pixel_card.h"
#include "views_fixture.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace rasterlens;

namespace
{

/// Relative luminance of WCAG 2.1.
double luminance(QRgb color)
{
    const auto linear = [](int channel) {
        const double c = channel / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(color)) + 0.7152 * linear(qGreen(color)) + 0.0722 * linear(qBlue(color));
}

double contrast(QRgb a, QRgb b)
{
    const double lighter = std::max(luminance(a), luminance(b));
    return (lighter + 0.05) / (std::min(luminance(a), luminance(b)) + 0.05);
}

/// How far a point lies from the line through two others.
double distance(const glm::dvec2& point, const std::array<glm::dvec2, 2>& line)
{
    const glm::dvec2 along = line[1] - line[0];
    const glm::dvec2 to = point - line[0];
    return std::abs(along.x * to.y - along.y * to.x) / glm::length(along);
}

} // namespace

class TestOverlays : public test::ViewsFixture
{
    Q_OBJECT

private Q_SLOTS:
    void weightsAreThoseOfTheCard_data();
    void numbersHideNoNarrowArea_data();
    void numbersHideNoNarrowArea();
    void weightsAreThoseOfTheCard();
    void footprintsAreThoseOfTheCard();
    void isoLinesHoldTheirWeight();
    void outlineIsThatOfTheOwner();
    void boxesHoldWhatIsCovered();
    void wiresShowOnBlack();
    void inksStandOut();
    void depthLiesBesideTheColour();
    void depthBesideFollowsTheSteps();
};

void TestOverlays::weightsAreThoseOfTheCard_data()
{
    QTest::addColumn<QString>("scene");
    QTest::addColumn<QString>("mistake");
    for (const char* scene : {"triangle-600", "tile-square", "behind-camera"})
        QTest::newRow(scene) << QStringLiteral("builtin:") + QLatin1String(scene) << QString();
    const auto all = mistakes();
    for (std::size_t i = 0; i < all.size(); i += test::everyOfBuild())
        QTest::newRow(all[i].id) << QStringLiteral("builtin:tile-square") << QString(QLatin1String(all[i].id));
}

void TestOverlays::numbersHideNoNarrowArea_data()
{
    QTest::addColumn<QPolygonF>("corners");
    QTest::newRow("from left to right") << QPolygonF{{40, 420}, {780, 330}, {700, 280}};
    QTest::newRow("upright") << QPolygonF{{400, 30}, {340, 480}, {370, 490}};
    QTest::newRow("small") << QPolygonF{{400, 250}, {420, 255}, {410, 265}};
}

/// Where the areas have no room for their numbers, these stand beside the triangle. What differs between two paintings
/// with other numbers is where they stand.
void TestOverlays::numbersHideNoNarrowArea()
{
    QFETCH(QPolygonF, corners);
    const auto paint = [&](const Weights& numbers) {
        auto weights = std::make_shared<PixelWeights>();
        for (std::size_t i = 0; i < 3; ++i) {
            const QPointF& corner = corners[static_cast<qsizetype>(i)];
            weights->corners[i] = {corner.x(), corner.y()};
            weights->point += weights->corners[i] / 3.0;
            weights->invW[i] = 1;
        }
        weights->screen = weights->used = numbers;
        BarycentricLayer layer;
        layer.setWeights(weights);
        OverlayOptions options;
        options.barycentric = true;
        QImage canvas(800, 520, QImage::Format_RGB32);
        canvas.fill(Qt::gray);
        QPainter painter(&canvas);
        layer.paint(painter, canvas.rect(), {}, options);
        return canvas;
    };
    const QImage one = paint({0.1111, 0.1111, 0.1111});
    const QImage other = paint({0.8888, 0.8888, 0.8888});
    int differ = 0;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            if (one.pixel(x, y) != other.pixel(x, y)) {
                ++differ;
                QVERIFY2(!corners.containsPoint(QPointF(x + 0.5, y + 0.5), Qt::OddEvenFill),
                         qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
            }
    QVERIFY(differ > 0);
}

void TestOverlays::weightsAreThoseOfTheCard()
{
    QFETCH(QString, scene);
    QFETCH(QString, mistake);
    QVERIFY(openSmall(scene, {120, 120}));
    if (!mistake.isEmpty())
        QVERIFY(change([&](Settings& s) { s.mistakes = QStringList{mistake}; }));
    QVERIFY(m_window->cards().show(QStringLiteral("why")));
    views().setOverlayNamed(QStringLiteral("barycentric"), true);
    const auto pixel = ownedPixel();
    if (!pixel)
        QSKIP("nothing is drawn under this mistake");
    QVERIFY(choose(*pixel));
    const auto weights = views().barycentric().weights();
    const auto report = m_window->cards().pixelCard().report();
    QVERIFY(report);
    const WhyFace* face = report->visibleFace ? report->find(*report->visibleFace) : nullptr;
    if (!face || !face->fragment)
        QSKIP("the card knows no fragment under this mistake");
    QVERIFY(weights);
    QCOMPARE(weights->face, face->face);
    const QString card = m_window->cards().pixelCard().asText();
    for (const QString& text : views().barycentric().texts())
        for (const QString& line : text.split(QLatin1Char('\n')))
            QVERIFY2(card.contains(QString(line).remove(QStringLiteral("perspective "))), qPrintable(line + card));
    QVERIFY(weights->screen == face->fragment->screen);
    if (face->fragment->shaded)
        QVERIFY(weights->used == face->fragment->weights);
}

/// The plate on the canvas speaks of the selected pixel, and of none where no texture is looked up.
void TestOverlays::footprintsAreThoseOfTheCard()
{
    QVERIFY(openSmall(QStringLiteral("builtin:tile-square"), {120, 120}));
    QVERIFY(change([](Settings& s) {
        s.shading = Shading::Texture;
        s.textureFilter = TextureFilter::Trilinear;
    }));
    QVERIFY(m_window->cards().show(QStringLiteral("why")));
    const auto pixel = ownedPixel();
    QVERIFY(pixel && choose(*pixel));
    QVERIFY(!views().texels().footprint());
    const QImage without = viewport().grab().toImage();
    views().setOverlayNamed(QStringLiteral("texels"), true);
    QVERIFY(complete());
    const auto footprint = views().texels().footprint();
    const auto report = m_window->cards().pixelCard().report();
    QVERIFY(report && report->visibleFace);
    QVERIFY(footprint);
    const WhyFace* face = report->find(*report->visibleFace);
    QVERIFY(face && face->texels);
    QVERIFY(footprint->corners() == face->texels->corners());
    QCOMPARE(footprint->reads.size(), face->texels->reads.size());
    QVERIFY(footprint->patch.texels == face->texels->patch.texels);
    QVERIFY(viewport().grab().toImage() != without);
    QVERIFY(change([](Settings& s) { s.shading = Shading::Gouraud; }));
    QVERIFY(complete() && !views().texels().footprint());
}

void TestOverlays::isoLinesHoldTheirWeight()
{
    PixelWeights rounded;
    rounded.screen = {0.2, 0.3, 0.5};
    rounded.used = {0.2 + 1e-16, 0.3 - 1e-16, 0.5};
    QVERIFY2(!rounded.isCorrected(), "rounding is no perspective");
    rounded.used = {0.2 + 1e-6, 0.3 - 1e-6, 0.5};
    QVERIFY(rounded.isCorrected());
    QVERIFY(openSmall(QStringLiteral("builtin:tile-square"), {120, 120}));
    for (const Interpolation interpolation : {Interpolation::Perspective, Interpolation::Affine}) {
        QVERIFY(change([&](Settings& s) { s.interpolation = interpolation; }));
        const auto pixel = ownedPixel();
        QVERIFY(pixel);
        const std::int32_t owner = viewport().frame()->frame.ids[std::size_t(pixel->y() * 120 + pixel->x())];
        const auto weights = pixelWeights(*document().scene(), settings(), std::uint32_t(owner), *pixel);
        QVERIFY(weights);
        QCOMPARE(weights->isCorrected(), interpolation == Interpolation::Perspective);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto used =
                isoLine(weights->corners, weights->invW, corner, weights->used[corner], weights->isCorrected());
            QVERIFY(distance(weights->point, used) < 1e-6);
            const auto onScreen = isoLine(weights->corners, weights->invW, corner, weights->screen[corner], false);
            QVERIFY(distance(weights->point, onScreen) < 1e-6);
        }
    }
}

void TestOverlays::outlineIsThatOfTheOwner()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube"), {160, 120}));
    const auto pixel = ownedPixel();
    QVERIFY(pixel);
    QVERIFY(choose(*pixel));
    const Frame& frame = viewport().frame()->frame;
    const std::int32_t owner = frame.ids[std::size_t(pixel->y() * frame.image.width() + pixel->x())];
    QCOMPARE(views().geometry().winner(), std::optional(std::uint32_t(owner)));
    const auto corners = vertexTable(*document().scene(), settings(), std::uint32_t(owner));
    const auto isOutlined = [&] {
        const QImage figure = viewport().figure(8);
        const QColor ink(kOutlineInk);
        const auto isYellow = [&](int x, int y) { // but for the smoothing of its rim
            const QColor seen(figure.pixel(x, y));
            return std::abs(seen.red() - ink.red()) + std::abs(seen.green() - ink.green()) +
                       std::abs(seen.blue() - ink.blue()) <
                   90;
        };
        int yellow = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 middle = (corners[i].snapped + corners[(i + 1) % 3].snapped) * 4.0;
            bool found = false;
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    found |= isYellow(int(std::lround(middle.x)) + x, int(std::lround(middle.y)) + y);
            yellow += found ? 1 : 0;
        }
        return yellow == 3;
    };
    QVERIFY(isOutlined());
    views().setOverlayNamed(QStringLiteral("outline"), false);
    QVERIFY(!isOutlined());
    views().setOverlayNamed(QStringLiteral("outline"), true);
    viewport().selectPixel(std::nullopt);
    QVERIFY(!isOutlined());
}

void TestOverlays::boxesHoldWhatIsCovered()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube"), {160, 120}));
    const ScreenFaces faces = screenFaces(*document().scene(), settings());
    const Frame& frame = viewport().frame()->frame;
    QCOMPARE(faces.faces.size(), document().scene()->mesh.faceCount());
    int inside = 0;
    for (std::size_t i = 0; i < frame.ids.size(); ++i) {
        if (frame.ids[i] < 0)
            continue;
        const ScreenFace& face = faces.faces[std::size_t(frame.ids[i])];
        QVERIFY(face.drawn && face.front);
        QCOMPARE(face.cornerCount, 3U);
        const ScreenPiece& piece = faces.piecesOf(face).front();
        const glm::dvec2 centre(double(i % 160) + 0.5, double(i / 160) + 0.5);
        QVERIFY(glm::all(glm::lessThan(piece.boxLow, centre)) && glm::all(glm::lessThan(centre, piece.boxHigh)));
        ++inside;
    }
    QVERIFY(inside > 100);
    // The box that the mistake makes one column and one row too small is shown so.
    Settings mistaken = settings();
    const auto oneShort = std::ranges::find_if(mistakes(), [](const Mistake& mistake) {
        Rules rules;
        mistake.apply(rules);
        return rules.bounds == Bounds::OneShort;
    });
    QVERIFY(oneShort != mistakes().end());
    mistaken.mistakes = QStringList{QLatin1String(oneShort->id)};
    const ScreenFaces shorter = screenFaces(*document().scene(), mistaken);
    QCOMPARE(shorter.pieces.size(), faces.pieces.size());
    for (std::size_t i = 0; i < faces.pieces.size(); ++i)
        QCOMPARE(shorter.pieces[i].boxHigh + glm::dvec2(1, 1), faces.pieces[i].boxHigh);
}

void TestOverlays::wiresShowOnBlack()
{
    constexpr double kLeastContrast = 3; // WCAG 2.1 for lines
    QVERIFY(openSmall(QStringLiteral("builtin:cube"), {160, 120}));
    QVERIFY(change([](Settings& s) {
        s.fill = Fill::Wireframe;
        s.culling = Culling::None;
    }));
    for (const Shading shading : {Shading::Gouraud, Shading::Flat, Shading::Phong}) {
        QVERIFY(change([&](Settings& s) { s.shading = shading; }));
        const Frame& frame = viewport().frame()->frame;
        int lines = 0;
        for (std::size_t i = 0; i < frame.ids.size(); ++i) {
            if (frame.ids[i] < 0)
                continue;
            ++lines;
            const QRgb color = frame.image.pixel(int(i % 160), int(i / 160));
            QVERIFY2(contrast(color, frame.image.pixel(0, 0)) >= kLeastContrast, qPrintable(QColor(color).name()));
        }
        QVERIFY(lines > 100);
    }
}

/// Every line over the picture has a seam in the dark ink: it shows where the line itself does not.
void TestOverlays::inksStandOut()
{
    constexpr double kReadable = 4.5;
    std::vector<QRgb> inks{kWireInk, kOutlineInk, kBoxInk, kTileInk, kMidLineInk};
    inks.insert(inks.end(), kWeightInks.begin(), kWeightInks.end());
    for (const QRgb ink : inks)
        QVERIFY2(contrast(ink, kCanvasInk) >= kReadable, qPrintable(QColor(ink).name()));
    QVERIFY(contrast(qRgb(255, 255, 255), kCanvasInk) >= kReadable);
    QVERIFY(contrast(kFrontColor, kBackColor) > 1.3); // and the words say which is which
}

void TestOverlays::depthLiesBesideTheColour()
{
    QVERIFY(openSmall(QStringLiteral("builtin:teapot"), {80, 60}));
    QVERIFY(!viewport().depthShown());
    views().setOverlayNamed(QStringLiteral("depth-beside"), true);
    QVERIFY(complete());
    const auto shown = viewport().depthShown();
    QVERIFY(shown);
    const DepthBuffer& depth = viewport().frame()->frame.depth;
    float low = 1;
    float high = 0;
    for (const float d : depth)
        if (d > 0 && d < 1) {
            low = std::min(low, d);
            high = std::max(high, d);
        }
    QCOMPARE(shown->black, low);
    QCOMPARE(shown->white, high);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const double grey = std::clamp((double(depth[i]) - double(low)) / (double(high) - double(low)), 0.0, 1.0) * 255;
        const QRgb pixel = shown->shown.frame.image.pixel(int(i % 80), int(i / 80));
        QVERIFY(std::abs(qRed(pixel) - grey) <= 0.51);
        QCOMPARE(depthLines(*viewport().frame(), {int(i % 80), int(i / 80)}),
                 QStringList{QString::number(double(depth[i]), 'f', 4)});
    }
    // Both halves have one place and one zoom, and answer to the mouse alike.
    QCOMPARE(viewport().pane().size(), viewport().depthPane().size());
    const QPointF at = viewport().transform().toCanvas(QPointF(40.5, 30.5));
    QVERIFY(viewport().pane().contains(at.toPoint()));
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, at.toPoint());
    QCOMPARE(viewport().selectedPixel(), std::optional(QPoint(40, 30)));
    viewport().selectPixel(std::nullopt);
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, at.toPoint() + viewport().depthPane().topLeft());
    QCOMPARE(viewport().selectedPixel(), std::optional(QPoint(40, 30)));
    viewport().selectPixel(std::nullopt); // the ring about it would lie over others
    const QImage beside = viewport().figure(1);
    QCOMPARE(beside.pixel(2, 2), picture().pixel(2, 2));
    QCOMPARE(beside.pixel(beside.width() - 80 + 40, 20), shown->shown.frame.image.pixel(40, 20));
    views().setOverlayNamed(QStringLiteral("depth-beside"), false);
    QCOMPARE(viewport().pane(), viewport().rect());
    QCOMPARE(viewport().figure(1).width(), 80);
}

void TestOverlays::depthBesideFollowsTheSteps()
{
    for (const Samples samples : {Samples::One, Samples::Grid2}) {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        QVERIFY(change([&](Settings& s) { s.samples = samples; }));
        views().setOverlayNamed(QStringLiteral("depth-beside"), true);
        StepSession& session = m_window->stepMode().session();
        session.open();
        QVERIFY(complete());
        session.moveTo(session.size() / 2);
        QVERIFY(complete());
        QVERIFY(viewport().depthShown());
        const int grid = sampleGrid(samples);
        const int width = viewport().frame()->frame.image.width();
        const auto stored = session.cursor()->sampleDepths();
        int cleared = 0;
        for (int y = 0; y < width; ++y)
            for (int x = 0; x < width; ++x) {
                const auto sample = std::size_t((y * grid + grid / 2) * width * grid + x * grid + grid / 2);
                const float depth = stored[sample];
                QCOMPARE(viewport().frame()->frame.depth[std::size_t(y * width + x)], depth);
                cleared += depth == 1;
            }
        QVERIFY(cleared > 0 && cleared < width * width);
        session.close();
    }
}

QTEST_MAIN(TestOverlays)
#include "test_overlays.moc"
