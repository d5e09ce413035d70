// Derivations as data: symbols and their places, both languages, JSON, and what is refused.
#include "core/derive/derive.h"
#include "tests/derivation_fixture.h"
#include "tests/support.h"

#include <QDir>
#include <QFile>
#include <QHash>
#include <QJsonArray>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QXmlStreamReader>

using namespace rasterlens;
using namespace rasterlens::test;

class TestDerivationForms : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void symbolsAreThere();
    void sentencesAreTranslated();
    void jsonHasEverything();
    void jsonHasFigures();
    void refusals();
};

void TestDerivationForms::symbolsAreThere()
{
    QSet<int> topics;
    forEachQuestion([&](const Scene& scene, const Settings& settings, const Question& question) {
        const Derived found = derive(question.topic, scene, settings, question.place);
        if (!found.derivation)
            return;
        topics.insert(int(question.topic));
        const Derivation& derivation = *found.derivation;
        QVERIFY(!derivation.lines.empty());
        QSet<QString> ids;
        for (const DerivationSymbol& symbol : derivation.symbols) {
            QVERIFY2(!ids.contains(symbol.id), qPrintable(symbol.id));
            ids.insert(symbol.id);
            QVERIFY2(std::isfinite(symbol.value), qPrintable(scene.id + QLatin1Char(' ') + symbol.id));
            for (const glm::dvec2& point : symbol.canvas.points)
                QVERIFY2(std::isfinite(point.x) && std::isfinite(point.y), qPrintable(symbol.id));
        }
        for (const DerivationFigure& figure : derivation.figures) {
            QVERIFY(figure.high.x > figure.low.x && figure.high.y > figure.low.y);
            for (const FigureStroke& stroke : figure.strokes) {
                QVERIFY(stroke.points.size() >= 2);
                QVERIFY(stroke.symbol < int(derivation.symbols.size()));
                for (const glm::dvec2& point : stroke.points)
                    QVERIFY(std::isfinite(point.x) && std::isfinite(point.y));
            }
            for (const FigurePoint& point : figure.points)
                QVERIFY(point.symbol < int(derivation.symbols.size()) && std::isfinite(point.at.x + point.at.y));
        }
        for (const DerivationLine& line : derivation.lines) {
            QCOMPARE(line.formula.size(), line.numbers.size());
            for (const auto* tokens : {&line.left, &line.formula})
                for (const DerivationToken& token : *tokens)
                    if (token.symbol >= 0) {
                        QVERIFY(std::size_t(token.symbol) < derivation.symbols.size());
                        QCOMPARE(token.text, derivation.symbols[std::size_t(token.symbol)].name);
                    }
        }
    });
    QCOMPARE(topics.size(), qsizetype(derivationTopics().size()));
}

void TestDerivationForms::sentencesAreTranslated()
{
    QFile file(QStringLiteral(RASTERLENS_SOURCE "/resources/translations/rasterlens_zh_CN.ts"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader reader(&file);
    QString context;
    QString source;
    QHash<QString, QString> chinese;
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (reader.name() == QLatin1String("name"))
            context = reader.readElementText();
        else if (reader.name() == QLatin1String("source"))
            source = reader.readElementText();
        else if (reader.name() == QLatin1String("translation") && context == QLatin1String("Derive"))
            chinese.insert(source, reader.readElementText());
    }
    // Every sentence of the sources, whether a scene of this test says it or not.
    const QRegularExpression marked(
        QStringLiteral("QT_TRANSLATE_NOOP\\(\\s*\"Derive\",\\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)\\)"));
    const QRegularExpression quoted(QStringLiteral("\"((?:[^\"\\\\]|\\\\.)*)\""));
    const QRegularExpression place(QStringLiteral("%[1-9]"));
    int sentences = 0;
    const QDir folder(QStringLiteral(RASTERLENS_SOURCE "/core/derive"));
    for (const QString& name : folder.entryList({QStringLiteral("*.cpp")})) {
        QFile code(folder.filePath(name));
        QVERIFY(code.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(code.readAll());
        for (const QRegularExpressionMatch& match : marked.globalMatch(text)) {
            QString sentence;
            const QString literals = match.captured(1);
            for (const QRegularExpressionMatch& piece : quoted.globalMatch(literals))
                sentence += piece.captured(1);
            sentence.replace(QStringLiteral("\\\""), QStringLiteral("\""));
            const QString translated = chinese.value(sentence);
            QVERIFY2(!translated.isEmpty(), qPrintable(sentence));
            for (const QRegularExpressionMatch& number : place.globalMatch(sentence))
                QVERIFY2(translated.contains(number.captured()), qPrintable(translated));
            ++sentences;
        }
    }
    QVERIFY2(sentences > 150, qPrintable(QString::number(sentences)));
}

void TestDerivationForms::jsonHasEverything()
{
    const Scene scene = builtin("triangle-600");
    const Derivation d =
        derived(DerivationTopic::EdgeFunction, scene, scene.defaults, {0, QPoint(250, 350), 0, 0.5, {}});
    const QJsonObject json = toJson(d);
    QCOMPARE(json.value(QStringLiteral("id")).toString(), QStringLiteral("edge-function"));
    const QJsonArray symbols = json.value(QStringLiteral("symbols")).toArray();
    QCOMPARE(std::size_t(symbols.size()), d.symbols.size());
    const QJsonObject corner = symbols.first().toObject(); // A_x = 100, at (100, 400)
    QCOMPARE(corner.value(QStringLiteral("exact")).toString(), QStringLiteral("100"));
    const QJsonObject canvas = corner.value(QStringLiteral("canvas")).toObject();
    QCOMPARE(canvas.value(QStringLiteral("kind")).toString(), QStringLiteral("corner"));
    QCOMPARE(canvas.value(QStringLiteral("points")).toArray(), (QJsonArray{QJsonArray{100.0, 400.0}}));
    const QJsonArray lines = json.value(QStringLiteral("lines")).toArray();
    QCOMPARE(std::size_t(lines.size()), d.lines.size());
    for (std::size_t i = 0; i < d.lines.size(); ++i) {
        const QJsonObject line = lines[qsizetype(i)].toObject();
        QString numbers;
        const QJsonArray tokens = line.value(QStringLiteral("numbers")).toArray();
        for (const QJsonValue& token : tokens)
            numbers += token.toObject().value(QStringLiteral("text")).toString();
        QCOMPARE(numbers, textOf(d.lines[i].numbers));
        QCOMPARE(line.value(QStringLiteral("words")).toString(), textOf(d.lines[i].words));
        QCOMPARE(line.contains(QStringLiteral("holds")), d.lines[i].isComparison());
    }
}

void TestDerivationForms::jsonHasFigures()
{
    const Scene scene = builtin("four-z");
    const Derivation d = derived(DerivationTopic::Perspective, scene, scene.defaults, {});
    const QJsonArray figures = toJson(d).value(QStringLiteral("figures")).toArray();
    QCOMPARE(std::size_t(figures.size()), d.figures.size());
    const QJsonObject side = figures.first().toObject();
    QCOMPARE(side.value(QStringLiteral("axes")).toArray(), (QJsonArray{QStringLiteral("Z"), QStringLiteral("X")}));
    const QJsonArray points = side.value(QStringLiteral("points")).toArray();
    const QJsonObject eye = points.first().toObject();
    QCOMPARE(eye.value(QStringLiteral("at")).toArray(), (QJsonArray{0.0, 0.0}));
    QCOMPARE(points.last().toObject().value(QStringLiteral("symbol")).toString(), QStringLiteral("P'"));
    QCOMPARE(std::size_t(side.value(QStringLiteral("strokes")).toArray().size()), d.figures.front().strokes.size());
}

void TestDerivationForms::refusals()
{
    const auto refusal = [](DerivationTopic topic, const Scene& scene, const DerivationPlace& place) {
        return textOf(derive(topic, scene, scene.defaults, place).refusal);
    };
    const Scene triangle = builtin("triangle-600");
    QCOMPARE(refusal(DerivationTopic::Barycentric, triangle, {0, QPoint(0, 0), 0, 0.5, {}}),
             QStringLiteral("pixel (0, 0) is not inside face 0"));
    QCOMPARE(refusal(DerivationTopic::DepthCurve, triangle, {}),
             QStringLiteral("a scene in clip space has no distances of near and far"));
    QCOMPARE(refusal(DerivationTopic::FlatLight, triangle, {}),
             QStringLiteral("this scene has no light: its colours are shown as they are"));
    QVERIFY(refusal(DerivationTopic::Perspective, builtin("behind-camera"), {})
                .startsWith(QStringLiteral("corner B of face 0 is not in front of the eye")));
    const Scene cube = builtin("cube");
    int culled = 0;
    for (std::uint32_t face = 0; face < 12; ++face)
        culled += refusal(DerivationTopic::EdgeFunction, cube, {face, {}, 0, 0.5, {}})
                          .endsWith(QStringLiteral("it is a back face, and those are culled"))
                      ? 1
                      : 0;
    QCOMPARE(culled, 6);
}

QTEST_APPLESS_MAIN(TestDerivationForms)
#include "test_derivation_forms.moc"
