#pragma once
#include <QImage>
#include <QPoint>
#include <QRect>
#include <QRgb>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace rasterlens
{

/// A pixel at which another picture differs from the right one.
struct ChangedPixel {
    std::uint32_t index; ///< row by row from the top
    QRgb color;          ///< in the other picture
};

/// What another picture changes in the right one.
struct PictureChange {
    std::vector<ChangedPixel> pixels; ///< row by row
    QRect box;                        ///< around them; empty where there are none
};

/// How well a picture that was handed in fits one that was drawn, before the noise is known.
struct PictureFit {
    QPoint offset;     ///< of the picture handed in, in pixels of the comparison: it lies that far right and down
    double weight = 0; ///< of the change: its pixels, each by the square of its contrast
    double gain = 0;   ///< the same, each pixel times how far it has gone from the right colour to the other, -1..1
    std::array<double, 2> excess{};  ///< squared differences from both pictures: flat areas, edges
    std::array<double, 2> count{};   ///< pixels: flat areas, edges
    std::array<double, 2> typical{}; ///< squared difference from the other picture that is spread all over it, a pixel
    double residual = 0;             ///< squared differences from the other picture, small ones too, over all pixels
    int unlike = 0;                  ///< pixels that differ visibly from the other picture
};

/// The square of a difference that counts as a whole wrong pixel.
constexpr double kWholePixel = 96.0 * 96.0;

/// A picture laid over the right picture of a scene, to be compared with it and with others of its size. A place where
/// the one is larger than the other is made smaller, so that no pixel is compared with nothing.
class PictureComparison
{
public:
    /// in  `place`: the part of the picture handed in that shows the scene; what lies outside is background
    PictureComparison(const QImage& handedIn, const QRect& place, const QImage& right, QRgb background);

    [[nodiscard]] QSize size() const { return m_right.size(); }
    /// The picture handed in as it is compared, moved by no offset.
    [[nodiscard]] const QImage& picture() const { return m_picture; }

    /// This comparison with another colour in place of the background: that which most pixels have that should be
    /// background; where nothing should be, the most frequent one if the right picture does not have it. Nothing where
    /// there is no such colour.
    [[nodiscard]] std::optional<PictureComparison> withOwnBackground() const;

    /// This comparison with another right picture, which has the same size.
    [[nodiscard]] PictureComparison withRight(const QImage& right) const;

    /// The squared differences from a picture of the scene, without moving anything.
    [[nodiscard]] double leaves(const QImage& other) const;

    /// A picture that has at each pixel the colour of that one of some pictures of the scene which is nearest to the
    /// picture handed in at that offset, the first of those equally near. In the size of the comparison.
    [[nodiscard]] QImage nearest(const std::vector<QImage>& pictures, QPoint offset) const;

    /// in  a picture of the scene, as large as the right one was
    [[nodiscard]] PictureChange changeTo(const QImage& other) const;

    /// The best fit of a picture that differs from the right one by `change`, moved by at most two pixels.
    [[nodiscard]] PictureFit fit(const PictureChange& change) const;

private:
    [[nodiscard]] std::optional<QRgb> ownBackground() const;

    /// Squared differences from the right picture at an offset, by blocks of the picture.
    struct Blocks {
        std::array<std::vector<double>, 2> energy;
        std::array<std::vector<double>, 2> count;
        std::array<double, 2> energySum{};
        std::array<double, 2> countSum{};
        double residual = 0; ///< small differences too
        int unlike = 0;
    };
    /// Squared differences from the right picture at an offset, a pixel.
    struct Mean {
        double left = 0;
        double pixels = 0; ///< of the right picture that lie in the other one
    };
    [[nodiscard]] const Mean& meanAt(std::size_t offset) const;
    [[nodiscard]] const Blocks& blocksAt(std::size_t offset) const;
    [[nodiscard]] std::size_t blockOf(int x, int y) const;
    [[nodiscard]] std::optional<QRgb> pictureAt(std::uint32_t index, QPoint offset) const;
    [[nodiscard]] double distance(const PictureChange& change, std::size_t offset, std::size_t stride) const;
    [[nodiscard]] PictureFit fitAt(const PictureChange& change, std::size_t offset) const;
    [[nodiscard]] double spread(const std::vector<double>& energy, const std::vector<double>& count) const;
    void markEdges();

    QImage m_right;
    QImage m_picture;
    QRgb m_background;
    std::vector<std::uint8_t> m_edge; ///< 1 where the right picture has an edge
    int m_blocksAcross = 1;
    mutable std::vector<std::optional<Blocks>> m_blocks; ///< by offset
    mutable std::vector<std::optional<Mean>> m_means;    ///< by offset
};

/// What is left of a score at an offset: a pixel costs one fiftieth.
[[nodiscard]] double offsetFactor(QPoint offset);

/// The parts of a picture that may show the scene: all of it, or less where there is a border.
///
/// out  the likeliest first; a rectangle may reach out of the picture
[[nodiscard]] std::vector<QRect> placesIn(const QImage& handedIn, const QImage& right);

} // namespace rasterlens
