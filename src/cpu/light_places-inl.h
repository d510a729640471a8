// Where the lights and their shadow maps are, as one triangle sees them.
#if defined(SHEER_LIGHT_PLACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_LIGHT_PLACES_INL_H
#undef SHEER_LIGHT_PLACES_INL_H
#else
#define SHEER_LIGHT_PLACES_INL_H
#endif

#include "cpu/tile_fragments.h"
#include "cpu/triangle_places.h"
#include "shade/detail-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

inline void set_light_places(const TileJob& job, const Triangle& t, TileScratch& scratch,
                             TriangleDetail& result)
{
    const Lighting& light = job.surfaces->light;
    const Surface& surface = job.surfaces->surfaces[t.object];
    result.edge1 = result.edge2 = {0, 0, 0};
    result.light_places = nullptr;
    result.receivers = nullptr;
    result.occlusion = nullptr;
    if (surface.shading == Shading::unlit) return;
    result.occlusion = job.shading.occlusion;
    if (light.lights.empty() && light.shadows == nullptr && result.occlusion == nullptr) return;
    const Eye& eye = job.geometry->eye;
    const std::array<double, 3> p[3] = {place_of(eye, t, 0), place_of(eye, t, 1),
                                        place_of(eye, t, 2)};
    std::vector<Float3>& places = scratch.light_places;
    places.resize(light.lights.size());
    result.light_places = places.data();
    for (std::size_t i = 0; i < 3; ++i) {
        result.edge1[i] = static_cast<float>(p[1][i] - p[0][i]);
        result.edge2[i] = static_cast<float>(p[2][i] - p[0][i]);
        for (std::size_t l = 0; l < places.size(); ++l) {
            places[l][i] = static_cast<float>(light.lights[l].place[i] - p[0][i]);
        }
    }
    result.rays_from = {p[0], t.primitive, 2 * double{surface.facing.half_width}};
    if (light.shadows == nullptr) return;
    const LightShadows& shadows = *light.shadows;
    scratch.receivers.resize(shadows.size());
    result.receivers = scratch.receivers.data();
    for (std::size_t i = 0; i < shadows.size(); ++i) {
        if (!shadows[i].map) continue;
        scratch.receivers[i] = make_receiver(*shadows[i].map, p, surface.facing);
    }
}

// For what stays on the surface, where rays of ambient occlusion are hashed.
inline void set_noise_places(const TileJob& job, const TriangleChunk& chunk, const Triangle& t,
                             TriangleDetail& result)
{
    if (result.occlusion == nullptr || !result.occlusion->is_hashed()) return;
    const auto at = [&](std::size_t i) {
        return job.geometry->place_of(PlaceSpace::object, chunk, t.vertex[i]);
    };
    result.noise_place.set(at(0), at(1), at(2));
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_LIGHT_PLACES_INL_H
