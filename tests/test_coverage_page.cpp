// docs/COVERAGE.md: every name in its tables exists, every item is there once, and the sums are right.
#include "core/derive/topics.h"
#include "core/lessons/lesson.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "core/settings/settings.h"
#include "core/settings/step_kind.h"
#include "core/truth/hard_cases.h"
#include "tests/support.h"

#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

using namespace rasterlens;

namespace
{

QString contentOf(const QString& name)
{
    QFile file(QStringLiteral(RASTERLENS_SOURCE "/") + name);
    if (!file.open(QIODevice::ReadOnly))
        throw std::runtime_error(name.toStdString());
    return QString::fromUtf8(file.readAll());
}

/// The first group of each match.
QSet<QString> matchesOf(const QString& text, const QString& pattern)
{
    QSet<QString> found;
    const QRegularExpression expression(pattern, QRegularExpression::MultilineOption);
    for (const QRegularExpressionMatch& match : expression.globalMatch(text))
        found.insert(match.captured(1));
    return found;
}

/// The names that the program and its tests know, each as the page writes it.
QSet<QString> knownNames()
{
    QSet<QString> names;
    const auto add = [&](const char* kind, const QString& name) { names.insert(QLatin1String(kind) + name); };
    for (const BuiltinScene& scene : builtinScenes())
        add("builtin:", QLatin1String(scene.name));
    for (const QString& name : hardCaseNames())
        add("case:", name);
    for (const DerivationTopicInfo& info : derivationTopics())
        add("topic:", QLatin1String(info.id));
    for (const Mistake& mistake : mistakes())
        add("mistake:", QLatin1String(mistake.id));
    for (const QString& id : lessonIds())
        add("lesson:", id);
    for (int kind = 0; kind < kStepKinds; ++kind)
        add("step:", QLatin1String(stepKindId(static_cast<StepKind>(kind))));
    for (const QString& id :
         matchesOf(contentOf(QStringLiteral("ui/window/panel_places.cpp")), QStringLiteral("\"panel\\.([a-z]+)\"")))
        add("panel:", id);
    const QString views = contentOf(QStringLiteral("ui/pipeline/canvas_views.cpp"));
    for (const QString& id : matchesOf(views, QStringLiteral("\\{CanvasView::\\w+, \"([a-z-]+)\"")))
        add("view:", id);
    for (const QString& id : matchesOf(views, QStringLiteral("\\{&OverlayOptions::\\w+, \"([a-z-]+)\"")))
        add("overlay:", id);
    const QString tests = contentOf(QStringLiteral("tests/CMakeLists.txt"));
    for (const char* pattern :
         {"^rasterlens_test\\((\\w+)", "^rasterlens_window_test\\((\\w+)", "^ *add_test\\(NAME ([\\w-]+)"})
        for (const QString& name : matchesOf(tests, QLatin1String(pattern)))
            add("ctest:", name);
    // A row of README's list of keys may have several: `X / Shift+X`.
    for (const QString& keys :
         matchesOf(contentOf(QStringLiteral("README.md")), QStringLiteral("^\\| [^|]+ \\| ([^|]+) \\| [^|]+ \\|$")))
        for (const QString& key : keys.split(QStringLiteral(" / ")))
            add("key:", key);
    return names;
}

/// Whether `--id value` is a setting and one of its values.
bool isSetting(const QString& name)
{
    const QStringList words = name.sliced(2).split(QLatin1Char(' '));
    if (words.front() == QLatin1String("light"))
        return words.size() == 2 && parseLight(words.back());
    const SettingsField* field = findSettingsField(words.front());
    Settings settings;
    return field != nullptr && words.size() == 2 && !setFromText(*field, words.back(), settings);
}

/// A row of a table of items.
struct Row {
    QString item;
    QString ok;
    QStringList places;
    QStringList tests;
    QString missing;
};

QStringList namesIn(const QString& cell)
{
    const QRegularExpression quoted(QStringLiteral("`([^`]+)`"));
    QStringList names;
    for (const QRegularExpressionMatch& match : quoted.globalMatch(cell))
        names << match.captured(1);
    return names;
}

std::vector<Row> rowsOf(const QString& page)
{
    std::vector<Row> rows;
    for (const QString& line : page.split(QLatin1Char('\n'))) {
        QStringList cells = line.split(QLatin1Char('|'));
        if (cells.size() != 8 ||
            !(cells[3] == QLatin1String(" Y ") || cells[3] == QLatin1String(" P ") || cells[3] == QLatin1String(" N ")))
            continue;
        rows.push_back(
            {cells[1].trimmed(), cells[3].trimmed(), namesIn(cells[4]), namesIn(cells[5]), cells[6].trimmed()});
    }
    return rows;
}

/// The items of the five texts: how many each has.
QStringList itemsOfTexts()
{
    constexpr int kItems[] = {53, 25, 76, 27, 31};
    QStringList items;
    for (int text = 0; text < 5; ++text)
        for (int item = 1; item <= kItems[text]; ++item)
            items << QStringLiteral("%1.%2").arg(text).arg(item);
    return items;
}

QString faultOf(const Row& row, const QSet<QString>& known)
{
    for (const QString& name : row.places + row.tests)
        if (!(name.startsWith(QLatin1String("--")) ? isSetting(name) : known.contains(name)))
            return QStringLiteral("there is no ") + name;
    for (const QString& name : row.tests)
        if (!name.startsWith(QLatin1String("ctest:")))
            return name + QStringLiteral(" is no test");
    if (row.ok != QLatin1String("N") && (row.places.isEmpty() || row.tests.isEmpty()))
        return QStringLiteral("it names no place or no test");
    if ((row.ok == QLatin1String("Y")) != row.missing.isEmpty())
        return QStringLiteral("what is missing does not go with ") + row.ok;
    return {};
}

/// The row of the table of sums: `| items of the texts | 1 | 2 | 3 |`.
QString sumOf(const QString& part, const std::vector<Row>& rows, std::size_t begin, std::size_t end)
{
    QString text = QStringLiteral("| %1 |").arg(part);
    for (const char* ok : {"Y", "P", "N"})
        text += QStringLiteral(" %1 |").arg(std::count_if(rows.begin() + std::ptrdiff_t(begin),
                                                          rows.begin() + std::ptrdiff_t(end),
                                                          [&](const Row& row) { return row.ok == QLatin1String(ok); }));
    return text;
}

/// What is wrong with a page; empty: nothing.
QStringList faultsOf(const QString& page)
{
    static const QSet<QString> known = knownNames();
    const std::vector<Row> rows = rowsOf(page);
    const QStringList items = itemsOfTexts();
    QStringList faults;
    for (const Row& row : rows)
        if (const QString fault = faultOf(row, known); !fault.isEmpty())
            faults << row.item + QStringLiteral(": ") + fault;
    QStringList named;
    QSet<QString> once;
    for (const Row& row : rows) {
        named << row.item;
        if (once.contains(row.item))
            faults << row.item + QStringLiteral(" stands there twice");
        once.insert(row.item);
    }
    if (named.sliced(0, std::min(named.size(), items.size())) != items) {
        faults << QStringLiteral("the items of the texts are not all there in their order");
        return faults;
    }
    const auto texts = std::size_t(items.size());
    for (const QString& sum : {sumOf(QStringLiteral("items of the texts"), rows, 0, texts),
                               sumOf(QStringLiteral("rows of the plan"), rows, texts, rows.size())})
        if (!page.contains(sum))
            faults << QStringLiteral("the sum is ") + sum;
    return faults;
}

} // namespace

class TestCoveragePage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesExist();
    void detects_data();
    void detects();
};

void TestCoveragePage::namesExist()
{
    const QStringList faults = faultsOf(contentOf(QStringLiteral("docs/COVERAGE.md")));
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
}

void TestCoveragePage::detects_data()
{
    QTest::addColumn<QString>("good");
    QTest::addColumn<QString>("bad");
    const auto plant = [](const char* good, const char* bad) {
        QTest::newRow(bad) << QString::fromUtf8(good) << QString::fromUtf8(bad);
    };
    plant("`builtin:lines`", "`builtin:line`");
    plant("`case:074_w_zero_origin`", "`case:074`");
    plant("`--fill wireframe`", "`--fill wire`");
    plant("`--fill wireframe`", "`--filled wireframe`");
    plant("`topic:bresenham`", "`topic:bressenham`");
    plant("`panel:curves`", "`panel:curve`");
    plant("`step:span`", "`step:spans`");
    plant("`mistake:affine`", "`mistake:afine`");
    plant("`overlay:mid-line`", "`overlay:midline`");
    plant("`lesson:top-left`", "`lesson:topleft`");
    plant("`key:Ctrl+G`", "`key:Ctrl+GG`");
    plant("`ctest:lines`", "`ctest:line`");
    plant("| `ctest:lines` ", "| `builtin:lines` ");
    plant("| `ctest:lens` |", "| |");
    plant("| Y | `builtin:covering`", "| P | `builtin:covering`");
    plant("| 0.2 |", "| 0.3 |");
    plant("| items of the texts | ", "| items of the texts | 9");
}

void TestCoveragePage::detects()
{
    QFETCH(QString, good);
    QFETCH(QString, bad);
    QString page = contentOf(QStringLiteral("docs/COVERAGE.md"));
    // In the tables, not in what explains the form of names.
    const qsizetype from = bad.startsWith(QLatin1String("| items")) ? 0 : page.indexOf(QStringLiteral("| item |"));
    const qsizetype at = page.indexOf(good, from);
    QVERIFY2(at >= 0, qPrintable(good));
    QVERIFY(!faultsOf(page.replace(at, good.size(), bad)).isEmpty());
}

QTEST_APPLESS_MAIN(TestCoveragePage)
#include "test_coverage_page.moc"
