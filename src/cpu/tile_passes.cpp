// Streams, passes and halves.
#include "cpu/tile_passes.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <sheer/error.h>

namespace sheer {

namespace {

// What is behind everything transparent.
void fill_backdrop(const OpaqueTile& opaque, const TileSetting& setting, const PixelRect& region,
                   SampleColors& colors)
{
    const auto samples = static_cast<std::size_t>(colors.samples);
    const PixelRect& rect = setting.job.rect;
    const auto pixel_at = [&](int x, int y) {
        return static_cast<std::size_t>((y - rect.y0) * kTileSize + x - rect.x0);
    };
    // The background: the first row, and that row's copies.
    float* first_row = colors.channel(pixel_at(region.x0, region.y0), 0);
    float* end = first_row;
    for (int x = region.x0; x < region.x1; ++x) {
        for (const float channel : setting.background) end = std::fill_n(end, samples, channel);
    }
    for (int y = region.y0 + 1; y < region.y1; ++y) {
        std::copy(first_row, end, colors.channel(pixel_at(region.x0, y), 0));
    }
    if (!opaque.any) return;

    const float* channels[3] = {opaque.red.data(), opaque.green.data(), opaque.blue.data()};
    const auto cover_pixel = [&](std::size_t pixel) {
        for (std::size_t s = 0; s < samples; ++s) {
            const std::size_t at = pixel * samples + s;
            if (opaque.depth[at] == std::numeric_limits<float>::infinity()) continue;
            for (std::size_t c = 0; c < 3; ++c) colors.channel(pixel, c)[s] = channels[c][at];
            colors.channel(pixel, 3)[s] = 1.0f;
        }
    };
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) cover_pixel(pixel_at(x, y));
    }
}

// Leaves the fragments of the chosen pixels.
void keep_pixels(FragmentStream& s, const std::vector<char>& chosen)
{
    std::uint32_t kept = 0;
    int runs = 0;
    for (int r = 0; r < s.run_count; ++r) {
        FragmentRun run = s.runs[r];
        const std::uint32_t first = kept;
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
            if (chosen[s.pixel[i]] != 0) s.move(kept++, i);
        }
        run.first = first;
        run.count = kept - first;
        if (run.count > 0) s.runs[runs++] = run;
    }
    s.run_count = runs;
    s.size = static_cast<int>(kept);
}

std::pair<PixelRect, PixelRect> halves(const PixelRect& r)
{
    const int width = r.x1 - r.x0, height = r.y1 - r.y0;
    if (width == 1 && height == 1) {
        throw Error(Fault::work, "memory-limit: too low for all fragments of pixel " +
                                     std::to_string(r.x0) + "," + std::to_string(r.y0));
    }
    PixelRect first = r, second = r;
    if (width > height) {
        first.x1 = second.x0 = r.x0 + width / 2;
    } else {
        first.y1 = second.y0 = r.y0 + height / 2;
    }
    return {first, second};
}

}  // namespace

TilePasses::TilePasses(TileFragmentsFunction fragments, OpaqueTile opaque, FragmentStream stream)
    : fragments_(fragments), opaque_(std::move(opaque)), stream_(std::move(stream))
{
}

void TilePasses::keep(const TileSetting& setting)
{
    const FragmentWants& wants = setting.job.wants;
    auto entry = std::find_if(keeping_.begin(), keeping_.end(),
                              [&](const auto& of) { return of.first == wants; });
    if (entry == keeping_.end()) entry = keeping_.insert(entry, {wants, {}});
    Stopwatch& watch = entry->second;
    watch.start();
    bool fits = true;
    const FragmentConsumer too_long{[](void* context, const FragmentStream&) {
                                        *static_cast<bool*>(context) = false;
                                        return false;
                                    },
                                    &fits};
    kept_ = fragments_(setting.job, scratch_, opaque_, stream_, too_long) && fits;
    watch.stop();
}

double TilePasses::ms_keeping(const FragmentWants& wants) const
{
    for (const auto& [of, watch] : keeping_) {
        if (of == wants) return watch.ms();
    }
    return 0;
}

void TilePasses::restrict_to(const std::vector<char>* chosen)
{
    chosen_ = chosen;
    if (kept_ && chosen_ != nullptr) keep_pixels(stream_, *chosen_);
}

void TilePasses::draw(const TileSetting& setting, TileStore& store, SampleColors& colors)
{
    draw_region(setting, setting.job.rect, store, colors);
}

// True: the store has all fragments of the region.
bool TilePasses::feed(const TileSetting& setting, const PixelRect& region, TileStore& store)
{
    std::uint64_t fragments = 0;
    const auto done = [&] {
        return store.verbs->done != nullptr && store.verbs->done(store.store.get());
    };
    // Of several passes each begins with nothing kept, and needs all.
    const float* hidden_behind = nullptr;
    if (store.storing.size() == 1 && store.verbs->hidden_behind != nullptr) {
        hidden_behind = store.verbs->hidden_behind(store.store.get());
    }
    for (std::size_t p = 0; p < store.storing.size() && (p == 0 || !done()); ++p) {
        const int pass = static_cast<int>(p);
        Stopwatch& storing = store.storing[p];
        fragments = 0;
        if (kept_) {
            storing.start();
            const bool held =
                stream_.size == 0 || store.verbs->insert(store.store.get(), stream_, pass);
            storing.stop();
            if (!held) return false;
            fragments = static_cast<std::uint64_t>(stream_.size);
            continue;
        }
        TileJob job = setting.job;
        job.region = region;
        store.raster_shade.start();
        const bool held = rasterise(job, hidden_behind, [&](const FragmentStream& stream) {
            if (chosen_ != nullptr) keep_pixels(stream_, *chosen_);
            store.raster_shade.stop();
            storing.start();
            const bool more = store.verbs->insert(store.store.get(), stream, pass);
            storing.stop();
            store.raster_shade.start();
            fragments += static_cast<std::uint64_t>(stream.size);
            return more;
        });
        store.raster_shade.stop();
        if (!held) return false;
        fragments += scratch_.hidden;
    }
    store.fragments += fragments;
    return true;
}

void TilePasses::draw_region(const TileSetting& setting, const PixelRect& region, TileStore& store,
                             SampleColors& colors)
{
    store.storing[0].start();
    store.verbs->clear(store.store.get(), setting.place);
    store.storing[0].stop();
    if (feed(setting, region, store)) {
        resolve(setting, region, store, colors);
        return;
    }
    kept_ = false;
    const auto [first, second] = halves(region);
    draw_region(setting, first, store, colors);
    draw_region(setting, second, store, colors);
}

// Outside the region the store is clear and leaves the colours as they are.
void TilePasses::resolve(const TileSetting& setting, const PixelRect& region, TileStore& store,
                         SampleColors& colors)
{
    store.resolving.start();
    fill_backdrop(opaque_, setting, region, colors);
    store.verbs->resolve(store.store.get(), colors);
    store.resolving.stop();
}

}  // namespace sheer
