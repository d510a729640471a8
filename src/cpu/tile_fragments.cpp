// A tile's triangles, one after the other: coverage, depth at the samples against what is opaque,
// shading at the centroid, into the stream. docs/numerics.md says what exactly is computed.
#include "cpu/tile_fragments.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/tile_fragments.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "cpu/locate-inl.h"
#include "cpu/visibility-inl.h"
#include "geometry/screen_bounds.h"
#include "raster/coverage-inl.h"
#include "raster/coverage_wide.h"
#include "shade/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// One tile in the making.
struct Tile {
    const TileJob& job;
    CoverageList& list;
    OpaqueTile& opaque;
    FragmentStream& stream;
    const FragmentConsumer& consumer;
    OpaqueSamples samples;  // the functions for this number of samples
};

HWY_INLINE bool cover(const Tile& tile, const Triangle& t)
{
    const SampleSet& set = *tile.job.samples;
    const PixelRect& rect = tile.job.rect;
    const PixelBounds bounds = pixel_bounds(t, set.extent);
    const PixelRect region{std::max(rect.x0, bounds.x0), std::max(rect.y0, bounds.y0),
                           std::min(rect.x1, bounds.x1 + 1), std::min(rect.y1, bounds.y1 + 1)};
    tile.list.count = 0;
    if (region.x0 >= region.x1 || region.y0 >= region.y1) return false;
    RegionEdges edges;
    if (!make_region_edges(t, region, edges)) return false;
    if (edges.wide) {
        cover_wide(t, set, region, rect.x0, rect.y0, tile.list);
    } else {
        const PixelRect local{region.x0 - rect.x0, region.y0 - rect.y0, region.x1 - rect.x0,
                              region.y1 - rect.y0};
        cover_narrow(edges, set, local, tile.list);
    }
    return tile.list.count > 0;
}

HWY_INLINE TriangleSurface surface_of(const Tile& tile, const TriangleChunk& chunk,
                                      const Triangle& t, const Surface& surface)
{
    const Geometry& geometry = *tile.job.geometry;
    const Attributes& a0 = geometry.attributes_of(chunk, t.vertex[0]);
    const Attributes& a1 = geometry.attributes_of(chunk, t.vertex[1]);
    const Attributes& a2 = geometry.attributes_of(chunk, t.vertex[2]);
    TriangleSurface result;
    result.side = t.back_facing ? -1.0f : 1.0f;
    if (!surface.unlit) result.normal.set(a0.normal, a1.normal, a2.normal);
    if (surface.has_vertex_colors) result.color.set(a0.color, a1.color, a2.color);
    return result;
}

HWY_INLINE void draw_opaque(Tile& tile, const TriangleChunk& chunk, const Triangle& t,
                            const Surface& surface)
{
    const SampleSet& set = *tile.job.samples;
    const CoverageList& list = tile.list;
    const TrianglePlanes planes =
        make_triangle_planes(t, tile.job.rect, tile.job.geometry->orthographic);
    const TriangleSurface triangle = surface_of(tile, chunk, t, surface);
    for (int i = 0; i < list.count; i += Block::kCount) {
        const Located at = locate(planes, set, list, i);
        const Shaded<Block> f =
            shade<Block>(surface, triangle, tile.job.surfaces->light, at.w1, at.w2);
        alignas(64) float depth[16], red[16], green[16], blue[16], opacity[16];
        at.depth.store(depth);
        f.red.store(red);
        f.green.store(green);
        f.blue.store(blue);
        f.opacity.store(opacity);
        for (int lane = 0; lane < std::min(Block::kCount, list.count - i); ++lane) {
            if (surface.alpha_mode == AlphaMode::mask && opacity[lane] < surface.alpha_cutoff) {
                continue;
            }
            const OpaqueFragment fragment{list.pixel[i + lane],
                                          list.samples(i + lane),
                                          t.primitive,
                                          depth[lane],
                                          {red[lane], green[lane], blue[lane]}};
            tile.samples.write(tile.opaque, set, planes, fragment);
        }
    }
}

// Drops the fragments of the newest run that nothing can be seen of: all samples behind opaque
// surfaces, or no opacity.
inline void drop_invisible(Tile& tile, const TrianglePlanes& planes, FragmentRun& run)
{
    FragmentStream& s = tile.stream;
    std::uint32_t kept = run.first;
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
        std::uint64_t visible = s.sample_bits(i);
        if (tile.opaque.any) {
            visible &= tile.samples.in_front(tile.opaque, *tile.job.samples, planes, s.pixel[i],
                                             s.depth[i]);
        }
        if (visible == 0 || !(s.opacity[i] > 0)) continue;
        s.pixel[kept] = s.pixel[i];
        s.samples[kept] = static_cast<std::uint32_t>(visible);
        s.samples_high[kept] = static_cast<std::uint32_t>(visible >> 32);
        s.depth[kept] = s.depth[i];
        s.red[kept] = s.red[i];
        s.green[kept] = s.green[i];
        s.blue[kept] = s.blue[i];
        s.opacity[kept] = s.opacity[i];
        ++kept;
    }
    run.count = kept - run.first;
}

inline void flush(Tile& tile)
{
    if (tile.stream.size > 0) tile.consumer.take(tile.consumer.context, tile.stream);
    tile.stream.clear();
}

HWY_INLINE void append_transparent(Tile& tile, const TriangleChunk& chunk, const Triangle& t,
                                   const Surface& surface)
{
    const SampleSet& set = *tile.job.samples;
    const CoverageList& list = tile.list;
    FragmentStream& s = tile.stream;
    if (s.size + list.count > s.capacity) flush(tile);
    const TrianglePlanes planes =
        make_triangle_planes(t, tile.job.rect, tile.job.geometry->orthographic);
    const TriangleSurface triangle = surface_of(tile, chunk, t, surface);
    for (int i = 0, to = s.size; i < list.count; i += Block::kCount, to += Block::kCount) {
        const Located at = locate(planes, set, list, i);
        const Shaded<Block> f =
            shade<Block>(surface, triangle, tile.job.surfaces->light, at.w1, at.w2);
        Block::whole::load(list.pixel + i).store(s.pixel.data() + to);
        Block::whole::load(list.low + i).store(s.samples.data() + to);
        if (set.count > 32) Block::whole::load(list.high + i).store(s.samples_high.data() + to);
        at.depth.store(s.depth.data() + to);
        f.red.store(s.red.data() + to);
        f.green.store(s.green.data() + to);
        f.blue.store(s.blue.data() + to);
        f.opacity.store(s.opacity.data() + to);
    }
    FragmentRun run{static_cast<std::uint32_t>(s.size),
                    static_cast<std::uint32_t>(list.count),
                    t.primitive,
                    t.object,
                    planes.depth_dx,
                    planes.depth_dy,
                    planes.depth_min,
                    planes.depth_max};
    if (tile.opaque.any || surface.has_vertex_colors) drop_invisible(tile, planes, run);
    if (run.count == 0) return;
    s.runs[s.run_count++] = run;
    s.size += static_cast<int>(run.count);
}

template <class Draw>
HWY_INLINE void for_each_triangle(const TileJob& job, Draw&& draw)
{
    const auto tile = static_cast<std::size_t>(job.tile);
    for (const TriangleChunk& chunk : job.geometry->chunks) {
        if (chunk.triangles.empty()) continue;
        for (std::uint32_t i = chunk.tile_begin[tile]; i < chunk.tile_begin[tile + 1]; ++i) {
            const Triangle& t = chunk.triangles[chunk.tile_triangles[i]];
            draw(chunk, t, job.surfaces->surfaces[t.object]);
        }
    }
}

void tile_fragments(const TileJob& job, CoverageList& list, OpaqueTile& opaque,
                    FragmentStream& stream, const FragmentConsumer& consumer)
{
    Tile tile{job, list, opaque, stream, consumer, opaque_samples_for(job.samples->count)};
    stream.clear();
    opaque.any = false;
    if (job.surfaces->any_opaque) {
        for_each_triangle(job, [&](const TriangleChunk& chunk, const Triangle& t,
                                   const Surface& surface) HWY_ATTR {
            if (surface.alpha_mode == AlphaMode::blend || !cover(tile, t)) return;
            if (!opaque.any) opaque.clear();
            draw_opaque(tile, chunk, t, surface);
        });
    }
    for_each_triangle(
        job, [&](const TriangleChunk& chunk, const Triangle& t, const Surface& surface) HWY_ATTR {
            if (surface.alpha_mode != AlphaMode::blend || !(surface.opacity > 0)) return;
            if (cover(tile, t)) append_transparent(tile, chunk, t, surface);
        });
    flush(tile);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(tile_fragments);

TileFragmentsFunction tile_fragments_for(TargetSet targets)
{
    return SHEER_DISPATCH(tile_fragments, targets);
}

}  // namespace sheer
#endif
