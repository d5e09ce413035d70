#pragma once
#include <vector>

namespace rasterlens
{

struct CurvePoint {
    double x;
    double y;
};

/// n(m): the fraction of the way in space that belongs to the fraction m of the way on the screen, from depth z1 to z2.
///
/// in      z1, z2 > 0; m in 0..1
/// out     m z1 / ((1 - m) z2 + m z1); m itself where z1 = z2
/// source  Heckbert & Moreton, Interpolation for Polygon Texture Mapping and Shading, 1991
[[nodiscard]] double spaceFraction(double m, double z1, double z2);

/// The curve of spaceFraction over m = 0..1.
///
/// in  at least two points
[[nodiscard]] std::vector<CurvePoint> spaceFractionCurve(double z1, double z2, int points);

/// z' = n + f - n f / z: what the perspective-to-orthographic matrix makes of a distance; n and f stay where they are,
/// all between moves towards f.
///
/// in  0 < n <= z <= f
[[nodiscard]] double squeezedDepth(double z, double n, double f);
/// The curve of squeezedDepth over z = n..f.
[[nodiscard]] std::vector<CurvePoint> squeezedDepthCurve(double n, double f, int points);

/// z/w of OpenGL's projection, -1..1, for a distance in front of the eye.
[[nodiscard]] double ndcDepth(double z, double n, double f);

/// One of the two depths, between the ends of an edge.
struct DepthGuess {
    double truth = 0;
    double linear = 0;         ///< interpolated by the fraction of the way on the screen
    double corrected = 0;      ///< interpolated by the fraction of the way in space
    double linearError = 0;    ///< linear - truth
    double correctedError = 0; ///< corrected - truth
};

/// The four-z board: z/w is linear on the screen and must not be corrected; the distance is not linear and must be.
struct FourZ {
    double fraction = 0; ///< n(m)
    DepthGuess ndc;      ///< z/w
    DepthGuess view;     ///< distance
};

/// in  near and far planes n and f, the distances z1 and z2 of the ends, the fraction m of the way on the screen
[[nodiscard]] FourZ fourZ(double n, double f, double z1, double z2, double m);

} // namespace rasterlens
