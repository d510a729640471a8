// Lofts and what is made of them: revolutions, prisms, tubes and boxes. All in double precision
// with the project's own sine and cosine, so that every compiler makes the same vertices.
#include "scene/builtin/shapes.h"

#include <algorithm>
#include <cmath>

#include "support/math.h"

namespace sheer::shapes {
namespace {

void add_cap(Solid& solid, const Ring& ring)
{
    Vec center;
    for (const Vec& point : ring) center = center + point;
    center = (1.0 / static_cast<double>(ring.size())) * center;
    for (std::size_t j = 0; j < ring.size(); ++j)
        solid.faces.push_back({{center, ring[j], ring[(j + 1) % ring.size()], center}});
}

void add_sections(Solid& solid, const std::vector<Ring>& rings)
{
    const std::size_t count = rings.size();
    const std::size_t last = rings[0].size() - 1;
    for (std::size_t i = 0; i + 1 < count / 2; ++i) {
        const std::size_t across = count - 1 - i;
        solid.faces.push_back(
            {{rings[i][0], rings[i + 1][0], rings[across - 1][0], rings[across][0]}});
        solid.faces.push_back(
            {{rings[across][last], rings[across - 1][last], rings[i + 1][last], rings[i][last]}});
    }
}

}  // namespace

Vec normalize(Vec v)
{
    const double length = std::sqrt(dot(v, v));
    return length > 0 ? (1 / length) * v : v;
}

Vec polar(double x, double r, double angle)
{
    return {x, r * own_cos(angle), r * own_sin(angle)};
}

Placement operator*(const Placement& outer, const Placement& inner)
{
    const auto turn = [&](Vec v) { return v.x * outer.x + v.y * outer.y + v.z * outer.z; };
    return {turn(inner.x), turn(inner.y), turn(inner.z), turn(inner.origin) + outer.origin};
}

Placement moved(double x, double y, double z)
{
    Placement placement;
    placement.origin = {x, y, z};
    return placement;
}

Placement turned_about_x(double angle)
{
    const double c = own_cos(angle), s = own_sin(angle);
    return {{1, 0, 0}, {0, c, s}, {0, -s, c}, {}};
}

Placement turned_about_z(double angle)
{
    const double c = own_cos(angle), s = own_sin(angle);
    return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}, {}};
}

Placement scaled(double s)
{
    return {{s, 0, 0}, {0, s, 0}, {0, 0, s}, {}};
}

Mat4 to_matrix(const Placement& placement)
{
    Mat4 matrix = kIdentity;
    const Vec columns[4] = {placement.x, placement.y, placement.z, placement.origin};
    for (std::size_t i = 0; i < 4; ++i) {
        matrix[4 * i] = static_cast<float>(columns[i].x);
        matrix[4 * i + 1] = static_cast<float>(columns[i].y);
        matrix[4 * i + 2] = static_cast<float>(columns[i].z);
    }
    return matrix;
}

void add_loft(Solid& solid, const Loft& loft)
{
    const std::vector<Ring>& rings = loft.rings;
    const std::size_t points = rings[0].size();
    const std::size_t steps = loft.looped ? rings.size() : rings.size() - 1;
    const std::size_t columns = loft.open ? points - 1 : points;
    for (std::size_t i = 0; i < steps; ++i) {
        const Ring& a = rings[i];
        const Ring& b = rings[(i + 1) % rings.size()];
        for (std::size_t j = 0; j < columns; ++j) {
            const std::size_t k = (j + 1) % points;
            solid.faces.push_back({{a[j], a[k], b[k], b[j]}});
        }
    }
    if (loft.open) add_sections(solid, rings);
    if (loft.looped) return;
    add_cap(solid, Ring(rings.front().rbegin(), rings.front().rend()));
    add_cap(solid, rings.back());
}

void add_lathe(Solid& solid, const Lathe& lathe)
{
    const bool open = lathe.to - lathe.from < 2 * kPi;
    const int points = lathe.segments + (open ? 1 : 0);
    Loft loft;
    for (const ProfilePoint& p : lathe.profile) {
        Ring ring;
        for (int j = 0; j < points; ++j)
            ring.push_back(
                polar(p.x, p.r, lathe.from + (lathe.to - lathe.from) * j / lathe.segments));
        loft.rings.push_back(std::move(ring));
    }
    loft.looped = lathe.closed;
    loft.open = open;
    add_loft(solid, loft);
}

void add_prism(Solid& solid, const Prism& prism)
{
    Loft loft;
    const auto add_ring = [&](const std::vector<OutlinePoint>& outline, int slice) {
        const double part = static_cast<double>(slice) / prism.slices;
        Ring ring;
        for (const OutlinePoint& p : outline)
            ring.push_back(polar(prism.from + part * (prism.to - prism.from), p.r,
                                 p.angle + part * prism.twist));
        loft.rings.push_back(std::move(ring));
    };
    for (int i = 0; i <= prism.slices; ++i) add_ring(prism.outer, i);
    for (int i = prism.slices; i >= 0; --i) add_ring(prism.inner, i);
    loft.looped = true;
    loft.open = prism.open;
    add_loft(solid, loft);
}

std::vector<OutlinePoint> at_radius(std::vector<OutlinePoint> outline, double r)
{
    for (OutlinePoint& point : outline) point.r = r;
    return outline;
}

void add_tube(Solid& solid, const Tube& tube)
{
    const std::size_t count = tube.points.size();
    Loft loft;
    loft.looped = tube.looped;
    for (std::size_t i = 0; i < count; ++i) {
        const bool first = i == 0 && !tube.looped, last = i + 1 == count && !tube.looped;
        const Vec before = tube.points[first ? 0 : (i + count - 1) % count];
        const Vec after = tube.points[last ? i : (i + 1) % count];
        const Vec tangent = normalize(after - before);
        const Vec v = normalize(cross(tangent, tube.sides[std::min(i, tube.sides.size() - 1)]));
        const Vec u = cross(v, tangent);
        Ring ring;
        for (int j = 0; j < tube.segments; ++j) {
            const double angle = 2 * kPi * j / tube.segments;
            ring.push_back(tube.points[i] + tube.radius * own_cos(angle) * u +
                           tube.radius * own_sin(angle) * v);
        }
        loft.rings.push_back(std::move(ring));
    }
    add_loft(solid, loft);
}

void add_box(Solid& solid, Vec low, Vec high, double bevel)
{
    // An octagon in y and z at each height of x; `inset` shrinks it for the edges at the ends.
    const auto ring = [&](double x, double inset) {
        const double y0 = low.y + inset, y1 = high.y - inset;
        const double z0 = low.z + inset, z1 = high.z - inset;
        const double b = bevel;
        return Ring{{x, y1, z0 + b}, {x, y1, z1 - b}, {x, y1 - b, z1}, {x, y0 + b, z1},
                    {x, y0, z1 - b}, {x, y0, z0 + b}, {x, y0 + b, z0}, {x, y1 - b, z0}};
    };
    add_loft(solid, {{ring(low.x, bevel), ring(low.x + bevel, 0), ring(high.x - bevel, 0),
                      ring(high.x, bevel)},
                     false,
                     false});
}

void add_plate(Solid& solid, const std::vector<ProfilePoint>& outline, double half_thickness)
{
    Loft loft;
    for (int side = -1; side <= 1; side += 2) {
        Ring ring;
        for (const ProfilePoint& p : outline) ring.push_back({p.x, p.r, side * half_thickness});
        loft.rings.push_back(std::move(ring));
    }
    add_loft(solid, loft);
}

void add_placed(Solid& solid, const Solid& part, const Placement& placement)
{
    for (const Face& face : part.faces) {
        Face placed;
        for (int i = 0; i < 4; ++i) {
            const Vec c = face.corner[i];
            placed.corner[i] =
                c.x * placement.x + c.y * placement.y + c.z * placement.z + placement.origin;
        }
        solid.faces.push_back(placed);
    }
}

}  // namespace sheer::shapes
