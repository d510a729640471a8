// Ambient occlusion of a vector of fragments: the numbers that choose their rays, and the rays, one
// fragment after the other.
#if defined(SHEER_AMBIENT_OCCLUSION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_AMBIENT_OCCLUSION_INL_H
#undef SHEER_AMBIENT_OCCLUSION_INL_H
#else
#define SHEER_AMBIENT_OCCLUSION_INL_H
#endif

#include <algorithm>

#include "lanes/text.h"
#include "shade/ambient_occlusion.h"
#include "shade/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct SkyText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/hashed_threshold.glsl"
};

// Two for each point, in [0, 1].
template <class L>
struct SkyNumbers {
    typename L::real chi1, chi2;
};

// Of cells that stay on the surface: "using different offsets" (section 9). A place on it, and what
// a pixel to the right and down adds.
template <class L>
HWY_NOINLINE SkyNumbers<L> hashed_numbers(RayCells kind, const Vector<L>& place,
                                          const Vector<L>& dx, const Vector<L>& dy)
{
    using Text = SkyText<L>;
    using real = typename L::real;
    const auto text = [](const Vector<L>& v)
                          HWY_ATTR { return typename Text::real3(v.x, v.y, v.z); };
    constexpr int kPcg = 1;
    const real pixel(1.0f);
    typename Text::HashCells cells;
    if (kind == RayCells::isotropic) {
        cells =
            Text::isotropic_cells(text(place), Text::isotropic_scale(text(dx), text(dy), pixel));
    } else {
        cells = Text::anisotropic_cells(text(place),
                                        Text::anisotropic_scales(text(dx), text(dy), pixel));
    }
    const typename Text::HashCells others = Text::other_cells(cells, typename Text::whole(1u));
    return {Text::threshold_of_cells(cells, kPcg, true),
            Text::threshold_of_cells(others, kPcg, true)};
}

// Of no more than the point: weights of a triangle's vertices name it.
template <class L>
HWY_NOINLINE SkyNumbers<L> random_numbers(std::uint32_t primitive, std::uint32_t key,
                                          typename L::real w1, typename L::real w2)
{
    using Text = SkyText<L>;
    using whole = typename L::whole;
    const whole triangle = Text::identity_seed(whole(primitive), whole(key));
    const whole row = Text::hash_whole(whole::bits_of(w2) + triangle);
    whole seed = Text::hash_whole(whole::bits_of(w1) + row);
    const auto chi1 = Text::next_random_real(seed);
    return {chi1, Text::next_random_real(seed)};
}

template <class L>
struct SkyPoints {
    const RayOrigin& origin;
    Float3 edge1, edge2;              // of the triangle
    Vector<L> place, normal, to_eye;  // the first relative to its first vertex
    int lanes;                        // that hold a point
};

// The part of the sky that is seen, in [0, 1]; all of it where nothing is `shown`, and where there
// is no normal.
template <class L>
HWY_NOINLINE typename L::real open_part(const OcclusionRays& rays, const SkyPoints<L>& points,
                                        const SkyNumbers<L>& numbers, typename L::mask shown)
{
    using real = typename L::real;
    constexpr auto kCount = static_cast<std::size_t>(L::kCount);
    alignas(64) float values[11][kCount], open[kCount];
    const real all[11] = {points.place.x,  points.place.y,  points.place.z,  points.normal.x,
                          points.normal.y, points.normal.z, points.to_eye.x, points.to_eye.y,
                          points.to_eye.z, numbers.chi1,    numbers.chi2};
    for (std::size_t i = 0; i < 11; ++i) all[i].store(values[i]);
    real(1.0f).store(open);
    const std::uint32_t wanted = (shown & (dot(points.normal, points.normal) > real(0.0f))).bits();
    const Vec3d across = normalized(cross(to_vec3d(points.edge1), to_vec3d(points.edge2)));
    for (std::size_t i = 0; i < std::min(static_cast<std::size_t>(points.lanes), kCount); ++i) {
        if ((wanted >> i & 1) == 0) continue;
        const auto vector = [&](std::size_t from) {
            return to_vec3d({values[from][i], values[from + 1][i], values[from + 2][i]});
        };
        const double side = dot(across, vector(6)) < 0 ? -1 : 1;
        const SkyPoint point{vector(0), vector(3), side * across};
        open[i] = static_cast<float>(rays.open_part(points.origin, point,
                                                    static_cast<double>(values[9][i]),
                                                    static_cast<double>(values[10][i])));
    }
    return real::load(open);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_AMBIENT_OCCLUSION_INL_H
