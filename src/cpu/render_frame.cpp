// One picture from as many frames as it takes.
#include <algorithm>
#include <utility>

#include <sheer/error.h>

#include "cpu/adaptive_frames.h"
#include "cpu/frame.h"
#include "cpu/frame_sums.h"
#include "cpu/frame_stats.h"
#include "cpu/post_filter.h"
#include "support/memory.h"

namespace sheer {

namespace {

// Of all frames of a film, the number of the picture's first. Adaptive ones are as many as asked
// for.
std::int64_t first_frame(const Options& options)
{
    const bool adapts = options.adaptive.noise_target > 0 || options.adaptive.budget > 0;
    const int of_picture = adapts ? options.adaptive.most : options.accumulate;
    return std::int64_t{options.frame} * of_picture;
}

// Without frames yet.
Take make_take(const Options& options)
{
    Take take{.method = choose_method(options.method), .keys = {}};
    take.transparent = options.post_filter.cross_bilateral;
    take.film = {first_frame(options), options.period};
    if (take.transparent && !take.method.traits().divides) {
        throw Error(Fault::input,
                    "post filter: it is for colours that are corrected by total alpha, as "
                    "those of stochastic:correction=on; " +
                        options.method + "'s are not");
    }
    return take;
}

// The take's frames, all with the same shadows, as pictures.
Frame draw_frames(const Scene& scene, const View& view, const Options& options, Take take)
{
    for (int i = 0; i < take.frames; ++i)
        take.keys.push_back(frame_key(options.seed, take.film.number + i));
    FrameTakes result = render_takes(scene, view, options, {.takes = {&take, 1}});
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
    Stats pilots;
    take.frames_of_pixels = plan_frames(scene, view, options, pilots);
    take.frames = *std::max_element(take.frames_of_pixels.begin(), take.frames_of_pixels.end());
    Frame frame = draw_frames(scene, view, options, std::move(take));
    frame.stats.frames_per_pixel += kPilotFrames;
    add_times(pilots, frame.stats);
    return frame;
}

// Fragments are shaded once for all frames, so frames with random shadows or rays of their own are
// drawn one by one.
bool is_lit_at_random(const View& view)
{
    const AmbientOcclusion& occlusion = view.ambient_occlusion;
    return view.shadows.kind == ShadowKind::stochastic ||
           (occlusion.rays > 0 && occlusion.samples == RaySamples::random);
}

Frame draw_one_by_one(const Scene& scene, const View& view, const Options& options)
{
    const Take prepared = make_take(options);
    const std::uint64_t sums_bytes = FrameSums::bytes(view, prepared.method.traits().divides);
    Frame all;
    FrameSums sums;
    for (int i = 0; i < options.accumulate; ++i) {
        Options one = options;
        one.channels = options.channels && i == 0;
        one.progress = [&, i](double part) {
            if (options.progress) options.progress((i + part) / options.accumulate);
        };
        Take take = prepared;
        take.film.number += i;
        take.keys = {frame_key(options.seed, take.film.number)};
        take.alone = {frame_key(options.seed, prepared.film.number), i, options.accumulate};
        take.transparent = false;
        take.apart = true;
        FrameTakes result =
            render_takes(scene, view, one, {{&take, 1}, {}, sums_bytes, i, options.accumulate});
        TakeFrame& frame = result.frames.front();
        sums.add(frame);
        if (i == 0) {
            if (result.channels) result.channels->frames = frames_channel(take, view);
            all = {std::move(frame.image), std::move(frame.stats), std::move(result.channels)};
        } else {
            add_times(frame.stats, all.stats);
        }
    }
    all.stats.frames_per_pixel = options.accumulate;
    Image transparent;
    sums.finish(all.image, transparent);
    if (prepared.transparent) {
        apply_post_filter(options.post_filter, transparent, options.threads, all.image);
    }
    return all;
}

}  // namespace

Frame render_frame(const Scene& scene, const View& view, const Options& options)
{
    Take take = make_take(options);
    const MethodTraits traits = take.method.traits();
    const bool adapts = options.adaptive.noise_target > 0 || options.adaptive.budget > 0;
    const auto draw = [&] {
        if (traits.random && adapts) return draw_adaptively(scene, view, options);
        if (is_lit_at_random(view) && options.accumulate > 1) {
            return draw_one_by_one(scene, view, options);
        }
        if (traits.random || traits.by_frame) take.frames = options.accumulate;
        return draw_frames(scene, view, options, std::move(take));
    };
    Frame frame = draw();
    if (options.memory_limit != 0) release_free_memory();
    return frame;
}

}  // namespace sheer
