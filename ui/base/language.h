#pragma once
#include <QString>
#include <QStringList>
#include <QTranslator>

namespace rasterlens
{

enum class LanguageKind { English, Chinese };

/// The two languages of the window. English is the text in the code; Chinese comes from the resources.
class Language
{
public:
    Language();

    /// Retranslates the running program: every widget gets a LanguageChange event.
    void use(LanguageKind kind);
    [[nodiscard]] LanguageKind kind() const { return m_kind; }

    /// The language whose texts the program shows.
    [[nodiscard]] static LanguageKind inUse() { return s_inUse; }

    /// The term in the language that is *not* in use, for tool-tips that show both.
    [[nodiscard]] QString inOther(const char* context, const char* source) const;

    /// The language of the system, where we have it.
    [[nodiscard]] static LanguageKind ofSystem();

private:
    QTranslator m_chinese;
    QTranslator m_chineseOfQt; ///< file dialogs, and why files cannot be read
    LanguageKind m_kind = LanguageKind::English;
    static inline LanguageKind s_inUse = LanguageKind::English;
};

/// A list in a sentence, in the language in use: `1, 3` and `1、3`.
[[nodiscard]] QString listed(const QStringList& items);

/// What comes before what it stands for, in the language in use: `M1: All edges` and `M1：所有边`.
[[nodiscard]] QString labelled(const QString& label, const QString& text);

} // namespace rasterlens
