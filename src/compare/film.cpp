// Frame by frame: the truth, then all methods over the same fragments.
#include "compare/film.h"

#include <utility>

#include "compare/truth.h"
#include "cpu/frame.h"

namespace sheer {

namespace {

struct Shown {
    TemporalAverage average;
    FilmErrors errors = {};
    Image last = {};
};

// Of a frame, the truth's part of the time: 4 passes of 64 samples, and one of few for each method.
constexpr double kTruth = 0.5;

void draw_methods(const Scene& scene, View view, const Options& options, const FilmRequest& request,
                  const FilmTruth& truth, std::span<Shown> shown)
{
    std::size_t i = 0;
    for (const int samples : request.samples) {
        view.samples = samples;
        std::vector<Take> takes;
        for (const std::string& method : request.methods) {
            takes.push_back({.method = choose_method(method),
                             .keys = {frame_key(options.seed, options.frame)},
                             .film = {options.frame, options.period}});
        }
        FrameTakes drawn = render_takes(scene, view, options, {.takes = takes});
        for (TakeFrame& frame : drawn.frames) {
            shown[i].last = shown[i].average.add(std::move(frame.image));
            shown[i].errors.add(shown[i].last, truth);
            ++i;
        }
    }
}

}  // namespace

std::vector<Filmed> film_methods(const Scene& first, const Options& options,
                                 const FilmRequest& request)
{
    const std::size_t count = request.methods.size() * request.samples.size();
    std::vector<Shown> shown(count, Shown{TemporalAverage(request.taa)});
    FilmTruth truth;
    const double frames = request.last - request.first + 1;
    for (int frame = request.first; frame <= request.last; ++frame) {
        Options of_frame = options;
        of_frame.frame = frame;
        of_frame.period = request.taa.period;
        const double done = (frame - request.first) / frames;
        const auto report = [&](double from, double to) {
            if (!options.progress) return;
            of_frame.progress = [&options, done, frames, from, to](double part) {
                options.progress(done + (from + part * (to - from)) / frames);
            };
        };
        Scene moved;
        if (request.scene) moved = request.scene(frame);
        const Scene& scene = request.scene ? moved : first;
        View view = request.view(frame);
        view.sample_shift = {};
        report(0, kTruth);
        truth.add(render_truth(scene, view, of_frame));
        if (request.taa.kind != TemporalAntialiasing::Kind::none) {
            view.sample_shift = sample_shift(request.taa.period, frame);
        }
        report(kTruth, 1);
        draw_methods(scene, view, of_frame, request, truth, shown);
    }
    std::vector<Filmed> result;
    for (Shown& one : shown) result.push_back({one.errors.scores(), std::move(one.last)});
    return result;
}

}  // namespace sheer
