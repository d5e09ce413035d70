#include "ui/language.h"

#include <QCoreApplication>
#include <QLocale>

namespace rasterlens
{

Language::Language() { (void)m_chinese.load(QStringLiteral(":/rasterlens/translations/rasterlens_zh_CN.qm")); }

void Language::use(LanguageKind kind)
{
    if (kind == m_kind)
        return;
    m_kind = kind;
    if (kind == LanguageKind::Chinese)
        QCoreApplication::installTranslator(&m_chinese);
    else
        QCoreApplication::removeTranslator(&m_chinese);
}

QString Language::inOther(const char* context, const char* source) const
{
    return m_kind == LanguageKind::Chinese ? QString::fromUtf8(source) : m_chinese.translate(context, source);
}

LanguageKind Language::ofSystem()
{
    return QLocale::system().language() == QLocale::Chinese ? LanguageKind::Chinese : LanguageKind::English;
}

} // namespace rasterlens
