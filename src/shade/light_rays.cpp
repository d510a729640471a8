// Products over hits.
#include "shade/light_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sheer {

namespace {

using Rgb = std::array<double, 3>;

double wrapped(double u, Wrap wrap)
{
    switch (wrap) {
        case Wrap::repeat: return u - std::floor(u);
        case Wrap::mirrored_repeat: {
            const double t = u - 2 * std::floor(0.5 * u);
            return t > 1 ? 2 - t : t;
        }
        case Wrap::clamp_to_edge: break;
    }
    return std::clamp(u, 0.0, 1.0);
}

std::array<double, 4> texel(const MipChain& mips, std::int64_t x, std::int64_t y)
{
    const std::size_t at =
        static_cast<std::size_t>(y) * mips.width[0] + static_cast<std::size_t>(x);
    if (!mips.floats.empty()) {
        const float* f = &mips.floats[4 * at];
        return {static_cast<double>(f[0]), static_cast<double>(f[1]), static_cast<double>(f[2]),
                static_cast<double>(f[3])};
    }
    const std::uint32_t low = mips.words[2 * at], high = mips.words[2 * at + 1];
    const auto part = [](std::uint32_t bits) { return (bits & 0xffffu) / 65535.0; };
    return {part(low), part(low >> 16), part(high), part(high >> 16)};
}

// The two texels along an axis that a place lies between, and how far from the first.
struct Between {
    std::int64_t first, second;
    double f;
};

Between between(double u, std::int64_t size, Wrap wrap, TexelFilter filter)
{
    const double at = wrapped(u, wrap) * static_cast<double>(size);
    if (filter == TexelFilter::nearest) {
        const auto i = std::min(static_cast<std::int64_t>(at), size - 1);
        return {i, i, 0};
    }
    const double low = std::floor(at - 0.5);
    const auto i = static_cast<std::int64_t>(low);
    const auto inside = [&](std::int64_t k) {
        return wrap == Wrap::repeat ? (k + size) % size : std::clamp<std::int64_t>(k, 0, size - 1);
    };
    return {inside(i), inside(i + 1), at - 0.5 - low};
}

// At the finest level, which a light sees whatever the eye does.
std::array<double, 4> read(const PreparedTexture& texture, const Float2 (&corners)[3],
                           const RayHit& hit)
{
    double uv[2];
    for (std::size_t c = 0; c < 2; ++c) {
        const auto at = [&](std::size_t i) { return static_cast<double>(corners[i][c]); };
        uv[c] = at(0) + hit.w1 * (at(1) - at(0)) + hit.w2 * (at(2) - at(0));
    }
    const auto& m = texture.transform;
    const auto turned = [&](std::size_t r) {
        return static_cast<double>(m[r]) * uv[0] + static_cast<double>(m[r + 1]) * uv[1] +
               static_cast<double>(m[r + 2]);
    };
    const MipChain& mips = *texture.mips;
    const Sampler& sampler = texture.sampler;
    const Between x = between(turned(0), mips.width[0], sampler.wrap_u, sampler.magnify);
    const Between y = between(turned(3), mips.height[0], sampler.wrap_v, sampler.magnify);
    const auto row = [&](std::int64_t at) {
        auto left = texel(mips, x.first, at);
        const auto right = texel(mips, x.second, at);
        for (std::size_t c = 0; c < 4; ++c) left[c] += x.f * (right[c] - left[c]);
        return left;
    };
    auto upper = row(y.first);
    const auto lower = row(y.second);
    for (std::size_t c = 0; c < 4; ++c) upper[c] += y.f * (lower[c] - upper[c]);
    return upper;
}

Vec3d place(const Mat4& m, const Float3& p)
{
    return turned(m, to_vec3d(p)) + to_vec3d({m[12], m[13], m[14]});
}

bool is_mirrored(const Mat4& m)
{
    const auto column = [&](std::size_t c) {
        return to_vec3d({m[4 * c], m[4 * c + 1], m[4 * c + 2]});
    };
    return dot(cross(column(0), column(1)), column(2)) < 0;
}

// As the geometry stage numbers them: through the objects in the order of their ids.
std::vector<std::uint32_t> first_primitives(const Scene& scene, const DrawnObjects& drawn)
{
    std::vector<std::size_t> order(drawn.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return scene.objects[a].id < scene.objects[b].id;
    });
    std::vector<std::uint32_t> first(drawn.size());
    std::uint32_t next = 0;
    for (const std::size_t i : order) {
        first[i] = next;
        next += static_cast<std::uint32_t>(drawn[i].mesh->indices.size() / 3);
    }
    return first;
}

}  // namespace

RayStart ray_start(const Eye& eye, const RayOrigin& origin, const std::array<float, 3>& place)
{
    RayStart start{{}, origin.primitive, 0};
    double squared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double from_eye = origin.corner[i] + static_cast<double>(place[i]);
        start.place[i] = eye.position[i] + from_eye;
        squared += from_eye * from_eye;
    }
    const double pixel =
        2 / (eye.scale_y * eye.height) * (eye.orthographic ? 1 : std::sqrt(squared));
    start.least = pixel / 32 + origin.width;
    return start;
}

Casters::Casters(const Scene& scene, const FrameSurfaces& surfaces, const Projection& light,
                 int size)
    : surfaces_(surfaces), drawn_(scene, light, size)
{
    std::vector<TriangleCorners> triangles;
    const std::vector<std::uint32_t> first = first_primitives(scene, drawn_);
    for (std::size_t o = 0; o < drawn_.size(); ++o) {
        const DrawnObject& object = drawn_[o];
        const Surface& surface = surfaces.surfaces[o];
        mirrored_.push_back(is_mirrored(object.transform));
        if (surface.shading == Shading::unlit) continue;
        if (surface.transparent && !is_seen_through(surface)) continue;
        const auto& indices = object.mesh->indices;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            const Caster caster{static_cast<std::uint32_t>(o),
                                first[o] + static_cast<std::uint32_t>(i / 3),
                                {indices[i], indices[i + 1], indices[i + 2]}};
            casters_.push_back(caster);
            TriangleCorners corners;
            for (std::size_t k = 0; k < 3; ++k) {
                corners[k] = place(object.transform, object.mesh->positions[caster.vertex[k]]);
            }
            triangles.push_back(corners);
        }
    }
    tree_ = TriangleTree(std::move(triangles));
}

// docs/numerics.md, "Base colour and opacity" and "Transmission".
Rgb Casters::passing(const Caster& caster, const RayHit& hit) const
{
    const Surface& surface = surfaces_.surfaces[caster.object];
    const Mesh& mesh = *drawn_[caster.object].mesh;
    const MaterialDetail& detail = *surface.detail;
    const auto read_texture = [&](const std::optional<PreparedTexture>& texture) {
        if (!texture) return std::array<double, 4>{1, 1, 1, 1};
        const auto& set = mesh.texcoords[texture->set];
        Float2 corners[3] = {};
        if (!set.empty()) {
            for (std::size_t k = 0; k < 3; ++k) corners[k] = set[caster.vertex[k]];
        }
        return read(*texture, corners, hit);
    };
    std::array<double, 4> vertex = {1, 1, 1, 1};
    if (!mesh.colors.empty()) {
        for (std::size_t c = 0; c < 4; ++c) {
            const auto at = [&](std::size_t k) {
                return static_cast<double>(mesh.colors[caster.vertex[k]][c]);
            };
            vertex[c] = at(0) + hit.w1 * (at(1) - at(0)) + hit.w2 * (at(2) - at(0));
        }
    }
    const auto base = read_texture(detail.base_color);
    const double alpha =
        std::clamp(static_cast<double>(surface.opacity) * vertex[3] * base[3], 0.0, 1.0);
    double opacity = static_cast<double>(surface.object_opacity);
    if (surface.alpha_mode == AlphaMode::blend) opacity *= alpha;
    if (surface.alpha_mode == AlphaMode::mask &&
        alpha < static_cast<double>(surface.alpha_cutoff)) {
        return {1, 1, 1};
    }
    const double rest = 1 - opacity;
    if (!(detail.transmission > 0)) return {rest, rest, rest};
    const double metallic =
        static_cast<double>(detail.metallic) * read_texture(detail.metallic_roughness)[2];
    const double through = opacity * static_cast<double>(detail.transmission) *
                           read_texture(detail.transmission_map)[0] * (1 - metallic) * (1 - 0.04);
    Rgb result;
    for (std::size_t c = 0; c < 3; ++c) {
        const double straight = base[3] > 0 ? base[c] / base[3] : 0;
        const double color = static_cast<double>(surface.color[c]) * vertex[c] * straight;
        result[c] = std::min(1.0, rest + through * color);
    }
    return result;
}

Rgb Casters::transmittance(const RayStart& start, const Vec3d& to_light, double most) const
{
    Rgb left = {1, 1, 1};
    const double length = std::sqrt(dot(to_light, to_light));
    const Ray ray{
        {start.place[0], start.place[1], start.place[2]}, to_light, start.least / length, most};
    tree_.trace(ray, [&](const RayHit& hit) {
        const Caster& caster = casters_[hit.triangle];
        if (caster.primitive == start.primitive) return true;
        if (!drawn_[caster.object].double_sided) {
            const double facing = dot(tree_.normal(hit.triangle), to_light);
            // The side that the light doesn't see lets it pass, as it lets the eye.
            if ((facing > 0) == mirrored_[caster.object]) return true;
        }
        const Rgb part = passing(caster, hit);
        for (std::size_t c = 0; c < 3; ++c) left[c] *= part[c];
        return left != Rgb{0, 0, 0};
    });
    return left;
}

double Casters::open(const RayStart& start, const Vec3d& way, double most) const
{
    Rgb left = {1, 1, 1};
    const Ray ray{{start.place[0], start.place[1], start.place[2]}, way, start.least, most};
    tree_.trace(ray, [&](const RayHit& hit) {
        const Caster& caster = casters_[hit.triangle];
        if (caster.primitive == start.primitive) return true;
        const Rgb part = passing(caster, hit);
        for (std::size_t c = 0; c < 3; ++c) left[c] *= part[c];
        return left != Rgb{0, 0, 0};
    });
    return (left[0] + left[1] + left[2]) / 3;
}

Rgb LightRays::transmittance(const RayStart& start) const
{
    if (directional) {
        return casters->transmittance(start, to_light, std::numeric_limits<double>::infinity());
    }
    const Vec3d way = position - Vec3d{start.place[0], start.place[1], start.place[2]};
    if (dot(way, way) == 0) return {1, 1, 1};
    return casters->transmittance(start, way, 1);
}

}  // namespace sheer
