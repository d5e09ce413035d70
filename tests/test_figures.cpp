// Figures for pages and slides: from the window and from the command line, as pixels and as drawings; handouts.
#include "tests/cli_support.h"
#include "tests/page_support.h"
#include "tests/window_fixture.h"
#include "ui/canvas/figure_sheet.h"
#include "ui/steps/run_export.h"
#include "ui/steps/step_mode.h"
#include "ui/window/figure_export.h"
#include "ui/window/page_export.h"

#include <QClipboard>
#include <QImageReader>
#include <QPainter>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSvgRenderer>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr int kMargin = 20; ///< around a figure

QImage asRgb(const QImage& image) { return image.convertToFormat(QImage::Format_RGB32); }

/// Whether anything is written in a part of a figure.
bool hasInk(const QImage& image, const QRect& part)
{
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x)
            if (qGray(image.pixel(x, y)) < 128)
                return true;
    return false;
}

std::vector<QImage> framesOf(const QString& path)
{
    QImageReader reader(path);
    std::vector<QImage> frames;
    for (QImage frame = reader.read(); !frame.isNull(); frame = reader.read())
        frames.push_back(asRgb(frame));
    return frames;
}

/// What 256 colours in place of a figure's many may make of a channel.
constexpr int kPaletteError = 40;

int error(const QImage& a, const QImage& b)
{
    int most = a.size() == b.size() ? 0 : 255;
    for (int y = 0; y < std::min(a.height(), b.height()); ++y)
        for (int x = 0; x < std::min(a.width(), b.width()); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            most = std::max(
                {most, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
        }
    return most;
}

} // namespace

class TestFigures : public WindowFixture
{
    Q_OBJECT

private:
    FigureExport& figures() { return m_window->figures(); }
    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    bool openSquare() { return open(QStringLiteral("builtin:square-diagonal")); }
    bool goToTie()
    {
        m_window->stepMode().showStep(QStringLiteral("tie"));
        return waitFor([this] { return m_window->stepMode().session().position() > 0; }) && complete();
    }
    /// The command line, which draws figures with the program beside it.
    Run figure(const QStringList& words) { return run(QStringList{QStringLiteral("figure")} + words, m_folder.path()); }

private Q_SLOTS:
    void aFigureIsThePictureWithAMarginAndTexts()
    {
        QVERIFY(openSquare() && goToTie());
        viewport().selectPixel(QPoint(7, 0));
        QVERIFY(complete());
        figures().setZoom(48);
        const QImage image = figures().image();
        const QImage plain = viewport().figure(48);
        QCOMPARE(image.copy(QRect(QPoint(kMargin, kMargin), plain.size())), plain);
        QVERIFY(!hasInk(image, QRect(0, 0, image.width(), kMargin)));
        QVERIFY(!hasInk(image, QRect(0, 0, kMargin, image.height())));
        const int below = kMargin + plain.height();
        QVERIFY(hasInk(image, QRect(kMargin, below, image.width() - 2 * kMargin, image.height() - below)));
        // Caption, code, formula and legend need more room than a caption alone, and that more than nothing.
        figures().setCaption(QStringLiteral("One line"));
        QVERIFY(figures().image().height() < image.height());
        figures().setTexts(false);
        QCOMPARE(figures().image(), plain);
    }

    void everyZoomIsExact()
    {
        QVERIFY(openSquare());
        for (const int zoom : {1, 2, 7, 24, 64, FigureExport::kLargestZoom}) {
            figures().setZoom(zoom);
            const QImage image = figures().image();
            for (int y = 0; y < 8; ++y)
                for (int x = 0; x < 8; ++x) { // beside the sample dots
                    const QPoint inside(kMargin + x * zoom + zoom / 4, kMargin + y * zoom + zoom / 4);
                    if (zoom < 48) // from there on numbers stand on the pixels
                        QCOMPARE(image.pixel(inside), picture().pixel(x, y));
                }
            QVERIFY(image.width() >= 8 * zoom + 2 * kMargin);
        }
        figures().setZoom(4);
        figures().setRegion(QRect(2, 3, 5, 4));
        figures().setTexts(true);
        const QImage part = figures().image();
        QCOMPARE(part.pixel(kMargin + 1, kMargin + 1), picture().pixel(2, 3));
        QCOMPARE(part.pixel(kMargin + 4 * 4 + 1, kMargin + 4 * 3 + 1), picture().pixel(6, 6));
    }

    void copyingTakesTheFigure()
    {
        QVERIFY(openSquare());
        key(Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(asRgb(QGuiApplication::clipboard()->image()), figures().image());
    }

    /// A picture inside a drawing would be blurred by most viewers.
    void drawingsHoldSquaresAndNoPictures()
    {
        QVERIFY(openSquare());
        figures().setZoom(20);
        QCOMPARE(figures().exportTo(path("f.svg")), std::nullopt);
        const QByteArray svg = readFile(path("f.svg"));
        QVERIFY(!svg.contains("<image"));
        QVERIFY(svg.contains("<style>rect{shape-rendering:crispEdges}</style>")); // no seams where it is scaled
        QVERIFY(svg.contains("<rect"));
        QSvgRenderer renderer(svg);
        QImage drawn(renderer.defaultSize() * 3, QImage::Format_RGB32); // enlarged: still sharp
        drawn.fill(Qt::magenta);
        QPainter painter(&drawn);
        renderer.render(&painter, QRectF(drawn.rect()));
        painter.end();
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                for (const QPoint corner : {QPoint(3, 3), QPoint(18, 3), QPoint(3, 18), QPoint(18, 18)}) {
                    const QPoint at = 3 * (QPoint(kMargin + 20 * x, kMargin + 20 * y) + corner);
                    QCOMPARE(drawn.pixel(at), picture().pixel(x, y));
                }
        QCOMPARE(figures().exportTo(path("f.pdf")), std::nullopt);
        const QByteArray pdf = readFile(path("f.pdf"));
        QVERIFY(pdf.startsWith("%PDF-"));
        QVERIFY(!pdf.contains("/Subtype /Image"));
        QVERIFY(goToTie());
        QCOMPARE(figures().exportTo(path("step.pdf")), std::nullopt);
        QVERIFY(!readFile(path("step.pdf")).contains("/Subtype /Image"));
    }

    void beforeAndAfterStandBesideEachOther()
    {
        QVERIFY(openSquare());
        const QImage right = picture();
        QVERIFY(change([](Settings& s) { s.mistakes = {QStringLiteral("all-exclusive")}; }));
        const QImage wrong = picture();
        QVERIFY(right != wrong);
        figures().setZoom(6);
        QSignalSpy finished(&figures(), &FigureExport::finished);
        figures().exportBeforeAfter(path("both.png"));
        QVERIFY(finished.wait(kPatienceMs));
        QCOMPARE(finished.front()[1].toString(), QString());
        const QImage both = asRgb(QImage(path("both.png")));
        const auto find = [&both](const QImage& picture, int fromX) { // the first place of a picture, 6 times as large
            const QImage large = picture.scaled(picture.size() * 6);
            for (int y = 0; y < 80; ++y)
                for (int x = fromX; x + large.width() < both.width(); ++x)
                    if (both.copy(x, y, large.width(), large.height()) == large)
                        return x;
            return -1;
        };
        const int first = find(right, 0);
        QCOMPARE(first, kMargin);
        QVERIFY(find(wrong, first + 48) > 0);
    }

    void framesOfARunHaveOneSize()
    {
        QVERIFY(openSquare() && goToTie());
        viewport().goToPixel({0, 0}); // a close-up that would follow the steps
        viewport().setZoom(128);
        const std::size_t last = m_window->stepMode().session().size();
        QVERIFY(last >= 100);
        QSignalSpy finished(&m_window->stepMode().exportRun(m_folder.path(), {98, 101, std::nullopt}),
                            &RunExport::finished);
        QVERIFY(finished.wait(kPatienceMs));
        QCOMPARE(finished.front().front().toString(), QString());
        const QSize size = QImage(path("step-098.png")).size();
        QVERIFY(!size.isEmpty());
        for (const char* name : {"step-099.png", "step-100.png", "step-101.png"})
            QCOMPARE(QImage(path(name)).size(), size);
    }

    /// The single figures of a run, each on a sheet as large as the largest of them.
    void animationsHoldTheFigures()
    {
        QVERIFY(openSquare() && goToTie());
        figures().setZoom(20);
        QSignalSpy finished(&figures(), &FigureExport::finished);
        const std::size_t position = m_window->stepMode().session().position();
        figures().exportRun(path("run.gif"), {36, 42, 120}, m_window.get());
        QVERIFY(finished.wait(kPatienceMs));
        QCOMPARE(finished.front()[1].toString(), QString());
        QCOMPARE(m_window->stepMode().session().position(), position);
        const std::vector<QImage> frames = framesOf(path("run.gif"));
        QCOMPARE(frames.size(), std::size_t(7));
        QSize size;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            m_window->stepMode().session().moveTo(36 + i);
            size = size.expandedTo(figures().size());
        }
        for (std::size_t i = 0; i < frames.size(); ++i) {
            m_window->stepMode().session().moveTo(36 + i);
            const QImage figure = figures().imageOn(size);
            QCOMPARE(frames[i].size(), size);
            QVERIFY(error(frames[i], figure) <= kPaletteError);
        }
        QVERIFY(frames[3] != frames[4]);
    }

    /// A figure of few colours loses none of them.
    void animationsOfFewColorsAreExact()
    {
        QVERIFY(openSquare() && goToTie());
        viewport().setOverlays({});
        figures().setTexts(false);
        figures().setZoom(8);
        QSignalSpy finished(&figures(), &FigureExport::finished);
        figures().exportRun(path("few.gif"), {300, 306, 100}, m_window.get());
        QVERIFY(finished.wait(kPatienceMs));
        QCOMPARE(finished.front()[1].toString(), QString());
        const std::vector<QImage> frames = framesOf(path("few.gif"));
        QCOMPARE(frames.size(), std::size_t(7));
        for (std::size_t i = 0; i < frames.size(); ++i) {
            m_window->stepMode().session().moveTo(300 + i);
            QCOMPARE(frames[i], figures().image());
        }
    }

    void commandLineWritesAnimations()
    {
        const auto made = [this](const QStringList& words) {
            return figure(QStringList{QStringLiteral("builtin:square-diagonal"), QStringLiteral("--figure-scale"),
                                      QStringLiteral("24"), QStringLiteral("-o")} +
                          words);
        };
        const auto option = [](const char* name, const char* value) {
            return QStringList{QLatin1String(name), QLatin1String(value)};
        };
        const Run run = made(QStringList{QStringLiteral("c.gif")} + option("--steps", "38-41"));
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        const std::vector<QImage> frames = framesOf(path("c.gif"));
        QCOMPARE(frames.size(), std::size_t(4));
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const QByteArray number = QByteArray::number(int(38 + i));
            QCOMPARE(made(QStringList{QStringLiteral("one.png")} + option("--step", number.constData())).exitCode, 0);
            const QImage one = asRgb(QImage(path("one.png")));
            QVERIFY(error(frames[i].copy(one.rect()), one) <= kPaletteError);
        }
        const auto refused = [&](const QStringList& words, const char* why) {
            const Run run = made(words);
            return run.exitCode == 2 && run.err.contains(QLatin1String(why));
        };
        const QStringList gif{QStringLiteral("r.gif")};
        QVERIFY(refused(gif, "--steps FIRST-LAST or --motion ID:FIRST-LAST is expected"));
        QVERIFY(refused(QStringList{QStringLiteral("r.png")} + option("--steps", "1-2"), "gif"));
        QVERIFY(refused(gif + option("--steps", "9-3"), "no run of steps"));
        QVERIFY(refused(gif + option("--steps", "3-999"), "the record has the steps 0 to 341"));
        QVERIFY(refused(gif + option("--steps", "3-99999"), "at most 5000 pictures"));
        QVERIFY(refused(gif + option("--steps", "3-9") + option("--step", "3"), "cannot be combined"));
        QVERIFY(refused(gif + option("--steps", "3-9") + option("--frame-time", "5"), "--frame-time"));
        QVERIFY(refused(QStringList{QStringLiteral("r.png")} + option("--frame-time", "50"), "needs --steps"));
        QVERIFY(refused(gif + option("--motion", "jitter:9-3"), "not a motion"));
        QVERIFY(refused(gif + option("--motion", "turntable:0-9"), "clip space"));
        QVERIFY(refused(gif + option("--motion", "jitter:0-5000"), "at most 5000 pictures"));
        QVERIFY(refused(gif + option("--motion", "jitter:0-9") + option("--steps", "3-9"), "cannot be combined"));
        QVERIFY(refused(QStringList{QStringLiteral("r.png")} + option("--motion", "jitter:0-9"), "gif"));
        QVERIFY(!QFile::exists(path("r.gif")) && !QFile::exists(path("r.png")));
        // Frames of a motion: that of the jitter is the picture of its caption, alone and in a run.
        const Run moved = made(QStringList{QStringLiteral("m.gif")} + option("--motion", "jitter:127-130"));
        QVERIFY2(moved.exitCode == 0, qPrintable(moved.err));
        const std::vector<QImage> jitter = framesOf(path("m.gif"));
        QCOMPARE(jitter.size(), std::size_t(4));
        QCOMPARE(made(QStringList{QStringLiteral("one.png")} + option("--motion", "jitter:129")).exitCode, 0);
        const QImage one = asRgb(QImage(path("one.png")));
        QVERIFY(error(jitter[2].copy(one.rect()), one) <= kPaletteError);
    }

    void commandLineWritesFigures()
    {
        const QString scene = QStringLiteral("builtin:square-diagonal");
        for (const char* name : {"c.png", "c.svg", "c.pdf"}) {
            const Run made = figure({scene, QStringLiteral("--step"), QStringLiteral("tie"), QStringLiteral("--pixel"),
                                     QStringLiteral("7,0"), QStringLiteral("--overlay"), QStringLiteral("grid"),
                                     QStringLiteral("--figure-scale"), QStringLiteral("48"), QStringLiteral("-o"),
                                     QLatin1String(name)});
            QVERIFY2(made.exitCode == 0, qPrintable(made.err));
            QVERIFY(QFile::exists(path(name)));
        }
        const int width = QImage(path("c.png")).width();
        QVERIFY(width >= 8 * 48 + 2 * kMargin);
        // A viewer's own font must not run over the border.
        static const QRegularExpression text(
            QStringLiteral("<text [^>]*\\bx=\"([0-9.]+)\"[^>]*textLength=\"([0-9.]+)\""));
        int texts = 0;
        for (auto it = text.globalMatch(QString::fromUtf8(readFile(path("c.svg")))); it.hasNext(); ++texts) {
            const QRegularExpressionMatch match = it.next();
            QVERIFY(match.captured(1).toDouble() + match.captured(2).toDouble() <= width);
        }
        QVERIFY(texts > 5);

        QVERIFY(openSquare() && change([](Settings& s) { s.mistakes = {QStringLiteral("all-exclusive")}; }));
        const Run wrong = figure({scene, QStringLiteral("--mistake"), QStringLiteral("all-exclusive"),
                                  QStringLiteral("--overlay"), QStringLiteral("none"), QStringLiteral("--figure-scale"),
                                  QStringLiteral("4"), QStringLiteral("-o"), QStringLiteral("wrong.png")});
        QVERIFY2(wrong.exitCode == 0, qPrintable(wrong.err));
        const QImage image = asRgb(QImage(path("wrong.png")));
        QCOMPARE(image.copy(kMargin, kMargin, 32, 32), picture().scaled(32, 32));
    }

    void commandLineRefuses()
    {
        const QString scene = QStringLiteral("builtin:square-diagonal");
        const QString out = QStringLiteral("r.png");
        const auto code = [&](const QStringList& words) { return figure(words).exitCode; };
        QCOMPARE(code({scene}), 2);
        QCOMPARE(code({scene, QStringLiteral("-o"), QStringLiteral("r.gif")}), 2);
        QCOMPARE(code({scene, QStringLiteral("-o"), out, QStringLiteral("--step"), QStringLiteral("nowhere")}), 2);
        QCOMPARE(code({scene, QStringLiteral("-o"), out, QStringLiteral("--step"), QStringLiteral("clip")}), 2);
        QCOMPARE(code({scene, QStringLiteral("-o"), out, QStringLiteral("--pixel"), QStringLiteral("8,0")}), 2);
        QCOMPARE(code({scene, QStringLiteral("-o"), out, QStringLiteral("--overlay"), QStringLiteral("lace")}), 2);
        QCOMPARE(code({scene, QStringLiteral("-o"), out, QStringLiteral("--figure-scale"), QStringLiteral("129")}), 2);
        QCOMPARE(code({scene, QStringLiteral("-o"), out, QStringLiteral("--region"), QStringLiteral("8,0,2,2")}), 2);
        QCOMPARE(code({scene, QStringLiteral("-o"), out, QStringLiteral("--before-after")}), 2);
        const Run missing = figure({QStringLiteral("none.obj"), QStringLiteral("-o"), out});
        QCOMPARE(missing.exitCode, 3);
        QVERIFY2(missing.err.startsWith(QStringLiteral("none.obj: ")), qPrintable(missing.err));
        QVERIFY(!QFile::exists(path("r.png")));
    }

    void sessionsKeepTheirMoment()
    {
        writeFile(path("session.json"), "{\"rasterlens\": 1, \"scene\": \"builtin:square-diagonal\", \"settings\": {}, "
                                        "\"step\": \"face 0 tie\", \"pixel\": [3, 4]}");
        const auto draw = [this](const QStringList& words, const char* file) {
            const Run made = figure(words + QStringList{QStringLiteral("-o"), path(file)});
            return made.exitCode == 0 ? QImage(path(file)) : QImage();
        };
        const QString scene = QStringLiteral("builtin:square-diagonal");
        const QStringList step{QStringLiteral("--step"), QStringLiteral("face 0 tie")};
        const QStringList pixel{QStringLiteral("--pixel"), QStringLiteral("3,4")};
        const QImage kept = draw({path("session.json")}, "kept.png");
        QVERIFY(!kept.isNull());
        QCOMPARE(kept, draw(QStringList{scene} + step + pixel, "said.png"));
        QVERIFY(kept != draw({scene}, "plain.png"));
        QVERIFY(kept != draw({path("session.json"), QStringLiteral("--step"), QStringLiteral("end")}, "end.png"));
    }

    void aPageShowsWhatTheWindowShows()
    {
        QVERIFY(openSquare());
        m_window->stepMode().showStep(QStringLiteral("39"));
        m_window->viewport().selectPixel(QPoint(3, 4));
        QVERIFY(settle());
        QString said = QStringLiteral("no answer yet");
        writePage(*m_window, {document().session(), {}}, QStringLiteral(RASTERLENS_CLI), path("page.html"),
                  [&said](const QString&, const QString& error) { said = error; });
        QTRY_VERIFY_WITH_TIMEOUT(said != QLatin1String("no answer yet"), 60'000);
        QCOMPARE(said, QString());
        const QJsonObject start = dataOf(readFile(path("page.html")))[QStringLiteral("start")].toObject();
        QCOMPARE(start[QStringLiteral("step")].toInt(), 38); // the event just before the position
        QCOMPARE(start[QStringLiteral("pixel")].toArray(), (QJsonArray{3, 4}));
        said = QStringLiteral("no answer yet");
        writePage(*m_window, {document().session(), {}}, QStringLiteral(RASTERLENS_CLI), path("no/page.html"),
                  [&said](const QString&, const QString& error) { said = error; });
        QTRY_VERIFY_WITH_TIMEOUT(said != QLatin1String("no answer yet"), 60'000);
        QVERIFY2(said.contains(QLatin1String("cannot be written")), qPrintable(said));
    }

    void handoutsHoldEverySlide()
    {
        const auto handout = [this](const QString& file) {
            return run({QStringLiteral("lesson"), QStringLiteral("handout"), QStringLiteral("top-left"),
                        QStringLiteral("-o"), file},
                       m_folder.path());
        };
        const Run made = handout(QStringLiteral("h.md"));
        QVERIFY2(made.exitCode == 0, qPrintable(made.err));
        const QByteArray text = readFile(path("h.md"));
        int slides = 0;
        while (text.contains("](h-" + QByteArray::number(slides + 1).rightJustified(2, '0') + ".png)"))
            ++slides;
        QVERIFY(slides >= 5);
        QVERIFY(!text.contains('{')); // numbers stand in place of their names
        for (int i = 1; i <= slides; ++i)
            QVERIFY(!QImage(m_folder.filePath(QStringLiteral("h-%1.png").arg(i, 2, 10, QLatin1Char('0')))).isNull());
        QCOMPARE(handout(QStringLiteral("h.txt")).exitCode, 2);
        const Run pdf = handout(QStringLiteral("h.pdf"));
        QVERIFY2(pdf.exitCode == 0, qPrintable(pdf.err));
        QVERIFY(readFile(path("h.pdf")).startsWith("%PDF-"));
    }
};

QTEST_MAIN(TestFigures)
#include "test_figures.moc"
