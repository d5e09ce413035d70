#pragma once
#include "core/base/reason.h"

#include <QByteArray>
#include <QImage>

#include <memory>
#include <optional>

namespace rasterlens
{

/// Makes an animated GIF of pictures that come one after the other, and is repeated for ever.
///
/// exact   where the first picture has at most 256 colours and what changes from one to the next at most 255; else the
///         palette is that of withPalette()
/// cost    only what changes is stored
/// source  GIF89a; written by giflib
class GifWriter
{
public:
    static constexpr int kMostPictures = 5000;
    static constexpr int kMostSide = 8192;
    static constexpr qsizetype kMostBytes = 100'000'000;
    static constexpr int kLeastMilliseconds = 20; ///< viewers slow down what is quicker
    static constexpr int kMostMilliseconds = 60'000;

    /// in  the time of each picture in milliseconds, kLeastMilliseconds to kMostMilliseconds; GIF counts in 10
    GifWriter(QSize size, int milliseconds);
    ~GifWriter();
    GifWriter(const GifWriter&) = delete;
    GifWriter& operator=(const GifWriter&) = delete;

    /// errors  the picture is empty or of another size, there are too many, or the file becomes too large: of the
    ///         context "Diagnostic"; nothing can be added then
    [[nodiscard]] std::optional<Reason> add(const QImage& picture);

    struct Finished {
        QByteArray bytes;
        std::optional<Reason> problem;
    };
    /// in  at least one picture was added; nothing is added afterwards
    [[nodiscard]] Finished finish();

private:
    struct File;

    [[nodiscard]] std::optional<Reason> write(const QImage& picture, const QRect& part);

    QSize m_size;
    int m_milliseconds;
    int m_pictures = 0;
    QImage m_last; ///< the picture before
    std::unique_ptr<File> m_file;
};

} // namespace rasterlens
