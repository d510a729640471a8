// Up to a vector of a tile's triangles on their way to fragments: set up side by side, a triangle a
// lane; covered one after the other; shaded together, a fragment a lane, whichever triangle it is
// of. They are of one object, so that what differs among lanes are numbers.
#if defined(SHEER_TRIANGLE_BATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_TRIANGLE_BATCH_INL_H
#undef SHEER_TRIANGLE_BATCH_INL_H
#else
#define SHEER_TRIANGLE_BATCH_INL_H
#endif

#include <hwy/cache_control.h>

#include "cpu/light_places-inl.h"
#include "cpu/locate-inl.h"
#include "cpu/shade_point-inl.h"
#include "cpu/tile_fragments.h"
#include "raster/coverage-inl.h"
#include "raster/coverage_wide.h"
#include "raster/pixel_overlap.h"
#include "shade/detail-inl.h"
#include "shade/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// The functions and numbers that all triangles of a tile share.
struct TileSetup {
    CoverFunction cover_narrow;
    EyeRays rays;
    const ShadingRates* rates;  // or null: all is shaded at full rate
};

inline TileSetup make_tile_setup(const TileJob& job, TileScratch& scratch)
{
    TileSetup setup{cover_function_for(*job.samples), make_eye_rays(job.geometry->eye, job.rect),
                    nullptr};
    if (job.shading.foveation == nullptr) return setup;
    if (!scratch.foveation) scratch.foveation = std::make_unique<FoveationScratch>();
    ShadingRates& rates = scratch.foveation->rates;
    rates.set(*job.shading.foveation, job.rect);
    if (rates.coarse) setup.rates = &rates;
    return setup;
}

struct TriangleBatch {
    static constexpr std::size_t kMost = Block::kCount;
    // Fragments that wait for shading, at most; a triangle has up to kTilePixels.
    static constexpr int kMostCovered = CandidateList::kMostPixels;

    std::size_t count = 0;
    const TriangleChunk* chunk[kMost];
    const Triangle* triangle[kMost];
    CornerBatch corners;
    alignas(64) RealEach depth[3] = {};
    EdgeBatch edges;
    CandidateList candidates;
    PlaneBatch planes;
    SurfaceBatch<Block> varying;
    // Triangle k's fragments in the list are begin[k], begin[k] + 1, ... before begin[k + 1].
    int begin[kMost + 1];
    bool conservative = false;
    // Bit k, of triangle k: a pixel hides it that it may cover; it is in front of all that is
    // opaque where it may be (HiddenBlocks).
    std::uint32_t partly_hidden = 0, in_front = 0;
    // The triangle of each fragment in the list, from the first that waits for shading on.
    alignas(64) std::uint32_t owner[kMostCovered + Block::kCount] = {};

    std::uint32_t object() const { return triangle[0]->object; }
    bool has_room_for(const Triangle& t) const
    {
        return count == 0 || (count < kMost && object() == t.object);
    }
};

HWY_INLINE void add_triangle(const Geometry& geometry, const TriangleChunk& from, const Triangle& t,
                             TriangleBatch& batch)
{
    const std::size_t k = batch.count++;
    batch.chunk[k] = &from;
    batch.triangle[k] = &t;
    for (std::size_t i = 0; i < 3; ++i) {
        batch.corners.x[i][k] = t.x[i];
        batch.corners.y[i][k] = t.y[i];
        batch.depth[i][k] = t.depth[i];
        hwy::Prefetch(&geometry.attributes_of(from, t.vertex[i]));
    }
}

// What `shade` needs; materials with more than a colour are set up a triangle at a time.
HWY_INLINE void set_up_surfaces(const TileJob& job, const Surface& surface, TriangleBatch& batch)
{
    SurfaceBatch<Block>& varying = batch.varying;
    for (std::size_t k = 0; k < batch.count; ++k) {
        const Triangle& t = *batch.triangle[k];
        const Attributes& a0 = job.geometry->attributes_of(*batch.chunk[k], t.vertex[0]);
        const Attributes& a1 = job.geometry->attributes_of(*batch.chunk[k], t.vertex[1]);
        const Attributes& a2 = job.geometry->attributes_of(*batch.chunk[k], t.vertex[2]);
        varying.side[k] = t.back_facing ? -1.0f : 1.0f;
        if (surface.shading != Shading::unlit) {
            varying.normal.set(k, a0.normal, a1.normal, a2.normal);
        }
        if (surface.has_vertex_colors) varying.color.set(k, a0.color, a1.color, a2.color);
    }
}

// How far fragments are from one another, in pixels: samples are so dense.
inline float spacing_of(const Surface& surface, const SampleSet& set)
{
    return surface.at_samples ? std::sqrt(1.0f / static_cast<float>(set.count)) : 1.0f;
}

HWY_INLINE void set_up(const TileJob& job, TriangleBatch& batch)
{
    const Surface& surface = job.surfaces->surfaces[batch.object()];
    set_up_edges(batch.corners, batch.count, *job.samples, {job.rect.x0, job.rect.y0, job.region},
                 batch.edges);
    set_up_planes(batch.corners, batch.depth, batch.count, job.rect, job.geometry->orthographic,
                  batch.planes);
    batch.conservative = surface.conservative != Conservative::off;
    batch.planes.spacing = spacing_of(surface, *job.samples);
    if (surface.detail == nullptr) set_up_surfaces(job, surface, batch);
}

// The most fragments that triangle k can have.
HWY_INLINE int most_fragments(const TriangleBatch& batch, std::size_t k)
{
    const bool outside = (batch.edges.outside >> k & 1) != 0;  // of any sample
    if (outside && !batch.conservative) return 0;
    return std::max(batch.edges.width[k], 0) * std::max(batch.edges.height[k], 0);
}

// The pixels of the picture that triangle k may cover.
HWY_INLINE PixelRect region_of(const TileJob& job, const TriangleBatch& batch, std::size_t k)
{
    const int x = job.rect.x0 + batch.edges.x0[k], y = job.rect.y0 + batch.edges.y0[k];
    return {x, y, x + batch.edges.width[k], y + batch.edges.height[k]};
}

// As `cover`, of surfaces that are drawn conservatively.
inline void cover_conservatively(const TileJob& job, std::size_t first, std::size_t end,
                                 TriangleBatch& batch, CoverageList& list)
{
    const int before = list.count;
    const bool counts = job.surfaces->surfaces[batch.object()].conservative == Conservative::area;
    batch.begin[first] = before;
    for (std::size_t k = first; k < end; ++k) {
        cover_touched(*batch.triangle[k],
                      {*job.samples, region_of(job, batch, k), job.rect.x0, job.rect.y0, counts},
                      list);
        batch.begin[k + 1] = list.count;
        std::fill(batch.owner + (batch.begin[k] - before), batch.owner + (list.count - before),
                  static_cast<std::uint32_t>(k));
    }
}

// Appends the fragments of triangles first, ..., end - 1 to the list, on which nothing waits for
// shading. One with edges too long for 32 bits is alone.
HWY_INLINE void cover(const TileJob& job, const TileSetup& setup, std::size_t first,
                      std::size_t end, TriangleBatch& batch, CoverageList& list)
{
    if (batch.conservative) return cover_conservatively(job, first, end, batch, list);
    const SampleSet& set = *job.samples;
    const EdgeBatch& edges = batch.edges;
    const int before = list.count;
    std::fill(batch.begin + first, batch.begin + end + 1, before);
    if ((edges.wide >> first & 1) != 0) {
        cover_wide(*batch.triangle[first], set, region_of(job, batch, first), job.rect.x0,
                   job.rect.y0, list);
        batch.begin[end] = list.count;
        std::fill_n(batch.owner, list.count - before, static_cast<std::uint32_t>(first));
        return;
    }
    batch.candidates.vectors = 0;
    for (std::size_t k = first; k < end; ++k) {
        if (most_fragments(batch, k) > 0) add_candidates(edges, k, batch.candidates);
    }
    setup.cover_narrow(edges, batch.candidates, set, list, batch.begin + 1, batch.owner);
    for (std::size_t k = first; k < end; ++k) {
        batch.begin[k + 1] = std::max(batch.begin[k], batch.begin[k + 1]);
    }
}

inline void set_surface(const TileJob& job, const TriangleChunk& chunk, const Triangle& t,
                        const Surface& surface, TriangleSurface& result)
{
    const Geometry& geometry = *job.geometry;
    const Attributes& a0 = geometry.attributes_of(chunk, t.vertex[0]);
    const Attributes& a1 = geometry.attributes_of(chunk, t.vertex[1]);
    const Attributes& a2 = geometry.attributes_of(chunk, t.vertex[2]);
    result.side = t.back_facing ? -1.0f : 1.0f;
    if (surface.shading != Shading::unlit) result.normal.set(a0.normal, a1.normal, a2.normal);
    if (surface.has_vertex_colors) result.color.set(a0.color, a1.color, a2.color);
}

inline void set_texcoords(const TileJob& job, const TriangleChunk& chunk, const Triangle& t,
                          TriangleDetail& result)
{
    const Geometry& geometry = *job.geometry;
    const TextureAttributes a0 = geometry.texture_attributes_of(chunk, t.vertex[0]);
    const TextureAttributes a1 = geometry.texture_attributes_of(chunk, t.vertex[1]);
    const TextureAttributes a2 = geometry.texture_attributes_of(chunk, t.vertex[2]);
    for (std::size_t set = 0; set < 2; ++set) {
        result.texcoords[set].set(a0.texcoords[set], a1.texcoords[set], a2.texcoords[set]);
    }
    result.tangent.set(a0.tangent, a1.tangent, a2.tangent);
    result.bitangent_side = a0.tangent[3] < 0 ? -1.0f : 1.0f;
}

inline void set_detail(const TileJob& job, const TriangleChunk& chunk, const Triangle& t,
                       TileScratch& scratch, TriangleDetail& result)
{
    set_texcoords(job, chunk, t, result);
    set_light_places(job, t, scratch, result);
    set_noise_places(job, chunk, t, result);
}

// What shades a triangle's fragments, of a material with more than a colour.
struct DetailedTriangle {
    const TileJob& job;
    const TileSetup& setup;
    const TriangleBatch& batch;
    const Surface& surface;
    const TriangleSurface& triangle;
    const TriangleDetail& detail;
};

// Methods that test opacities themselves get those of MASK surfaces, as if they were BLEND.
HWY_INLINE const Surface& surface_as_drawn(const TileJob& job, const TriangleBatch& batch,
                                           Surface& blended)
{
    const Surface& surface = job.surfaces->surfaces[batch.object()];
    if (!job.wants.masks || surface.alpha_mode != AlphaMode::mask) return surface;
    blended = surface;
    blended.alpha_mode = AlphaMode::blend;
    return blended;
}

// Fragments begin, begin + 1, ... before `end` of the list, which are of triangle k: `store` as of
// shade_covered.
template <class Store>
HWY_INLINE void shade_list(const DetailedTriangle& of_triangle, std::size_t k, int begin, int end,
                           const CoverageList& list, Store&& store)
{
    const auto& [job, setup, batch, surface, triangle, detail] = of_triangle;
    const Block::Lookup of(Block::whole(static_cast<std::int32_t>(k)));
    for (int i = begin; i < end; i += Block::kCount) {
        const LocatedOnScreen at =
            locate_on_screen(batch.planes, of, *job.samples, list, i, setup.rates);
        const ShadePoint<Block> point = shade_point(batch.planes, k, setup.rays, at, end - i);
        const DetailedFragment<Block> f =
            shade_detail<Block>(surface, triangle, detail, job.surfaces->light, point);
        store(i, end, at.depth, f.shaded, f.transmittance);
    }
}

// Once for each square of pixels, and then to its fragments.
template <class Store>
HWY_INLINE void shade_squares(const DetailedTriangle& triangle, std::size_t k, int begin, int end,
                              const CoverageList& list, ShadedSquares& squares, Store&& store)
{
    using real = Block::real;
    const TriangleBatch& batch = triangle.batch;
    const int count = squares.list(*triangle.setup.rates, list.pixel + begin, list.low + begin,
                                   list.high + begin, end - begin);
    const auto keep = [&](int i, int, real, const Shaded<Block>& f,
                          const Vector<Block>& through) HWY_ATTR {
        const real values[7] = {f.red, f.green, f.blue, f.opacity, through.x, through.y, through.z};
        for (std::size_t c = 0; c < 7; ++c) values[c].store(squares.shaded[c].data() + i);
    };
    shade_list(triangle, k, 0, count,
               {squares.pixel.data(), squares.low.data(), squares.high.data(), count}, keep);
    const Block::Lookup of(Block::whole(static_cast<std::int32_t>(k)));
    for (int i = begin; i < end; i += Block::kCount) {
        alignas(64) float values[7][Block::kCount] = {};
        for (int lane = 0; lane < std::min(Block::kCount, end - i); ++lane) {
            const std::uint16_t number = squares.number[i - begin + lane];
            for (std::size_t c = 0; c < 7; ++c) values[c][lane] = squares.shaded[c][number];
        }
        const auto value = [&](std::size_t c) HWY_ATTR { return real::load(values[c]); };
        const LocatedOnScreen at =
            locate_on_screen(batch.planes, of, *triangle.job.samples, list, i, nullptr);
        store(i, end, at.depth, Shaded<Block>{value(0), value(1), value(2), value(3)},
              Vector<Block>{value(4), value(5), value(6)});
    }
}

// Triangle k's fragments, of a material with more than a colour.
template <class Store>
HWY_INLINE void shade_detailed(const TileJob& job, const TileSetup& setup,
                               const TriangleBatch& batch, std::size_t k, const CoverageList& list,
                               TileScratch& scratch, Store&& store)
{
    Surface blended;
    const Surface& surface = surface_as_drawn(job, batch, blended);
    const Triangle& t = *batch.triangle[k];
    const int begin = batch.begin[k], end = batch.begin[k + 1];
    TriangleSurface triangle;
    TriangleDetail detail;
    set_surface(job, *batch.chunk[k], t, surface, triangle);
    set_detail(job, *batch.chunk[k], t, scratch, detail);
    const DetailedTriangle of{job, setup, batch, surface, triangle, detail};
    if (setup.rates == nullptr) {
        shade_list(of, k, begin, end, list, store);
    } else {
        shade_squares(of, k, begin, end, list, scratch.foveation->squares, store);
    }
}

// The fragments of triangles first, ..., end - 1, a block at a time: `store(i, end, depth at the
// pixel's centre, shaded, what passes through)` for fragments i, i + 1, ... before `end` of the
// list.
template <class Store>
HWY_INLINE void shade_covered(const TileJob& job, const TileSetup& setup,
                              const TriangleBatch& batch, std::size_t first, std::size_t end,
                              const CoverageList& list, TileScratch& scratch, Store&& store)
{
    using real = Block::real;
    const auto store_part = [&](int i, int last, real depth, Shaded<Block> f,
                                Vector<Block> through) HWY_ATTR {
        if (list.overlaps != nullptr) {
            const real part = real::load(list.overlaps->part.data() + i);
            f.opacity = part * f.opacity;
            through = Vector<Block>::all(1.0f) - part * (Vector<Block>::all(1.0f) - through);
        }
        store(i, last, depth, f, through);
    };
    Surface blended;
    const Surface& surface = surface_as_drawn(job, batch, blended);
    if (surface.detail != nullptr) {
        for (std::size_t k = first; k < end; ++k) {
            if (batch.begin[k] == batch.begin[k + 1]) continue;
            shade_detailed(job, setup, batch, k, list, scratch, store_part);
        }
        return;
    }
    const int begin = batch.begin[first];
    for (int i = begin; i < batch.begin[end]; i += Block::kCount) {
        const Block::Lookup of(Block::whole::load(batch.owner + (i - begin)));
        const Located at = locate(batch.planes, of, *job.samples, list, i, setup.rates);
        const Shaded<Block> f =
            shade<Block>(surface, batch.varying, of, job.surfaces->light, at.w1, at.w2);
        const real rest = real(1.0f) - f.opacity;
        store_part(i, batch.begin[end], at.depth, f, Vector<Block>{rest, rest, rest});
    }
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_TRIANGLE_BATCH_INL_H
