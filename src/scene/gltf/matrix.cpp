// Transforms (glTF 2.0, section 3.5.3: translation times rotation times scale).

#include "scene/gltf/matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sheer::gltf {

namespace {

Vec3 column(const Matrix& m, std::size_t c)
{
    return {m[4 * c], m[4 * c + 1], m[4 * c + 2]};
}

double dot(const Vec3& a, const Vec3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

std::optional<Vec3> direction(Vec3 v)
{
    const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
    // Scaled by it first, so that squares neither overflow nor vanish.
    for (double& c : v) c /= largest;
    const double length = std::sqrt(dot(v, v));
    for (double& c : v) c /= length;
    return v;
}

Matrix multiply(const Matrix& a, const Matrix& b)
{
    Matrix product;
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t r = 0; r < 4; ++r) {
            double sum = 0;
            for (std::size_t k = 0; k < 4; ++k) sum += a[4 * k + r] * b[4 * c + k];
            product[4 * c + r] = sum;
        }
    }
    return product;
}

Matrix matrix_of(const Placement& placement)
{
    const auto [x, y, z, w] = placement.rotation;
    const Vec3& t = placement.translation;
    const Vec3& s = placement.scale;
    return {
        s[0] * (1 - 2 * (y * y + z * z)),
        s[0] * 2 * (x * y + z * w),
        s[0] * 2 * (x * z - y * w),
        0,
        s[1] * 2 * (x * y - z * w),
        s[1] * (1 - 2 * (x * x + z * z)),
        s[1] * 2 * (y * z + x * w),
        0,
        s[2] * 2 * (x * z + y * w),
        s[2] * 2 * (y * z - x * w),
        s[2] * (1 - 2 * (x * x + y * y)),
        0,
        t[0],
        t[1],
        t[2],
        1,
    };
}

std::optional<Mat4> to_float(const Matrix& m)
{
    Mat4 result;
    for (std::size_t i = 0; i < 16; ++i) {
        // Not std::isfinite of the cast: a double too large for a float must not be cast at all.
        if (!(std::abs(m[i]) <= static_cast<double>(std::numeric_limits<float>::max()))) {
            return std::nullopt;
        }
        result[i] = static_cast<float>(m[i]);
    }
    return result;
}

std::optional<Matrix> rigid(const Matrix& m)
{
    const auto z = direction(column(m, 2));
    const auto up = direction(column(m, 1));
    if (!z || !up) return std::nullopt;
    const auto x = direction(cross(*up, *z));
    if (!x) return std::nullopt;
    const Vec3 y = cross(*z, *x);
    return Matrix{(*x)[0], (*x)[1], (*x)[2], 0, y[0],  y[1],  y[2],  0,
                  (*z)[0], (*z)[1], (*z)[2], 0, m[12], m[13], m[14], 1};
}

}  // namespace sheer::gltf
