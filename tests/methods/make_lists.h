// Fragment lists to try texts on: of real tiles, random ones, and ones with opacities at which
// something jumps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sheer/sheer.h>

#include "cpu/tile_fragments.h"
#include "geometry/build.h"
#include "methods/fragment_lists.h"
#include "scene/camera.h"

namespace sheer::test {

inline FragmentLists empty_lists(std::string name, int samples, int capacity)
{
    FragmentLists lists;
    lists.name = std::move(name) + ", S = " + std::to_string(samples);
    lists.set = make_sample_set(samples, SamplePositions::standard);
    lists.stream = FragmentStream(capacity, false, true);
    lists.place.key = 0x5eed1e55u;
    return lists;
}

// Of the tile that most triangles touch, of a picture of 800 x 800; at more than 16 samples its
// upper quarter, for the sake of time.
inline FragmentLists lists_of_fullest_tile(const Scene& scene, const std::string& name, int samples)
{
    FragmentLists lists = empty_lists(name, samples, 1 << 17);
    View view;
    view.width = view.height = 800;
    const TileGrid grid{view.width, view.height, 0};
    const Projection projection = resolve_camera(scene, view);
    const Geometry geometry =
        build_geometry({scene, projection, grid, lists.set.extent, 1, {true, false, false}});
    std::vector<std::size_t> triangles(static_cast<std::size_t>(grid.count()));
    for (const TriangleChunk& chunk : geometry.chunks) {
        for (std::size_t t = 0; t + 1 < chunk.tile_begin.size(); ++t) {
            triangles[t] += chunk.tile_begin[t + 1] - chunk.tile_begin[t];
        }
    }
    const auto fullest = std::max_element(triangles.begin(), triangles.end());
    const int tile = static_cast<int>(fullest - triangles.begin());

    const FrameSurfaces surfaces = make_surfaces({scene, 0, geometry.eye, 1});
    TileScratch scratch;
    OpaqueTile opaque(samples, surfaces.any_opaque);
    const PixelRect rect = grid.rect(tile);
    PixelRect region = rect;
    if (samples > 16) region.y1 = region.y0 + kTileSize / 4;
    FragmentWants wants;
    wants.places = PlaceSpace::object;
    wants.levels = true;
    const TileJob job{&geometry, &surfaces, &lists.set, tile, rect, region, wants};
    const FragmentConsumer full{[](void*, const FragmentStream&) { return false; }, nullptr};
    if (!tile_fragments_for(targets_of(Simd::best))(job, scratch, opaque, lists.stream, full)) {
        throw std::runtime_error(name + ": the tile has too many fragments");
    }
    lists.eye = {projection.orthographic, static_cast<float>(projection.znear),
                 static_cast<float>(projection.zfar)};
    lists.place = {rect.x0, rect.y0, lists.place.key};
    list_fragments(lists);
    return lists;
}

// With depths of 14 bits behind the point, and so of 22 at samples on a grid of 1/256 pixel, which
// floats know exactly below 4: for stores that know depths better than the texts alone, which have
// them as floats.
inline FragmentLists with_exact_depths(FragmentLists lists)
{
    const auto rounded = [](double x) { return std::round(x * 0x1p14) * 0x1p-14; };
    FragmentStream& f = lists.stream;
    for (int r = 0; r < f.run_count; ++r) {
        const FragmentRun& run = f.runs[r];
        DepthPlane& plane = f.runs[r].depth;
        if (std::max(std::abs(plane.least), std::abs(plane.most)) >= 4) {
            throw std::runtime_error(lists.name + ": depths of 4 and more");
        }
        plane.precise_at = rounded(plane.precise_at);
        plane.precise_dx = rounded(plane.precise_dx);
        plane.precise_dy = rounded(plane.precise_dy);
        plane.dx = static_cast<float>(plane.precise_dx);
        plane.dy = static_cast<float>(plane.precise_dy);
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            f.depth[i] =
                static_cast<float>(plane.precise_at + f.pixel[i] % kTileSize * plane.precise_dx +
                                   f.pixel[i] / kTileSize * plane.precise_dy);
        }
    }
    lists.name += ", exact depths";
    list_fragments(lists);
    return lists;
}

// In (0, 1]: those at which a random mask gets another sample, and their neighbours; tiny ones.
inline std::vector<float> edge_opacities(int samples)
{
    std::vector<float> all = {0x1p-50f, 1e-12f, 0x1p-25f, 0x1p-24f, 0x1p-23f, 1 - 0x1p-24f};
    for (int k = 0; k <= samples; ++k) {
        const float even = static_cast<float>(k) / static_cast<float>(samples);
        all.insert(all.end(), {even, std::nextafter(even, 0.0f), std::nextafter(even, 1.0f)});
    }
    // Whatever is denormal a device may flush to zero.
    std::erase_if(all, [](float a) { return a < 0x1p-126f; });
    return all;
}

class RandomLists {
public:
    // Under a perspective or an orthographic camera, without an end or with one.
    RandomLists(std::string name, int samples, EyeSpace eye)
        : lists_(empty_lists(std::move(name), samples, 8192)), opacities_(edge_opacities(samples))
    {
        lists_.eye = eye;
        lists_.place.x = 96;
        lists_.place.y = 64;
    }

    // Planes that cross one another inside pixels, some at equal depth; every opacity.
    FragmentLists plates()
    {
        for (std::uint32_t i = 0; i < kPlates; ++i) {
            begin_run(i, plate());
            for (std::uint32_t p = 0; p < kUsedPixels; ++p) {
                const bool whole = bits() % 4 == 0;
                add_fragment(p * kPixelStep % kTilePixels, whole ? ~0ull : long_bits(), opacity());
            }
        }
        list_fragments(lists_);
        return std::move(lists_);
    }

    // Every edge opacity in some pixel, three deep and all samples covered; the first two tie.
    FragmentLists edges()
    {
        std::size_t next = 0;
        for (std::uint32_t i = 0; i < 3; ++i) {
            begin_run(i, flat_plate(i < 2 ? 2.0f : 1.5f));
            for (std::uint32_t p = 0; p < kTilePixels; ++p) {
                add_fragment(p, ~0ull, opacities_[next++ % opacities_.size()]);
            }
        }
        list_fragments(lists_);
        return std::move(lists_);
    }

private:
    static constexpr std::uint32_t kPlates = 48, kUsedPixels = 64, kPixelStep = 37;

    std::uint32_t bits() { return static_cast<std::uint32_t>(random_.bits(counter_++) >> 32); }
    std::uint64_t long_bits() { return random_.bits(counter_++); }
    float uniform() { return unit_float(bits()); }

    float depth_of(float distance) const
    {
        return lists_.eye.orthographic ? distance : -1.0f / distance;
    }

    DepthPlane flat_plate(float distance) const
    {
        const float depth = depth_of(distance);
        const float room = 0.3f * std::abs(depth);
        return {0, 0, depth - room, depth + room, 0, static_cast<double>(depth), 0, 0};
    }

    DepthPlane plate()
    {
        const std::uint32_t kind = bits() % 3;
        if (kind == 0) return flat_plate(1.0f + static_cast<float>(bits() % 4) * 0.0125f);
        const float u = uniform();
        // Close together, so that they cross, or anywhere that the weights of wboit speak of.
        DepthPlane plane = flat_plate(kind == 1 ? 1.0f + 0.05f * u : 0.1f + 500 * u * u * u * u);
        plane.dx = (uniform() - 0.5f) * 0.04f * static_cast<float>(std::abs(plane.precise_at));
        plane.dy = (uniform() - 0.5f) * 0.04f * static_cast<float>(std::abs(plane.precise_at));
        plane.precise_dx = static_cast<double>(plane.dx);
        plane.precise_dy = static_cast<double>(plane.dy);
        return plane;
    }

    // Far enough from 1 for products of many transmittances not to become denormal.
    float opacity()
    {
        switch (bits() % 8) {
            case 0: return 1.0f;
            case 1: return 0x1.fep-1f;
            case 2: return opacities_[bits() % 5];
            default: return 1 - 0.99f * uniform();
        }
    }

    void begin_run(std::uint32_t number, DepthPlane plane)
    {
        plane.slack = depth_slack(plane, 2 * std::abs(plane.precise_at));
        // Odd times a number, modulo a power of two: all different, in no order.
        const std::uint32_t primitive = (number + 1) * 0x5851f42du & 0x7fffffffu;
        FragmentStream& f = lists_.stream;
        f.runs[f.run_count++] = {static_cast<std::uint32_t>(f.size), 0, primitive, number / 5,
                                 plane};
    }

    void add_fragment(std::uint32_t pixel, std::uint64_t samples, float opacity)
    {
        samples &= lists_.set.all();
        if (samples == 0) return;
        FragmentStream& f = lists_.stream;
        FragmentRun& run = f.runs[f.run_count - 1];
        const int at = f.size++;
        ++run.count;
        f.pixel[at] = pixel;
        f.samples[at] = static_cast<std::uint32_t>(samples);
        f.samples_high[at] = static_cast<std::uint32_t>(samples >> 32);
        f.depth[at] =
            static_cast<float>(run.depth.precise_at + pixel % kTileSize * run.depth.precise_dx +
                               pixel / kTileSize * run.depth.precise_dy);
        f.red[at] = bits() % 8 == 0 ? 0.0f : 4 * uniform();
        f.green[at] = uniform();
        f.blue[at] = uniform();
        f.opacity[at] = opacity;
        // Derivatives of 2^-12 to 2^3, a twelfth of them 0.
        const float size = std::ldexp(1.0f, static_cast<int>(run.primitive % 16) - 12);
        for (std::size_t c = 0; c < 9; ++c) {
            const float u = bits() % 12 == 0 ? 0.0f : 2 * uniform() - 1;
            f.place[c][at] = c < 3 ? 20 * u : size * u;
        }
        f.level[at] = f.place[0][at] / 2;
    }

    FragmentLists lists_;
    std::vector<float> opacities_;
    CounterRandom random_{11};
    std::uint64_t counter_ = 0;
};

// Three cameras' random lists and the edges.
inline std::vector<FragmentLists> random_lists(int samples)
{
    std::vector<FragmentLists> all;
    all.push_back(RandomLists("plates", samples, {false, 0.1f, 0}).plates());
    all.push_back(RandomLists("plates up to zfar", samples, {false, 0.1f, 501}).plates());
    all.push_back(RandomLists("plates, orthographic", samples, {true, 0, 501}).plates());
    all.push_back(RandomLists("edges", samples, {false, 0.1f, 0}).edges());
    return all;
}

}  // namespace sheer::test
