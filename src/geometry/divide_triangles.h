// Where a set of triangles is divided, so that rays are likely to meet few of them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "support/vec3.h"

namespace sheer {

inline constexpr double Vec3d::*kCoordinates[3] = {&Vec3d::x, &Vec3d::y, &Vec3d::z};

using TriangleCorners = std::array<Vec3d, 3>;

// Empty at first: its sides are infinite, the low ones above the high ones.
struct Box {
    Vec3d low, high;

    Box();
    void add(const Vec3d& p);
    void add(const Box& other);
    // Half of its surface, to which the rays that meet it are proportional.
    double area() const;
};

Box box_of(const std::vector<TriangleCorners>& triangles, std::span<const std::uint32_t> numbers);

// Divides by cost while sets come from fewer divisions than this; else by halves.
constexpr int kMostCuts = 32;

// Rearranges the numbers of two triangles or more; how many of them are the first part. `depth`:
// the divisions that the set comes from.
std::size_t divide_triangles(const std::vector<TriangleCorners>& triangles,
                             std::span<std::uint32_t> numbers, int depth);

}  // namespace sheer
