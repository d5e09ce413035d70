#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/variant_list.h"
#include "app/cli/verbs.h"
#include "core/scenes/load_scene.h"
#include "core/truth/hard_cases.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <algorithm>
#include <map>

namespace rasterlens::cli
{
namespace
{

constexpr const char* kDefaultVariants = "edge-equation,edge-walking,tiled";

Usage usage()
{
    const auto value = [](const char* name, const char* valueName, const char* help) {
        return Option{QString::fromLatin1(name), Option::Kind::Value, QString::fromLatin1(valueName),
                      QString::fromLatin1(help)};
    };
    const QList<Option> options{
        {QStringLiteral("--list"),
         Option::Kind::Switch,
         {},
         QStringLiteral("Print the names and what must hold, and end.")},
        value("--filter", "PATTERN", "Only cases whose name matches: a part of it, or a pattern with * and ?."),
        value("--variants", "LIST",
              "all, or ids joined by commas (rasterlens-cli bench --list-variants); default "
              "edge-equation,edge-walking,tiled, which must pass everything. A variant changes what it names and "
              "leaves the rest as the case has it."),
        value("--json", "FILE",
              "The matrix as an array of {\"case\", \"variant\", \"pass\", \"reason\"}; pass is null where the variant "
              "cannot draw the case. - is stdout, and then there is no table.")};
    return {QStringLiteral("cases"),
            QStringLiteral("rasterlens-cli cases [--list] [--filter PATTERN] [--variants LIST] [--json FILE]"),
            QStringLiteral(
                "Draws the catalogue of hard cases with every variant and compares with the exact reference, which "
                "is the first column: + passes, ~ passes within what snapping or the depth format can tell, x fails, . "
                "cannot draw it. The reasons follow.\n\n"
                "A case passes when every pixel is covered by as many faces as in truth, the right face is seen, all "
                "`expect` lines hold, depths are within 2^-22 (or a code of the format) and colours within 1.01 "
                "steps. ~ is for another face whose depth is right to that tolerance, and for cases marked `exact`, "
                "where the reference alone does not snap: others may differ as far as snapping goes."),
            {},
            {{QStringLiteral("Options:"), options}},
            QStringLiteral("Floating-point and coarse variants fail some cases; that is what the cases are for.\n\n"
                           "Exit codes: 0 everything passes; 1 something fails; 2 bad arguments; 3 output that cannot "
                           "be written.")};
}

QStringList namesMatching(const std::optional<QString>& pattern)
{
    QStringList names = hardCaseNames();
    if (!pattern)
        return names;
    const bool isGlob = pattern->contains(QLatin1Char('*')) || pattern->contains(QLatin1Char('?'));
    const QString glob = isGlob ? *pattern : QLatin1Char('*') + *pattern + QLatin1Char('*');
    names = names.filter(QRegularExpression::fromWildcard(glob, Qt::CaseInsensitive));
    if (names.isEmpty())
        failArguments(QStringLiteral("rasterlens-cli cases: --filter: no case matches \"%1\"; --list names them all")
                          .arg(*pattern));
    return names;
}

Scene caseScene(const QString& name) { return *loadScene(hardCasePath(name)).scene; }

QString listOf(const QStringList& names)
{
    QString text;
    for (const QString& name : names)
        text += QStringLiteral("%1 %2\n").arg(name, -44).arg(caseScene(name).note.section(QLatin1Char('\n'), 0, 0));
    return text;
}

struct Entry {
    QString variant;
    CaseVerdict verdict;
};

struct Row {
    QString name;
    std::vector<Entry> entries; ///< the reference first
};

Row judge(const QString& name, const std::vector<const Variant*>& variants)
{
    const Scene scene = caseScene(name);
    std::map<Samples, ExactFrame> truths;
    const auto truthFor = [&](Samples samples) -> const ExactFrame& {
        const auto found = truths.find(samples);
        return found != truths.end() ? found->second : truths.emplace(samples, caseTruth(scene, samples)).first->second;
    };
    Row row{name, {{QStringLiteral("reference"), judgeReference(scene, truthFor(scene.defaults.samples))}}};
    for (const Variant* variant : variants) {
        const Settings settings = changedBy(*variant, scene.defaults);
        CaseVerdict verdict = judgeCase(scene, truthFor(settings.samples), settings);
        verdict.difference.verdicts.clear(); // the matrix is large
        row.entries.push_back({QLatin1String(variant->id), std::move(verdict)});
    }
    return row;
}

QLatin1Char glyph(CaseGrade grade)
{
    switch (grade) {
    case CaseGrade::Passes: return QLatin1Char('+');
    case CaseGrade::PassesWithin: return QLatin1Char('~');
    case CaseGrade::Fails: return QLatin1Char('x');
    case CaseGrade::Unsupported: break;
    }
    return QLatin1Char('.');
}

constexpr int kNameWidth = 44;

/// The names of the columns, from top to bottom.
QString headline(const Row& row)
{
    qsizetype height = 0;
    for (const Entry& entry : row.entries)
        height = std::max(height, entry.variant.size());
    QString text;
    for (qsizetype line = 0; line < height; ++line) {
        QString letters(kNameWidth, QLatin1Char(' '));
        for (const Entry& entry : row.entries) {
            const QString name = entry.variant.rightJustified(height);
            letters += name[line];
            letters += QLatin1Char(' ');
        }
        text += letters.trimmed().isEmpty() ? QString() : letters + QLatin1Char('\n');
    }
    return text;
}

QString line(const Row& row)
{
    QString text = row.name.leftJustified(kNameWidth);
    for (const Entry& entry : row.entries) {
        text += glyph(entry.verdict.grade);
        text += QLatin1Char(' ');
    }
    return text + QLatin1Char('\n');
}

/// Why cases do not pass exactly; variants with the same reason together.
QString reasonsOf(const std::vector<Row>& rows)
{
    QString text;
    for (const Row& row : rows) {
        QStringList reasons;
        QList<QStringList> variants;
        for (const Entry& entry : row.entries) {
            if (entry.verdict.grade != CaseGrade::Fails && entry.verdict.grade != CaseGrade::PassesWithin)
                continue;
            qsizetype at = reasons.indexOf(textOf(entry.verdict.reasons));
            if (at < 0) {
                at = reasons.size();
                reasons << textOf(entry.verdict.reasons);
                variants << QStringList();
            }
            variants[at] << entry.variant;
        }
        for (qsizetype i = 0; i < reasons.size(); ++i)
            text += QStringLiteral("%1: %2: %3\n").arg(row.name, variants[i].join(QStringLiteral(", ")), reasons[i]);
    }
    return text.isEmpty() ? text : QLatin1Char('\n') + text;
}

QString totals(const std::vector<Row>& rows)
{
    QString text = QStringLiteral("\n");
    for (std::size_t i = 0; i < rows.front().entries.size(); ++i) {
        const auto count = [&](CaseGrade grade) {
            return std::count_if(rows.begin(), rows.end(),
                                 [&](const Row& row) { return row.entries[i].verdict.grade == grade; });
        };
        text += QStringLiteral("%1 %2 pass, %3 fail, %4 not drawn\n")
                    .arg(rows.front().entries[i].variant, -32)
                    .arg(count(CaseGrade::Passes) + count(CaseGrade::PassesWithin))
                    .arg(count(CaseGrade::Fails))
                    .arg(count(CaseGrade::Unsupported));
    }
    return text;
}

QByteArray jsonOf(const std::vector<Row>& rows)
{
    QJsonArray array;
    for (const Row& row : rows)
        for (const auto& [variant, verdict] : row.entries)
            array.append(QJsonObject{{"case", row.name},
                                     {"variant", variant},
                                     {"pass", verdict.grade == CaseGrade::Unsupported
                                                  ? QJsonValue()
                                                  : QJsonValue(verdict.grade != CaseGrade::Fails)},
                                     {"reason", textOf(verdict.reasons)}});
    return QJsonDocument(array).toJson();
}

bool anyFails(const std::vector<Row>& rows)
{
    return std::any_of(rows.begin(), rows.end(), [](const Row& row) {
        return std::any_of(row.entries.begin(), row.entries.end(),
                           [](const Entry& entry) { return entry.verdict.grade == CaseGrade::Fails; });
    });
}

} // namespace

Usage casesUsage() { return usage(); }

ExitCode runCases(const QStringList& words)
{
    const auto arguments = parseArguments(usage(), words);
    if (!arguments)
        return ExitCode::Fine;
    const QStringList names = namesMatching(arguments->value(QStringLiteral("--filter")));
    if (arguments->isOn(QStringLiteral("--list"))) {
        printText(listOf(names));
        return ExitCode::Fine;
    }
    const QString list = arguments->value(QStringLiteral("--variants")).value_or(QLatin1String(kDefaultVariants));
    const std::vector<const Variant*> variants = list == QLatin1String("all")
                                                     ? supportedVariants(Scene(), Settings())
                                                     : variantsOf(list, QStringLiteral("cases"));
    const QString json = arguments->value(QStringLiteral("--json")).value_or(QString());
    if (!json.isEmpty())
        checkOutputs({json});
    const bool printed = json != QLatin1String("-");

    std::vector<Row> rows;
    for (const QString& name : names) {
        rows.push_back(judge(name, variants));
        if (printed)
            printText((rows.size() == 1 ? headline(rows.back()) : QString()) + line(rows.back()));
    }
    if (printed)
        printText(reasonsOf(rows) + totals(rows));
    if (!json.isEmpty()) {
        OutputFiles files;
        files.add(json, jsonOf(rows));
        files.write();
    }
    return anyFails(rows) ? ExitCode::Found : ExitCode::Fine;
}

} // namespace rasterlens::cli
