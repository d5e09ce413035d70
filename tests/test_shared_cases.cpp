// The hard cases beside the project: every rasterizer against the exact result, as ../shared/cases/README.md defines
// it.
#include "core/io/case_file.h"
#include "core/render/render.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>
#include <QtEndian>

#include <cmath>

using namespace rasterlens;

namespace
{

struct Array {
    std::vector<int> shape;
    std::vector<double> values;
};

template <class T>
std::vector<double> decode(const QByteArray& bytes)
{
    std::vector<double> values;
    for (qsizetype i = 0; i + qsizetype(sizeof(T)) <= bytes.size(); i += qsizetype(sizeof(T)))
        values.push_back(double(qFromLittleEndian<T>(bytes.constData() + i)));
    return values;
}

/// NumPy format 1.0 with the types the expected results use.
std::optional<Array> readArray(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QByteArray bytes = file.readAll();
    const qsizetype headerSize = 10 + qFromLittleEndian<quint16>(bytes.constData() + 8);
    const QByteArray header = bytes.left(headerSize);
    const QByteArray body = bytes.mid(headerSize);
    Array array;
    if (header.contains("<u4"))
        array.values = decode<quint32>(body);
    else if (header.contains("<i4"))
        array.values = decode<qint32>(body);
    else if (header.contains("<f4"))
        array.values = decode<float>(body);
    else if (header.contains("<f8"))
        array.values = decode<double>(body);
    return array;
}

QString casesFolder() { return QStringLiteral(RASTERLENS_SHARED "/cases/"); }

bool anyVertexOutside(const Scene& scene)
{
    for (const MeshVertex& v : scene.mesh.vertices) {
        const glm::vec4& p = v.position;
        if (!(std::abs(p.x) <= p.w && std::abs(p.y) <= p.w && std::abs(p.z) <= p.w))
            return true;
    }
    return false;
}

/// One rasterizer's answer beside the exact one.
struct Comparison {
    int wrongCoverage = 0; ///< pixels whose count differs
    int wrongCoverageOutsideBand = 0;
    int wrongIds = 0;
    int wrongIdsOutsideBand = 0;
    double depthError = 0; ///< largest, outside the band
    double colorError = 0; ///< largest, outside the band, in 8-bit steps
};

Comparison compare(const Scene& scene, const Frame& frame, const QString& expected)
{
    const QSize size = scene.defaults.size;
    const PixelRect window = scene.window.value_or(PixelRect{0, 0, size.width(), size.height()});
    const Array cover = *readArray(expected + ".cover.npy");
    const Array id = *readArray(expected + ".id.npy");
    const Array depth = *readArray(expected + ".depth.npy");
    const Array color = *readArray(expected + ".color.npy");
    const Array edge = *readArray(expected + ".edge.npy");
    const double band = std::sqrt(2) / 512 + std::max(size.width(), size.height()) * 0x1p-22;
    Comparison result;
    std::size_t i = 0;
    for (int y = window.y; y < window.y + window.height; ++y)
        for (int x = window.x; x < window.x + window.width; ++x, ++i) {
            const std::size_t at = std::size_t(y) * std::size_t(size.width()) + std::size_t(x);
            const bool outsideBand = edge.values[i] > band;
            if (frame.coverage[at] != cover.values[i]) {
                ++result.wrongCoverage;
                result.wrongCoverageOutsideBand += outsideBand;
            }
            if (frame.ids[at] != id.values[i]) {
                ++result.wrongIds;
                result.wrongIdsOutsideBand += outsideBand;
            }
            if (!outsideBand || id.values[i] < 0 || frame.ids[at] != id.values[i])
                continue;
            result.depthError = std::max(result.depthError, std::abs(frame.depth[at] - depth.values[i]));
            const QRgb pixel = frame.image.pixel(x, y);
            const std::array<int, 3> channels{qRed(pixel), qGreen(pixel), qBlue(pixel)};
            for (std::size_t k = 0; k < 3; ++k)
                result.colorError = std::max(
                    result.colorError, std::abs(channels[k] - 255 * std::clamp(color.values[3 * i + k], 0.0, 1.0)));
        }
    return result;
}

} // namespace

class TestSharedCases : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void matchesTheExactResult_data();
    void matchesTheExactResult();
};

void TestSharedCases::matchesTheExactResult_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("algorithm");
    QTest::addColumn<bool>("watertight");
    QFile catalogue(casesFolder() + "catalogue.json");
    if (!catalogue.open(QIODevice::ReadOnly))
        QSKIP("../shared/cases is not here");
    const QJsonArray cases = QJsonDocument::fromJson(catalogue.readAll()).array();
    QVERIFY(!cases.isEmpty());
    const SettingsField* algorithm = findSettingsField("algorithm");
    for (const auto& value : cases) {
        const QJsonObject entry = value.toObject();
        const QString name = entry["name"].toString();
        const QJsonObject histogram = entry["cover_histogram"].toObject();
        for (int a = 0; a < int(algorithm->choices.size()); ++a) {
            Settings settings;
            algorithm->set(settings, a);
            if (unsupported(Scene(), settings) || settings.algorithm == Algorithm::ColumnFill)
                continue;
            QTest::addRow("%s, %s", qPrintable(name), algorithm->choices[std::size_t(a)].id)
                << name << a << (histogram.size() == 1 && histogram.contains("1"));
        }
    }
}

void TestSharedCases::matchesTheExactResult()
{
    QFETCH(QString, name);
    QFETCH(int, algorithm);
    QFETCH(bool, watertight);
    const SceneLoad load = loadCase(casesFolder() + name + ".case");
    QVERIFY(load.scene);
    Settings settings = load.scene->defaults;
    settings.algorithm = static_cast<Algorithm>(algorithm);
    Frame frame;
    render(*load.scene, settings, frame, {.depth = true, .ids = true, .coverage = true});
    const Comparison c = compare(*load.scene, frame, casesFolder() + "expected/" + name);

    // Cases marked `exact` come with the answer for vertices that are not snapped.
    const bool snappedAlike = !anyVertexOutside(*load.scene) && !load.scene->exact;
    if (snappedAlike) {
        QCOMPARE(c.wrongCoverage, 0);
        QCOMPARE(c.wrongIds, 0);
    }
    QCOMPARE(c.wrongCoverageOutsideBand, 0);
    const bool depthPrecision = name.contains("_depth_n") || name.contains("z_fight");
    if (!depthPrecision)
        QCOMPARE(c.wrongIdsOutsideBand, 0);
    if (watertight && !load.scene->window)
        for (const std::uint16_t count : frame.coverage)
            QCOMPARE(count, std::uint16_t(1));
    QVERIFY2(c.depthError <= 2.5e-7, qPrintable(QString::number(c.depthError)));
    QVERIFY2(c.colorError <= 1, qPrintable(QString::number(c.colorError)));
}

QTEST_APPLESS_MAIN(TestSharedCases)
#include "test_shared_cases.moc"
