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

// Not std::isfinite of the cast: a double too large for a float must not be cast at all.
bool fits_float(double x)
{
    return std::abs(x) <= static_cast<double>(std::numeric_limits<float>::max());
}

}  // namespace

std::optional<Vec3> direction(Vec3 v)
{
    double largest = 0;
    for (const double c : v) {
        if (!std::isfinite(c)) return std::nullopt;
        largest = std::max(largest, std::abs(c));
    }
    if (largest == 0) return std::nullopt;
    // Scaled by it first, so that squares neither overflow nor vanish.
    for (double& c : v) c /= largest;
    const double length = std::sqrt(dot(v, v));
    for (double& c : v) c /= length;
    return v;
}

bool normalize(std::array<double, 4>& q)
{
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(length > 1e-6) || !std::isfinite(length)) return false;
    for (double& c : q) c /= length;
    return true;
}

std::optional<Matrix> affine(const Matrix& m)
{
    Matrix result = m;
    for (std::size_t c = 0; c < 4; ++c) {
        // Writers that invert matrices leave rounding in the last row.
        if (!(std::abs(m[4 * c + 3] - kIdentityMatrix[4 * c + 3]) <= 1e-5)) return std::nullopt;
        result[4 * c + 3] = kIdentityMatrix[4 * c + 3];
    }
    const bool is_finite =
        std::all_of(m.begin(), m.end(), [](double c) { return std::isfinite(c); });
    return is_finite ? std::optional(result) : std::nullopt;
}

double determinant(const Matrix& m)
{
    return dot(column(m, 0), cross(column(m, 1), column(m, 2)));
}

Vec3 transform_point(const Matrix& m, const Float3& p)
{
    const Vec3 v = transform_direction(m, p);
    return {v[0] + m[12], v[1] + m[13], v[2] + m[14]};
}

Vec3 transform_direction(const Matrix& m, const Float3& v)
{
    Vec3 result;
    for (std::size_t r = 0; r < 3; ++r) {
        result[r] = m[r] * double{v[0]} + m[4 + r] * double{v[1]} + m[8 + r] * double{v[2]};
    }
    return result;
}

// By the cofactors, which are the inverse transpose times the determinant and exist without one.
Vec3 transform_normal(const Matrix& m, const Float3& n)
{
    const Vec3 x = cross(column(m, 1), column(m, 2));
    const Vec3 y = cross(column(m, 2), column(m, 0));
    const Vec3 z = cross(column(m, 0), column(m, 1));
    const double side = dot(column(m, 0), x) < 0 ? -1 : 1;
    Vec3 result;
    for (std::size_t r = 0; r < 3; ++r) {
        result[r] = side * (x[r] * double{n[0]} + y[r] * double{n[1]} + z[r] * double{n[2]});
    }
    return result;
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

bool fits_floats(const Vec3& v)
{
    return std::all_of(v.begin(), v.end(), fits_float);
}

std::optional<Mat4> to_float(const Matrix& m)
{
    Mat4 result;
    for (std::size_t i = 0; i < 16; ++i) {
        if (!fits_float(m[i])) return std::nullopt;
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
