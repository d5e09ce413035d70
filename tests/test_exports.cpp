// What the window writes: formats by suffix, full disks, devices, pipes and inputs in use; and the sessions it opens
// that say too much, too little or what does not go together.
#include "core/io/session.h"
#include "scene_files.h"
#include "ui/base/image_export.h"
#include "ui/truth/experiment_panel.h"
#include "ui/truth/truth_mode.h"
#include "window_fixture.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QSvgRenderer>

#include <csignal>

#ifdef Q_OS_UNIX
#include <sys/resource.h>
#include <sys/stat.h>
#endif

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr char kCase[] = "size 8 8\ntri -1 -1 0 1 1 0 0   1 -1 0 1 0 1 0   0 1 0 1 0 0 1\n";

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
}

#ifdef Q_OS_UNIX
/// What `write` answers while no file may grow beyond that many bytes.
template <class Write>
auto onDiskOf(std::size_t bytes, Write&& write)
{
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit limit = before;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
    auto answer = write();
    setrlimit(RLIMIT_FSIZE, &before);
    return answer;
}
#endif

} // namespace

class TestExports : public WindowFixture
{
    Q_OBJECT

    Folder m_files;

    bool openCase() { return open(m_files.write(QStringLiteral("a.case"), kCase)); }
    QString path(const char* name) const { return m_files.path(QLatin1String(name)); }

    /// Opens a session that is refused: the scene stays, and the message says why.
    void verifyRefused(const QByteArray& json, const QString& why)
    {
        const auto before = document().scene();
        const QString file = m_files.write(QStringLiteral("refused.json"), json);
        document().open(file);
        QVERIFY(waitFor([this] { return !document().isLoading(); }));
        QVERIFY(document().scene() == before);
        QVERIFY2(m_window->message().contains(why), qPrintable(m_window->message()));
    }

private Q_SLOTS:
    void formatsFollowTheSuffix()
    {
        QVERIFY(openCase());
        const std::pair<const char*, const char*> kinds[] = {{"f.png", "\x89PNG"},   {"f.JPG", "\xff\xd8"},
                                                             {"f.jpeg", "\xff\xd8"}, {"f.bmp", "BM"},
                                                             {"f.ppm", "P6"},        {"f", "\x89PNG"}};
        for (const auto& [name, beginning] : kinds) {
            for (const auto& write :
                 {&MainWindow::exportFigure, &MainWindow::exportFramebuffer, &MainWindow::exportWindow}) {
                QFile::remove(path(name));
                QVERIFY2((m_window.get()->*write)(path(name)), qPrintable(m_window->message()));
                QVERIFY2(contentOf(path(name)).startsWith(beginning), name);
            }
        }
        QVERIFY(m_window->exportFigure(path("f.svg")));
        QVERIFY(contentOf(path("f.svg")).contains("<svg"));
        QVERIFY(!m_window->exportFigure(path("f.gif")));
        QCOMPARE(m_window->message(),
                 QStringLiteral("%1 could not be written: \"gif\" is not a format pictures are written in, which are: "
                                "png, ppm, bmp, jpg, jpeg, svg, pdf")
                     .arg(path("f.gif")));
        QVERIFY(!m_window->exportFramebuffer(path("f.svg")));
        QVERIFY(m_window->message().endsWith(QStringLiteral("which are: png, ppm, bmp, jpg, jpeg")));
        QVERIFY(!QFile::exists(path("f.gif")));
        auto& panel = m_window->truthMode().experiment();
        QVERIFY(panel.exportTo(path("m.txt")).value_or(QString()).endsWith(QStringLiteral("jpeg, csv, json, svg")));
        QVERIFY(!panel.exportTo(path("m.csv")) && !panel.exportTo(path("m.bmp")));
    }

    /// An SVG, drawn once more, is the figure: its cells end between pixels and nothing in it has to be scaled.
    void drawingsAreSharpAtEveryZoom()
    {
        QVERIFY(openCase());
        ViewportWidget& canvas = m_window->viewport();
        OverlayOptions overlays = canvas.overlays();
        overlays.numbers = false; // letters are smoothed in two ways
        canvas.setOverlays(overlays);
        for (const int zoom : {2, 3, 6, 7, 8, 15, 16, 37, 50, 128}) {
            QCOMPARE(canvas.saveSvgFigure(zoom, {path("s.svg"), {}}), std::nullopt);
            const QByteArray svg = contentOf(path("s.svg"));
            const QImage figure = canvas.figure(zoom);
            QVERIFY(!svg.contains("<image"));
            QVERIFY2(svg.contains("<svg width=\"" + QByteArray::number(figure.width()) + "\" height=\"" +
                                  QByteArray::number(figure.height()) + '"'),
                     svg.left(120).constData());
            QCOMPARE(svg.contains("fill-opacity=\"0.745"), zoom >= 16); // the rims of sample dots
            QImage drawn(figure.size(), QImage::Format_RGB32);
            drawn.fill(Qt::magenta);
            QSvgRenderer renderer(svg);
            QPainter painter(&drawn);
            renderer.render(&painter, QRectF(drawn.rect()));
            painter.end();
            int worst = 0;
            QString where;
            for (int y = 0; y < figure.height(); ++y)
                for (int x = 0; x < figure.width(); ++x) {
                    const QColor a(figure.pixel(x, y));
                    const QColor b(drawn.pixel(x, y));
                    const int here = std::max(
                        {std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
                    if (here > worst)
                        where = QStringLiteral("(%1, %2): %3 and %4").arg(x).arg(y).arg(a.name(), b.name());
                    worst = std::max(worst, here);
                }
            constexpr int kRounding = 4; // of opacities, which stand there as decimals
            constexpr int kRims = 40;    // of dots, which the screen smooths in a tile before it blends them
            const int allowed = zoom < 8 ? 0 : zoom < 16 ? kRounding : kRims;
            QVERIFY2(worst <= allowed, qPrintable(QStringLiteral("zoom %1 at %2").arg(zoom).arg(where)));
        }
    }

    void theDialogChangesTheSuffixWithTheFormat()
    {
        const std::unique_ptr<QFileDialog> dialog(newExportDialog(
            m_window.get(), QStringLiteral("x"), m_files.path(QStringLiteral("figure.png")),
            {QStringLiteral("png"), QStringLiteral("jpg"), QStringLiteral("jpeg"), QStringLiteral("svg")}));
        QCOMPARE(dialog->nameFilters(),
                 (QStringList{QStringLiteral("PNG (*.png)"), QStringLiteral("JPG (*.jpg *.jpeg)"),
                              QStringLiteral("SVG (*.svg)")}));
        Q_EMIT dialog->filterSelected(QStringLiteral("SVG (*.svg)"));
        QCOMPARE(dialog->defaultSuffix(), QStringLiteral("svg"));
        QVERIFY(dialog->selectedFiles().value(0).endsWith(QStringLiteral("/figure.svg")));
    }

    void oldFilesSurviveAFullDisk()
    {
#ifdef Q_OS_UNIX
        QVERIFY(openCase());
        QVERIFY(document().saveSession(path("s.json")));
        QVERIFY(change([](Settings& s) { s.culling = Culling::Front; }));
        const QByteArray session = contentOf(path("s.json"));
        QVERIFY(!onDiskOf(10, [&] { return document().saveSession(path("s.json")); }));
        QCOMPARE(m_window->message(),
                 QStringLiteral("%1: the file cannot be written: %2").arg(path("s.json"), qt_error_string(EFBIG)));
        QCOMPARE(contentOf(path("s.json")), session);
        QVERIFY(document().isDirty());
        QVERIFY(document().saveSession(path("s.json")));

        for (const char* name : {"f.png", "f.svg", "f.jpg"}) {
            QVERIFY(m_window->exportFigure(path(name)));
            const QByteArray old = contentOf(path(name));
            for (const qsizetype bytes : {qsizetype(0), old.size() / 2, old.size() - 1}) {
                QVERIFY(!onDiskOf(static_cast<std::size_t>(bytes), [&] { return m_window->exportFigure(path(name)); }));
                QCOMPARE(m_window->message(),
                         QStringLiteral("%1 could not be written: %2").arg(path(name), qt_error_string(EFBIG)));
                QVERIFY(contentOf(path(name)) == old);
            }
        }
        auto& panel = m_window->truthMode().experiment();
        for (const char* name : {"m.svg", "m.json"}) {
            QVERIFY(!panel.exportTo(path(name)));
            const QByteArray old = contentOf(path(name));
            QVERIFY(onDiskOf(1, [&] { return panel.exportTo(path(name)); }));
            QVERIFY(contentOf(path(name)) == old);
        }
#else
        QSKIP("no such limit on this system");
#endif
    }

    void devicesAndPipesStay()
    {
#ifdef Q_OS_UNIX
        QVERIFY(openCase());
        const QString full = QStringLiteral("/dev/full");
        if (QFile::exists(full)) {
            QVERIFY(!m_window->exportFramebuffer(full));
            QVERIFY(m_window->message().endsWith(qt_error_string(ENOSPC)));
            QVERIFY(!QFileInfo(full).isFile());
        }
        const QString pipe = path("pipe.png");
        QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        QVERIFY(!m_window->exportFramebuffer(pipe)); // and does not wait for a reader
        QVERIFY(m_window->message().endsWith(QStringLiteral("no program reads from this pipe")));
        QVERIFY(!QFileInfo(pipe).isFile());
#else
        QSKIP("no devices and pipes on this system");
#endif
    }

    void inputsAreNotOverwritten()
    {
        QVERIFY(openCase());
        QVERIFY(document().saveSession(path("s.json")));
        QVERIFY(QFile::link(path("a.case"), path("link.png")));
        const QByteArray session = contentOf(path("s.json"));
        const QString said = QStringLiteral("it is in use as an input and would be overwritten; another name is "
                                            "expected");
        QVERIFY(!m_window->exportFramebuffer(path("link.png")));
        QVERIFY2(m_window->message().endsWith(said), qPrintable(m_window->message()));
        QVERIFY(m_window->truthMode().experiment().exportTo(path("s.json")).value_or(QString()).endsWith(said));
        QVERIFY(!document().saveSession(path("a.case")));
        QVERIFY2(m_window->message().endsWith(said), qPrintable(m_window->message()));
        QCOMPARE(contentOf(path("a.case")), QByteArray(kCase));
        QCOMPARE(contentOf(path("s.json")), session);
        QCOMPARE(document().sessionPath(), path("s.json"));
        QVERIFY(document().saveSession(path("s.json"))); // its own session is what saving is about
    }

    void sessionsThatContradictTheSceneAreRefused()
    {
        QVERIFY(openCase());
        verifyRefused(R"({"rasterlens": 1, "scene": "builtin:tunnel", "settings": {"culling": "front",
                         "view": {"near": 150}}})",
                      QStringLiteral("the far plane is at 100, but must lie beyond the near plane at 150"));
        verifyRefused(R"({"rasterlens": 1, "scene": "builtin:cube", "settings": {"culling": "sideways"}})",
                      QStringLiteral("\"sideways\" is not a value of culling"));
    }

    void whatIsUnderstoodOfANewerSessionIsOpened()
    {
        m_files.write(QStringLiteral("a.case"), kCase);
        const QByteArray json = R"({"rasterlens": 2, "scene": "a.case", "mood": 1, "settings": {"culling": "front"}})";
        const QString file = m_files.write(QStringLiteral("newer.session"), json);
        QSignalSpy opened(&document(), &Document::opened);
        document().open(file);
        QVERIFY(waitFor([&] { return opened.size() == 1; }) && settle());
        QCOMPARE(document().scene()->id, path("a.case"));
        QCOMPARE(settings().culling, Culling::Front);
        QVERIFY2(m_window->message().contains(QStringLiteral("made by a newer version (2); this one reads 1")),
                 qPrintable(m_window->message()));
        QVERIFY(m_window->message().contains(QStringLiteral("\"mood\"")));
        QVERIFY2(document().sessionPath().isEmpty(), "saving asks for a name");
        QCOMPARE(contentOf(file), json);
    }

    void aSessionSaysThatItsModelIsMissing()
    {
        QVERIFY(openCase());
        QSignalSpy missing(&document(), &Document::sceneMissing);
        verifyRefused(R"({"rasterlens": 1, "scene": "gone/m.obj", "settings": {"culling": "front"}})",
                      QStringLiteral("there is no such file"));
        QCOMPARE(missing.size(), 1);
        QCOMPARE(missing[0][0].toString(), path("refused.json"));
        auto* question = m_window->findChild<QMessageBox*>(QStringLiteral("locateQuestion"));
        QVERIFY(question != nullptr && question->isVisible());
        question->defaultButton()->click();
        auto* dialog = m_window->findChild<QFileDialog*>(QStringLiteral("locateDialog"));
        QVERIFY(dialog != nullptr && dialog->isVisible());
        Q_EMIT dialog->fileSelected(path("a.case"));
        dialog->close();
        QVERIFY(waitFor([this] { return !document().isLoading(); }) && settle());
        QCOMPARE(settings().culling, Culling::Front);
        // The model is there now; that its only face is culled is another matter.
        QVERIFY2(!m_window->message().contains(QStringLiteral("m.obj")), qPrintable(m_window->message()));
        QVERIFY2(m_window->message().contains(QStringLiteral("nothing is seen")), qPrintable(m_window->message()));
        QCOMPARE(document().sessionPath(), path("refused.json"));
        QVERIFY(document().saveSession(path("refused.json")));
        QCOMPARE(loadSession(path("refused.json")).session->scene, path("a.case"));
    }
};

QTEST_MAIN(TestExports)
#include "test_exports.moc"
