#include "ui/face/vertex_editing.h"
// Corners typed and dragged in pixels, colours of corners, and distances of the planes.
#include "core/questions/vertex_place.h"
#include "core/questions/vertex_table.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "tests/window_fixture.h"
#include "ui/face/cards.h"
#include "ui/face/vertex_handles.h"
#include "ui/face/vertex_panel.h"
#include "ui/pipeline/mistake_badge.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/pipeline/plane_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableView>

using namespace rasterlens;
using namespace rasterlens::test;

class TestVertexEditing : public WindowFixture
{
    Q_OBJECT

private:
    VertexPanel& panel() { return m_window->cards().vertexPanel(); }
    VertexTableModel& model() { return panel().model(); }
    bool show(const char* scene)
    {
        return open(QLatin1String(scene)) && m_window->cards().show(QStringLiteral("vertices")) && complete();
    }
    static void choose(QComboBox& box, int value)
    {
        box.setCurrentIndex(box.findData(value));
        Q_EMIT box.activated(box.currentIndex());
    }
    void typeIn(VertexEditing::Typed unit) { choose(panel().typedBox(), int(unit)); }
    void dragTo(VertexEditing::Snap snap) { choose(panel().snapBox(), int(snap)); }
    bool type(int row, int corner, const char* text)
    {
        return model().setData(model().index(row, corner), QString::fromUtf8(text)) && complete();
    }
    VertexRow corner(std::uint32_t face, std::size_t which)
    {
        return vertexTable(*document().scene(), settings(), face)[which];
    }
    glm::vec4 position(std::size_t index)
    {
        const Mesh& mesh = document().scene()->mesh;
        return mesh.vertices[mesh.indices[index]].position;
    }

private Q_SLOTS:
    void pixelsAreTyped();
    void anyCommaIsTaken_data();
    void anyCommaIsTaken();
    void refusedTextSaysWhyAndStays();
    void sharedCornersMoveTogether();
    void draggedCornersSnap_data();
    void draggedCornersSnap();
    void dragIsOneUndoStepForBothFaces();
    void aCameraKeepsTheDistance();
    void behindTheEyeThereIsNoPlace();
    void pixelsAreThoseThatAreDrawn_data();
    void pixelsAreThoseThatAreDrawn();
    void colorsAreTyped();
    void colorsComeBackWithTheSession();
    void allRowsAreInSight();
    void planesAreTyped();
    void switchesSayThatTheyChangeNothing();
};

void TestVertexEditing::pixelsAreTyped()
{
    // By hand on 600 x 600 with w = 600: x = (2 * 100 / 600 - 1) * 600 = -400, y = (1 - 2 * 400 / 600) * 600 = -200.
    QVERIFY(show("builtin:triangle-600"));
    typeIn(VertexEditing::Typed::Pixels);
    const auto index = model().index(VertexTableModel::ScreenSpace, 1);
    QVERIFY(index.flags() & Qt::ItemIsEditable);
    QVERIFY(!(model().index(VertexTableModel::ObjectSpace, 1).flags() & Qt::ItemIsEditable));
    QVERIFY(type(VertexTableModel::ScreenSpace, 1, "100, 400"));
    QVERIFY(position(1) == glm::vec4(-400, -200, 0, 600));
    QVERIFY(corner(0, 1).snapped == glm::dvec2(100, 400));
    QVERIFY(type(VertexTableModel::ScreenSpace, 1, "450.25 75"));
    QVERIFY(position(1) == glm::vec4(300.5F, 450, 0, 600));
    typeIn(VertexEditing::Typed::Given);
    QVERIFY(type(VertexTableModel::ObjectSpace, 1, "-400 -200 0 600"));
    QVERIFY(corner(0, 1).snapped == glm::dvec2(100, 400));
}

void TestVertexEditing::anyCommaIsTaken_data()
{
    QTest::addColumn<QString>("text");
    for (const char* text : {"3,4", "3 4", "3，4", "(3; 4)", "３、４"})
        QTest::newRow(text) << QString::fromUtf8(text);
}

void TestVertexEditing::anyCommaIsTaken()
{
    QFETCH(QString, text);
    QVERIFY(show("builtin:square-diagonal"));
    typeIn(VertexEditing::Typed::Pixels);
    QVERIFY(model().setData(model().index(VertexTableModel::ScreenSpace, 0), text));
    QVERIFY(position(0) == glm::vec4(-0.25F, 0, 0, 1)); // 2 * 3 / 8 - 1, 1 - 2 * 4 / 8
}

void TestVertexEditing::refusedTextSaysWhyAndStays()
{
    QVERIFY(show("builtin:square-diagonal"));
    typeIn(VertexEditing::Typed::Pixels);
    const auto former = document().scene();
    auto* table = panel().findChild<QTableView*>();
    const QModelIndex cell = model().index(VertexTableModel::ScreenSpace, 0);
    table->setFocus();
    table->setCurrentIndex(cell);
    table->edit(cell);
    auto* edit = table->findChild<QLineEdit*>();
    QVERIFY(edit);
    for (const char* text : {"3", "3, 4, 5", "three, four", "3, "}) {
        edit->setText(QLatin1String(text));
        QTest::keyClick(edit, Qt::Key_Return);
        QVERIFY2(m_window->message().contains(QStringLiteral("Write x, y in pixels")), text);
        QVERIFY2(edit->isVisible() && edit->text() == QLatin1String(text), "stays to be mended");
        QCOMPARE(document().scene(), former);
    }
    edit->clear();
    QTest::keyClicks(edit, QStringLiteral("3, 4"));
    QVERIFY(m_window->message().isEmpty());
    QTest::keyClick(edit, Qt::Key_Return);
    QTRY_VERIFY(corner(0, 0).snapped == glm::dvec2(3, 4));
}

void TestVertexEditing::sharedCornersMoveTogether()
{
    // The corner (8, 0) is the third of face 0 and the first of face 1, two vertices at one place.
    QVERIFY(show("builtin:square-diagonal"));
    QVERIFY(document().scene()->mesh.indices[2] != document().scene()->mesh.indices[3]);
    typeIn(VertexEditing::Typed::Pixels);
    QVERIFY(type(VertexTableModel::ScreenSpace, 2, "7.5, 1.25"));
    QVERIFY(corner(0, 2).snapped == glm::dvec2(7.5, 1.25));
    QVERIFY(corner(1, 0).snapped == glm::dvec2(7.5, 1.25));
    document().undo();
    QVERIFY(corner(0, 2).snapped == glm::dvec2(8, 0) && corner(1, 0).snapped == glm::dvec2(8, 0));
    QVERIFY(!document().canUndo());
    QVERIFY(complete());
    panel().togetherBox().setChecked(false);
    QVERIFY(type(VertexTableModel::ScreenSpace, 2, "7.5, 1.25"));
    QVERIFY(corner(0, 2).snapped == glm::dvec2(7.5, 1.25));
    QVERIFY(corner(1, 0).snapped == glm::dvec2(8, 0));
}

void TestVertexEditing::draggedCornersSnap_data()
{
    using Snap = VertexEditing::Snap;
    QTest::addColumn<int>("snap");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    // From (3.3001, 4.7003): 3.3001 * 256 = 844.8, 4.7003 * 256 = 1203.3.
    QTest::newRow("grid") << int(Snap::PixelGrid) << 3.0 << 5.0;
    QTest::newRow("centre") << int(Snap::PixelCentre) << 3.5 << 4.5;
    QTest::newRow("1/256") << int(Snap::SubpixelGrid) << 845.0 / 256 << 1203.0 / 256;
}

void TestVertexEditing::draggedCornersSnap()
{
    QFETCH(int, snap);
    QFETCH(double, x);
    QFETCH(double, y);
    QVERIFY(show("builtin:square-diagonal"));
    dragTo(static_cast<VertexEditing::Snap>(snap));
    m_window->cards().vertexHandles().moveVertex(document().scene()->mesh.indices[2], {3.3001, 4.7003});
    QVERIFY(complete());
    QVERIFY(corner(0, 2).snapped == glm::dvec2(x, y));
    QVERIFY(corner(1, 0).snapped == glm::dvec2(x, y));
}

void TestVertexEditing::dragIsOneUndoStepForBothFaces()
{
    QVERIFY(show("builtin:square-diagonal"));
    dragTo(VertexEditing::Snap::PixelGrid);
    const auto original = document().scene();
    ViewportWidget& canvas = viewport();
    const auto at = [&](QPointF pixels) { return canvas.transform().toCanvas(pixels).toPoint(); };
    QTest::mousePress(&canvas, Qt::LeftButton, {}, at({8, 0}));
    for (int i = 1; i <= 6; ++i)
        QTest::mouseMove(&canvas, at(QPointF(8, 0) + QPointF(-0.5, 0.5) * i));
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, at({5, 3}));
    QVERIFY(complete());
    QVERIFY(corner(0, 2).snapped == glm::dvec2(5, 3) && corner(1, 0).snapped == glm::dvec2(5, 3));
    document().undo();
    QVERIFY(document().scene() == original);
    QVERIFY(!document().canUndo());
}

void TestVertexEditing::aCameraKeepsTheDistance()
{
    // The eye of games101 is 7 before the plane z = -2 of face 0, and sees 7 tan 22.5 degrees of it to each side on 350
    // pixels: the corner at (350, 350) is (0, 0, -2), the one at (700, 350) is (7 tan 22.5 degrees, 0, -2).
    QVERIFY(show("builtin:games101"));
    typeIn(VertexEditing::Typed::Pixels);
    QVERIFY(type(VertexTableModel::ScreenSpace, 1, "350, 350"));
    QVERIFY(glm::length(position(1) - glm::vec4(0, 0, -2, 1)) < 1e-5F);
    QVERIFY(type(VertexTableModel::ScreenSpace, 1, "700, 350"));
    QVERIFY(glm::length(position(1) - glm::vec4(2.8994949F, 0, -2, 1)) < 1e-5F);
    QCOMPARE(corner(0, 1).clip.w, 7.0);
    QVERIFY(corner(0, 1).snapped == glm::dvec2(700, 350));
}

void TestVertexEditing::behindTheEyeThereIsNoPlace()
{
    QVERIFY(show("builtin:behind-camera"));
    typeIn(VertexEditing::Typed::Pixels);
    QVERIFY(corner(0, 1).clip.w < 0);
    const QModelIndex behind = model().index(VertexTableModel::ScreenSpace, 1);
    QVERIFY(!(behind.flags() & Qt::ItemIsEditable));
    QVERIFY(behind.data(Qt::ToolTipRole).toString().contains(QStringLiteral("no place on the screen")));
    QVERIFY(!model().setData(behind, QStringLiteral("3, 4")));
    QVERIFY(!positionAtPixel(*document().scene(), settings(), document().scene()->mesh.indices[1], {3, 4}));
    QVERIFY(model().index(VertexTableModel::ScreenSpace, 0).flags() & Qt::ItemIsEditable);
}

/// Also where a mistake moves the picture, or the depth runs the other way.
void TestVertexEditing::pixelsAreThoseThatAreDrawn_data()
{
    QTest::addColumn<QString>("scene");
    QTest::addColumn<QString>("mistake");
    for (const char* scene : {"builtin:square-diagonal", "builtin:triangle-600", "builtin:tile-square"})
        for (const char* mistake : {"", "corner-sampling", "y-flipped-once", "all-inclusive"})
            QTest::addRow("%s %s", scene, mistake) << QString::fromLatin1(scene) << QString::fromLatin1(mistake);
}

void TestVertexEditing::pixelsAreThoseThatAreDrawn()
{
    QFETCH(QString, scene);
    QFETCH(QString, mistake);
    QVERIFY(show(qPrintable(scene)));
    QVERIFY(change([&](Settings& s) {
        s.reversedZ = true;
        if (!mistake.isEmpty())
            s.mistakes = {mistake};
    }));
    typeIn(VertexEditing::Typed::Pixels);
    const VertexRow before = corner(0, 0);
    QVERIFY(type(VertexTableModel::ScreenSpace, 0, "5.25, 2.5"));
    const VertexRow after = corner(0, 0);
    QVERIFY(after.snapped == glm::dvec2(5.25, 2.5));
    QVERIFY(std::abs(after.depth - before.depth) < 1e-6 &&
            std::abs(after.clip.w - before.clip.w) < 1e-5 * before.clip.w);
}

void TestVertexEditing::colorsAreTyped()
{
    QVERIFY(show("builtin:square-diagonal"));
    const QImage before = picture();
    QVERIFY(type(VertexTableModel::VertexColor, 0, "0 0.5 1"));
    const Mesh& mesh = document().scene()->mesh;
    QVERIFY(mesh.vertices[mesh.indices[0]].color == glm::vec3(0, 0.5F, 1));
    QVERIFY(picture() != before);
    QVERIFY(type(VertexTableModel::VertexColor, 0, "#e8a33d"));
    QVERIFY(document().scene()->mesh.vertices[mesh.indices[0]].color == glm::vec3(232, 163, 61) / 255.0F);
    for (const char* text : {"0 0.5", "0, 0.5, 2", "-1 0 0", "#12", "red"}) {
        QVERIFY2(!model().setData(model().index(VertexTableModel::VertexColor, 0), QLatin1String(text)), text);
        QVERIFY2(model().whyRefused(VertexTableModel::VertexColor, QLatin1String(text)), text);
    }
    document().undo();
    document().undo();
    QVERIFY(complete());
    QCOMPARE(picture(), before);
    QVERIFY(!document().canUndo());
}

void TestVertexEditing::colorsComeBackWithTheSession()
{
    QVERIFY(show("builtin:square-diagonal"));
    QVERIFY(type(VertexTableModel::VertexColor, 1, "0.25 0.5 1"));
    QVERIFY(document().isDirty());
    const QImage edited = picture();
    const QString path = m_folder.filePath(QStringLiteral("colors.json"));
    QVERIFY(document().saveSession(path));
    QVERIFY(open(QStringLiteral("builtin:triangle")));
    document().open(path);
    QVERIFY(complete());
    QCOMPARE(picture(), edited);
    QVERIFY(document().session().colors ==
            (std::map<std::uint32_t, glm::vec3>{{document().scene()->mesh.indices[1], {0.25F, 0.5F, 1}}}));
}

/// Every row of the table has its whole height, name included, above the table's foot.
void TestVertexEditing::allRowsAreInSight()
{
    for (const char* scene : {"builtin:square-diagonal", "builtin:tile-square"}) {
        QVERIFY(show(scene));
        QCoreApplication::processEvents();
        const auto* table = panel().findChild<QTableView*>();
        const int last = VertexTableModel::kRowCount - 1;
        const QHeaderView* names = table->verticalHeader();
        QVERIFY(names->sectionViewportPosition(last) + names->sectionSize(last) <= table->viewport()->height());
    }
}

void TestVertexEditing::planesAreTyped()
{
    QVERIFY(open(QStringLiteral("builtin:games101")));
    auto* pipeline = m_window->findChild<PipelinePanel*>();
    PlaneFields& planes = pipeline->planes();
    const Settings before = settings();
    const auto typed = [&](QLineEdit& edit, const char* text) {
        edit.setFocus();
        edit.setText(QLatin1String(text));
        QTest::keyClick(&edit, Qt::Key_Return);
        return m_window->message();
    };
    for (const char* zero : {"0", "-1"}) {
        QVERIFY2(typed(planes.nearEdit(), zero).contains(QStringLiteral("z' = n + f - nf/z is f for every z")), zero);
        QCOMPARE(planes.nearEdit().text(), QLatin1String(zero));
        QVERIFY(settings() == before);
    }
    QTest::keyClick(&planes.nearEdit(), Qt::Key_Escape);
    QVERIFY(m_window->message().isEmpty());
    for (const char* text : {"0.1", "0.05"})
        QVERIFY2(typed(planes.farEdit(), text).contains(QStringLiteral("must lie beyond the near plane at 0.1")), text);
    QVERIFY(settings() == before);
    QTest::keyClick(&planes.farEdit(), Qt::Key_Escape);
    QVERIFY(typed(planes.nearEdit(), "near").contains(QStringLiteral("is not a distance")));
    QTest::keyClick(&planes.nearEdit(), Qt::Key_Escape);
    typed(planes.nearEdit(), "6");
    QCOMPARE(settings().view.near.value_or(0), 6.0);
    typed(planes.nearEdit(), "");
    QVERIFY(!settings().view.near);
    QVERIFY(planes.nearEdit().text().startsWith(QStringLiteral("auto (")));
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY2(!planes.isVisible(), "there is no camera");
}

void TestVertexEditing::switchesSayThatTheyChangeNothing()
{
    QVERIFY(open(QStringLiteral("builtin:games101")));
    auto* pipeline = m_window->findChild<PipelinePanel*>();
    const QString id = QStringLiteral("interpolation");
    QVERIFY(pipeline->note(id).isEmpty());
    QVERIFY(change([](Settings& s) { s.interpolation = Interpolation::Affine; }));
    QCOMPARE(pipeline->note(id), QStringLiteral("changes nothing here: the three w of each face are equal: 7 and 10"));
    QVERIFY(change([](Settings& s) {
        s.interpolation = Interpolation::Perspective;
        s.mistakes = {QStringLiteral("w-lost")};
    }));
    QVERIFY(pipeline->note(id).isEmpty());
    const QStringList lines = m_window->findChild<MistakeBadge*>()->lines();
    QVERIFY2(lines.size() == 2 && lines[1].endsWith(QStringLiteral("are equal: 7 and 10")),
             qPrintable(lines.join(u'\n')));
    QVERIFY(open(QStringLiteral("builtin:games101-tilted")));
    QVERIFY(change([](Settings& s) {
        s.interpolation = Interpolation::Affine;
        s.mistakes = {QStringLiteral("w-lost")};
    }));
    QVERIFY(pipeline->note(id).isEmpty());
    QCOMPARE(m_window->findChild<MistakeBadge*>()->lines().size(), 1);
}

QTEST_MAIN(TestVertexEditing)
#include "test_vertex_editing.moc"
