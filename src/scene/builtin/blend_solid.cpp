// The surface is found by surface nets (Gibson. Constrained Elastic Surface Nets. MICCAI 1998): one
// vertex in each cell that the surface crosses, one quad across each edge that it crosses.
#include "scene/builtin/blend_solid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/builtin/stage.h"

namespace sheer {
namespace {

using shapes::Vec;

struct Grid {
    Vec low;
    double cell;
    int nx, ny, nz;  // points

    std::size_t index(int i, int j, int k) const
    {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(ny) +
                static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(nx) +
               static_cast<std::size_t>(i);
    }
    Vec point(double i, double j, double k) const { return low + cell * Vec{i, j, k}; }
};

Grid grid_around(const BlendSolid& solid, double cell)
{
    Vec low = {1e30, 1e30, 1e30}, high = {-1e30, -1e30, -1e30};
    for (const Limb& limb : solid.limbs) {
        for (const auto& [p, r] :
             {std::pair{limb.from, limb.from_radius}, std::pair{limb.to, limb.to_radius}}) {
            const double reach = r + solid.blend + 3 * cell;
            low = {std::min(low.x, p.x - reach), std::min(low.y, p.y - reach),
                   std::min(low.z, p.z - reach)};
            high = {std::max(high.x, p.x + reach), std::max(high.y, p.y + reach),
                    std::max(high.z, p.z + reach)};
        }
    }
    const auto count = [&](double from, double to) {
        return static_cast<int>(std::ceil((to - from) / cell)) + 1;
    };
    const Grid grid = {low, cell, count(low.x, high.x), count(low.y, high.y), count(low.z, high.z)};
    if (static_cast<double>(grid.nx) * grid.ny * grid.nz > 1 << 26)
        throw std::length_error("blend solid: too many cells");
    return grid;
}

struct Net {
    const BlendSolid& solid;
    Grid grid;
    std::vector<double> distances;
    std::vector<std::uint32_t> vertex;  // of each cell
    Mesh mesh;

    void place_vertex(int i, int j, int k)
    {
        Vec sum;
        int crossings = 0, inside = 0;
        const auto value = [&](int corner) {
            return distances[grid.index(i + (corner & 1), j + (corner >> 1 & 1),
                                        k + (corner >> 2))];
        };
        for (int corner = 0; corner < 8; ++corner) {
            inside += value(corner) < 0 ? 1 : 0;
            for (int axis = 0; axis < 3; ++axis) {
                const int other = corner | 1 << axis;
                const double a = value(corner), b = value(other);
                if (other == corner || (a < 0) == (b < 0)) continue;
                const double t = a / (a - b);
                sum = sum + Vec{(corner & 1) + (axis == 0 ? t : 0),
                                (corner >> 1 & 1) + (axis == 1 ? t : 0),
                                (corner >> 2) + (axis == 2 ? t : 0)};
                ++crossings;
            }
        }
        if (inside == 0 || inside == 8) return;
        const Vec off = 1.0 / crossings * sum;
        Vec p = grid.point(i + off.x, j + off.y, k + off.z);
        const Vec normal = solid.normal(p);
        p = p - solid.distance(p) * normal;
        vertex[grid.index(i, j, k)] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(to_float(p));
        mesh.normals.push_back(to_float(solid.normal(p)));
    }

    // The quad of the four cells around the edge from point (i, j, k) along an axis.
    void place_quad(int i, int j, int k, int axis)
    {
        const bool x = axis == 0, y = axis == 1;
        const double a = distances[grid.index(i, j, k)];
        const double b =
            distances[grid.index(i + (x ? 1 : 0), j + (y ? 1 : 0), k + (axis == 2 ? 1 : 0))];
        if ((a < 0) == (b < 0)) return;
        // The two other axes, in turn, so that the quad turns about the edge.
        const int u[3] = {axis == 2 ? 1 : 0, axis == 0 ? 1 : 0, axis == 1 ? 1 : 0};
        const int v[3] = {axis == 1 ? 1 : 0, axis == 2 ? 1 : 0, axis == 0 ? 1 : 0};
        const auto at = [&](int du, int dv) {
            return vertex[grid.index(i - du * u[0] - dv * v[0], j - du * u[1] - dv * v[1],
                                     k - du * u[2] - dv * v[2])];
        };
        std::uint32_t quad[4] = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
        if (a >= 0) std::swap(quad[1], quad[3]);
        // Of the two diagonals the shorter: slivers come of the other.
        const auto length = [&](std::uint32_t p, std::uint32_t q) {
            double squared = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double off = mesh.positions[p][c] - mesh.positions[q][c];
                squared += off * off;
            }
            return squared;
        };
        const bool first = length(quad[0], quad[2]) <= length(quad[1], quad[3]);
        const std::uint32_t corners[] = {0, 1, first ? 2u : 3u, first ? 0u : 1u, 2, 3};
        for (std::size_t t = 0; t < 6; t += 3) {
            const std::uint32_t p = quad[corners[t]], q = quad[corners[t + 1]];
            const std::uint32_t r = quad[corners[t + 2]];
            // Where the surface goes through a point of the grid, cells' vertices coincide.
            if (length(p, q) == 0 || length(q, r) == 0 || length(r, p) == 0) continue;
            mesh.indices.insert(mesh.indices.end(), {p, q, r});
        }
    }
};

}  // namespace

double distance_to(const Limb& limb, Vec p)
{
    const Vec along = limb.to - limb.from;
    const double length_squared = dot(along, along);
    const double t =
        length_squared > 0 ? clamp_unit(dot(p - limb.from, along) / length_squared) : 0;
    const Vec off = p - (limb.from + t * along);
    return std::sqrt(dot(off, off)) - mix(limb.from_radius, limb.to_radius, t);
}

double BlendSolid::distance(Vec p) const
{
    double nearest = 1e30;
    for (const Limb& limb : limbs) {
        const double d = distance_to(limb, p);
        // Inigo Quilez's polynomial smooth minimum.
        const double h = std::max(blend - std::abs(d - nearest), 0.0) / blend;
        nearest = std::min(d, nearest) - 0.25 * h * h * blend;
    }
    return roughness ? nearest + roughness(p) : nearest;
}

Vec BlendSolid::normal(Vec p) const
{
    constexpr double kStep = 1e-4;
    const auto slope = [&](Vec step) { return distance(p + step) - distance(p - step); };
    return shapes::normalize({slope({kStep, 0, 0}), slope({0, kStep, 0}), slope({0, 0, kStep})});
}

Mesh to_mesh(const BlendSolid& solid, const std::string& name, double cell)
{
    Net net{solid, grid_around(solid, cell), {}, {}, {}};
    const Grid& grid = net.grid;
    net.mesh.name = name;
    for (int k = 0; k < grid.nz; ++k)
        for (int j = 0; j < grid.ny; ++j)
            for (int i = 0; i < grid.nx; ++i)
                net.distances.push_back(solid.distance(grid.point(i, j, k)));
    net.vertex.resize(net.distances.size());
    for (int k = 0; k + 1 < grid.nz; ++k)
        for (int j = 0; j + 1 < grid.ny; ++j)
            for (int i = 0; i + 1 < grid.nx; ++i) net.place_vertex(i, j, k);
    for (int k = 1; k + 1 < grid.nz; ++k)
        for (int j = 1; j + 1 < grid.ny; ++j)
            for (int i = 1; i + 1 < grid.nx; ++i)
                for (int axis = 0; axis < 3; ++axis) net.place_quad(i, j, k, axis);
    return std::move(net.mesh);
}

}  // namespace sheer
