// Shading of materials with textures, reflections, lights or coloured glass, a vector of fragments
// at a time (docs/numerics.md, "Shading").
#if defined(SHEER_DETAIL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_DETAIL_INL_H
#undef SHEER_DETAIL_INL_H
#else
#define SHEER_DETAIL_INL_H
#endif

#include "shade/ambient_occlusion-inl.h"
#include "shade/lights-inl.h"
#include "shade/surface-inl.h"
#include "shade/texture-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Where fragments are shaded.
template <class L>
struct ShadePoint {
    typename L::real w1, w2;      // perspective-correct weights of vertices 1 and 2
    typename L::real w1_x, w2_x;  // how they change a pixel to the right
    typename L::real w1_y, w2_y;  // and down
    Vector<L> to_eye;             // unit
    int lanes;                    // that hold a fragment
};

// What a triangle adds to TriangleSurface for a material with textures.
struct TriangleDetail {
    // Where there are lights: from vertex 0 to vertices 1 and 2, and to each of the lights, world
    // axes. From the eye floats would not do: lights may be much nearer.
    Float3 edge1, edge2;
    const Float3* light_places;
    // Where there are shadows: of each light's map, and for rays.
    const ShadowReceiver* receivers;
    RayOrigin rays_from;
    // Where there is ambient occlusion; the second where its samples are hashed.
    const OcclusionRays* occlusion;
    Varying<3> noise_place;
    Varying<2> texcoords[2];
    Varying<3> tangent;
    float bitangent_side;
};

template <class L>
struct DetailedFragment {
    Shaded<L> shaded;
    Vector<L> transmittance;
};

// Of a surface through which nothing but its opacity's rest is seen.
template <class L>
HWY_INLINE DetailedFragment<L> plain_fragment(const Vector<L>& color, typename L::real opacity)
{
    const typename L::real rest = typename L::real(1.0f) - opacity;
    return {{color.x, color.y, color.z, opacity}, {rest, rest, rest}};
}

template <class L>
HWY_INLINE Footprint<L> footprint(const PreparedTexture& texture, const TriangleDetail& t,
                                  const ShadePoint<L>& p)
{
    using real = typename L::real;
    const Varying<2>& uv = t.texcoords[texture.set];
    const auto& m = texture.transform;
    const real u = uv.at<L>(0, p.w1, p.w2), v = uv.at<L>(1, p.w1, p.w2);
    const auto step = [&](int c, real w1, real w2)
                          HWY_ATTR { return w1 * real(uv.toward1[c]) + w2 * real(uv.toward2[c]); };
    const real u_x = step(0, p.w1_x, p.w2_x), v_x = step(1, p.w1_x, p.w2_x);
    const real u_y = step(0, p.w1_y, p.w2_y), v_y = step(1, p.w1_y, p.w2_y);
    const auto turned = [&](std::size_t row, real a, real b)
                            HWY_ATTR { return real(m[row]) * a + real(m[row + 1]) * b; };
    return {turned(0, u, v) + real(m[2]), turned(3, u, v) + real(m[5]), turned(0, u_x, v_x),
            turned(3, u_x, v_x),          turned(0, u_y, v_y),          turned(3, u_y, v_y)};
}

template <class L>
HWY_INLINE Texel<L> look_up(const PreparedTexture& texture, const TriangleDetail& t,
                            const ShadePoint<L>& p)
{
    return sample_texture<L>(texture, footprint<L>(texture, t, p), p.lanes);
}

// Straight.
template <class L>
struct BaseColor {
    Vector<L> color;
    typename L::real opacity;
};

template <class L>
HWY_INLINE BaseColor<L> base_color(const Surface& surface, const TriangleSurface& triangle,
                                   const TriangleDetail& detail, const ShadePoint<L>& p)
{
    using real = typename L::real;
    BaseColor<L> base{Vector<L>::of(surface.color), real(1.0f)};
    real alpha(1.0f);
    if (surface.has_vertex_colors) {
        base.color = base.color * Vector<L>{triangle.color.at<L>(0, p.w1, p.w2),
                                            triangle.color.at<L>(1, p.w1, p.w2),
                                            triangle.color.at<L>(2, p.w1, p.w2)};
        alpha = triangle.color.at<L>(3, p.w1, p.w2);
    }
    if (surface.detail->base_color) {
        const PreparedTexture& texture = *surface.detail->base_color;
        const Footprint<L> at = footprint<L>(texture, detail, p);
        const Texel<L> texel = sample_texture<L>(texture, at, p.lanes);
        const real scale = texture.straight
                               ? real(1.0f)
                               : L::zero_unless(texel.a > real(0.0f), real(1.0f) / texel.a);
        base.color = base.color * Vector<L>{texel.r * scale, texel.g * scale, texel.b * scale};
        alpha = alpha * texel.a;
        if (surface.alpha_mode == AlphaMode::mask && texture.mips->has_thresholds) {
            alpha = alpha / threshold_at<L>(texture, at);
        }
    }
    base.opacity = surface_opacity<L>(surface, alpha);
    return base;
}

template <class L>
HWY_INLINE Vector<L> surface_normal(const Surface& surface, const TriangleSurface& triangle,
                                    const TriangleDetail& detail, const ShadePoint<L>& p)
{
    using real = typename L::real;
    const Varying<3>& n = triangle.normal;
    Vector<L> normal = normalized(
        Vector<L>{n.at<L>(0, p.w1, p.w2), n.at<L>(1, p.w1, p.w2), n.at<L>(2, p.w1, p.w2)});
    if (surface.detail->normal) {
        const Varying<3>& t = detail.tangent;
        Vector<L> tangent = {t.at<L>(0, p.w1, p.w2), t.at<L>(1, p.w1, p.w2),
                             t.at<L>(2, p.w1, p.w2)};
        tangent = normalized(tangent - dot(normal, tangent) * normal);
        const Vector<L> bitangent = real(detail.bitangent_side) * cross(normal, tangent);
        const Texel<L> texel = look_up<L>(*surface.detail->normal, detail, p);
        const real one(1.0f), two(2.0f), scale(surface.detail->normal_scale);
        const Vector<L> bent = normalized((scale * (two * texel.r - one)) * tangent +
                                          (scale * (two * texel.g - one)) * bitangent +
                                          (two * texel.b - one) * normal);
        const auto usable = dot(tangent, tangent) > real(0.0f);
        normal = select<L>(usable, bent, normal);
    }
    return real(triangle.side) * normal;
}

template <class L>
HWY_INLINE Vector<L> emission(const MaterialDetail& material, const TriangleDetail& detail,
                              const ShadePoint<L>& p)
{
    const Vector<L> factor = Vector<L>::of(material.emission);
    if (!material.emission_map) return factor;
    const Texel<L> texel = look_up<L>(*material.emission_map, detail, p);
    return factor * Vector<L>{texel.r, texel.g, texel.b};
}

// Of metallic-roughness: what the base colour is split into.
template <class L>
struct Split {
    typename L::real metallic, roughness, transmission;
};

template <class L>
HWY_INLINE Split<L> split(const MaterialDetail& material, const TriangleDetail& detail,
                          const ShadePoint<L>& p)
{
    using real = typename L::real;
    Split<L> s{real(material.metallic), real(material.roughness), real(material.transmission)};
    if (material.metallic_roughness) {
        const Texel<L> texel = look_up<L>(*material.metallic_roughness, detail, p);
        s.metallic = s.metallic * texel.b;
        s.roughness = s.roughness * texel.g;
    }
    if (material.transmission_map) {
        s.transmission = s.transmission * look_up<L>(*material.transmission_map, detail, p).r;
    }
    s.roughness = L::min(L::max(s.roughness, real(0.1f)), real(1.0f));
    return s;
}

// Colours may be brighter than white; what is let through or mirrored is not.
template <class L>
HWY_INLINE Vector<L> at_most_one(const Vector<L>& v)
{
    const typename L::real one(1.0f);
    return {L::min(v.x, one), L::min(v.y, one), L::min(v.z, one)};
}

// Of a surface that lets part of the light through in colours.
template <class L>
HWY_INLINE DetailedFragment<L> glass_fragment(const BaseColor<L>& base, const Split<L>& s,
                                              const Vector<L>& radiance)
{
    using real = typename L::real;
    const real one(1.0f), zero(0.0f);
    const real through = base.opacity * s.transmission * (one - s.metallic) * real(1 - 0.04f);
    const real rest = one - base.opacity;
    const Vector<L> t = at_most_one<L>(Vector<L>{rest, rest, rest} + through * base.color);
    const real mean = (t.x + t.y + t.z) * real(1.0f / 3);
    const real opacity = L::min(L::max(one - mean, zero), one);
    // Below a millionth there is nothing to see, and the colour's scale would not be finite.
    const real shown = L::zero_unless(opacity >= real(1e-6f), opacity);
    const real scale = L::zero_unless(shown > zero, base.opacity / shown);
    return {{scale * radiance.x, scale * radiance.y, scale * radiance.z, shown}, t};
}

// What stays on the surface, or else does not.
template <class L>
HWY_INLINE SkyNumbers<L> sky_numbers(const TriangleDetail& detail, const ShadePoint<L>& p)
{
    const OcclusionRays& rays = *detail.occlusion;
    if (!rays.is_hashed()) {
        return random_numbers<L>(detail.rays_from.primitive, rays.key(), p.w1, p.w2);
    }
    const Varying<3>& at = detail.noise_place;
    const auto toward1 = Vector<L>::of({at.toward1[0], at.toward1[1], at.toward1[2]});
    const auto toward2 = Vector<L>::of({at.toward2[0], at.toward2[1], at.toward2[2]});
    return hashed_numbers<L>(
        rays.cells(), {at.at<L>(0, p.w1, p.w2), at.at<L>(1, p.w1, p.w2), at.at<L>(2, p.w1, p.w2)},
        p.w1_x * toward1 + p.w2_x * toward2, p.w1_y * toward1 + p.w2_y * toward2);
}

template <class L>
HWY_NOINLINE DetailedFragment<L> shade_detail(const Surface& surface,
                                              const TriangleSurface& triangle,
                                              const TriangleDetail& detail, const Lighting& light,
                                              const ShadePoint<L>& p)
{
    using real = typename L::real;
    const MaterialDetail& material = *surface.detail;
    const BaseColor<L> base = base_color<L>(surface, triangle, detail, p);
    if (material.shading == Shading::unlit) {
        return plain_fragment<L>(real(light.gain) * base.color, base.opacity);
    }
    const Vector<L> place = p.w1 * Vector<L>::of(detail.edge1) + p.w2 * Vector<L>::of(detail.edge2);
    LitPoint<L> point{place,
                      detail.light_places,
                      p.to_eye,
                      surface_normal<L>(surface, triangle, detail, p),
                      base.color,
                      Vector<L>::all(0.04f),
                      real(1.0f),
                      p.w1,
                      p.w2,
                      p.lanes,
                      detail.receivers,
                      &detail.rays_from,
                      real(1.0f)};
    if (detail.occlusion != nullptr) {
        const SkyPoints<L> points{detail.rays_from, detail.edge1, detail.edge2, place,
                                  point.normal,     p.to_eye,     p.lanes};
        point.open_sky = open_part<L>(*detail.occlusion, points, sky_numbers<L>(detail, p),
                                      base.opacity > real(0.0f));
    }
    const Vector<L> emitted = emission<L>(material, detail, p);
    if (material.shading == Shading::diffuse) {
        return plain_fragment<L>(diffuse_radiance<L>(light, point) + emitted, base.opacity);
    }
    const Split<L> s = split<L>(material, detail, p);
    const real one(1.0f);
    point.at_front = point.at_front + s.metallic * (base.color - point.at_front);
    point.at_front = at_most_one<L>(point.at_front);
    point.color = ((one - s.metallic) * (one - s.transmission)) * base.color;
    point.roughness = s.roughness;
    const Vector<L> radiance = metallic_roughness_radiance<L>(light, point) + emitted;
    return material.transmission > 0 ? glass_fragment<L>(base, s, radiance)
                                     : plain_fragment<L>(radiance, base.opacity);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_DETAIL_INL_H
