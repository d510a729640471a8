// One picture from as many frames as it takes.
#include <algorithm>
#include <utility>

#include <sheer/error.h>

#include "cpu/adaptive_frames.h"
#include "cpu/frame.h"
#include "cpu/frame_stats.h"
#include "cpu/post_filter.h"
#include "cpu/tile_mean.h"
#include "support/memory.h"

namespace sheer {

namespace {

// Without frames yet.
Take make_take(const Options& options)
{
    Take take{.method = choose_method(options.method), .keys = {}};
    take.transparent = options.post_filter.cross_bilateral;
    if (take.transparent && !take.method.traits().divides) {
        throw Error(Fault::input, "post filter: it needs the total alpha, which " + options.method +
                                      " does not keep; stochastic:correction=on does");
    }
    return take;
}

// The take's frames, which begin with number `first` of the seed's sequence.
Frame draw_frames(const Scene& scene, const View& view, const Options& options, Take take,
                  int first)
{
    for (int i = 0; i < take.frames; ++i) take.keys.push_back(frame_key(options.seed, first + i));
    FrameTakes result =
        render_takes(scene, view, options, {.takes = {&take, 1}, .shadow_frame = first});
    TakeFrame& frame = result.frames.front();
    if (take.transparent) {
        apply_post_filter(options.post_filter, frame.transparent, options.threads, frame.image);
    }
    frame.stats.frames_per_pixel = mean_frames(take);
    if (result.channels) result.channels->frames = frames_channel(take, view);
    return {std::move(frame.image), std::move(frame.stats), std::move(result.channels)};
}

Frame draw_adaptively(const Scene& scene, const View& view, const Options& options)
{
    Take take = make_take(options);
    take.frames_of_pixels = plan_frames(scene, view, options);
    take.frames = *std::max_element(take.frames_of_pixels.begin(), take.frames_of_pixels.end());
    Frame frame = draw_frames(scene, view, options, std::move(take), 0);
    frame.stats.frames_per_pixel += kPilotFrames;
    return frame;
}

// Fragments are shaded once for all frames, so frames with random shadows of their own are drawn
// one by one.
Frame draw_one_by_one(const Scene& scene, const View& view, const Options& options)
{
    Frame all;
    TileMean<4> mean;
    for (int i = 0; i < options.accumulate; ++i) {
        Options one = options;
        one.channels = options.channels && i == 0;
        one.progress = [&, i](double part) {
            if (options.progress) options.progress((i + part) / options.accumulate);
        };
        Frame frame = draw_frames(scene, view, one, make_take(one), i);
        mean.add(frame.image.pixels);
        if (i == 0) {
            all = std::move(frame);
        } else {
            add_times(frame.stats, all.stats);
        }
    }
    all.stats.frames_per_pixel = options.accumulate;
    for (std::size_t i = 0; i < mean.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) all.image.pixels[i][c] = mean.mean(i, c);
    }
    return all;
}

}  // namespace

Frame render_frame(const Scene& scene, const View& view, const Options& options)
{
    Take take = make_take(options);
    const bool random = take.method.row->random;
    const bool adapts = options.adaptive.noise_target > 0 || options.adaptive.budget > 0;
    const auto draw = [&] {
        if (random && adapts) return draw_adaptively(scene, view, options);
        if (view.shadows.kind == ShadowKind::stochastic && options.accumulate > 1) {
            return draw_one_by_one(scene, view, options);
        }
        if (random) take.frames = options.accumulate;
        return draw_frames(scene, view, options, std::move(take), 0);
    };
    Frame frame = draw();
    if (options.memory_limit != 0) release_free_memory();
    return frame;
}

}  // namespace sheer
