// The views and overlays of the canvas: their pixels are the arrays of the frame, their numbers those of the cards,
// their lines lie where the stages have put the corners, and nothing moves while they are used.
#include "core/pipeline/shading.h"
#include "core/questions/vertex_table.h"
#include "core/render/render.h"
#include "core/settings/mistakes.h"
#include "ui/canvas/overlay_inks.h"
#include "ui/face/cards.h"
#include "ui/face/pixel_card.h"
#include "ui/pipeline/canvas_views.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/pipeline/views_bar.h"
#include "ui/truth/truth_mode.h"
#include "window_fixture.h"

#include <QAbstractButton>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <set>

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

class TestViews : public test::WindowFixture
{
    Q_OBJECT

    CanvasViews& views() { return m_window->canvasViews(); }

    bool show(CanvasView view)
    {
        views().setView(view);
        return complete();
    }

    bool choose(QPoint pixel)
    {
        viewport().selectPixel(pixel);
        return complete();
    }

    /// A pixel near the middle of what a face owns.
    std::optional<QPoint> ownedPixel()
    {
        const Frame& frame = viewport().frame()->frame;
        const int width = frame.image.width();
        std::vector<int> owned;
        for (std::size_t i = 0; i < frame.ids.size(); ++i)
            if (frame.ids[i] >= 0)
                owned.push_back(int(i));
        if (owned.empty())
            return std::nullopt;
        const int at = owned[owned.size() / 2];
        return QPoint(at % width, at / width);
    }

private Q_SLOTS:
    void pixelsAreTheArrays_data();
    void pixelsAreTheArrays();
    void facingsAreThoseOfTheArea();
    void facingsAreThoseThatCullingSees();
    void facingsFollowTheSteps();
    void numbersAreWhatTheViewShows();
    void weightsAreThoseOfTheCard_data();
    void weightsAreThoseOfTheCard();
    void isoLinesHoldTheirWeight();
    void outlineIsThatOfTheOwner();
    void boxesHoldWhatIsCovered();
    void wiresShowOnBlack();
    void inksStandOut();
    void depthLiesBesideTheColour();
    void depthBesideFollowsTheSteps();
    void keysChooseViewsAndOverlays();
    void undoAndSessionKeepTheView();
    void stagesShowTheirData();
    void nothingMoves_data();
    void nothingMoves();
    void namesAreThoseOfTheMenu();
};

void TestViews::pixelsAreTheArrays_data()
{
    QTest::addColumn<QString>("scene");
    for (const char* scene : {"cube", "piercing", "teapot", "tile-square"})
        QTest::newRow(scene) << QStringLiteral("builtin:") + QLatin1String(scene);
}

void TestViews::pixelsAreTheArrays()
{
    QFETCH(QString, scene);
    QVERIFY(openSmall(scene, {160, 120}));
    QVERIFY(show(CanvasView::Depth));
    int owned = 0;
    const auto compare = [&](auto colorOf) {
        const Frame& frame = viewport().frame()->frame;
        const int width = frame.image.width();
        owned = 0;
        for (std::size_t i = 0; i < frame.ids.size(); ++i) {
            if (frame.ids[i] < 0)
                continue;
            ++owned;
            const QRgb seen = frame.image.pixel(int(i) % width, int(i) / width);
            const std::uint32_t expected = colorOf(frame, i);
            if (seen != expected)
                return QStringLiteral("pixel %1: %2, not %3").arg(i).arg(seen, 0, 16).arg(expected, 0, 16);
        }
        return owned > 0 ? QString() : QStringLiteral("no face owns a pixel");
    };
    QCOMPARE(compare([](const Frame& f, std::size_t i) { return packColor(glm::vec3(f.depth[i])); }), QString());
    QVERIFY(show(CanvasView::Ids));
    QCOMPARE(compare([](const Frame& f, std::size_t i) { return colorOfId(std::uint32_t(f.ids[i])); }), QString());
    QVERIFY(show(CanvasView::Overdraw));
    QCOMPARE(compare([](const Frame& f, std::size_t i) { return overdrawColor(f.coverage[i]); }), QString());
    for (const auto& [view, shading] :
         {std::pair(CanvasView::Normals, Shading::Normals), std::pair(CanvasView::Uv, Shading::Uv)}) {
        QVERIFY(show(view));
        Settings alone = settings();
        alone.shading = shading;
        Frame frame;
        render(*document().scene(), alone, frame);
        QCOMPARE(picture(), frame.image);
    }
    QVERIFY(show(CanvasView::Colour));
    QCOMPARE(settings().shading, document().defaults().shading);
}

void TestViews::facingsAreThoseOfTheArea()
{
    QVERIFY(openSmall(QStringLiteral("builtin:fan"), {160, 120}));
    QVERIFY(change([](Settings& s) { s.culling = Culling::None; }));
    QVERIFY(show(CanvasView::Facing));
    const auto shown = views().facing().picture();
    QVERIFY(shown);
    const Frame& frame = viewport().frame()->frame;
    int front = 0;
    int back = 0;
    for (std::size_t i = 0; i < frame.ids.size(); ++i) {
        const QPoint pixel(int(i) % frame.image.width(), int(i) / frame.image.width());
        if (frame.ids[i] < 0) {
            QCOMPARE(shown->frame.image.pixel(pixel), frame.image.pixel(pixel));
            continue;
        }
        const auto corners = vertexTable(*document().scene(), settings(), std::uint32_t(frame.ids[i]));
        const glm::dvec2 ab = corners[1].snapped - corners[0].snapped;
        const glm::dvec2 ac = corners[2].snapped - corners[0].snapped;
        const bool isFront = ab.x * ac.y - ab.y * ac.x < 0; // counter-clockwise with y down
        QCOMPARE(shown->frame.image.pixel(pixel), isFront ? kFrontColor : kBackColor);
        QCOMPARE(views().facing().lines(pixel, NumberRoom::Hex).first(),
                 isFront ? QStringLiteral("front") : QStringLiteral("back"));
        ++(isFront ? front : back);
    }
    QVERIFY(front + back > 0);
    QVERIFY(show(CanvasView::Colour));
    QVERIFY(!views().facing().picture());
}

void TestViews::facingsAreThoseThatCullingSees()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube"), {160, 120}));
    QVERIFY(show(CanvasView::Facing));
    const auto colors = [this] {
        std::set<QRgb> colors;
        const Frame& frame = viewport().frame()->frame;
        const QImage& image = views().facing().picture()->frame.image;
        for (std::size_t i = 0; i < frame.ids.size(); ++i)
            if (frame.ids[i] >= 0)
                colors.insert(image.pixel(int(i) % image.width(), int(i) / image.width()));
        return colors;
    };
    for (const CullSpace space : {CullSpace::Screen, CullSpace::Clip, CullSpace::View})
        for (const Winding winding : {Winding::CounterClockwise, Winding::Clockwise}) {
            const auto with = [&](Culling culling) {
                return change([&](Settings& s) {
                    s.culling = culling;
                    s.cullSpace = space;
                    s.winding = winding;
                });
            };
            QVERIFY(with(Culling::Back));
            QCOMPARE(colors(), std::set<QRgb>{kFrontColor});
            QVERIFY(with(Culling::Front));
            QCOMPARE(colors(), std::set<QRgb>{kBackColor});
        }
    // While two pictures are compared, the canvas shows those.
    m_window->truthMode().comparison().setView(CompareView::Wipe);
    QVERIFY(complete());
    QVERIFY(!views().facing().picture());
    m_window->truthMode().comparison().setView(CompareView::Off);
    QVERIFY(complete());
    QVERIFY(views().facing().picture());
}

void TestViews::facingsFollowTheSteps()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(show(CanvasView::Facing));
    StepSession& session = m_window->stepMode().session();
    session.open();
    QVERIFY(complete());
    for (const std::size_t position : {std::size_t(0), session.size() / 3, session.size()}) {
        session.moveTo(position);
        QVERIFY(complete());
        const auto owners = m_window->stepMode().owners();
        QVERIFY(views().facing().picture());
        QCOMPARE(views().facing().picture()->frame.ids, owners);
        const auto owned = std::size_t(std::ranges::count_if(owners, [](std::int32_t id) { return id >= 0; }));
        QCOMPARE(owned, std::size_t(session.cursor()->counters().pixels.written));
    }
    Frame finished;
    render(*document().scene(), settings(), finished, {.depth = true, .ids = true});
    QCOMPARE(m_window->stepMode().owners(), finished.ids);
}

void TestViews::numbersAreWhatTheViewShows()
{
    QVERIFY(openSmall(QStringLiteral("builtin:teapot"), {80, 60}));
    const auto pixel = [this] { return *ownedPixel(); };
    const auto first = [&](NumberRoom room) { return pixelNumbers(*viewport().frame(), pixel(), room).first(); };
    const auto index = [&] { return std::size_t(pixel().y()) * 80U + std::size_t(pixel().x()); };
    QVERIFY(show(CanvasView::Overdraw));
    QCOMPARE(viewport().frame()->frame.image.width(), 80);
    QCOMPARE(first(NumberRoom::Hex), QStringLiteral("\u00d7%1").arg(viewport().frame()->frame.coverage[index()]));
    QVERIFY(show(CanvasView::Depth));
    QCOMPARE(first(NumberRoom::Hex), QString::number(double(viewport().frame()->frame.depth[index()]), 'f', 4));
    QVERIFY(show(CanvasView::Ids));
    QCOMPARE(first(NumberRoom::Hex), QStringLiteral("#%1").arg(viewport().frame()->frame.ids[index()]));
    QVERIFY(show(CanvasView::Normals));
    const QStringList normal = first(NumberRoom::Hex).split(QLatin1Char('\n'));
    QCOMPARE(normal.size(), 3);
    double squared = 0;
    for (const QString& part : normal) {
        const QString number = QString(part.mid(2)).replace(QChar(0x2212), QLatin1Char('-'));
        squared += number.toDouble() * number.toDouble();
    }
    QVERIFY2(std::abs(std::sqrt(squared) - 1) < 0.02, qPrintable(normal.join(QLatin1Char(' '))));
    QVERIFY(show(CanvasView::Uv));
    const QRgb color = viewport().frame()->frame.image.pixel(pixel());
    QCOMPARE(first(NumberRoom::Hex),
             QStringLiteral("u %1\nv %2").arg(qRed(color) / 255.0, 0, 'f', 2).arg(qGreen(color) / 255.0, 0, 'f', 2));
    // Where no face was written, a colour stands for nothing.
    QCOMPARE(pixelNumbers(*viewport().frame(), {0, 0}, NumberRoom::Hex), QStringList{QString()});
}

void TestViews::weightsAreThoseOfTheCard_data()
{
    QTest::addColumn<QString>("scene");
    QTest::addColumn<QString>("mistake");
    for (const char* scene : {"triangle-600", "tile-square", "behind-camera"})
        QTest::newRow(scene) << QStringLiteral("builtin:") + QLatin1String(scene) << QString();
    for (const Mistake& mistake : mistakes())
        QTest::newRow(mistake.id) << QStringLiteral("builtin:tile-square") << QString(QLatin1String(mistake.id));
}

void TestViews::weightsAreThoseOfTheCard()
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

void TestViews::isoLinesHoldTheirWeight()
{
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

void TestViews::outlineIsThatOfTheOwner()
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
        int yellow = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 middle = (corners[i].snapped + corners[(i + 1) % 3].snapped) * 4.0;
            yellow += figure.pixel(int(std::lround(middle.x)), int(std::lround(middle.y))) == kOutlineInk;
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

void TestViews::boxesHoldWhatIsCovered()
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

void TestViews::wiresShowOnBlack()
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
void TestViews::inksStandOut()
{
    constexpr double kReadable = 4.5;
    std::vector<QRgb> inks{kWireInk, kOutlineInk, kBoxInk, kTileInk, kMidLineInk};
    inks.insert(inks.end(), kWeightInks.begin(), kWeightInks.end());
    for (const QRgb ink : inks)
        QVERIFY2(contrast(ink, kCanvasInk) >= kReadable, qPrintable(QColor(ink).name()));
    QVERIFY(contrast(qRgb(255, 255, 255), kCanvasInk) >= kReadable);
    QVERIFY(contrast(kFrontColor, kBackColor) > 1.3); // and the words say which is which
}

void TestViews::depthLiesBesideTheColour()
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
    const QImage beside = viewport().figure(1);
    QCOMPARE(beside.pixel(2, 2), picture().pixel(2, 2));
    QCOMPARE(beside.pixel(beside.width() - 80 + 40, 20), shown->shown.frame.image.pixel(40, 20));
    views().setOverlayNamed(QStringLiteral("depth-beside"), false);
    QCOMPARE(viewport().pane(), viewport().rect());
    QCOMPARE(viewport().figure(1).width(), 80);
}

void TestViews::depthBesideFollowsTheSteps()
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

void TestViews::keysChooseViewsAndOverlays()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube"), {80, 60}));
    for (const CanvasViewRow& row : canvasViews()) {
        key(row.key);
        QVERIFY(complete());
        QCOMPARE(views().view(), row.view);
        if (row.shading)
            QCOMPARE(settings().shading, *row.shading);
        for (std::size_t i = 0; i < canvasViews().size(); ++i)
            QCOMPARE(views().viewActions()[i]->isChecked(), canvasViews()[i].view == row.view);
    }
    int withKey = 0;
    for (const OverlayRow& row : canvasOverlays()) {
        if (row.key.key() == Qt::Key(0))
            continue;
        ++withKey;
        QVERIFY(!(viewport().overlays().*row.member));
        key(row.key.key(), row.key.keyboardModifiers());
        QVERIFY(viewport().overlays().*row.member);
        key(row.key.key(), row.key.keyboardModifiers());
        QVERIFY(!(viewport().overlays().*row.member));
    }
    QCOMPARE(withKey, 3);
}

void TestViews::undoAndSessionKeepTheView()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube"), {80, 60}));
    QVERIFY(change([](Settings& s) { s.shading = Shading::Flat; }));
    QVERIFY(show(CanvasView::Depth));
    QCOMPARE(document().session().settings.value(QLatin1String("shading")).toString(), QStringLiteral("depth"));
    QVERIFY(show(CanvasView::Colour));
    QCOMPARE(settings().shading, Shading::Flat); // the last shading in colours
    document().undo();
    QVERIFY(complete());
    QCOMPARE(views().view(), CanvasView::Depth);
    document().undo();
    QVERIFY(complete());
    QCOMPARE(views().view(), CanvasView::Colour);
}

void TestViews::stagesShowTheirData()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube"), {80, 60}));
    const auto click = [this](Stage stage) {
        const QString name = QStringLiteral("stage%1").arg(static_cast<int>(stage));
        QTest::mouseClick(m_window->stageStrip().findChild<QAbstractButton*>(name), Qt::LeftButton);
        return complete();
    };
    QVERIFY(click(Stage::Depth));
    QCOMPARE(views().view(), CanvasView::Depth);
    QVERIFY(click(Stage::Cull));
    QCOMPARE(views().view(), CanvasView::Facing);
    QVERIFY(click(Stage::Cover));
    QCOMPARE(views().view(), CanvasView::Overdraw);
    QVERIFY(click(Stage::Screen));
    QCOMPARE(views().view(), CanvasView::Colour);
    QVERIFY(viewport().overlays().boxes);
    QVERIFY(click(Stage::Clip));
    QVERIFY(viewport().overlays().wireframe && !viewport().overlays().boxes);
    QVERIFY(click(Stage::Scene));
    QCOMPARE(views().view(), CanvasView::Ids);
    QVERIFY(!viewport().overlays().wireframe);
    QVERIFY(click(Stage::Scene)); // once more: back to the colours
    QCOMPARE(views().view(), CanvasView::Colour);
}

void TestViews::nothingMoves_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("chinese");
    for (const QSize size : {QSize(1024, 768), QSize(1280, 800), QSize(1920, 1080)})
        for (const bool chinese : {false, true})
            QTest::addRow("%d %s", size.width(), chinese ? "zh" : "en") << size << chinese;
}

void TestViews::nothingMoves()
{
    QFETCH(QSize, size);
    QFETCH(bool, chinese);
    m_window->resize(size);
    m_window->setLanguage(chinese ? LanguageKind::Chinese : LanguageKind::English);
    QVERIFY(openSmall(QStringLiteral("builtin:cube"), {80, 60}));
    QVERIFY(choose({40, 30}));
    const auto places = [this] {
        QList<QRect> places{viewport().geometry()};
        for (const auto* button : m_window->viewsBar().findChildren<QToolButton*>(Qt::FindDirectChildrenOnly))
            if (button->isVisible())
                places << button->geometry().translated(m_window->viewsBar().pos());
        return places;
    };
    const QList<QRect> before = places();
    QVERIFY(before.size() > 1);
    // The bar takes no height: its line is as high as the links beside it.
    const auto* beside = m_window->viewsBar().parentWidget()->findChild<QToolButton*>(QStringLiteral("link"));
    QVERIFY(m_window->viewsBar().height() <= beside->sizeHint().height());
    for (const auto* button : m_window->viewsBar().findChildren<QToolButton*>(Qt::FindDirectChildrenOnly))
        if (button->isVisible()) {
            QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
            QVERIFY(m_window->viewsBar().rect().contains(button->geometry()));
        }
    for (const CanvasViewRow& row : canvasViews()) {
        QVERIFY(show(row.view));
        QCOMPARE(places(), before);
    }
    for (const OverlayRow& row : canvasOverlays()) {
        views().setOverlay(row.member, !(viewport().overlays().*row.member));
        QVERIFY(complete());
        QCOMPARE(places(), before);
    }
}

void TestViews::namesAreThoseOfTheMenu()
{
    for (const QString& name : CanvasViews::viewNames())
        QVERIFY2(m_window->actionTable().action(QStringLiteral("view.") + name), qPrintable(name));
    for (const OverlayRow& row : canvasOverlays())
        QVERIFY2(m_window->actionTable().action(QLatin1String(row.id)), row.id);
    QVERIFY(!views().setViewNamed(QStringLiteral("nothing")));
    QVERIFY(!views().setOverlayNamed(QStringLiteral("nothing"), true));
}

QTEST_MAIN(TestViews)
#include "test_views.moc"
