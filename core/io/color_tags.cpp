#include "core/io/color_tags.h"

#include <QColorSpace>
#include <QtEndian>

namespace rasterlens
{
namespace
{

Reason notApplied(Reason what)
{
    return {QT_TRANSLATE_NOOP("Diagnostic", "the picture carries %1, which is not applied: its colours are taken as "
                                            "they are stored"),
            {std::move(what)}};
}

Reason gamma(double value)
{
    return notApplied({QT_TRANSLATE_NOOP("Diagnostic", "a gamma of %1"), {QString::number(value)}});
}

Reason profile(const QString& name)
{
    return notApplied({QT_TRANSLATE_NOOP("Diagnostic", "the colour profile \"%1\""), {name}});
}

/// The chunks of a PNG that stand before its pixels.
std::optional<Reason> remarkOfPng(const QByteArray& file)
{
    constexpr qsizetype kSignature = 8;
    constexpr qsizetype kAround = 12; // length, type and check sum of a chunk
    std::optional<Reason> remark;
    for (qsizetype at = kSignature; at + kAround <= file.size();) {
        const auto size = qsizetype{qFromBigEndian<quint32>(file.constData() + at)};
        const QByteArray type = file.mid(at + 4, 4);
        if (type == "IDAT" || file.size() - at - kAround < size)
            break;
        const QByteArray data = file.mid(at + 8, size);
        if (type == "iCCP")
            return profile(QString::fromLatin1(data.left(data.indexOf('\0'))));
        if (type == "cICP")
            return profile(QStringLiteral("cICP"));
        if (type == "sRGB")
            return std::nullopt;
        if (type == "gAMA" && size == 4)
            remark = gamma(qFromBigEndian<quint32>(data.constData()) / 100000.0);
        at += kAround + size;
    }
    return remark;
}

/// The segments of a JPEG that stand before its pixels.
std::optional<Reason> remarkOfJpeg(const QByteArray& file)
{
    const QByteArray mark("ICC_PROFILE\0", 12);
    constexpr qsizetype kNumbers = 2; // which part of the profile it is, of how many
    for (qsizetype at = 2; at + 4 <= file.size() && file[at] == '\xff';) {
        const char type = file[at + 1];
        const auto size = qsizetype{qFromBigEndian<quint16>(file.constData() + at + 2)};
        if (type == '\xda')
            break;
        const QByteArray data = file.mid(at + 4, size - 2);
        if (type == '\xe2' && data.startsWith(mark)) {
            const QString name = QColorSpace::fromIccProfile(data.mid(mark.size() + kNumbers)).description();
            return profile(name.isEmpty() ? QStringLiteral("ICC") : name);
        }
        at += 2 + size;
    }
    return std::nullopt;
}

/// The footer of a TGA of version 2 says where its extension lies, which holds the gamma as a fraction.
std::optional<Reason> remarkOfTga(const QByteArray& file)
{
    constexpr qsizetype kFooter = 26;
    constexpr qsizetype kGamma = 478;
    const auto extension = qsizetype{qFromLittleEndian<quint32>(file.constData() + file.size() - kFooter)};
    if (extension == 0 || extension + kGamma + 4 > file.size())
        return std::nullopt;
    const auto numerator = qFromLittleEndian<quint16>(file.constData() + extension + kGamma);
    const auto denominator = qFromLittleEndian<quint16>(file.constData() + extension + kGamma + 2);
    if (denominator == 0 || numerator == 0 || numerator == denominator)
        return std::nullopt;
    return gamma(static_cast<double>(numerator) / denominator);
}

} // namespace

std::optional<Reason> colorTagRemark(const QByteArray& file)
{
    if (file.startsWith("\x89PNG\r\n\x1a\n"))
        return remarkOfPng(file);
    if (file.startsWith("\xff\xd8"))
        return remarkOfJpeg(file);
    if (file.endsWith(QByteArray("TRUEVISION-XFILE.\0", 18)) && file.size() > 44)
        return remarkOfTga(file);
    return std::nullopt;
}

} // namespace rasterlens
