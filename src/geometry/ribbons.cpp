// Ribbons: at each vertex the line is widened at right angles to itself and to the line of sight.
#include "geometry/ribbons.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/vec3.h"

namespace sheer {

namespace {

// A mitre is at most this much longer than the ribbon is wide.
constexpr double kMostMitre = 2;

// One mesh on its way.
class Widener {
public:
    Widener(const Mesh& source, const Mat4& to_world, const RibbonView& view)
        : source_(source), to_world_(to_world), view_(view)
    {
        made_.name = source.name;
        made_.material = source.material;
        for (std::size_t c = 0; c < 3; ++c) {
            scale_ = std::max(scale_, std::sqrt(dot(column(c), column(c))));
        }
    }

    Vec3d place(std::uint32_t vertex) const
    {
        return turned(to_world_, to_vec3d(source_.positions[vertex])) + column(3);
    }

    // Towards the eye.
    Vec3d facing(Vec3d at) const
    {
        const Projection& p = view_.projection;
        if (p.orthographic) return axis(2);
        return normalized(Vec3d{p.eye[0], p.eye[1], p.eye[2]} - at);
    }

    Vec3d axis(std::size_t row) const
    {
        const double* w = view_.projection.world_to_view;
        return {w[row], w[4 + row], w[8 + row]};
    }

    double half_width(Vec3d at) const
    {
        if (source_.width > 0) return 0.5 * static_cast<double>(source_.width) * scale_;
        const Projection& p = view_.projection;
        const double distance = -(dot(axis(2), at) + p.world_to_view[14]);
        const double w = p.orthographic ? 1 : std::max(distance, p.znear);
        const double pixel = 2 * w / (p.scale_y * view_.height);
        return 0.5 * static_cast<double>(kDefaultLineWidth) * pixel;
    }

    // Appends one that has the source vertex's attributes and gives its number.
    std::uint32_t add(std::uint32_t vertex, Vec3d at, Vec3d facing)
    {
        made_.positions.push_back(to_float3(at));
        made_.normals.push_back(to_float3(normal(vertex, facing)));
        if (!source_.colors.empty()) made_.colors.push_back(source_.colors[vertex]);
        for (std::size_t set = 0; set < 2; ++set) {
            if (!source_.texcoords[set].empty()) {
                made_.texcoords[set].push_back(source_.texcoords[set][vertex]);
            }
        }
        return static_cast<std::uint32_t>(made_.positions.size() - 1);
    }

    // Counter-clockwise seen from the front.
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
    {
        made_.indices.insert(made_.indices.end(), {a, b, c, a, c, d});
    }

    Mesh& made() { return made_; }

private:
    Vec3d column(std::size_t c) const
    {
        return to_vec3d({to_world_[4 * c], to_world_[4 * c + 1], to_world_[4 * c + 2]});
    }

    // The line's own normal turned as a direction, which is right where nothing is stretched.
    Vec3d normal(std::uint32_t vertex, Vec3d facing) const
    {
        if (source_.normals.empty()) return facing;
        return normalized(turned(to_world_, to_vec3d(source_.normals[vertex])));
    }

    const Mesh& source_;
    const Mat4& to_world_;
    const RibbonView& view_;
    double scale_ = 0;  // of the object: the largest along an axis
    Mesh made_;
};

// The vertices of one ribbon, in order, no two that follow one another at the same place.
void add_ribbon(Widener& widener, const std::vector<std::uint32_t>& line)
{
    if (line.size() < 2) return;
    const std::size_t last = line.size() - 1;
    const bool closed = last > 1 && line.front() == line.back();
    std::uint32_t left_before = 0, right_before = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        const Vec3d at = widener.place(line[i]), facing = widener.facing(at);
        const bool has_before = i > 0 || closed, has_after = i < last || closed;
        Vec3d before, after;
        if (has_before) before = normalized(at - widener.place(line[i > 0 ? i - 1 : last - 1]));
        if (has_after) after = normalized(widener.place(line[i < last ? i + 1 : 1]) - at);
        Vec3d side = normalized(cross(facing, normalized(before + after)));
        const Vec3d one_side = normalized(cross(facing, has_after ? after : before));
        if (dot(side, side) == 0) side = one_side;
        const double cosine = std::max(dot(side, one_side), 1 / kMostMitre);
        const Vec3d offset = (widener.half_width(at) / cosine) * side;
        const std::uint32_t left = widener.add(line[i], at + offset, facing);
        const std::uint32_t right = widener.add(line[i], at - offset, facing);
        if (i > 0) widener.add_quad(right_before, right, left, left_before);
        left_before = left;
        right_before = right;
    }
}

}  // namespace

Mesh make_ribbons(const Mesh& lines, const Mat4& to_world, const RibbonView& view)
{
    Widener widener(lines, to_world, view);
    std::vector<std::uint32_t> line;
    for (std::size_t i = 0; i + 1 < lines.indices.size(); i += 2) {
        if (!line.empty() && line.back() != lines.indices[i]) {
            add_ribbon(widener, line);
            line.clear();
        }
        if (line.empty()) line.push_back(lines.indices[i]);
        const std::uint32_t next = lines.indices[i + 1];
        if (lines.positions[next] == lines.positions[line.back()]) {
            line.back() = next;
        } else {
            line.push_back(next);
        }
    }
    if (!line.empty()) add_ribbon(widener, line);
    return std::move(widener.made());
}

Mesh make_squares(const Mesh& points, const Mat4& to_world, const RibbonView& view)
{
    Widener widener(points, to_world, view);
    for (const std::uint32_t vertex : points.indices) {
        const Vec3d at = widener.place(vertex), facing = widener.facing(at);
        const double half = widener.half_width(at);
        const Vec3d right = half * widener.axis(0), up = half * widener.axis(1);
        const std::uint32_t corner = widener.add(vertex, at - right - up, facing);
        widener.add(vertex, at + right - up, facing);
        widener.add(vertex, at + right + up, facing);
        widener.add(vertex, at - right + up, facing);
        widener.add_quad(corner, corner + 1, corner + 2, corner + 3);
    }
    return std::move(widener.made());
}

}  // namespace sheer
