// Polygons cut into triangles: the same area, once. What is asked is what a triangulation is, not
// how it is found.
#include "scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace sheer::test {
namespace {

using Indices = std::vector<std::uint32_t>;

std::array<double, 3> area_vector(const Float3& a, const Float3& b, const Float3& c)
{
    std::array<double, 3> u, v;
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] = static_cast<double>(b[k]) - a[k];
        v[k] = static_cast<double>(c[k]) - a[k];
    }
    return {(u[1] * v[2] - u[2] * v[1]) / 2, (u[2] * v[0] - u[0] * v[2]) / 2,
            (u[0] * v[1] - u[1] * v[0]) / 2};
}

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Triangles around any point add up to the polygon's area, with signs.
std::array<double, 3> area_of(const std::vector<Float3>& corners)
{
    std::array<double, 3> sum = {0, 0, 0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto part = area_vector({0, 0, 0}, corners[i], corners[(i + 1) % corners.size()]);
        for (std::size_t k = 0; k < 3; ++k) sum[k] += part[k];
    }
    return sum;
}

Indices cut(const std::vector<Float3>& corners)
{
    Indices polygon(corners.size()), indices;
    std::iota(polygon.begin(), polygon.end(), 100u);  // any names
    PolygonCutter().add(indices, polygon, corners);
    for (std::uint32_t& index : indices) index -= 100;
    return indices;
}

// n - 2 triangles, none turned over, whose areas add up to the polygon's: then none overlaps.
void expect_cut(const std::vector<Float3>& corners)
{
    const Indices indices = cut(corners);
    ASSERT_EQ(indices.size(), 3 * (corners.size() - 2));
    const auto whole = area_of(corners);
    const double area = std::sqrt(dot(whole, whole));
    double sum = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const double part = dot(whole, area_vector(corners[indices[i]], corners[indices[i + 1]],
                                                   corners[indices[i + 2]])) /
                            area;
        EXPECT_GE(part, -1e-6 * area) << "triangle " << i / 3;
        sum += std::abs(part);
    }
    // Corners are floats: of a tilted plane they are beside it by 6e-8 of their distance.
    EXPECT_NEAR(sum, area, 1e-5 * area);
}

void expect_cut_from_every_corner_and_side(std::vector<Float3> corners)
{
    for (std::size_t start = 0; start < corners.size(); ++start) {
        expect_cut(corners);
        expect_cut({corners.rbegin(), corners.rend()});
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
}

TEST(Polygon, ConvexOnesAreFans)
{
    EXPECT_EQ(cut({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}}),
              (Indices{0, 1, 2, 0, 2, 3, 0, 3, 4}));
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Indices{0, 1, 2}));
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}}), Indices{});
    EXPECT_EQ(cut({}), Indices{});
}

TEST(Polygon, NotchesStayOpen)
{
    expect_cut_from_every_corner_and_side({{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}});
    expect_cut_from_every_corner_and_side(
        {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
    // In planes across each axis and askew.
    expect_cut_from_every_corner_and_side({{5, 0, 0}, {5, 2, 1}, {5, 0, 2}, {5, 1, 1}});
    expect_cut_from_every_corner_and_side({{0, 5, 0}, {2, 5, 1}, {0, 5, 2}, {1, 5, 1}});
    expect_cut_from_every_corner_and_side({{0, 0, 0}, {2, 1, 3}, {0, 2, 2}, {1, 1, 2}});
    // A comb, whose teeth hide one another's ears.
    std::vector<Float3> comb = {{0, -1, 0}, {40, -1, 0}};
    for (int i = 40; i >= 0; --i) comb.push_back({static_cast<float>(i), i % 2 ? 0.f : 9.f, 0});
    expect_cut_from_every_corner_and_side(comb);
}

TEST(Polygon, AHoleOnABridgeStaysOpen)
{
    // Two corners are in one place, twice; those of the hole turn the other way.
    expect_cut_from_every_corner_and_side({{0, 0, 0},
                                           {4, 0, 0},
                                           {4, 4, 0},
                                           {0, 4, 0},
                                           {0, 0, 0},
                                           {1, 1, 0},
                                           {1, 3, 0},
                                           {3, 3, 0},
                                           {3, 1, 0},
                                           {1, 1, 0}});
}

TEST(Polygon, RandomStarsInRandomPlanes)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0, 1);
    for (int trial = 0; trial < 300; ++trial) {
        const int n = 4 + trial % 60;
        std::array<double, 6> axes;
        for (double& x : axes) x = 2 * part(random) - 1;
        std::vector<Float3> corners;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * (i + 0.8 * part(random)) / n;
            const double radius = 0.2 + part(random);
            const double x = radius * std::cos(angle), y = radius * std::sin(angle);
            corners.push_back({static_cast<float>(axes[0] * x + axes[3] * y),
                               static_cast<float>(axes[1] * x + axes[4] * y),
                               static_cast<float>(axes[2] * x + axes[5] * y)});
        }
        expect_cut(corners);
    }
}

TEST(Polygon, WhateverComesIsCut)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> any(-1, 1);
    for (int n = 3; n < 200; n += 1 + n / 20) {
        std::vector<Float3> corners;
        for (int i = 0; i < n; ++i) {
            // Crossing itself, with corners in one place and on lines.
            corners.push_back({std::round(4 * any(random)), std::round(4 * any(random)), 0});
        }
        EXPECT_LE(cut(corners).size(), 3 * (corners.size() - 2));
        for (Float3& corner : corners) corner = {1, 1, 1};
        EXPECT_LE(cut(corners).size(), n == 3 ? 3u : 0u);
        // No two in one place and none on a line: none is left out.
        for (int i = 0; i < n; ++i) {
            corners[static_cast<std::size_t>(i)] = {any(random), any(random), 0};
        }
        EXPECT_EQ(cut(corners).size(), 3 * (corners.size() - 2));
    }
}

double area_of_triangles(const std::vector<Float3>& corners, const Indices& indices)
{
    double sum = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const auto part =
            area_vector(corners[indices[i]], corners[indices[i + 1]], corners[indices[i + 2]]);
        sum += std::sqrt(dot(part, part));
    }
    return sum;
}

TEST(Polygon, CornersGivenTwiceChangeNothing)
{
    // An arrow with a notch, and a square: areas 2 and 4.
    const std::vector<Float3> arrow = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
    const std::vector<Float3> square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    for (const auto& polygon : {arrow, square}) {
        for (std::size_t twice = 0; twice < polygon.size(); ++twice) {
            std::vector<Float3> corners = polygon;
            corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(twice), 2, polygon[twice]);
            const auto whole = area_of(polygon);
            const double area = std::sqrt(dot(whole, whole));
            for (std::size_t start = 0; start < corners.size(); ++start) {
                const Indices indices = cut(corners);
                EXPECT_EQ(indices.size(), 6u);
                EXPECT_NEAR(area_of_triangles(corners, indices), area, 1e-12);
                std::rotate(corners.begin(), corners.begin() + 1, corners.end());
            }
        }
    }
}

TEST(Polygon, SpikesWithoutAreaAreNotDrawn)
{
    // Inwards and out again, to where it began and to less.
    std::vector<Float3> to_it = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    std::vector<Float3> to_less = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0},
                                   {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    for (std::size_t start = 0; start < to_it.size(); ++start) {
        EXPECT_NEAR(area_of_triangles(to_it, cut(to_it)), 4, 1e-12);
        std::rotate(to_it.begin(), to_it.begin() + 1, to_it.end());
    }
    for (std::size_t start = 0; start < to_less.size(); ++start) {
        EXPECT_NEAR(area_of_triangles(to_less, cut(to_less)), 4.5, 1e-12);
        std::rotate(to_less.begin(), to_less.begin() + 1, to_less.end());
    }
}

// Neighbours along an edge have its corners: no triangle may leave one inside of its own edge.
TEST(Polygon, CornersOnALineAreCornersOfTriangles)
{
    // Side by side: one, two and no more corners on the sides of a square, and of a triangle.
    std::vector<std::vector<Float3>> all = {
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}},
        {{0, 0, 0},
         {1, 0, 0},
         {2, 0, 0},
         {3, 0, 0},
         {2, 1, 0},
         {1, 2, 0},
         {0, 3, 0},
         {0, 2, 0},
         {0, 1, 0}}};
    for (std::vector<Float3>& corners : all) {
        for (std::size_t start = 0; start < corners.size(); ++start) {
            const Indices indices = cut(corners);
            ASSERT_EQ(indices.size(), 3 * (corners.size() - 2));
            for (std::size_t i = 0; i < indices.size(); i += 3) {
                const auto part = area_vector(corners[indices[i]], corners[indices[i + 1]],
                                              corners[indices[i + 2]]);
                EXPECT_GT(part[2], 0);
            }
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        }
    }
}

TEST(Polygon, WorkHasABound)
{
    // A spiral of saws: each look for an ear costs all that turn the other way.
    constexpr int kCorners = 3000;
    std::vector<Float3> corners;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners, radius = i % 2 ? 1 : 0.999;
        corners.push_back({static_cast<float>(radius * std::cos(angle)),
                           static_cast<float>(radius * std::sin(angle)), 0});
    }
    Indices polygon(kCorners), indices;
    std::iota(polygon.begin(), polygon.end(), 0u);
    PolygonCutter cutter(5'000'000);
    for (int i = 0; i < 20; ++i) cutter.add(indices, polygon, corners);
    EXPECT_GT(cutter.uncut(), 0u);
    EXPECT_EQ(indices.size(), 20u * 3 * (kCorners - 2));
}

// Half of a ring's corners turn the other way: cut one by one without the bound, 10^10 tests.
TEST(Polygon, BeyondTheBoundNothingIsLookedAt)
{
    constexpr int kCorners = 100000;
    std::vector<Float3> corners;
    for (int i = 0; i < kCorners; ++i) {
        const int k = i < kCorners / 2 ? i : kCorners - 1 - i;
        const double angle = 3.0 * k / kCorners, radius = i < kCorners / 2 ? 1 : 0.5;
        corners.push_back({static_cast<float>(1000 * radius * std::cos(angle)),
                           static_cast<float>(1000 * radius * std::sin(angle)), 0});
    }
    Indices polygon(kCorners), indices;
    std::iota(polygon.begin(), polygon.end(), 0u);
    PolygonCutter cutter(1'000'000);
    cutter.add(indices, polygon, corners);
    EXPECT_EQ(cutter.uncut(), 1u);
    EXPECT_EQ(indices.size(), 3u * (kCorners - 2));
}

}  // namespace
}  // namespace sheer::test
