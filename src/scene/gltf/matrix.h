// Transforms of nodes, in double: the product of a long chain is rounded to float once.
#pragma once

#include <array>
#include <optional>

#include <sheer/scene.h>

namespace sheer::gltf {

using Matrix = std::array<double, 16>;  // column-major; the last row is 0 0 0 1

inline constexpr Matrix kIdentityMatrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

using Vec3 = std::array<double, 3>;

struct Placement {
    std::array<double, 3> translation = {0, 0, 0};
    std::array<double, 4> rotation = {0, 0, 0, 1};  // a unit quaternion, x y z w
    std::array<double, 3> scale = {1, 1, 1};
};

// Makes it a unit quaternion. False when it is too far from any to be one.
bool normalize(std::array<double, 4>& rotation);

// With the last row put right. Nothing when that is not 0 0 0 1 up to rounding, or when a number is
// infinite or none.
std::optional<Matrix> affine(const Matrix& m);

double determinant(const Matrix& m);  // of the 3x3 part

Vec3 transform_point(const Matrix& m, const Float3& p);
Vec3 transform_direction(const Matrix& m, const Float3& v);
// Of any length. Stays at right angles to what it is the normal of, on the same side of it.
Vec3 transform_normal(const Matrix& m, const Float3& n);

Matrix multiply(const Matrix& a, const Matrix& b);
Matrix matrix_of(const Placement& placement);

// Of unit length. Nothing when there is no direction in it.
std::optional<Vec3> direction(Vec3 v);

bool fits_floats(const Vec3& v);  // false also for what is infinite or not a number

// Nothing when a number is too large for a float.
std::optional<Mat4> to_float(const Matrix& m);

// The same place and direction without scale, shear and mirroring: -z and then y keep their
// directions as far as they can. Nothing when they have none.
std::optional<Matrix> rigid(const Matrix& m);

}  // namespace sheer::gltf
