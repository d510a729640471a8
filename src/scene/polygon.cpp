#include "scene/polygon.h"

#include <array>
#include <cmath>
#include <utility>

namespace sheer {

namespace {

// Tests of a corner against an ear, of all polygons of a file: two seconds or so.
constexpr std::uint64_t kMostWork = 500'000'000;

void add_fan(std::vector<std::uint32_t>& indices, std::span<const std::uint32_t> polygon)
{
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        indices.insert(indices.end(), {polygon[0], polygon[i - 1], polygon[i]});
    }
}

// Newell's, twice the polygon's area long: right also where corners lie on a line, or not quite in
// one plane.
std::array<double, 3> normal_of(std::span<const Float3> corners)
{
    std::array<double, 3> normal = {0, 0, 0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Float3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
            normal[k] += (static_cast<double>(a[u]) - b[u]) * (static_cast<double>(a[v]) + b[v]);
        }
    }
    return normal;
}

}  // namespace

// Along the axis on which the most of the area is seen.
void PolygonCutter::flatten(std::span<const Float3> corners)
{
    const std::array<double, 3> normal = normal_of(corners);
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
    }
    std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(u, v);
    points_.clear();
    for (const Float3& p : corners) points_.push_back({p[u], p[v]});
}

double PolygonCutter::turn(std::size_t a, std::size_t b, std::size_t c) const
{
    const Point &p = points_[a], &q = points_[b], &r = points_[c];
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

bool PolygonCutter::is_convex() const
{
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (turn(i, (i + 1) % n, (i + 2) % n) < 0) return false;
    }
    return true;
}

// Whether the triangle of a corner and its neighbours has area, and none of the others in it.
bool PolygonCutter::is_ear(std::size_t corner)
{
    const std::size_t a = before_[corner], c = after_[corner];
    if (!(turn(a, corner, c) > 0)) return false;
    const auto same_place = [this](std::size_t i, std::size_t k) {
        return points_[i].x == points_[k].x && points_[i].y == points_[k].y;
    };
    work_ += reflex_.size();
    for (const std::size_t i : reflex_) {
        if (i == a || i == corner || i == c) continue;
        // Where a bridge leads to a hole, two corners are in one place.
        if (same_place(i, a) || same_place(i, corner) || same_place(i, c)) continue;
        if (turn(a, corner, i) >= 0 && turn(corner, c, i) >= 0 && turn(c, a, i) >= 0) return false;
    }
    return true;
}

void PolygonCutter::cut_ears(std::vector<std::uint32_t>& indices,
                             std::span<const std::uint32_t> polygon)
{
    const std::size_t n = points_.size();
    before_.resize(n);
    after_.resize(n);
    reflex_.clear();
    for (std::size_t i = 0; i < n; ++i) {
        before_[i] = (i + n - 1) % n;
        after_[i] = (i + 1) % n;
        if (!(turn(before_[i], i, after_[i]) > 0)) reflex_.push_back(i);
    }
    std::size_t left = n, corner = 1, looked_at = 0;
    while (left > 3) {
        if (looked_at < left && work_ < kMostWork && !is_ear(corner)) {
            corner = after_[corner];
            ++looked_at;
            continue;
        }
        const std::size_t a = before_[corner], c = after_[corner];
        indices.insert(indices.end(), {polygon[a], polygon[corner], polygon[c]});
        after_[a] = c;
        before_[c] = a;
        std::erase_if(reflex_, [&](std::size_t i) {
            return i == corner || ((i == a || i == c) && turn(before_[i], i, after_[i]) > 0);
        });
        work_ += reflex_.size();
        --left;
        looked_at = 0;
        // Not the neighbour at once: triangles get wider.
        corner = after_[c];
    }
    indices.insert(indices.end(),
                   {polygon[before_[corner]], polygon[corner], polygon[after_[corner]]});
    if (work_ >= kMostWork) ++uncut_;
}

void PolygonCutter::add(std::vector<std::uint32_t>& indices, std::span<const std::uint32_t> polygon,
                        std::span<const Float3> corners)
{
    if (polygon.size() <= 3) return add_fan(indices, polygon);
    flatten(corners);
    if (is_convex()) return add_fan(indices, polygon);
    if (work_ >= kMostWork) {
        ++uncut_;
        return add_fan(indices, polygon);
    }
    cut_ears(indices, polygon);
}

}  // namespace sheer
