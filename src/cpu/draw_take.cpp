// Frames over frames: the same number for every pixel, or as many as each needs.
#include "cpu/draw_take.h"

#include <algorithm>

namespace sheer {

namespace {

template <class Value>
void write_tile(const PixelRect& interior, Image& image, Value&& value)
{
    std::size_t i = 0;
    for (int y = interior.y0; y < interior.y1; ++y) {
        for (int x = interior.x0; x < interior.x1; ++x, ++i) {
            for (std::size_t c = 0; c < 4; ++c) image.at(x, y)[c] = value(i, c);
        }
    }
}

void write_apart(const TileGrid& grid, const PixelRect& interior, const TilePicture& picture,
                 TakeFrame& frame)
{
    write_tile(interior, frame.image,
               [&](std::size_t p, std::size_t c) { return picture.color(p, c); });
    if (frame.fraction.empty()) return;
    std::size_t i = 0;
    for (int y = interior.y0; y < interior.y1; ++y) {
        for (int x = interior.x0; x < interior.x1; ++x, ++i) {
            frame.fraction[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
                           static_cast<std::size_t>(x)] = picture.fraction(i);
        }
    }
}

// Pixels that have frames left after `drawn` of them: of the picture's interior, and of the tile as
// far as the filter reaches around those.
struct Unfinished {
    std::vector<char> interior, tile;
    bool any = false;
};

void find_unfinished(const FrameJob& job, const Take& take, const PixelRect& rect,
                     const PixelRect& interior, std::size_t drawn, Unfinished& left)
{
    left.interior.clear();
    left.tile.assign(kTilePixels, 0);
    left.any = false;
    const int reach = job.filter.reach();
    for (int y = interior.y0; y < interior.y1; ++y) {
        for (int x = interior.x0; x < interior.x1; ++x) {
            const std::size_t at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(job.grid.width) +
                static_cast<std::size_t>(x);
            const bool more = take.frames_of_pixels[at] > drawn;
            left.interior.push_back(more ? 1 : 0);
            if (!more) continue;
            left.any = true;
            for (int ny = std::max(y - reach, rect.y0); ny < std::min(y + reach + 1, rect.y1); ++ny)
                for (int nx = std::max(x - reach, rect.x0); nx < std::min(x + reach + 1, rect.x1);
                     ++nx)
                    left.tile[static_cast<std::size_t>((ny - rect.y0) * kTileSize + nx - rect.x0)] =
                        1;
        }
    }
}

void set_frame(const Take& take, std::size_t i, TilePlace& place)
{
    place.key = take.keys[i];
    place.frame = take.frame_of_picture(i);
    place.film = take.film;
    place.film.number += static_cast<std::int64_t>(i);
}

// One picture whose pixels have as many frames as each needs. What the tile kept is forgotten.
void draw_unevenly(const FrameJob& job, const Take& take, TileSetting& setting, Worker& worker,
                   TileStore& store)
{
    const PixelRect interior = job.grid.interior(setting.job.tile);
    Unfinished left;
    worker.picture.clear();
    for (std::size_t i = 0; i < take.keys.size(); ++i) {
        find_unfinished(job, take, setting.job.rect, interior, i, left);
        if (!left.any) break;
        if (i > 0) worker.passes.restrict_to(&left.tile);
        set_frame(take, i, setting.place);
        const std::uint64_t fragments = store.fragments;
        worker.passes.draw(setting, store, worker.colors);
        if (i > 0) store.fragments = fragments;  // those of all pixels count
        store.resolving.start();
        worker.picture.add(job.filter, worker.colors, store.divides, setting.job.rect, interior,
                           &left.interior);
        store.resolving.stop();
    }
    worker.passes.restrict_to(nullptr);
    worker.passes.forget();
    worker.mean.add(worker.picture.pixels());
}

void draw_evenly(const FrameJob& job, const Take& take, TileSetting& setting, Worker& worker,
                 TileStore& store)
{
    const PixelRect interior = job.grid.interior(setting.job.tile);
    const auto frames = static_cast<std::size_t>(take.frames);
    for (std::size_t i = 0; i < take.keys.size(); ++i) {
        if (i % frames == 0) worker.picture.clear();
        set_frame(take, i, setting.place);
        worker.passes.draw(setting, store, worker.colors);
        store.resolving.start();
        worker.picture.add(job.filter, worker.colors, store.divides, setting.job.rect, interior);
        if (i % frames == frames - 1) worker.mean.add(worker.picture.pixels());
        store.resolving.stop();
    }
}

}  // namespace

void draw_take(const FrameJob& job, std::size_t number, TileSetting& setting, Worker& worker,
               TakeFrame& frame)
{
    const Take& take = job.takes[number];
    const PixelRect interior = job.grid.interior(setting.job.tile);
    worker.mean.clear();
    (take.frames_of_pixels.empty() ? draw_evenly : draw_unevenly)(job, take, setting, worker,
                                                                  worker.stores[number]);
    if (take.apart) {
        write_apart(job.grid, interior, worker.picture, frame);
    } else {
        write_tile(interior, frame.image,
                   [&](std::size_t p, std::size_t c) { return worker.mean.mean(p, c); });
    }
    if (take.variance) {
        write_tile(interior, frame.variance,
                   [&](std::size_t p, std::size_t c) { return worker.mean.variance(p, c); });
    }
    if (take.transparent) {
        write_tile(interior, frame.transparent,
                   [&](std::size_t p, std::size_t c) { return worker.picture.transparent(p)[c]; });
    }
}

}  // namespace sheer
