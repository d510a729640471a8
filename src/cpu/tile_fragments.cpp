// A tile's triangles, one after the other: coverage, depth at the samples against what is opaque,
// shading at the centroid, into the stream. docs/numerics.md says what exactly is computed.
#include "cpu/tile_fragments.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/tile_fragments.cpp"
#include "lanes/targets.h"

#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>

#include "cpu/light_places-inl.h"
#include "cpu/locate-inl.h"
#include "cpu/shade_point-inl.h"
#include "cpu/visibility-inl.h"
#include "geometry/screen_bounds.h"
#include "raster/coverage-inl.h"
#include "raster/coverage_wide.h"
#include "shade/detail-inl.h"
#include "shade/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// One tile in the making.
struct Tile {
    const TileJob& job;
    TileScratch& scratch;
    OpaqueTile& opaque;
    FragmentStream& stream;
    const FragmentConsumer& consumer;
    // The functions for this number of samples.
    OpaqueSamples samples;
    CoverFunction cover_narrow;
    EyeRays rays;
    bool wanted = true;  // by the consumer
};

// The part of the tile that a triangle may cover, in pixels of the picture.
HWY_INLINE bool region_of(const Tile& tile, const Triangle& t, PixelRect& region)
{
    const PixelRect& rect = tile.job.region;
    const PixelBounds bounds = pixel_bounds(t, tile.job.samples->extent);
    region = {std::max(rect.x0, bounds.x0), std::max(rect.y0, bounds.y0),
              std::min(rect.x1, bounds.x1 + 1), std::min(rect.y1, bounds.y1 + 1)};
    return region.x0 < region.x1 && region.y0 < region.y1;
}

// Appends to the list.
HWY_INLINE void cover(const Tile& tile, const Triangle& t, const PixelRect& region,
                      CoverageList& list)
{
    const SampleSet& set = *tile.job.samples;
    const PixelRect& rect = tile.job.rect;
    RegionEdges edges;
    if (!make_region_edges(t, region, edges)) return;
    const PixelRect local{region.x0 - rect.x0, region.y0 - rect.y0, region.x1 - rect.x0,
                          region.y1 - rect.y0};
    if (edges.inside) {
        cover_all(set, local, list);
    } else if (edges.wide) {
        cover_wide(t, set, region, rect.x0, rect.y0, list);
    } else {
        tile.cover_narrow(edges, set, local, list);
    }
}

HWY_INLINE void set_surface(const Tile& tile, const TriangleChunk& chunk, const Triangle& t,
                            const Surface& surface, TriangleSurface& result)
{
    const Geometry& geometry = *tile.job.geometry;
    const Attributes& a0 = geometry.attributes_of(chunk, t.vertex[0]);
    const Attributes& a1 = geometry.attributes_of(chunk, t.vertex[1]);
    const Attributes& a2 = geometry.attributes_of(chunk, t.vertex[2]);
    result.side = t.back_facing ? -1.0f : 1.0f;
    if (surface.shading != Shading::unlit) result.normal.set(a0.normal, a1.normal, a2.normal);
    if (surface.has_vertex_colors) result.color.set(a0.color, a1.color, a2.color);
}

inline void set_detail(const Tile& tile, const TriangleChunk& chunk, const Triangle& t,
                       TriangleDetail& result)
{
    const Geometry& geometry = *tile.job.geometry;
    const TextureAttributes a0 = geometry.texture_attributes_of(chunk, t.vertex[0]);
    const TextureAttributes a1 = geometry.texture_attributes_of(chunk, t.vertex[1]);
    const TextureAttributes a2 = geometry.texture_attributes_of(chunk, t.vertex[2]);
    for (std::size_t set = 0; set < 2; ++set) {
        result.texcoords[set].set(a0.texcoords[set], a1.texcoords[set], a2.texcoords[set]);
    }
    result.tangent.set(a0.tangent, a1.tangent, a2.tangent);
    result.bitangent_side = a0.tangent[3] < 0 ? -1.0f : 1.0f;
    set_light_places(tile.job, t, tile.scratch, result);
}

// A triangle's fragments, shaded a block at a time: `store(i, depth at the pixel's centre, shaded,
// what passes through)` for fragments i, i + 1, ... of the list.
template <class Store>
HWY_INLINE void shade_all(const Tile& tile, const TriangleChunk& chunk, const Triangle& t,
                          const TrianglePlanes& planes, const CoverageList& list, int first,
                          int end, Store&& store)
{
    const SampleSet& set = *tile.job.samples;
    const Lighting& light = tile.job.surfaces->light;
    const Surface& surface = tile.job.surfaces->surfaces[t.object];
    TriangleSurface triangle;
    set_surface(tile, chunk, t, surface, triangle);
    if (surface.detail == nullptr) {
        for (int i = first; i < end; i += Block::kCount) {
            const Located at = locate(planes, set, list, i);
            const Shaded<Block> f = shade<Block>(surface, triangle, light, at.w1, at.w2);
            const Block::real rest = Block::real(1.0f) - f.opacity;
            store(i, at.depth, f, Vector<Block>{rest, rest, rest});
        }
        return;
    }
    TriangleDetail detail;
    set_detail(tile, chunk, t, detail);
    for (int i = first; i < end; i += Block::kCount) {
        const LocatedOnScreen at = locate_on_screen(planes, set, list, i);
        const ShadePoint<Block> point = shade_point(planes, tile.rays, at, end - i);
        const DetailedFragment<Block> f =
            shade_detail<Block>(surface, triangle, detail, light, point);
        store(i, at.depth, f.shaded, f.transmittance);
    }
}

inline void draw_opaque(Tile& tile, const TriangleChunk& chunk, const Triangle& t,
                        const Surface& surface)
{
    const SampleSet& set = *tile.job.samples;
    CoverageList list{tile.scratch.pixel.data(), tile.scratch.low.data(), tile.scratch.high.data(),
                      0};
    PixelRect region;
    if (region_of(tile, t, region)) cover(tile, t, region, list);
    if (list.count == 0) return;
    if (!tile.opaque.any) tile.opaque.clear();
    TrianglePlanes planes;
    make_triangle_planes(t, tile.job.rect, tile.job.geometry->orthographic, planes);
    tile.opaque.surfaces.push_back({planes.depth, t.primitive});
    const auto write = [&](int i, Block::real center_depth, const Shaded<Block>& f,
                           const Vector<Block>&) HWY_ATTR {
        alignas(64) float depth[16], red[16], green[16], blue[16], opacity[16];
        center_depth.store(depth);
        f.red.store(red);
        f.green.store(green);
        f.blue.store(blue);
        f.opacity.store(opacity);
        for (int lane = 0; lane < std::min(Block::kCount, list.count - i); ++lane) {
            if (surface.alpha_mode == AlphaMode::mask && opacity[lane] < surface.alpha_cutoff) {
                continue;
            }
            tile.samples.write(tile.opaque, set,
                               {list.pixel[i + lane],
                                list.samples(i + lane),
                                depth[lane],
                                {red[lane], green[lane], blue[lane]}});
        }
    };
    shade_all(tile, chunk, t, planes, list, 0, list.count, write);
}

// Moves the run's fragments down to `to`, without those of which nothing can be seen: all samples
// behind opaque surfaces, or no opacity.
inline void keep_visible(Tile& tile, FragmentRun& run, int to)
{
    FragmentStream& s = tile.stream;
    auto kept = static_cast<std::uint32_t>(to);
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
        std::uint64_t visible = s.sample_bits(i);
        if (tile.opaque.any) {
            visible = tile.samples.in_front(tile.opaque, *tile.job.samples, run.depth,
                                            {s.pixel[i], visible, s.depth[i], {}});
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
        if (s.colored) {
            s.through_red[kept] = s.through_red[i];
            s.through_green[kept] = s.through_green[i];
            s.through_blue[kept] = s.through_blue[i];
        }
        ++kept;
    }
    run.first = static_cast<std::uint32_t>(to);
    run.count = kept - run.first;
}

// `kept`: fragments of earlier runs; counts this run's too.
HWY_INLINE void shade_run(Tile& tile, const PendingRun& pending, int& kept)
{
    FragmentStream& s = tile.stream;
    const Triangle& t = *pending.triangle;
    const Surface& surface = tile.job.surfaces->surfaces[t.object];
    const CoverageList list{s.pixel.data(), s.samples.data(), s.samples_high.data(), 0};
    TrianglePlanes planes;
    make_triangle_planes(t, tile.job.rect, tile.job.geometry->orthographic, planes);
    const auto write = [&](int i, Block::real center_depth, const Shaded<Block>& f,
                           const Vector<Block>& through) HWY_ATTR {
        center_depth.store(s.depth.data() + i);
        f.red.store(s.red.data() + i);
        f.green.store(s.green.data() + i);
        f.blue.store(s.blue.data() + i);
        f.opacity.store(s.opacity.data() + i);
        if (!s.colored) return;
        through.x.store(s.through_red.data() + i);
        through.y.store(s.through_green.data() + i);
        through.z.store(s.through_blue.data() + i);
    };
    shade_all(tile, *pending.chunk, t, planes, list, pending.first, pending.first + pending.count,
              write);
    FragmentRun& run = s.runs[s.run_count];
    run = {static_cast<std::uint32_t>(pending.first),
           static_cast<std::uint32_t>(pending.count),
           t.primitive,
           surface.id,
           planes.depth,
           t.back_facing != 0};
    if (tile.opaque.any || surface.may_vanish || kept < pending.first) {
        keep_visible(tile, run, kept);
    }
    kept += static_cast<int>(run.count);
    if (run.count > 0) ++s.run_count;
}

// Shades what is covered so far. Coverage and shading take turns over many triangles at a time, so
// that neither waits for the other's latency.
inline void finish_stream(Tile& tile)
{
    constexpr std::size_t kAhead = 4;
    const std::vector<PendingRun>& pending = tile.scratch.pending;
    int kept = 0;
    for (std::size_t i = 0; i < pending.size(); ++i) {
        if (i + kAhead < pending.size()) {
            const PendingRun& next = pending[i + kAhead];
            for (const std::uint32_t v : next.triangle->vertex) {
                hwy::Prefetch(&tile.job.geometry->attributes_of(*next.chunk, v));
            }
        }
        shade_run(tile, pending[i], kept);
    }
    tile.stream.size = kept;
    tile.scratch.pending.clear();
}

inline void hand_on(Tile& tile)
{
    finish_stream(tile);
    if (tile.stream.size > 0) {
        tile.wanted = tile.consumer.take(tile.consumer.context, tile.stream);
    }
    tile.stream.clear();
}

HWY_INLINE void cover_transparent(Tile& tile, const TriangleChunk& chunk, const Triangle& t)
{
    FragmentStream& s = tile.stream;
    PixelRect region;
    if (!tile.wanted || !region_of(tile, t, region)) return;
    const int most = (region.x1 - region.x0) * (region.y1 - region.y0);
    if (s.size + most > s.capacity) hand_on(tile);
    CoverageList list{s.pixel.data(), s.samples.data(), s.samples_high.data(), s.size};
    cover(tile, t, region, list);
    if (list.count == s.size) return;
    tile.scratch.pending.push_back({&chunk, &t, s.size, list.count - s.size});
    s.size = list.count;
}

template <class Draw>
HWY_INLINE void for_each_triangle(const TileJob& job, Draw&& draw)
{
    constexpr std::uint32_t kAhead = 8;  // triangles lie scattered over the memory
    const auto tile = static_cast<std::size_t>(job.tile);
    for (const TriangleChunk& chunk : job.geometry->chunks) {
        if (chunk.triangles.empty()) continue;
        const std::uint32_t end = chunk.tile_begin[tile + 1];
        for (std::uint32_t i = chunk.tile_begin[tile]; i < end; ++i) {
            if (i + kAhead < end) {
                hwy::Prefetch(&chunk.triangles[chunk.tile_triangles[i + kAhead]]);
            }
            const Triangle& t = chunk.triangles[chunk.tile_triangles[i]];
            draw(chunk, t, job.surfaces->surfaces[t.object]);
        }
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

// The transparent triangles, in the job's order.
template <class Draw>
HWY_INLINE void for_each_transparent(const TileJob& job, std::vector<SortedTriangle>& sorted,
                                     Draw&& draw)
{
    if (job.submission == Submission::as_given) {
        for_each_triangle(job, [&](const TriangleChunk& chunk, const Triangle& t,
                                   const Surface& surface) HWY_ATTR {
            if (is_seen_through(surface)) draw(chunk, t);
        });
        return;
    }
    sorted.clear();
    for_each_triangle(
        job, [&](const TriangleChunk& chunk, const Triangle& t, const Surface& surface) HWY_ATTR {
            if (!is_seen_through(surface)) return;
            if (job.submission == Submission::objects_sorted) {
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

bool tile_fragments(const TileJob& job, TileScratch& scratch, OpaqueTile& opaque,
                    FragmentStream& stream, const FragmentConsumer& consumer)
{
    Tile tile{job,
              scratch,
              opaque,
              stream,
              consumer,
              opaque_samples_for(job.samples->count),
              cover_function_for(*job.samples),
              make_eye_rays(job.geometry->eye, job.rect)};
    stream.clear();
    scratch.pending.clear();
    opaque.any = false;
    if (job.surfaces->any_opaque) {
        for_each_triangle(job, [&](const TriangleChunk& chunk, const Triangle& t,
                                   const Surface& surface) HWY_ATTR {
            if (!surface.transparent) draw_opaque(tile, chunk, t, surface);
        });
    }
    for_each_transparent(job, scratch.sorted,
                         [&](const TriangleChunk& chunk, const Triangle& t)
                             HWY_ATTR { cover_transparent(tile, chunk, t); });
    finish_stream(tile);
    return tile.wanted;
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
