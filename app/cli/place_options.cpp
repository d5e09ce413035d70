#include "app/cli/place_options.h"

#include "app/cli/failure.h"
#include "core/base/typed_numbers.h"

namespace rasterlens::cli
{

std::optional<QPoint> pixelOption(const Arguments& arguments, QSize size)
{
    const auto text = arguments.value(QStringLiteral("--pixel"));
    if (!text)
        return std::nullopt;
    const auto typed = typedPoint(*text);
    if (!typed)
        failArguments(QStringLiteral("--pixel: \"%1\" is not a pixel; expected: x,y").arg(*text));
    const QPoint pixel = *typed;
    if (pixel.x() < 0 || pixel.y() < 0 || pixel.x() >= size.width() || pixel.y() >= size.height())
        failArguments(QStringLiteral("--pixel: %1 lies outside the picture; expected: 0,0 to %2,%3")
                          .arg(*text)
                          .arg(size.width() - 1)
                          .arg(size.height() - 1));
    return pixel;
}

std::optional<std::int64_t> wholeOption(const Arguments& arguments, const QString& name, std::int64_t minimum,
                                        std::int64_t maximum)
{
    const auto text = arguments.value(name);
    if (!text)
        return std::nullopt;
    bool good = false;
    const qlonglong value = text->toLongLong(&good);
    if (!good || value < minimum || value > maximum)
        failArguments(QStringLiteral("%1: \"%2\" is not a whole number from %3 to %4")
                          .arg(name, *text)
                          .arg(minimum)
                          .arg(maximum));
    return value;
}

} // namespace rasterlens::cli
