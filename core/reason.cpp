#include "core/reason.h"

namespace rasterlens
{

QString textOf(const Reason& reason, Translate translate)
{
    QString text = translate != nullptr ? translate(reason.text) : QString::fromUtf8(reason.text);
    for (const QString& argument : reason.arguments)
        text = text.arg(argument);
    return text;
}

} // namespace rasterlens
