#include "core/io/tga.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rasterlens
{
namespace
{

constexpr int kHeaderBytes = 18;
constexpr int kRunLengthPacked = 8; ///< added to the image type
enum ImageType { Palette = 1, TrueColor = 2, Grey = 3 };

int byteAt(const QByteArray& file, qsizetype at) { return static_cast<unsigned char>(file[at]); }
int wordAt(const QByteArray& file, qsizetype at) { return byteAt(file, at) | byteAt(file, at + 1) << 8; }

struct Header {
    explicit Header(const QByteArray& file)
        : idBytes(byteAt(file, 0)), hasPalette(byteAt(file, 1) == 1), type(byteAt(file, 2) & ~kRunLengthPacked),
          packed((byteAt(file, 2) & kRunLengthPacked) != 0), paletteFirst(wordAt(file, 3)),
          paletteSize(wordAt(file, 5)), paletteBits(byteAt(file, 7)), width(wordAt(file, 12)), height(wordAt(file, 14)),
          bits(byteAt(file, 16)), alphaBits(byteAt(file, 17) & 0x0f), rightToLeft((byteAt(file, 17) & 0x10) != 0),
          topToBottom((byteAt(file, 17) & 0x20) != 0)
    {
    }

    int idBytes;
    bool hasPalette;
    int type;
    bool packed;
    int paletteFirst;
    int paletteSize;
    int paletteBits;
    int width;
    int height;
    int bits;
    int alphaBits; ///< what the file says of its fourth channel; 8: it is alpha
    bool rightToLeft;
    bool topToBottom;
};

int bytesOf(int bits) { return (bits + 7) / 8; }

bool isColorDepth(int bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

bool isSupported(const Header& header)
{
    switch (header.type) {
    case Palette:
        return header.hasPalette && isColorDepth(header.paletteBits) && (header.bits == 8 || header.bits == 16);
    case TrueColor: return isColorDepth(header.bits);
    case Grey: return header.bits == 8;
    default: return false;
    }
}

/// Makes every pixel opaque where none is to be seen at all: many programs write a fourth channel of zeros.
void dropEmptyAlpha(QImage& image)
{
    const auto rowIsEmpty = [&](int y) {
        const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        return std::all_of(row, row + image.width(), [](QRgb pixel) { return qAlpha(pixel) == 0; });
    };
    for (int y = 0; y < image.height(); ++y)
        if (!rowIsEmpty(y))
            return;
    image.reinterpretAsFormat(QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        std::transform(row, row + image.width(), row, [](QRgb pixel) { return pixel | 0xff000000U; });
    }
}

/// A stored colour of 15 (five bits a channel) to 32 bits; blue comes first.
QRgb colorAt(const QByteArray& file, qsizetype at, int bits)
{
    if (bits >= 24)
        return qRgb(byteAt(file, at + 2), byteAt(file, at + 1), byteAt(file, at));
    const int word = wordAt(file, at);
    const auto channel = [word](int shift) { return ((word >> shift) & 31) * 255 / 31; };
    return qRgb(channel(10), channel(5), channel(0));
}

TgaImage endsEarly() { return {{}, QT_TRANSLATE_NOOP("Diagnostic", "the image ends early")}; }

class Reader
{
public:
    explicit Reader(const QByteArray& file) : m_file(file), m_header(file) {}

    TgaImage read()
    {
        if (!isSupported(m_header))
            return {{},
                    Reason(QT_TRANSLATE_NOOP("Diagnostic", "a TGA image of type %1 with %2 bits is not supported"),
                           {m_header.type, m_header.bits})};
        m_at = kHeaderBytes + m_header.idBytes;
        if (!readPalette())
            return endsEarly();
        const bool hasAlpha = m_header.type == TrueColor && m_header.bits == 32 && m_header.alphaBits == 8;
        QImage image(m_header.width, m_header.height, hasAlpha ? QImage::Format_ARGB32 : QImage::Format_RGB32);
        if (image.isNull())
            return {{}, QT_TRANSLATE_NOOP("Diagnostic", "there is not enough memory for the image")};
        for (int row = 0; row < m_header.height; ++row) {
            const int y = m_header.topToBottom ? row : m_header.height - 1 - row;
            QRgb* const line = reinterpret_cast<QRgb*>(image.scanLine(y));
            for (int x = 0; x < m_header.width; ++x) {
                const auto pixel = nextPixel();
                if (!pixel)
                    return endsEarly();
                line[m_header.rightToLeft ? m_header.width - 1 - x : x] = *pixel;
            }
        }
        if (hasAlpha)
            dropEmptyAlpha(image);
        return {image, {}};
    }

private:
    bool has(qsizetype bytes) const { return m_at + bytes <= m_file.size(); }

    bool readPalette()
    {
        if (!m_header.hasPalette)
            return true;
        const int bytes = bytesOf(m_header.paletteBits);
        if (!has(qsizetype{bytes} * m_header.paletteSize))
            return false;
        for (int i = 0; i < m_header.paletteSize; ++i, m_at += bytes)
            if (m_header.type == Palette)
                m_palette.push_back(colorAt(m_file, m_at, m_header.paletteBits));
        return true;
    }

    /// A packet begins with its length less one; the top bit says that one pixel is repeated. Packets may run on from
    /// one row to the next.
    std::optional<QRgb> nextPixel()
    {
        if (!m_header.packed)
            return storedPixel();
        if (m_left == 0) {
            if (!has(1))
                return std::nullopt;
            const int head = byteAt(m_file, m_at++);
            m_left = (head & 0x7f) + 1;
            m_repeats = (head & 0x80) != 0;
            m_pixel.reset();
        }
        --m_left;
        if (!m_repeats || !m_pixel)
            m_pixel = storedPixel();
        return m_pixel;
    }

    std::optional<QRgb> storedPixel()
    {
        const int bytes = bytesOf(m_header.bits);
        if (!has(bytes))
            return std::nullopt;
        const qsizetype at = m_at;
        m_at += bytes;
        if (m_header.type == TrueColor) {
            const QRgb color = colorAt(m_file, at, m_header.bits);
            return m_header.bits == 32 && m_header.alphaBits == 8
                       ? qRgba(qRed(color), qGreen(color), qBlue(color), byteAt(m_file, at + 3))
                       : color;
        }
        if (m_header.type == Grey)
            return qRgb(byteAt(m_file, at), byteAt(m_file, at), byteAt(m_file, at));
        const int index = (bytes == 1 ? byteAt(m_file, at) : wordAt(m_file, at)) - m_header.paletteFirst;
        const bool known = index >= 0 && index < static_cast<int>(m_palette.size());
        return known ? m_palette[static_cast<std::size_t>(index)] : qRgb(0, 0, 0);
    }

    const QByteArray& m_file;
    const Header m_header;
    qsizetype m_at = 0;
    std::vector<QRgb> m_palette;
    int m_left = 0; ///< pixels of the packet that are still to come
    bool m_repeats = false;
    std::optional<QRgb> m_pixel;
};

} // namespace

std::optional<QSize> tgaSize(const QByteArray& file)
{
    if (file.size() < kHeaderBytes)
        return std::nullopt;
    const Header header(file);
    return QSize(header.width, header.height);
}

TgaImage readTga(const QByteArray& file)
{
    if (file.size() < kHeaderBytes)
        return endsEarly();
    return Reader(file).read();
}

} // namespace rasterlens
