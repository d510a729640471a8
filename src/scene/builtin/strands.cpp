#include "scene/builtin/strands.h"

#include <algorithm>
#include <cmath>

#include "scene/builtin/noise.h"
#include "scene/builtin/particles.h"
#include "scene/builtin/stage.h"

namespace sheer {
namespace {

using shapes::Vec;

Vec to_vec(const Float3& p)
{
    return {p[0], p[1], p[2]};
}

}  // namespace

void add_strand(Mesh& mesh, const Strand& strand)
{
    const double step = strand.length / strand.segments;
    Vec p = strand.root;
    for (int i = 0; i <= strand.segments; ++i) {
        const double t = static_cast<double>(i) / strand.segments;
        Vec way = strand.direction + t * strand.pull;
        // Neighbours turn alike: locks form.
        if (strand.curl > 0) way = way + (strand.curl * t) * swirl(14.0 * p, 2);
        way = shapes::normalize(way);
        const Vec normal = strand.normal - dot(strand.normal, way) * way;
        const Paint paint = {mix(strand.root_paint.color, strand.tip_paint.color, t),
                             mix(strand.root_paint.alpha, strand.tip_paint.alpha, t)};
        mesh.positions.push_back(to_float(p));
        mesh.normals.push_back(to_float(shapes::normalize(normal + 0.05 * strand.normal)));
        mesh.colors.push_back(to_float(paint.color, paint.alpha));
        const auto at = static_cast<std::uint32_t>(mesh.positions.size() - 1);
        if (i < strand.segments) mesh.indices.insert(mesh.indices.end(), {at, at + 1});
        p = p + step * way;
    }
}

SurfacePoints::SurfacePoints(const Mesh& mesh) : mesh_(mesh)
{
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec a = to_vec(mesh.positions[mesh.indices[i]]);
        const Vec b = to_vec(mesh.positions[mesh.indices[i + 1]]);
        const Vec c = to_vec(mesh.positions[mesh.indices[i + 2]]);
        const Vec area = cross(b - a, c - a);
        sum += 0.5 * std::sqrt(dot(area, area));
        area_up_to_.push_back(sum);
    }
}

SurfacePoints::Point SurfacePoints::point(std::uint64_t i, std::uint64_t n, Draws& draws) const
{
    const double area =
        (static_cast<double>(i) + 0.5) / static_cast<double>(n) * area_up_to_.back();
    const auto found = std::lower_bound(area_up_to_.begin(), area_up_to_.end(), area);
    const auto triangle = static_cast<std::size_t>(found - area_up_to_.begin());
    // Even over a triangle: a square's points beyond the diagonal are folded back.
    double u = draws.unit(), v = draws.unit();
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const auto between = [&](const std::vector<Float3>& values) {
        const Vec a = to_vec(values[mesh_.indices[3 * triangle]]);
        const Vec b = to_vec(values[mesh_.indices[3 * triangle + 1]]);
        const Vec c = to_vec(values[mesh_.indices[3 * triangle + 2]]);
        return a + u * (b - a) + v * (c - a);
    };
    return {between(mesh_.positions), shapes::normalize(between(mesh_.normals))};
}

}  // namespace sheer
