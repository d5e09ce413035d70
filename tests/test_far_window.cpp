// Models far from the origin in the window: the file's coordinates in the vertex table, under the mouse and in
// sessions; the camera; and the referee that judges the vertex stage as well.
#include "core/questions/vertex_table.h"
#include "core/scene/origin.h"
#include "tests/window_fixture.h"
#include "ui/document/navigation.h"
#include "ui/face/cards.h"
#include "ui/face/vertex_handles.h"
#include "ui/face/vertex_panel.h"
#include "ui/truth/referee_bar.h"
#include "ui/truth/truth_mode.h"

#include <QToolButton>

using namespace rasterlens;
using namespace rasterlens::test;

class TestFarWindow : public WindowFixture
{
    Q_OBJECT

private:
    /// A tetrahedron 8 units large that lies somewhere.
    QString tetrahedron(double x, double y, double z)
    {
        const QString path = m_folder.filePath(QStringLiteral("far.obj"));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly))
            qFatal("cannot write %s", qPrintable(path));
        const double corners[4][3] = {{0, 0, 0}, {8, 0, 0}, {4, 8, 0}, {4, 2.7, 6.1}};
        for (const auto& corner : corners)
            file.write(QStringLiteral("v %1 %2 %3\n")
                           .arg(x + corner[0], 0, 'f', 3)
                           .arg(y + corner[1], 0, 'f', 3)
                           .arg(z + corner[2], 0, 'f', 3)
                           .toUtf8());
        file.write("f 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 3 2\n");
        return path;
    }

    VertexTableModel& table() { return m_window->cards().vertexPanel().model(); }
    QString cell(int column) { return table().data(table().index(VertexTableModel::ObjectSpace, column)).toString(); }
    bool openFar()
    {
        return open(tetrahedron(500000, 5000000, 100)) && m_window->cards().show(QStringLiteral("vertices")) &&
               complete();
    }
    glm::dvec3 worldOf(std::uint32_t vertex) { return glm::dvec3(worldPosition(document().scene()->mesh, vertex)); }

private Q_SLOTS:
    void vertexTableShowsAndTakesTheCoordinatesOfTheFile()
    {
        QVERIFY(openFar());
        QVERIFY(document().scene()->mesh.origin == glm::dvec3(500000, 5000000, 104));
        QCOMPARE(table().headerData(VertexTableModel::ObjectSpace, Qt::Vertical, Qt::DisplayRole).toString(),
                 QStringLiteral("world  x, y, z"));
        QCOMPARE(cell(0), QStringLiteral("500000, 5000000, 100"));
        QCOMPARE(cell(2), QStringLiteral("500004, 5000002.7, 106.1"));
        const QModelIndex last = table().index(VertexTableModel::ObjectSpace, 2);
        const auto before = document().scene();
        QVERIFY(table().setData(last, cell(2))); // what is shown, typed again, moves nothing
        QVERIFY(document().scene() == before);
        QVERIFY(table().setData(last, QStringLiteral("500004.125, 5000003.5, 105")));
        QVERIFY(complete());
        QVERIFY(worldOf(before->mesh.indices[2]) == glm::dvec3(500004.125, 5000003.5, 105));
        QCOMPARE(cell(2), QStringLiteral("500004.125, 5000003.5, 105"));
        QVERIFY(open(QStringLiteral("builtin:leaf")));
        QCOMPARE(table().headerData(VertexTableModel::ObjectSpace, Qt::Vertical, Qt::DisplayRole).toString(),
                 QStringLiteral("object  x, y, z"));
    }

    void draggedCornersGoWhereTheMouseIs()
    {
        QVERIFY(openFar());
        const std::uint32_t vertex = document().scene()->mesh.indices[1];
        const glm::dvec3 before = worldOf(vertex);
        const QPointF from = *m_window->cards().vertexHandles().screenOf(vertex);
        m_window->cards().vertexHandles().moveVertex(vertex, from + QPointF(10, -6));
        QVERIFY(complete());
        const QPointF to = *m_window->cards().vertexHandles().screenOf(vertex);
        constexpr double kTwoSteps = 2.0 / 256;
        QVERIFY(std::abs(to.x() - from.x() - 10) <= kTwoSteps && std::abs(to.y() - from.y() + 6) <= kTwoSteps);
        const double moved = glm::length(worldOf(vertex) - before);
        QVERIFY(moved > 0.01 && moved < 8);
    }

    void sessionsHoldTheCoordinatesOfTheFile()
    {
        QVERIFY(openFar());
        const std::uint32_t vertex = document().scene()->mesh.indices[0];
        QVERIFY(table().setData(table().index(VertexTableModel::ObjectSpace, 0),
                                QStringLiteral("500001.25, 5000000.5, 99.5")));
        QVERIFY(complete());
        const QImage moved = picture();
        const QString session = m_folder.filePath(QStringLiteral("far.json"));
        QVERIFY(document().saveSession(session));
        QFile file(session);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("500001.25"));
        QVERIFY(open(QStringLiteral("builtin:leaf")));
        document().open(session);
        QVERIFY(complete());
        QVERIFY(worldOf(vertex) == glm::dvec3(500001.25, 5000000.5, 99.5));
        QCOMPARE(picture(), moved);
    }

    /// Far from 0, drags of the mouse give the pictures they give near 0, with either kind of camera.
    void camerasMoveAsNearTheOrigin()
    {
        QImage pictures[2][3];
        // 2^26 away: the positions are the same float32 values, and so are the eye's in object space.
        const glm::dvec3 places[2] = {{0, 0, 0}, {0x1p26, -0x1p26, 0}};
        for (int i = 0; i < 2; ++i) {
            const glm::dvec3& place = places[i];
            QVERIFY(open(tetrahedron(place.x, place.y, place.z)));
            QVERIFY(change([](Settings& s) {
                s.size = {320, 240};
                s.view = orbit(s.view, QPointF(60, 20), 240);
            }));
            pictures[i][0] = picture();
            QVERIFY(change([&](Settings& s) {
                s.view.fit = false;
                s.view.eye = place + glm::dvec3(10, 12, 24);
                s.view.target = place + glm::dvec3(4, 3, 2);
            }));
            pictures[i][1] = picture();
            QVERIFY(change([&](Settings& s) {
                s.view = orbit(s.view, QPointF(-45, 30), 240);
                s.view = panCamera(s.view, QPointF(7, -5), 240, document().scene()->bounds);
                s.view = dolly(s.view, 0.75);
            }));
            pictures[i][2] = picture();
        }
        QCOMPARE(pictures[0][0], pictures[1][0]);
        QCOMPARE(pictures[0][1], pictures[1][1]);
        // Eye and target are numbers of the world, which doubles hold to 2^-27 there.
        int differing = 0;
        for (int y = 0; y < 240; ++y)
            for (int x = 0; x < 320; ++x)
                differing += pictures[0][2].pixel(x, y) != pictures[1][2].pixel(x, y);
        QVERIFY2(differing < 20, qPrintable(QString::number(differing)));
        QVERIFY(pictures[0][2] != pictures[0][1]);
    }

    /// A camera beyond float32: from clip space all is well, from object space nothing is.
    void refereeSaysWhereItStarts()
    {
        TruthMode& truth = m_window->truthMode();
        Referee& referee = truth.referee();
        QToolButton& space = truth.refereeBar().spaceButton();
        QVERIFY(openSmall(QStringLiteral("builtin:sphere")));
        referee.setOn(true);
        QVERIFY(complete());
        QVERIFY(referee.judgement()->space == ReferenceSpace::Clip);
        QCOMPARE(space.text(), QStringLiteral("from clip space"));
        space.click();
        QVERIFY(complete());
        QVERIFY(referee.judgement()->space == ReferenceSpace::Object);
        QCOMPARE(space.text(), QStringLiteral("from object space"));
        QVERIFY(referee.judgement()->difference.wrong() < 20);

        auto far = std::make_shared<Scene>(*document().scene());
        const glm::dvec3 move(0x1p20, 0x1p20, 0);
        for (MeshVertex& vertex : far->mesh.vertices)
            vertex.position = glm::vec4(glm::dvec3(vertex.position) + move, 1);
        far->bounds.center += move;
        document().setScene(far, settings());
        QVERIFY(complete());
        QVERIFY(referee.judgement()->difference.wrong() > 1000);
        key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(complete());
        QCOMPARE(space.text(), QStringLiteral("from clip space"));
        QCOMPARE(referee.judgement()->difference.wrong(), std::uint64_t{0});

        referee.setSpace(ReferenceSpace::Object);
        QVERIFY(open(QStringLiteral("builtin:square-diagonal"))); // given in clip space
        QVERIFY(!space.isEnabled());
        QCOMPARE(space.text(), QStringLiteral("from clip space"));
        QVERIFY(referee.judgement()->space == ReferenceSpace::Clip);
    }
};

QTEST_MAIN(TestFarWindow)
#include "test_far_window.moc"
