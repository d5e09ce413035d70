#include "core/render/picture_memory.h"

#include <QByteArray>
#include <QFile>

#include <limits>

namespace rasterlens
{

std::int64_t samplesOf(const Settings& settings)
{
    return std::int64_t(settings.size.width()) * settings.size.height() * samplesPerPixel(settings.samples);
}

std::int64_t pictureBytes(const Settings& settings)
{
    constexpr std::int64_t kColor = 4;
    constexpr std::int64_t kDepthAndFace = 8;
    const std::int64_t pixels = std::int64_t(settings.size.width()) * settings.size.height();
    const std::int64_t kept = pixels * (kColor + kDepthAndFace);
    return settings.samples == Samples::One ? kept : kept + samplesOf(settings) * kDepthAndFace;
}

std::int64_t freeMemoryBytes()
{
    QFile file(QStringLiteral("/proc/meminfo"));
    if (!file.open(QIODevice::ReadOnly))
        return std::numeric_limits<std::int64_t>::max();
    std::int64_t kibibytes = 0;
    bool known = false;
    for (QByteArray line = file.readLine(); !line.isEmpty(); line = file.readLine())
        if (line.startsWith("MemAvailable:") || line.startsWith("SwapFree:")) {
            kibibytes += line.simplified().split(' ').value(1).toLongLong();
            known = known || line.startsWith("Mem");
        }
    return known ? kibibytes * 1024 : std::numeric_limits<std::int64_t>::max();
}

QString gigabytesText(std::int64_t bytes) { return QStringLiteral("%1 GB").arg(double(bytes) / 1e9, 0, 'f', 1); }

} // namespace rasterlens
