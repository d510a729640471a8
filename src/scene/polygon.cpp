#include "scene/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sheer {

namespace {

// Whether the way from a by b to c goes back along itself, exactly. Such spikes have no area, and
// two triangles on top of one another would be drawn for it.
bool is_spike(const Float3& a, const Float3& b, const Float3& c)
{
    std::array<double, 3> to, back;
    double along = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        to[k] = static_cast<double>(b[k]) - a[k];
        back[k] = static_cast<double>(c[k]) - b[k];
        along += to[k] * back[k];
    }
    return along < 0 && to[0] * back[1] == to[1] * back[0] && to[1] * back[2] == to[2] * back[1] &&
           to[2] * back[0] == to[0] * back[2];
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

void add_fan(std::vector<std::uint32_t>& indices, std::span<const std::uint32_t> polygon,
             std::size_t first)
{
    const std::size_t n = polygon.size();
    for (std::size_t i = 2; i < n; ++i) {
        indices.insert(indices.end(),
                       {polygon[first], polygon[(first + i - 1) % n], polygon[(first + i) % n]});
    }
}

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

double PolygonCutter::turn_at(std::size_t corner) const
{
    const std::size_t n = points_.size();
    return turn((corner + n - 1) % n, corner, (corner + 1) % n);
}

bool PolygonCutter::is_strictly_convex() const
{
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (!(turn_at(i) > 0)) return false;
    }
    return true;
}

// Of a fan in which every triangle has area, so that each corner is a corner of the triangles
// beside it: both its neighbours must turn. Nothing where the polygon is not convex, or where
// there is none, as in a triangle with two more corners on each side.
std::optional<std::size_t> PolygonCutter::fan_corner() const
{
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (turn_at(i) < 0) return std::nullopt;
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (turn_at((i + n - 1) % n) > 0 && turn_at((i + 1) % n) > 0) return i;
    }
    return std::nullopt;
}

// The corners but those in the place of the one before, and spikes' tips.
void PolygonCutter::keep_telling_corners(std::span<const std::uint32_t> polygon,
                                         std::span<const Float3> corners)
{
    std::vector<Float3>& kept = corners_;
    kept.clear();
    polygon_.clear();
    const auto drop_last = [this] {
        corners_.pop_back();
        polygon_.pop_back();
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        while (kept.size() >= 2 && is_spike(kept[kept.size() - 2], kept.back(), corners[i])) {
            drop_last();
        }
        if (!kept.empty() && kept.back() == corners[i]) continue;
        kept.push_back(corners[i]);
        polygon_.push_back(polygon[i]);
    }
    // Where the last meets the first.
    std::size_t first = 0;
    while (kept.size() >= first + 2) {
        const std::size_t last = kept.size() - 1;
        if (kept[last] == kept[first] || is_spike(kept[last - 1], kept[last], kept[first])) {
            drop_last();
        } else if (is_spike(kept[last], kept[first], kept[first + 1])) {
            ++first;
        } else {
            break;
        }
    }
    kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first));
    polygon_.erase(polygon_.begin(), polygon_.begin() + static_cast<std::ptrdiff_t>(first));
}

// Whether the triangle of a corner and its neighbours has area, and none of the others in it.
bool PolygonCutter::is_ear(std::size_t corner)
{
    const std::size_t a = before_[corner], c = after_[corner];
    ++work_;
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
    while (left > 3 && work_ < most_work_) {
        if (looked_at < left && !is_ear(corner)) {
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
    if (left > 3) ++uncut_;
    for (const std::size_t first = before_[corner]; left > 2; --left, corner = after_[corner]) {
        indices.insert(indices.end(), {polygon[first], polygon[corner], polygon[after_[corner]]});
    }
}

void PolygonCutter::add(std::vector<std::uint32_t>& indices, std::span<const std::uint32_t> polygon,
                        std::span<const Float3> corners)
{
    if (polygon.size() <= 3) return add_fan(indices, polygon);
    flatten(corners);
    if (is_strictly_convex()) return add_fan(indices, polygon);
    keep_telling_corners(polygon, corners);
    if (corners_.size() < corners.size()) flatten(corners_);
    if (polygon_.size() <= 3) return add_fan(indices, polygon_);
    if (const auto first = fan_corner()) return add_fan(indices, polygon_, *first);
    if (work_ >= most_work_) {
        ++uncut_;
        return add_fan(indices, polygon_);
    }
    cut_ears(indices, polygon_);
}

}  // namespace sheer
