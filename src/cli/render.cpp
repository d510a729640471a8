// sheer render: one picture of a scene by one method, or one after the other.
#include <cmath>
#include <filesystem>
#include <memory>
#include <span>
#include <system_error>

#include <sheer/sheer.h>

#include "cli/commands.h"
#include "cli/film_options.h"
#include "cli/help_text.h"
#include "cli/noise_options.h"
#include "cli/scene_options.h"
#include "cli/stats_json.h"
#include "cli/values.h"
#include "cli/view_options.h"
#include "image/write_channels.h"
#include "image/write_image.h"
#include "support/memory.h"
#include "support/progress.h"
#include "support/whole_file.h"

namespace sheer {

namespace {

struct RenderRequest {
    SceneOptions scene;
    std::string output;
    std::string stats;
    std::string channels;
    ViewOptions given;
    FilmOptions film;
    bool json = false;

    FrameRange frames() const
    {
        return film.frames.value_or(FrameRange{given.options.frame, given.options.frame});
    }
};

struct Files {
    std::string picture, channels;
};

Files files_of(const RenderRequest& request, int frame)
{
    Files files{request.output, request.channels};
    if (!request.film.frames) return files;
    files.picture = name_of_frame("--output", files.picture, frame);
    if (!files.channels.empty())
        files.channels = name_of_frame("--channels", files.channels, frame);
    return files;
}

// Which must all be different, but for those that are not wanted.
void check_different(const std::string& stats, const Files& files)
{
    std::error_code none;
    const auto same = [&](const std::string& a, const std::string& b) {
        const auto real = [&](const std::string& path) {
            return std::filesystem::weakly_canonical(std::filesystem::absolute(path), none);
        };
        return !a.empty() && !b.empty() && real(a) == real(b);
    };
    if (same(stats, files.picture) || same(stats, files.channels)) {
        throw Error(Fault::input, stats + ": is both the picture and its statistics");
    }
    if (same(files.channels, files.picture)) {
        throw Error(Fault::input, files.channels + ": is both the picture and its channels");
    }
}

// Whatever can be known to be wrong before the scene is read.
void check_request(const RenderRequest& request)
{
    check_view_options(request.given);
    check_makes_picture("--method", request.given.options.method);
    if (!request.stats.empty()) check_writable(request.stats);
    for (const int frame : {request.frames().first, request.frames().last}) {
        const Files files = files_of(request, frame);
        check_image_path(files.picture);
        if (!files.channels.empty()) check_channels_path(files.channels);
        check_different(request.stats, files);
    }
}

std::string summary(const RenderRequest& request, const Stats& stats, double ms)
{
    const std::string frames =
        request.film.frames
            ? counted(static_cast<std::uint64_t>(request.frames().count()), "frame") + ", "
            : "";
    return one_line(request.output) + ": " + frames + std::to_string(stats.width) + "x" +
           std::to_string(stats.height) + ", " + request.given.options.method + ", " +
           counted(static_cast<std::uint64_t>(stats.samples), "sample") + ", " +
           counted(stats.triangles, "triangle") + ", " + counted(stats.fragments, "fragment") +
           ", " + with_commas(static_cast<std::uint64_t>(std::lround(ms))) + " ms\n";
}

// Draws a frame and writes its files; what is known of it.
Stats draw_frame(const Scene& scene, const RenderRequest& request, int number,
                 TemporalAverage& average, ProgressBar& bar)
{
    const FrameRange frames = request.frames();
    Options options = options_of_frame(request.given.options, request.film, number);
    options.channels = !request.channels.empty();
    options.progress = [&](double part) {
        bar.update((number - frames.first + part) / frames.count());
    };
    const View view = view_of_frame(scene, request.given.view, request.film, number);
    Frame frame = render(scene, view, options);
    const Files files = files_of(request, number);
    write_image(files.picture, average.add(std::move(frame.image)));
    if (frame.channels) {
        write_channels(files.channels, frame.stats.width, frame.stats.height, *frame.channels);
    }
    frame.stats.peak_memory_bytes = peak_memory_bytes();
    return frame.stats;
}

// Of one picture its own; of a film, a list of theirs.
Json stats_of(const RenderRequest& request, const std::vector<Stats>& frames, bool with_images)
{
    Json list = Json::array();
    for (const Stats& stats : frames) {
        const int number = request.frames().first + static_cast<int>(list.size());
        Json json = request.film.frames ? Json{{"frame", number}} : Json::object();
        json.update(stats_json(stats));
        if (with_images) json["image"] = files_of(request, number).picture;
        list.push_back(std::move(json));
    }
    return request.film.frames ? Json{{"frames", list}} : list.front();
}

// Of a path that a file gives, before any frame is drawn.
void check_path(const Scene& scene, const RenderRequest& request)
{
    const FrameRange frames = request.frames();
    for (int i = frames.first; !request.film.path.keys.empty() && i <= frames.last; ++i) {
        view_of_frame(scene, request.given.view, request.film.path, i);
    }
}

void run_render(RenderRequest request)
{
    check_request(request);
    const std::uint64_t limit = request.given.options.memory_limit;
    const FrameRange range = request.frames();
    Scene scene = scene_of_frame(request.scene, request.film, range.first, limit);
    request.given.view =
        view_of_film(request.scene, request.film, request.given.view, scene, range.first, limit);
    check_path(scene, request);
    std::vector<Stats> frames;
    double ms = 0;
    {
        ProgressBar bar("rendering");
        TemporalAverage average(request.film.taa);
        for (int i = range.first; i <= range.last; ++i) {
            if (request.film.fps && i > range.first) {
                scene = scene_of_frame(request.scene, request.film, i, limit);
            }
            frames.push_back(draw_frame(scene, request, i, average, bar));
            ms += frames.back().ms_total;
        }
    }
    if (!request.stats.empty()) {
        const std::string text =
            json_text(stats_of(request, frames, request.film.frames.has_value()));
        write_whole_file(request.stats, std::as_bytes(std::span(text)));
    }
    print(request.json ? json_text(stats_of(request, frames, true))
                       : summary(request, frames.back(), ms));
}

void add_own_options(CLI::App& command, RenderRequest& request)
{
    Options& options = request.given.options;
    add_scene_options(command, request.scene);
    add_value(command, "-o,--output", "FILE",
              "The picture, .exr (linear) or .png (sRGB); required; with\n"
              "--frames name.####.png, the #s each frame's number",
              [&request](auto&, auto& text) { request.output = text; })
        ->required();
    add_value(command, "--method", "ID[:NAME=VALUE]...",
              "How transparency is drawn (" + options.method + ")",
              [&options](auto&, auto& text) { options.method = text; });
    add_value(command, "--samples", "S", "Samples a pixel: 1, 2, 4, 8, 16, 32 or 64 (8)",
              [&request](auto& option, auto& text) {
                  request.given.view.samples = parse_whole(option, text, 1, 64);
              });
    add_seed(command, options);
    add_noise_options(command, options);
    add_value(command, "--backend", "cpu", "Where it runs (cpu)", [](auto& option, auto& text) {
        parse_choice(option, text, std::array<std::pair<const char*, int>, 1>{{{"cpu", 0}}});
    });
    add_value(command, "--stats", "FILE", "Counts, times and memory as JSON",
              [&request](auto&, auto& text) { request.stats = text; });
    add_value(command, "--channels", "FILE",
              "Fragments, depth complexity, coverage and depth of the\n"
              "transparent surfaces, frames averaged, .exr",
              [&request](auto&, auto& text) { request.channels = text; });
    command.add_flag("--json", request.json, "Print those instead of a line of text")
        ->disable_flag_override();
}

}  // namespace

void add_render_command(CLI::App& tool)
{
    CLI::App* command = tool.add_subcommand("render", "Draw a picture of a scene");
    const auto request = std::make_shared<RenderRequest>();
    add_own_options(*command, *request);
    add_override_options(*command, request->scene);
    add_view_options(*command, request->given);
    add_film_options(*command, request->film);
    const std::string examples = examples_help(
        {"sheer render builtin:windy-hill -o hill.png",
         "sheer render builtin:motor -o blend.png --method blend --size 640x480",
         "sheer render 'builtin:layers?alpha=0.5&depth=1,2' -o layers.exr --samples 1",
         "sheer render builtin:quads -o quads.png --filter gaussian --stats quads.json",
         "sheer render builtin:motor -o noisy.exr --method stochastic --seed 7 --accumulate 16",
         "sheer render builtin:motor -o motor.exr --channels channels.exr --memory-limit 512",
         "sheer render builtin:motor -o side.png --eye 5,3,6 --target 1,0,0 --fov 40",
         "sheer render tree.glb -o around.###.png --frames 0..119 --orbit 360 --size 640x480",
         "sheer render car.glb -o xray.png --opacity 0.3 --opacity 'Engine*=1'",
         "sheer render tree.obj -o tree.png --mask-as-blend --allow-any-file",
         "sheer render variants.gltf -o second.png --scene 1"});
    command->footer(examples + "\n" + methods_help() + "\n" + scenes_help());
    command->callback([request] { run_render(*request); });
}

}  // namespace sheer
