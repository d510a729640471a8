// Section 4.1 of the paper that flip.h cites, with the sRGB primaries that its authors' programs
// use; white is where red, green and blue are 1.
#include "compare/flip_color.h"

#include <cmath>
#include <cstddef>

#include "support/math.h"

namespace sheer {

namespace {

using Matrix = std::array<Triple, 3>;

constexpr double kXy = 24577794, kY = 12288897, kZ = 73733382;
constexpr Matrix kXyzFromRgb = {{{10135552 / kXy, 8788810 / kXy, 4435075 / kXy},
                                 {2613072 / kY, 8788810 / kY, 887015 / kY},
                                 {1425312 / kZ, 8788810 / kZ, 70074185 / kZ}}};

constexpr Triple times(const Matrix& m, const Triple& v)
{
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    }
    return result;
}

// By cofactors.
constexpr Matrix inverse(const Matrix& m)
{
    Matrix result{};
    double determinant = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t r = (j + 1) % 3, s = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            result[i][j] = m[r][c] * m[s][d] - m[r][d] * m[s][c];
        }
        determinant += m[0][i] * result[i][0];
    }
    for (Triple& row : result) {
        for (double& value : row) value /= determinant;
    }
    return result;
}

constexpr Matrix kRgbFromXyz = inverse(kXyzFromRgb);
constexpr Triple kWhite = times(kXyzFromRgb, {1, 1, 1});

// XYZ by white's.
Triple relative_xyz(const Triple& rgb)
{
    Triple xyz = times(kXyzFromRgb, rgb);
    for (std::size_t i = 0; i < 3; ++i) xyz[i] /= kWhite[i];
    return xyz;
}

Triple opponents(const Triple& v)
{
    return {116 * v[1] - 16, 500 * (v[0] - v[1]), 200 * (v[1] - v[2])};
}

// CIE 15:2004, 8.2.1.
double lab_curve(double t)
{
    constexpr double kDelta = 6.0 / 29;
    if (t > kDelta * kDelta * kDelta) return own_pow(t, 1.0 / 3);
    return t / (3 * kDelta * kDelta) + 4.0 / 29;
}

}  // namespace

Triple ycxcz_from_linear(const Triple& rgb)
{
    return opponents(relative_xyz(rgb));
}

Triple linear_from_ycxcz(const Triple& color)
{
    const double y = (color[0] + 16) / 116;
    return times(kRgbFromXyz, {(y + color[1] / 500) * kWhite[0], y * kWhite[1],
                               (y - color[2] / 200) * kWhite[2]});
}

Triple hunt_lab_from_linear(const Triple& rgb)
{
    Triple xyz = relative_xyz(rgb);
    for (double& value : xyz) value = lab_curve(value);
    const Triple lab = opponents(xyz);
    return {lab[0], 0.01 * lab[0] * lab[1], 0.01 * lab[0] * lab[2]};
}

double hyab(const Triple& a, const Triple& b)
{
    const double da = a[1] - b[1], db = a[2] - b[2];
    return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

}  // namespace sheer
