// A tile's triangles, one after the other: coverage, depth at the samples against what is opaque,
// shading at the centroid, into the stream. docs/numerics.md says what exactly is computed.
#include "cpu/tile_fragments.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/tile_fragments.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "cpu/hidden-inl.h"
#include "cpu/hidden_blocks-inl.h"
#include "cpu/levels-inl.h"
#include "cpu/places-inl.h"
#include "cpu/submission-inl.h"
#include "cpu/triangle_batch-inl.h"
#include "cpu/visibility-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// One tile in the making.
struct Tile {
    const TileJob& job;
    TileScratch& scratch;
    OpaqueTile& opaque;
    FragmentStream& stream;
    const FragmentConsumer& consumer;
    OpaqueSamples samples;
    TileSetup setup;
    TriangleBatch batch = {};
    HiddenBlocks hidden = {};
    bool wanted = true;  // by the consumer

    const Surface& surface() const { return job.surfaces->surfaces[batch.object()]; }
    void look_at_kept()
    {
        const float* behind = consumer.hidden_behind;
        if (behind != nullptr) hidden.kept.find(behind, behind);
    }
};

// The end of the triangles from `first` on that are covered together: as many as have no more
// fragments than `room`, but of those with edges too long for 32 bits each by itself.
inline std::size_t end_of_covered(const TriangleBatch& batch, std::size_t first, int room)
{
    std::size_t end = first;
    for (; end < batch.count; ++end) {
        room -= most_fragments(batch, end);
        if (room < 0) break;
        if ((batch.edges.wide >> end & 1) != 0) return end == first ? end + 1 : end;
    }
    return end;
}

// Triangle k's fragments of sample after sample, each shaded there: `finish` as of cover_batch.
template <class Finish>
inline void cover_by_sample(Tile& tile, std::size_t k, CoverageList& list, int most,
                            Finish&& finish)
{
    TriangleBatch& batch = tile.batch;
    std::vector<std::uint32_t>& pixels = tile.scratch.sampled_pixel;
    std::vector<std::uint64_t>& samples = tile.scratch.sampled;
    if (most - list.count < most_fragments(batch, k)) finish(k, k, list);
    const int before = list.count;
    cover(tile.job, tile.setup, k, k + 1, batch, list);
    pixels.assign(list.pixel + before, list.pixel + list.count);
    samples.clear();
    for (int i = before; i < list.count; ++i) {
        const bool is_high = tile.job.samples->count > 32;
        samples.push_back(is_high ? list.samples(i) : list.low[i]);
    }
    list.count = before;
    for (int s = 0; s < tile.job.samples->count; ++s) {
        if (most - list.count < static_cast<int>(pixels.size())) finish(k, k, list);
        batch.begin[k] = list.count;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if ((samples[i] >> s & 1) == 0) continue;
            const std::uint64_t bit = std::uint64_t{1} << s;
            list.pixel[list.count] = pixels[i];
            list.low[list.count] = static_cast<std::uint32_t>(bit);
            list.high[list.count] = static_cast<std::uint32_t>(bit >> 32);
            ++list.count;
        }
        batch.begin[k + 1] = list.count;
        // Those of the sample before may have been rearranged.
        std::fill_n(batch.owner, list.count - batch.begin[k], static_cast<std::uint32_t>(k));
        if (batch.begin[k] < list.count) finish(k, k + 1, list);
    }
}

// Covers the batch's triangles and shades them: `finish(first, end, list)` takes those of triangles
// first, ..., end - 1 and leaves the list as far as it is to stay; of none where no more fragments
// would fit. `most`: the list's room.
template <class Finish>
HWY_INLINE void cover_batch(Tile& tile, CoverageList& list, int most, Finish&& finish)
{
    TriangleBatch& batch = tile.batch;
    set_up(tile.job, batch);
    tile.hidden.sort_out(batch);
    if (batch.conservative) {
        OverlapList& overlaps = tile.scratch.overlaps;
        const auto room = static_cast<std::size_t>(most + FragmentStream::kSlack);
        for (std::vector<float>* values : {&overlaps.part, &overlaps.x, &overlaps.y}) {
            values->resize(room);
        }
        list.overlaps = &overlaps;
    }
    if (tile.surface().at_samples && !batch.conservative) {
        for (std::size_t k = 0; k < batch.count; ++k) {
            if (most_fragments(batch, k) > 0) cover_by_sample(tile, k, list, most, finish);
        }
        batch.count = 0;
        return;
    }
    for (std::size_t first = 0; first < batch.count;) {
        const int room = std::min(most - list.count, TriangleBatch::kMostCovered);
        const std::size_t end = end_of_covered(batch, first, room);
        if (end > first) cover(tile.job, tile.setup, first, end, batch, list);
        finish(first, end, list);
        first = end;
    }
    batch.count = 0;
}

// Draws the opaque batch.
inline void draw_opaque(Tile& tile)
{
    const SampleSet& set = *tile.job.samples;
    const TriangleBatch& batch = tile.batch;
    const Surface& surface = tile.surface();
    CoverageList list{tile.scratch.pixel.data(), tile.scratch.low.data(), tile.scratch.high.data(),
                      0};
    std::uint32_t drawn[TriangleBatch::kMost];  // index of each triangle among the tile's surfaces
    const auto write = [&](int i, int end, Block::real center_depth, const Shaded<Block>& f,
                           const Vector<Block>&) HWY_ATTR {
        alignas(64) float depth[16], red[16], green[16], blue[16], opacity[16];
        center_depth.store(depth);
        f.red.store(red);
        f.green.store(green);
        f.blue.store(blue);
        f.opacity.store(opacity);
        for (int lane = 0; lane < std::min(Block::kCount, end - i); ++lane) {
            if (surface.alpha_mode == AlphaMode::mask && opacity[lane] < surface.alpha_cutoff) {
                continue;
            }
            tile.samples.write(tile.opaque, set,
                               {list.pixel[i + lane],
                                list.samples(i + lane),
                                depth[lane],
                                {red[lane], green[lane], blue[lane]}},
                               drawn[batch.owner[i + lane]]);
        }
    };
    const auto finish = [&](std::size_t first, std::size_t end, CoverageList& covered) HWY_ATTR {
        if (covered.count == 0) return;
        if (!tile.opaque.any) tile.opaque.clear();
        for (std::size_t k = first; k < end; ++k) {
            drawn[k] = static_cast<std::uint32_t>(tile.opaque.surfaces.size());
            if (batch.begin[k] == batch.begin[k + 1]) continue;
            tile.opaque.surfaces.push_back(
                {batch.planes.depth_plane(k), batch.triangle[k]->primitive});
        }
        shade_covered(tile.job, tile.setup, batch, first, end, covered, tile.scratch, write);
        covered.count = 0;
    };
    cover_batch(tile, list, kTilePixels, finish);
}

// Moves the run's fragments down to `to`, without those of which nothing can be seen: all samples
// behind opaque surfaces, or no opacity. `in_front`: of all of these surfaces, which is known.
inline void keep_visible(Tile& tile, FragmentRun& run, int to, bool in_front)
{
    FragmentStream& s = tile.stream;
    auto kept = static_cast<std::uint32_t>(to);
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
        std::uint64_t visible = s.sample_bits(i);
        if (!in_front) {
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
        if (s.placed) s.move_place(kept, i);
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

// Shades what is covered of triangles first, ..., end - 1 and adds their runs to the stream.
HWY_INLINE void add_runs(Tile& tile, std::size_t first, std::size_t end, const CoverageList& list)
{
    FragmentStream& s = tile.stream;
    TriangleBatch& batch = tile.batch;
    const Surface& surface = tile.surface();
    const auto write = [&](int i, int, Block::real center_depth, const Shaded<Block>& f,
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
    tile.scratch.hidden += static_cast<std::uint64_t>(leave_out_hidden(
        tile.consumer.hidden_behind, tile.opaque, *tile.job.samples, first, end, batch, list));
    shade_covered(tile.job, tile.setup, batch, first, end, list, tile.scratch, write);
    if (tile.job.wants.places) add_places(tile.job, tile.setup, batch, first, end, list, s);
    if (tile.job.wants.levels) add_levels(tile.job, tile.setup, batch, first, end, list, s);
    int kept = s.size;
    for (std::size_t k = first; k < end; ++k) {
        const int begin = batch.begin[k], count = batch.begin[k + 1] - begin;
        if (count == 0) continue;
        const Triangle& t = *batch.triangle[k];
        FragmentRun& run = s.runs[s.run_count];
        run = {static_cast<std::uint32_t>(begin),
               static_cast<std::uint32_t>(count),
               t.primitive,
               surface.id,
               batch.planes.depth_plane(k),
               t.back_facing != 0};
        const bool in_front = !tile.opaque.any || (batch.in_front >> k & 1) != 0;
        if (!in_front || surface.may_vanish || kept < begin)
            keep_visible(tile, run, kept, in_front);
        kept += static_cast<int>(run.count);
        if (run.count > 0) ++s.run_count;
    }
    s.size = kept;
}

inline void hand_on(Tile& tile)
{
    if (tile.stream.size > 0 && tile.wanted) {
        tile.wanted = tile.consumer.take(tile.consumer.context, tile.stream);
    }
    tile.stream.clear();
    tile.look_at_kept();
}

// Adds the transparent batch to the stream, which is handed on whenever it is full.
inline void draw_transparent(Tile& tile)
{
    FragmentStream& s = tile.stream;
    CoverageList list{s.pixel.data(), s.samples.data(), s.samples_high.data(), s.size};
    const auto finish = [&](std::size_t first, std::size_t end, CoverageList& covered) HWY_ATTR {
        add_runs(tile, first, end, covered);
        const bool full =
            end < tile.batch.count && s.size + most_fragments(tile.batch, end) > s.capacity;
        if (full) hand_on(tile);
        covered.count = s.size;
    };
    cover_batch(tile, list, s.capacity, finish);
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
              make_tile_setup(job, scratch)};
    TriangleBatch& batch = tile.batch;
    const auto draw = [&](const TriangleChunk& chunk, const Triangle& t, auto&& draw_batch)
                          HWY_ATTR {
                              if (!batch.has_room_for(t)) draw_batch(tile);
                              add_triangle(*job.geometry, chunk, t, batch);
                          };
    list_triangles(job, scratch.triangles);
    stream.clear();
    scratch.hidden = 0;
    opaque.any = false;
    if (job.surfaces->any_opaque && job.part != TilePart::transparent) {
        for_each_triangle(job, scratch.triangles,
                          [&](const TriangleChunk& chunk, const Triangle& t, const Surface& surface)
                              HWY_ATTR {
                                  if (is_drawn_first(job, surface)) draw(chunk, t, draw_opaque);
                              });
        if (batch.count > 0) draw_opaque(tile);
    }
    if (job.part == TilePart::opaque) return true;
    if (opaque.any) find_opaque(opaque, tile.hidden.opaque);
    tile.look_at_kept();
    for_each_transparent(job, scratch, [&](const TriangleChunk& chunk, const Triangle& t) HWY_ATTR {
        if (tile.wanted) draw(chunk, t, draw_transparent);
    });
    if (batch.count > 0 && tile.wanted) draw_transparent(tile);
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
