// The views of the canvas: their pixels and numbers are the arrays of the frame, keys and stages choose them, and
// nothing moves while they are used.
#include "core/pipeline/shading.h"
#include "core/questions/vertex_table.h"
#include "core/render/render.h"
#include "tests/seed.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/pipeline/views_bar.h"
#include "ui/truth/truth_mode.h"
#include "views_fixture.h"

#include <QAbstractButton>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace rasterlens;

class TestViews : public test::ViewsFixture
{
    Q_OBJECT

private Q_SLOTS:
    void pixelsAreTheArrays_data();
    void pixelsAreTheArrays();
    void facingsAreThoseOfTheArea();
    void facingsAreThoseThatCullingSees();
    void facingsFollowTheSteps();
    void winnersAreKnownDeepInARecord();
    void framesFollowTheCursor_data();
    void framesFollowTheCursor();
    void numbersAreWhatTheViewShows();
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
        const auto owners = viewport().frame()->frame.ids;
        QVERIFY(views().facing().picture());
        QCOMPARE(views().facing().picture()->frame.ids, owners);
        const auto owned = std::size_t(std::ranges::count_if(owners, [](std::int32_t id) { return id >= 0; }));
        QCOMPARE(owned, std::size_t(session.cursor()->counters().pixels.written));
    }
    Frame finished;
    render(*document().scene(), settings(), finished, {.depth = true, .ids = true});
    QCOMPARE(viewport().frame()->frame.ids, finished.ids);
}

/// Far from the beginning only a part of the record is at hand; whose the pixels are is known there, too.
void TestViews::winnersAreKnownDeepInARecord()
{
    QVERIFY(openSmall(QStringLiteral("builtin:teapot"), {320, 240}));
    QVERIFY(show(CanvasView::Facing));
    views().setOverlay(&OverlayOptions::outline, true);
    StepSession& session = m_window->stepMode().session();
    session.open();
    QVERIFY(complete());
    Frame finished;
    render(*document().scene(), settings(), finished, {.depth = true, .ids = true});
    for (const std::size_t part : {1U, 2U, 3U, 4U}) {
        session.moveTo(session.size() / 4 * part);
        QVERIFY(complete());
        QVERIFY(session.log()->first() > 0);
        const std::vector<std::int32_t> owners = viewport().frame()->frame.ids;
        const auto last = std::ranges::max_element(owners);
        QVERIFY(*last > 0);
        QCOMPARE(views().facing().picture()->frame.ids, owners);
        QVERIFY(choose(QPoint(int(last - owners.begin()) % 320, int(last - owners.begin()) / 320)));
        QCOMPARE(views().geometry().winner(), std::optional(std::uint32_t(*last)));
        // Faces are drawn in their order, and a pixel keeps the last of those that passed the test.
        QVERIFY(std::uint32_t(*last) <= session.event()->face);
    }
    session.moveTo(session.size());
    QVERIFY(complete());
    QCOMPARE(viewport().frame()->frame.ids, finished.ids);
    // A record of one face knows who else was drawn.
    session.selectFace(0);
    session.setScope(StepScope::SelectedFace);
    QVERIFY(complete());
    session.moveTo(session.size());
    QVERIFY(complete());
    QCOMPARE(viewport().frame()->frame.ids, finished.ids);
}

void TestViews::framesFollowTheCursor_data()
{
    QTest::addColumn<QString>("scene");
    QTest::addColumn<Samples>("samples");
    QTest::addColumn<QString>("mistake");
    QTest::newRow("one sample") << QStringLiteral("builtin:teapot") << Samples::One << QString();
    QTest::newRow("2 x 2") << QStringLiteral("builtin:piercing") << Samples::Grid2 << QString();
    QTest::newRow("resolved by mistake") << QStringLiteral("builtin:piercing") << Samples::Grid2
                                         << QStringLiteral("coverage-times-color");
}

/// Two frames take turns, and each is brought up to the present moment only where it is out of date.
void TestViews::framesFollowTheCursor()
{
    QFETCH(QString, scene);
    QFETCH(Samples, samples);
    QFETCH(QString, mistake);
    QVERIFY(openSmall(scene, {160, 120}));
    Settings next = settings();
    next.samples = samples;
    if (!mistake.isEmpty())
        next.mistakes = {mistake};
    document().setSettings(next);
    StepSession& session = m_window->stepMode().session();
    session.open();
    QVERIFY(complete());
    std::mt19937 random(test::seedOfRun());
    const auto isUpToDate = [&] {
        const StepCursor& cursor = *session.cursor();
        const Frame& frame = viewport().frame()->frame;
        const int grid = cursor.log().grid();
        for (int y = 0; y < frame.image.height(); ++y)
            for (int x = 0; x < frame.image.width(); ++x) {
                const auto sample = std::size_t(y * grid + grid / 2) * std::size_t(cursor.log().columns()) +
                                    std::size_t(x * grid + grid / 2);
                const auto pixel = std::size_t(y) * std::size_t(frame.image.width()) + std::size_t(x);
                if (frame.depth[pixel] != cursor.sampleDepths()[sample] ||
                    frame.ids[pixel] != cursor.sampleOwners()[sample])
                    return false;
            }
        return frame.image == cursor.image();
    };
    for (int i = 0; i < 40; ++i) {
        const std::size_t far = std::uniform_int_distribution<std::size_t>(0, session.size())(random);
        session.moveTo(i == 20 ? session.size() : i % 3 == 0 ? far : session.position() + 1);
        QVERIFY2(isUpToDate(), qPrintable(QString::number(session.position())));
    }
    // Another record begins anew.
    next.culling = Culling::Front;
    document().setSettings(next);
    QVERIFY(complete());
    for (const std::size_t part : {2U, 1U, 3U}) {
        session.moveTo(session.size() / 4 * part);
        QVERIFY(isUpToDate());
    }
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
