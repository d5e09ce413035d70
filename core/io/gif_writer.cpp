#include "core/io/gif_writer.h"

#include "core/io/palette.h"

#include <QCoreApplication>

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kHundredths = 10; ///< milliseconds
constexpr int kMostColors = 256;

/// The least rectangle that holds all pixels in which two pictures of one size differ; empty where there are none.
QRect changeOf(const QImage& before, const QImage& after)
{
    int left = after.width();
    int right = -1;
    int top = after.height();
    int bottom = -1;
    for (int y = 0; y < after.height(); ++y) {
        const auto* a = reinterpret_cast<const QRgb*>(before.constScanLine(y));
        const auto* b = reinterpret_cast<const QRgb*>(after.constScanLine(y));
        if (std::equal(b, b + after.width(), a))
            continue;
        top = std::min(top, y);
        bottom = y;
        for (int x = 0; x < after.width(); ++x)
            if (a[x] != b[x]) {
                left = std::min(left, x);
                right = std::max(right, x);
            }
    }
    return bottom < 0 ? QRect() : QRect(QPoint(left, top), QPoint(right, bottom));
}

/// A picture whose pixels all have colours of pixels that changed: of those alone, where any changed.
QImage onlyChanged(const QImage& before, const QImage& after)
{
    QImage picture = after;
    QRgb changed = after.pixel(0, 0);
    for (int pass = 0; pass < 2; ++pass) // the first finds a colour, the second replaces the others by it
        for (int y = 0; y < after.height(); ++y)
            for (int x = 0; x < after.width(); ++x)
                if (before.pixel(x, y) == after.pixel(x, y))
                    picture.setPixel(x, y, changed);
                else
                    changed = after.pixel(x, y);
    return picture;
}

} // namespace

struct GifWriter::File {
    QByteArray bytes;
    GifFileType* gif = nullptr;

    File()
    {
        int error = 0;
        gif = EGifOpen(
            this,
            [](GifFileType* to, const GifByteType* data, int length) {
                static_cast<File*>(to->UserData)->bytes.append(reinterpret_cast<const char*>(data), length);
                return length;
            },
            &error);
        if (gif)
            EGifSetGifVersion(gif, true);
    }
    ~File() { close(); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    bool close()
    {
        int error = 0;
        return !gif || EGifCloseFile(std::exchange(gif, nullptr), &error) == GIF_OK;
    }

    [[nodiscard]] Reason problem() const
    {
        const char* why = gif ? GifErrorString(gif->Error) : nullptr;
        return {QT_TRANSLATE_NOOP("Diagnostic", "the picture cannot be made a %1: %2"),
                {QStringLiteral("gif"), QString::fromLatin1(why ? why : "giflib")}};
    }

    /// The screen, and that the pictures are repeated for ever.
    bool begin(QSize size)
    {
        constexpr int kBitsOfColor = 8;
        constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
        static constexpr char kName[] = "NETSCAPE2.0";
        return gif && EGifPutScreenDesc(gif, size.width(), size.height(), kBitsOfColor, 0, nullptr) == GIF_OK &&
               EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
               EGifPutExtensionBlock(gif, sizeof(kName) - 1, kName) == GIF_OK &&
               EGifPutExtensionBlock(gif, int(kForEver.size()), kForEver.data()) == GIF_OK &&
               EGifPutExtensionTrailer(gif) == GIF_OK;
    }
};

GifWriter::GifWriter(QSize size, int milliseconds)
    : m_size(size), m_milliseconds(std::clamp(milliseconds, kLeastMilliseconds, kMostMilliseconds)),
      m_file(std::make_unique<File>())
{
}

GifWriter::~GifWriter() = default;

std::optional<Reason> GifWriter::add(const QImage& picture)
{
    if (picture.isNull() || picture.size() != m_size || std::max(m_size.width(), m_size.height()) > kMostSide)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the picture is empty or too large"));
    if (m_pictures == kMostPictures)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "an animation has at most %1 pictures"), {kMostPictures});
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB32);
    if (m_pictures == 0 && !m_file->begin(m_size))
        return m_file->problem();
    QRect part = m_pictures == 0 ? rgb.rect() : changeOf(m_last, rgb);
    if (part.isEmpty()) // its time passes all the same
        part = QRect(0, 0, 1, 1);
    if (auto problem = write(rgb, part))
        return problem;
    if (m_file->bytes.size() > kMostBytes)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the animation becomes larger than %1 million bytes"),
                      {kMostBytes / 1'000'000});
    ++m_pictures;
    m_last = rgb;
    return std::nullopt;
}

/// Writes a part of a picture over the one before, with a palette of its own; what stays is transparent.
std::optional<Reason> GifWriter::write(const QImage& picture, const QRect& part)
{
    const bool isFirst = m_pictures == 0;
    const QImage after = picture.copy(part);
    const QImage before = isFirst ? QImage() : m_last.copy(part);
    QImage image = withPalette(isFirst ? after : onlyChanged(before, after), isFirst ? kMostColors : kMostColors - 1);
    if (image.isNull())
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the picture is empty or too large"));
    std::array<GifColorType, kMostColors> colors{};
    const QList<QRgb> table = image.colorTable();
    std::ranges::transform(table, colors.begin(), [](QRgb color) {
        return GifColorType{static_cast<GifByteType>(qRed(color)), static_cast<GifByteType>(qGreen(color)),
                            static_cast<GifByteType>(qBlue(color))};
    });
    const int clear = isFirst ? NO_TRANSPARENT_COLOR : static_cast<int>(table.size());
    const int size = 1 << std::max(1, GifBitSize(static_cast<int>(table.size()) + (isFirst ? 0 : 1)));
    const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> map(GifMakeMapObject(size, colors.data()),
                                                                           &GifFreeMapObject);
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, m_milliseconds / kHundredths, clear};
    std::array<GifByteType, 4> extension{};
    EGifGCBToExtension(&control, extension.data());
    GifFileType* gif = m_file->gif;
    bool written = map &&
                   EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, int(extension.size()), extension.data()) == GIF_OK &&
                   EGifPutImageDesc(gif, part.x(), part.y(), part.width(), part.height(), false, map.get()) == GIF_OK;
    for (int y = 0; written && y < image.height(); ++y) {
        uchar* row = image.scanLine(y);
        for (int x = 0; !isFirst && x < image.width(); ++x)
            if (before.pixel(x, y) == after.pixel(x, y))
                row[x] = static_cast<uchar>(clear);
        written = EGifPutLine(gif, row, image.width()) == GIF_OK;
    }
    return written ? std::nullopt : std::optional(m_file->problem());
}

GifWriter::Finished GifWriter::finish()
{
    if (!m_file->close())
        return {{}, m_file->problem()};
    return {std::move(m_file->bytes), std::nullopt};
}

} // namespace rasterlens
