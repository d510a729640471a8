// A tile's triangles, in the order in which they are drawn.
#if defined(SHEER_SUBMISSION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SUBMISSION_INL_H
#undef SHEER_SUBMISSION_INL_H
#else
#define SHEER_SUBMISSION_INL_H
#endif

#include <algorithm>

#include <hwy/cache_control.h>

#include "cpu/tile_fragments.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// The tile's triangles, in the order of submission. They lie scattered over the memory.
inline void list_triangles(const TileJob& job, std::vector<TileTriangle>& triangles)
{
    const auto tile = static_cast<std::size_t>(job.tile);
    triangles.clear();
    for (const TriangleChunk& chunk : job.geometry->chunks) {
        if (chunk.triangles.empty()) continue;
        const std::uint32_t end = chunk.tile_begin[tile + 1];
        for (std::uint32_t i = chunk.tile_begin[tile]; i < end; ++i) {
            triangles.push_back({&chunk, &chunk.triangles[chunk.tile_triangles[i]]});
        }
    }
}

template <class Draw>
HWY_INLINE void for_each_triangle(const TileJob& job, const std::vector<TileTriangle>& triangles,
                                  Draw&& draw)
{
    constexpr std::size_t kAhead = 12;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i + kAhead < triangles.size()) hwy::Prefetch(triangles[i + kAhead].triangle);
        const Triangle& t = *triangles[i].triangle;
        draw(*triangles[i].chunk, t, job.surfaces->surfaces[t.object]);
    }
}

// Farther ones first; of equal ones that with the greater id, which counts as the farther.
inline bool is_farther(const SortedTriangle& a, const SortedTriangle& b)
{
    return a.distance > b.distance || (a.distance == b.distance && a.id > b.id);
}

// The mean of its corners' distances. A clipped triangle's pieces each have their own.
inline float centroid_distance(const Triangle& t, bool orthographic)
{
    const auto distance = [&](float depth) { return orthographic ? depth : -1.0f / depth; };
    return (distance(t.depth[0]) + distance(t.depth[1]) + distance(t.depth[2])) / 3.0f;
}

inline bool is_drawn_first(const TileJob& job, const Surface& surface)
{
    const bool tested = job.wants.masks && surface.alpha_mode == AlphaMode::mask;
    return !surface.transparent && !tested;
}

inline bool goes_to_methods(const TileJob& job, const Surface& surface)
{
    return surface.transparent ? is_seen_through(surface) : !is_drawn_first(job, surface);
}

// The transparent triangles, in the job's order.
template <class Draw>
HWY_INLINE void for_each_transparent(const TileJob& job, TileScratch& scratch, Draw&& draw)
{
    std::vector<SortedTriangle>& sorted = scratch.sorted;
    if (job.wants.submission == Submission::as_given) {
        for_each_triangle(job, scratch.triangles,
                          [&](const TriangleChunk& chunk, const Triangle& t, const Surface& surface)
                              HWY_ATTR {
                                  if (goes_to_methods(job, surface)) draw(chunk, t);
                              });
        return;
    }
    sorted.clear();
    for_each_triangle(
        job, scratch.triangles,
        [&](const TriangleChunk& chunk, const Triangle& t, const Surface& surface) HWY_ATTR {
            if (!goes_to_methods(job, surface)) return;
            if (job.wants.submission == Submission::objects_sorted) {
                sorted.push_back({job.surfaces->distances[t.object], surface.id, &chunk, &t});
            } else {
                const float distance = centroid_distance(t, job.geometry->orthographic);
                sorted.push_back({distance, t.primitive, &chunk, &t});
            }
        });
    // Stable: an object's triangles stay in their own order.
    std::stable_sort(sorted.begin(), sorted.end(), is_farther);
    for (const SortedTriangle& s : sorted) draw(*s.chunk, *s.triangle);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SUBMISSION_INL_H
