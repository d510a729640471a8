// Thresholds of hashed alpha testing, in double precision: C. Wyman, M. McGuire, "Improved alpha
// testing using hashed sampling", 2019. A fragment whose opacity is below its threshold is
// discarded.
#pragma once

#include <array>
#include <functional>
#include <span>

namespace sheer::reference {

using Point3 = std::array<double, 3>;

// The paper's: frac(1e4 sin(17 x + 0.1 y) (0.1 + |sin(13 y + x)|)), and of three numbers that of
// the first two's and the third. In [0, 1).
double paper_hash(double x, double y);
double paper_hash(const Point3& cell);

using CellHash = std::function<double(const Point3& cell)>;  // of whole numbers, to [0, 1)

// The chance that (1 - t) U0 + t U1 <= x, of two uniform numbers; equation 2 with a = min(t, 1 -
// t).
double mix_of_two_cdf(double x, double t);
// The same of a sum of uniform numbers times weights, which add up to 1. Weights below 1e-3 lose
// digits: with the smallest four of eight at 1e-3, all but some 4 are gone.
double mix_cdf(double x, std::span<const double> weights);

// Object space position of a point of a surface, and its derivatives along a pixel to the right and
// down.
struct SurfacePoint {
    Point3 position, dx, dy;
};

struct HashedThreshold {
    // One size of cells for all axes (listing 1), one for each (listing 2), or each with all eight
    // combinations of the two sizes (section 6.2).
    enum class Variant { isotropic, anisotropic, eight_corners } variant = Variant::isotropic;
    double hash_scale = 1;  // cells, in pixels
    CellHash hash = [](const Point3& cell) { return paper_hash(cell); };
    // What the paper shows to be needed: sizes that are powers of 2, of which two are mixed; the
    // mixture's distribution made uniform; the third coordinate.
    bool discrete = true, uniform = true, third = true;
};

// In [1e-6, 1]. The largest derivative is taken to be 1e-8 to 1e8, and each axis's at least 1/16 of
// the largest axis's, where each counts.
double hashed_threshold(const SurfacePoint& point, const HashedThreshold& how);

// Equations 3 to 5. b of the texture's level of detail x: 0 for x <= 0, (x / n)^2, 1 from n on.
double fade_in(double x, double n);
double faded_threshold(double threshold, double b);
// How often a fragment passes faded thresholds that are uniform in [0, 1).
double faded_pass_chance(double opacity, double b);
// What x is multiplied by before: from derivatives of texture coordinates, each not 0.
double anisotropy(std::array<double, 2> uv_dx, std::array<double, 2> uv_dy);

// The frame's number, 0 to n - 1, as the order of n strata has it: as it is, the lower and the
// upper half by turns (n even), or with its bits reversed (n a power of 2).
enum class StrataOrder { linear, alternating, van_der_corput };
int stratum(int frame, int n, StrataOrder order);
// frac(threshold + stratum / n): equation 6.
double stratified_threshold(double threshold, int stratum, int n);

// A direction about the z axis with a density of cosine / pi, from two uniform numbers.
Point3 cosine_direction(double chi1, double chi2);

}  // namespace sheer::reference
