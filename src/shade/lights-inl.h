// What a surface sends to the eye of the light that falls on it (docs/numerics.md, "Shading").
#if defined(SHEER_LIGHTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_LIGHTS_INL_H
#undef SHEER_LIGHTS_INL_H
#else
#define SHEER_LIGHTS_INL_H
#endif

#include "shade/light_rays-inl.h"
#include "shade/shadow_lookup-inl.h"
#include "shade/surface.h"
#include "shade/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

inline constexpr float kPi = 3.14159265f;

// A surface's point, as the light meets it.
template <class L>
struct LitPoint {
    Vector<L> place;             // relative to the triangle's first vertex, world axes
    const Float3* light_places;  // of each light, likewise
    Vector<L> to_eye;            // unit
    Vector<L> normal;            // unit or zero, turned to the side that is seen
    Vector<L> color;             // of diffuse reflection
    // Metallic-roughness alone.
    Vector<L> at_front;  // F0: reflected of what comes at right angles
    typename L::real roughness;
    // For shadows: the weights of vertices 1 and 2, and how many lanes hold a point.
    typename L::real w1, w2;
    int lanes;
    const ShadowReceiver* receivers;  // of each light, the sun first
    const RayOrigin* rays_from;
    typename L::real open_sky;  // the part that is seen, in [0, 1]
};

template <class L>
struct Incident {
    Vector<L> from;  // unit
    Vector<L> irradiance;
};

template <class L>
HWY_NOINLINE Incident<L> incident_light(const PreparedLight& light, const Float3& light_place,
                                        const Vector<L>& place)
{
    using real = typename L::real;
    const Vector<L> intensity = Vector<L>::of(light.intensity);
    const Vector<L> axis = Vector<L>::of(light.to_light);
    if (light.kind == LightKind::directional) return {axis, intensity};
    const real zero(0.0f), one(1.0f);
    const Vector<L> way = Vector<L>::of(light_place) - place;
    const real squared = dot(way, way);
    const Vector<L> from = normalized(way);
    real strength = one / L::max(squared, real(1e-4f));  // nothing is nearer than a centimetre
    const real part = squared * real(light.inverse_range * light.inverse_range);
    strength = strength * L::min(L::max(one - part * part, zero), one);
    if (light.kind == LightKind::spot) {
        const real q = (dot(axis, from) - real(light.outer_cosine)) * real(light.inverse_cone);
        const real within = L::min(L::max(q, zero), one);
        strength = strength * within * within;
    }
    return {from, strength * intensity};
}

template <class L>
HWY_INLINE Vector<L> sky_over(const Lighting& light, const Vector<L>& normal)
{
    return Vector<L>::of(light.sky_mean) + normal.y * Vector<L>::of(light.sky_slope);
}

// What reaches a point of a light, number `number` of those with shadows.
template <class L>
HWY_NOINLINE Incident<L> shadowed(const LightShadow& shadow, std::size_t number,
                                  const LitPoint<L>& p, const Incident<L>& in)
{
    using real = typename L::real;
    // Away from the light it is dark anyway.
    if (!(dot(p.normal, in.from) > real(0.0f)).any()) return in;
    if (shadow.rays) {
        return {in.from,
                light_through<L>(*shadow.rays, *p.rays_from, p.place, p.lanes) * in.irradiance};
    }
    if (!shadow.map) return in;
    return {in.from,
            visible_part<L>(*shadow.map, p.receivers[number], p.w1, p.w2, p.lanes) * in.irradiance};
}

// Calls `add` for the sun and for each light.
template <class L, class Add>
HWY_INLINE void for_each_light(const Lighting& light, const LitPoint<L>& p, Add&& add)
{
    using real = typename L::real;
    const auto add_shadowed = [&](std::size_t number, const Incident<L>& in) HWY_ATTR {
        add(light.shadows == nullptr ? in : shadowed<L>((*light.shadows)[number], number, p, in));
    };
    add_shadowed(0, Incident<L>{Vector<L>::of(light.to_light),
                                real(kPi * light.gain) * Vector<L>::of(light.sun)});
    for (std::size_t i = 0; i < light.lights.size(); ++i) {
        add_shadowed(i + 1, incident_light<L>(light.lights[i], p.light_places[i], p.place));
    }
}

// Lambert.
template <class L>
HWY_INLINE Vector<L> diffuse_radiance(const Lighting& light, const LitPoint<L>& p)
{
    using real = typename L::real;
    Vector<L> sum = (real(light.gain) * p.open_sky) * sky_over<L>(light, p.normal);
    for_each_light<L>(light, p, [&](const Incident<L>& in) HWY_ATTR {
        const real facing = L::max(dot(p.normal, in.from), real(0.0f));
        sum = sum + (facing * real(1 / kPi)) * in.irradiance;
    });
    return p.color * sum;
}

template <class L>
HWY_INLINE typename L::real fifth_power(typename L::real x)
{
    const typename L::real squared = x * x;
    return squared * squared * x;
}

// glTF 2.0, appendix B: the part of a light's radiance that a rough mirror sends to the eye, and
// what is left for the colour below.
template <class L>
HWY_NOINLINE Vector<L> reflected(const LitPoint<L>& p, const Incident<L>& in, typename L::real nv)
{
    using real = typename L::real;
    const real one(1.0f), zero(0.0f), half(0.5f);
    const real nl = dot(p.normal, in.from);
    const Vector<L> h = normalized(in.from + p.to_eye);
    const real vh = dot(p.to_eye, h), nh = dot(p.normal, h);
    const Vector<L> white = Vector<L>::all(1.0f);
    const Vector<L> fresnel = p.at_front + fifth_power<L>(one - vh) * (white - p.at_front);
    const real a = p.roughness * p.roughness, a2 = a * a;
    // 1 - (n . h)^2 would lose all digits where it counts, in the middle of a highlight.
    const Vector<L> off = cross(p.normal, h);
    const real t = dot(off, off) + a2 * nh * nh;
    // Light from behind along the line of sight has no half vector and no highlight.
    const real distribution = L::zero_unless(t > zero, a2 / (real(kPi) * t * t));
    const real visibility =
        half / (nl * L::sqrt(nv * nv * (one - a2) + a2) + nv * L::sqrt(nl * nl * (one - a2) + a2));
    const Vector<L> sum =
        real(1 / kPi) * ((white - fresnel) * p.color) + (distribution * visibility) * fresnel;
    const real facing = L::zero_unless(nl > zero, nl);
    return select<L>(nl > zero, facing * (in.irradiance * sum), Vector<L>::all(0.0f));
}

template <class L>
HWY_INLINE Vector<L> metallic_roughness_radiance(const Lighting& light, const LitPoint<L>& p)
{
    using real = typename L::real;
    const real one(1.0f), zero(0.0f), two(2.0f), half(0.5f);
    const real facing = dot(p.normal, p.to_eye);
    const real nv = L::max(facing, real(1e-4f));
    const auto max_color = [](real a, const Vector<L>& b) HWY_ATTR {
        return Vector<L>{L::max(a, b.x), L::max(a, b.y), L::max(a, b.z)};
    };
    // Lagarde. Adopting a physically based shading model. 2011.
    const Vector<L> mirror =
        p.at_front +
        fifth_power<L>(one - nv) * (max_color(one - p.roughness, p.at_front) - p.at_front);
    const real up = two * facing * p.normal.y - p.to_eye.y;  // of the mirrored line of sight
    const real steepness = (real(1.5f) - half * p.roughness * p.roughness) * up;
    const Vector<L> seen =
        max_color(zero, Vector<L>::of(light.sky_mean) + steepness * Vector<L>::of(light.sky_slope));
    const Vector<L> under =
        (Vector<L>::all(1.0f) - mirror) * p.color * sky_over<L>(light, p.normal);
    Vector<L> sum = (real(light.gain) * p.open_sky) * (under + mirror * seen);
    for_each_light<L>(light, p,
                      [&](const Incident<L>& in) HWY_ATTR { sum = sum + reflected<L>(p, in, nv); });
    const auto has_normal = dot(p.normal, p.normal) > zero;
    return select<L>(has_normal, sum, real(light.gain) * (p.color * Vector<L>::of(light.sky_mean)));
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_LIGHTS_INL_H
