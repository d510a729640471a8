// Wald. On fast Construction of SAH-based Bounding Volume Hierarchies. RT 2007.
#include "geometry/divide_triangles.h"

#include <algorithm>
#include <limits>

namespace sheer {

namespace {

double middle(const TriangleCorners& t, double Vec3d::*axis)
{
    return t[0].*axis + t[1].*axis + t[2].*axis;
}

constexpr std::size_t kBins = 16;

// Triangles are cut where those whose middle lies in the first bins end.
struct Cut {
    std::uint32_t axis = 0;
    std::size_t bins = 0;
    double cost = std::numeric_limits<double>::infinity();
};

// Of middles from `from` to `to`: which bin one is in.
struct Bins {
    double from, scale;

    Bins(double first, double last) : from(first), scale(kBins / (last - first)) {}
    std::size_t of(double at) const
    {
        const double bin = (at - from) * scale;
        return bin < kBins - 1 ? static_cast<std::size_t>(bin) : kBins - 1;
    }
};

void find_cut(const std::vector<TriangleCorners>& triangles, std::span<const std::uint32_t> numbers,
              std::uint32_t axis, const Bins& bins, Cut& best)
{
    std::array<Box, kBins> boxes;
    std::array<double, kBins> counts = {};
    for (const std::uint32_t i : numbers) {
        const std::size_t bin = bins.of(middle(triangles[i], kCoordinates[axis]));
        for (const Vec3d& p : triangles[i]) boxes[bin].add(p);
        counts[bin] += 1;
    }
    std::array<double, kBins> before = {};  // costs of all bins before
    Box box;
    double count = 0;
    for (std::size_t i = 0; i + 1 < kBins; ++i) {
        box.add(boxes[i]);
        count += counts[i];
        before[i + 1] = count > 0 ? count * box.area() : -1;
    }
    box = Box();
    count = 0;
    for (std::size_t i = kBins - 1; i > 0; --i) {
        box.add(boxes[i]);
        count += counts[i];
        if (!(count > 0) || before[i] < 0) continue;
        const double cost = before[i] + count * box.area();
        if (cost < best.cost) best = {axis, i, cost};
    }
}

}  // namespace

Box::Box()
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    low = {kInfinity, kInfinity, kInfinity};
    high = {-kInfinity, -kInfinity, -kInfinity};
}

void Box::add(const Vec3d& p)
{
    for (const auto axis : kCoordinates) {
        low.*axis = std::min(low.*axis, p.*axis);
        high.*axis = std::max(high.*axis, p.*axis);
    }
}

void Box::add(const Box& other)
{
    for (const auto axis : kCoordinates) {
        low.*axis = std::min(low.*axis, other.low.*axis);
        high.*axis = std::max(high.*axis, other.high.*axis);
    }
}

double Box::area() const
{
    const Vec3d side = high - low;
    return side.x * side.y + side.y * side.z + side.z * side.x;
}

Box box_of(const std::vector<TriangleCorners>& triangles, std::span<const std::uint32_t> numbers)
{
    Box box;
    for (const std::uint32_t i : numbers) {
        for (const Vec3d& p : triangles[i]) box.add(p);
    }
    return box;
}

std::size_t divide_triangles(const std::vector<TriangleCorners>& triangles,
                             std::span<std::uint32_t> numbers, int depth)
{
    Box middles;
    for (const std::uint32_t i : numbers) {
        const TriangleCorners& t = triangles[i];
        middles.add({middle(t, &Vec3d::x), middle(t, &Vec3d::y), middle(t, &Vec3d::z)});
    }
    const auto bins = [&](std::uint32_t a) {
        return Bins(middles.low.*kCoordinates[a], middles.high.*kCoordinates[a]);
    };
    const auto extent = [&](std::uint32_t a) {
        return middles.high.*kCoordinates[a] - middles.low.*kCoordinates[a];
    };
    Cut best;
    std::uint32_t longest = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        if (extent(axis) > extent(longest)) longest = axis;
        if (extent(axis) > 0 && depth < kMostCuts)
            find_cut(triangles, numbers, axis, bins(axis), best);
    }
    if (best.bins > 0) {
        const Bins of_axis = bins(best.axis);
        const auto is_before = [&](std::uint32_t i) {
            return of_axis.of(middle(triangles[i], kCoordinates[best.axis])) < best.bins;
        };
        const auto half = std::partition(numbers.begin(), numbers.end(), is_before);
        return static_cast<std::size_t>(half - numbers.begin());
    }
    const std::size_t half = numbers.size() / 2;
    // Ties by number, so that the halves are the same whatever the algorithm.
    std::nth_element(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(half),
                     numbers.end(), [&](std::uint32_t a, std::uint32_t b) {
                         const double at_a = middle(triangles[a], kCoordinates[longest]);
                         const double at_b = middle(triangles[b], kCoordinates[longest]);
                         return at_a < at_b || (at_a == at_b && a < b);
                     });
    return half;
}

}  // namespace sheer
