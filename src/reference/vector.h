// Three doubles: places, directions, colours by channel.
#pragma once

#include <array>
#include <cmath>

#include <sheer/scene.h>

namespace sheer::reference {

using Vec3 = std::array<double, 3>;

inline Vec3 to_vec3(const Float3& v)
{
    return {v[0], v[1], v[2]};
}

inline Vec3 operator+(const Vec3& a, const Vec3& b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Vec3 operator-(const Vec3& a, const Vec3& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Channel by channel.
inline Vec3 operator*(const Vec3& a, const Vec3& b)
{
    return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}

inline Vec3 operator*(double scale, const Vec3& v)
{
    return {scale * v[0], scale * v[1], scale * v[2]};
}

inline double dot(const Vec3& a, const Vec3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double mean(const Vec3& v)
{
    return (v[0] + v[1] + v[2]) / 3;
}

// Shorter vectors have no direction that could be trusted; docs/numerics.md makes them 0.
inline constexpr double kShortestVector = 1e-10;

inline Vec3 normalized(const Vec3& v)
{
    const double length = std::sqrt(dot(v, v));
    return length < kShortestVector ? Vec3{0, 0, 0} : (1 / length) * v;
}

}  // namespace sheer::reference
