// Polygons cut into triangles, for files whose faces have any number of corners.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <sheer/scene.h>

namespace sheer {

// Of PolygonCutter::uncut, for Scene::ignored.
inline constexpr const char* kUncutPolygons = "polygons with notches that are too much work to cut";
inline constexpr const char* kUncutBecause = "drawn as fans";

// Triangles around one of a polygon's corners, given by its place in it.
void add_fan(std::vector<std::uint32_t>& indices, std::span<const std::uint32_t> polygon,
             std::size_t first = 0);

// Cuts one polygon after the other. Corners in the place of the one before, and those to which an
// edge goes and comes back from, are left out. Convex ones become a fan, around their first corner
// unless that leaves a corner inside of another triangle's edge. Others lose
// an ear at a time (Meisters. Polygons Have Ears. The American Mathematical Monthly 82(6), 1975),
// seen along the normal of their area; where none is left, as in polygons that cross themselves,
// the next corner is cut off all the same. n corners that are left give n - 2 triangles, which
// turn as the polygon does.
class PolygonCutter {
public:
    // Tests of a corner against an ear, of all polygons of a file: two seconds or so.
    static constexpr std::uint64_t kMostWork = 500'000'000;

    explicit PolygonCutter(std::uint64_t most_work = kMostWork) : most_work_(most_work) {}

    // Adds the triangles of a polygon of vertices; corners: where these are, as many.
    void add(std::vector<std::uint32_t>& indices, std::span<const std::uint32_t> polygon,
             std::span<const Float3> corners);

    // Polygons that were not convex and were not cut at their ears, since all the work that a file
    // gets was done: it grows with the square of a polygon's corners.
    std::size_t uncut() const { return uncut_; }

private:
    struct Point {
        double x, y;
    };
    // Twice the area of the triangle, positive if it turns as the polygon does.
    double turn(std::size_t a, std::size_t b, std::size_t c) const;
    double turn_at(std::size_t corner) const;  // with its neighbours
    void flatten(std::span<const Float3> corners);
    bool is_strictly_convex() const;
    std::optional<std::size_t> fan_corner() const;
    void keep_telling_corners(std::span<const std::uint32_t> polygon,
                              std::span<const Float3> corners);
    bool is_ear(std::size_t corner);
    void cut_ears(std::vector<std::uint32_t>& indices, std::span<const std::uint32_t> polygon);

    std::vector<Point> points_;
    std::vector<std::uint32_t> polygon_;       // what is left of the polygon
    std::vector<Float3> corners_;              // and where that is
    std::vector<std::size_t> before_, after_;  // of a corner, among those that are left
    std::vector<std::size_t> reflex_;          // corners that may lie in an ear
    std::uint64_t most_work_, work_ = 0;
    std::size_t uncut_ = 0;
};

}  // namespace sheer
