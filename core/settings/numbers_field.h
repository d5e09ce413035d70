#pragma once
#include "core/settings/settings.h"

#include <QJsonArray>
#include <QString>

#include <optional>
#include <span>
#include <vector>

namespace rasterlens
{

/// A setting that is a few numbers, as `-1,-1` for a depth bias. One row drives JSON, command line, panel and texts of
/// it, as a SettingsField does for choices.
struct NumbersField {
    const char* id;    ///< JSON key and option name without the dashes
    const char* form;  ///< of the option's value: `C,S[,M]`
    const char* title; ///< QT_TRANSLATE_NOOP("Settings", ...)
    const char* help;  ///< QT_TRANSLATE_NOOP("Settings", ...)
    Stage stage;
    /// What the numbers must be, QT_TRANSLATE_NOOP("Diagnostic", ...), as the end of "... expected".
    const char* expected;
    std::vector<double> (*get)(const Settings&);
    bool (*set)(Settings&, std::span<const double>); ///< out: whether the numbers are good; else nothing is set
};

[[nodiscard]] std::span<const NumbersField> numbersFields();
[[nodiscard]] const NumbersField* findNumbersField(const QString& id);

/// The value in use, as it is typed: `-1,-1,0.01`.
[[nodiscard]] QString valueText(const NumbersField& field, const Settings& settings);

/// Sets a field from text.
///
/// errors  a text of the context "Diagnostic"; `settings` is then unchanged
[[nodiscard]] std::optional<Reason> setFromText(const NumbersField& field, const QString& text, Settings& settings);

[[nodiscard]] QJsonArray toJson(const NumbersField& field, const Settings& settings);

/// Sets a field from what toJson() writes.
///
/// errors  a text of the context "Diagnostic"; `settings` is then unchanged
[[nodiscard]] std::optional<Reason> setFromJson(const NumbersField& field, const QJsonValue& value, Settings& settings);

/// Whether two settings have the same value.
[[nodiscard]] bool isEqual(const NumbersField& field, const Settings& a, const Settings& b);

} // namespace rasterlens
