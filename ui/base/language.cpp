#include "ui/base/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace rasterlens
{

Language::Language()
{
    (void)m_chinese.load(QStringLiteral(":/rasterlens/translations/rasterlens_zh_CN.qm"));
    (void)m_chineseOfQt.load(QStringLiteral("qtbase_zh_CN"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
}

void Language::use(LanguageKind kind)
{
    if (kind == m_kind)
        return;
    m_kind = s_inUse = kind;
    for (QTranslator* texts : {&m_chinese, &m_chineseOfQt})
        if (kind == LanguageKind::Chinese)
            QCoreApplication::installTranslator(texts);
        else
            QCoreApplication::removeTranslator(texts);
}

QString Language::inOther(const char* context, const char* source) const
{
    return m_kind == LanguageKind::Chinese ? QString::fromUtf8(source) : m_chinese.translate(context, source);
}

LanguageKind Language::ofSystem()
{
    return QLocale::system().language() == QLocale::Chinese ? LanguageKind::Chinese : LanguageKind::English;
}

QString listed(const QStringList& items)
{
    return items.join(Language::inUse() == LanguageKind::Chinese ? QStringLiteral("\u3001") : QStringLiteral(", "));
}

QString labelled(const QString& label, const QString& text)
{
    return label + (Language::inUse() == LanguageKind::Chinese ? QStringLiteral("\uff1a") : QStringLiteral(": ")) +
           text;
}

} // namespace rasterlens
