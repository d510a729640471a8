// Three doubles with the operators of vectors.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace sheer {

struct Vec3d {
    double x = 0, y = 0, z = 0;
};

inline Vec3d operator+(Vec3d a, Vec3d b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Vec3d operator-(Vec3d a, Vec3d b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vec3d operator*(double s, Vec3d a)
{
    return {s * a.x, s * a.y, s * a.z};
}

inline double dot(Vec3d a, Vec3d b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec3d cross(Vec3d a, Vec3d b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Of length 1; zero where it has none, or one that is not finite.
inline Vec3d normalized(Vec3d a)
{
    const double length = std::sqrt(dot(a, a));
    return length > 0 && std::isfinite(length) ? (1 / length) * a : Vec3d{};
}

inline Vec3d to_vec3d(const std::array<float, 3>& a)
{
    return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}

inline std::array<float, 3> to_float3(Vec3d a)
{
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

// As a direction: by the 3x3 part of a column-major 4x4 matrix.
inline Vec3d turned(const std::array<float, 16>& m, Vec3d a)
{
    const auto column = [&](std::size_t c) {
        return to_vec3d({m[4 * c], m[4 * c + 1], m[4 * c + 2]});
    };
    return a.x * column(0) + a.y * column(1) + a.z * column(2);
}

}  // namespace sheer
