#pragma once
#include <QImage>

namespace rasterlens
{

/// The picture with a palette.
///
/// in      an opaque picture
/// out     Format_Indexed8 with at most `most` colours
/// exact   where the picture has no more than that
/// covers  more colours: median cut. The box of colours with the longest side is halved again and again where its
/// pixels
///         are halved, and a colour becomes the mean of its box
/// errors  a null image for a null one, and where there is not enough memory
[[nodiscard]] QImage withPalette(const QImage& picture, int most = 256);

} // namespace rasterlens
