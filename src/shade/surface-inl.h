// The radiance and opacity of a triangle's fragments, a vector of fragments at a time
// (docs/numerics.md, "Shading").
#if defined(SHEER_SURFACE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SURFACE_INL_H
#undef SHEER_SURFACE_INL_H
#else
#define SHEER_SURFACE_INL_H
#endif

#include "geometry/triangles.h"
#include "lanes/lanes-inl.h"
#include "shade/surface.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// An attribute over a triangle: at vertex 0, and what vertices 1 and 2 add.
template <int Channels>
struct Varying {
    float base[Channels], toward1[Channels], toward2[Channels];

    template <class Value>
    void set(const Value& at0, const Value& at1, const Value& at2)
    {
        for (std::size_t c = 0; c < Channels; ++c) {
            base[c] = at0[c];
            toward1[c] = at1[c] - at0[c];
            toward2[c] = at2[c] - at0[c];
        }
    }
    template <class L>
    HWY_INLINE typename L::real at(int c, typename L::real w1, typename L::real w2) const
    {
        using real = typename L::real;
        return real(base[c]) + w1 * real(toward1[c]) + w2 * real(toward2[c]);
    }
};

struct TriangleSurface {
    Varying<3> normal;
    Varying<4> color;
    float side;  // -1 where seen from behind, else 1
};

// The same of up to a vector of triangles: [vertex 0, and what vertices 1 and 2 add][channel].
template <class L, std::size_t Channels>
struct VaryingBatch {
    alignas(64) float value[3][Channels][L::kCount];

    // Of triangle k, at each vertex.
    template <class Value>
    void set(std::size_t k, const Value& at0, const Value& at1, const Value& at2)
    {
        for (std::size_t c = 0; c < Channels; ++c) {
            value[0][c][k] = at0[c];
            value[1][c][k] = at1[c] - at0[c];
            value[2][c][k] = at2[c] - at0[c];
        }
    }
    // `of`: each lane's triangle.
    HWY_INLINE typename L::real at(std::size_t c, const typename L::Lookup& of, typename L::real w1,
                                   typename L::real w2) const
    {
        return of.of(value[0][c]) + w1 * of.of(value[1][c]) + w2 * of.of(value[2][c]);
    }
};

template <class L>
struct SurfaceBatch {
    VaryingBatch<L, 3> normal;
    VaryingBatch<L, 4> color;
    alignas(64) float side[L::kCount];
};

template <class L>
struct Shaded {
    typename L::real red, green, blue, opacity;
};

template <class L>
HWY_INLINE void apply_light(const SurfaceBatch<L>& t, const typename L::Lookup& of,
                            const Lighting& light, typename L::real w1, typename L::real w2,
                            Shaded<L>& f)
{
    using real = typename L::real;
    const real nx = t.normal.at(0, of, w1, w2);
    const real ny = t.normal.at(1, of, w1, w2);
    const real nz = t.normal.at(2, of, w1, w2);
    const real squared = nx * nx + ny * ny + nz * nz;
    // 1e-10 squared: below it a normal is none (docs/numerics.md).
    const real scale = L::zero_unless(squared >= real(1e-20f), of.of(t.side) / L::sqrt(squared));
    const real facing = (nx * real(light.to_light[0]) + ny * real(light.to_light[1]) +
                         nz * real(light.to_light[2])) *
                        scale;
    const real sun = L::max(facing, real(0.0f));
    const real up = ny * scale;
    f.red = f.red *
            (real(light.sky_mean[0]) + real(light.sky_slope[0]) * up + real(light.sun[0]) * sun);
    f.green = f.green *
              (real(light.sky_mean[1]) + real(light.sky_slope[1]) * up + real(light.sun[1]) * sun);
    f.blue = f.blue *
             (real(light.sky_mean[2]) + real(light.sky_slope[2]) * up + real(light.sun[2]) * sun);
}

// Of what the material's factors, vertices and textures give. A MASK surface that is drawn first
// keeps it, for its cutoff.
template <class L>
HWY_INLINE typename L::real surface_opacity(const Surface& surface, typename L::real alpha)
{
    using real = typename L::real;
    const real zero(0.0f), one(1.0f);
    if (surface.alpha_mode == AlphaMode::opaque) return real(surface.object_opacity);
    const real opacity = L::min(L::max(real(surface.opacity) * alpha, zero), one);
    if (surface.alpha_mode == AlphaMode::mask) {
        if (!surface.transparent) return opacity;
        return L::zero_unless(opacity >= real(surface.alpha_cutoff), real(surface.object_opacity));
    }
    return opacity * real(surface.object_opacity);
}

// `of`: each lane's triangle of the batch. w1, w2: perspective-correct weights of vertices 1 and 2.
template <class L>
HWY_INLINE Shaded<L> shade(const Surface& surface, const SurfaceBatch<L>& t,
                           const typename L::Lookup& of, const Lighting& light, typename L::real w1,
                           typename L::real w2)
{
    using real = typename L::real;
    Shaded<L> f{real(surface.color[0]), real(surface.color[1]), real(surface.color[2]), real(1.0f)};
    if (surface.has_vertex_colors) {
        f.red = f.red * t.color.at(0, of, w1, w2);
        f.green = f.green * t.color.at(1, of, w1, w2);
        f.blue = f.blue * t.color.at(2, of, w1, w2);
        f.opacity = t.color.at(3, of, w1, w2);
    }
    f.opacity = surface_opacity<L>(surface, f.opacity);
    if (surface.shading != Shading::unlit) apply_light<L>(t, of, light, w1, w2, f);
    return f;
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SURFACE_INL_H
