// sheer render: one picture of a scene by one method.
#include <cmath>
#include <filesystem>
#include <memory>
#include <span>
#include <system_error>

#include <sheer/sheer.h>

#include "cli/commands.h"
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
    bool json = false;
};

// Whatever can be known to be wrong before the scene is read.
void check_request(const RenderRequest& request)
{
    check_view_options(request.given);
    check_makes_picture("--method", request.given.options.method);
    check_image_path(request.output);
    if (!request.stats.empty()) check_writable(request.stats);
    if (!request.channels.empty()) check_channels_path(request.channels);
    std::error_code none;
    const auto same = [&](const std::string& a, const std::string& b) {
        const auto real = [&](const std::string& path) {
            return std::filesystem::weakly_canonical(std::filesystem::absolute(path), none);
        };
        return !a.empty() && !b.empty() && real(a) == real(b);
    };
    if (same(request.stats, request.output) || same(request.stats, request.channels)) {
        throw Error(Fault::input, request.stats + ": is both the picture and its statistics");
    }
    if (same(request.channels, request.output)) {
        throw Error(Fault::input, request.channels + ": is both the picture and its channels");
    }
}

std::string summary(const RenderRequest& request, const Stats& stats)
{
    return one_line(request.output) + ": " + std::to_string(stats.width) + "x" +
           std::to_string(stats.height) + ", " + request.given.options.method + ", " +
           counted(static_cast<std::uint64_t>(stats.samples), "sample") + ", " +
           counted(stats.triangles, "triangle") + ", " + counted(stats.fragments, "fragment") +
           ", " + with_commas(static_cast<std::uint64_t>(std::lround(stats.ms_total))) + " ms\n";
}

Frame render_with_progress(const Scene& scene, const RenderRequest& request)
{
    ProgressBar bar("rendering");
    Options options = request.given.options;
    options.channels = !request.channels.empty();
    options.progress = [&bar](double part) { bar.update(part); };
    return render(scene, request.given.view, options);
}

void run_render(const RenderRequest& request)
{
    check_request(request);
    const Scene scene = load_scene(request.scene, request.given.options.memory_limit);
    Frame frame = render_with_progress(scene, request);
    write_image(request.output, frame.image);
    if (frame.channels) {
        write_channels(request.channels, frame.stats.width, frame.stats.height, *frame.channels);
    }

    frame.stats.peak_memory_bytes = peak_memory_bytes();
    Json stats = stats_json(frame.stats);
    if (!request.stats.empty()) {
        const std::string text = json_text(stats);
        write_whole_file(request.stats, std::as_bytes(std::span(text)));
    }
    stats["image"] = request.output;
    print(request.json ? json_text(stats) : summary(request, frame.stats));
}

void add_own_options(CLI::App& command, RenderRequest& request)
{
    Options& options = request.given.options;
    add_scene_options(command, request.scene);
    add_value(command, "-o,--output", "FILE", "The picture, .exr (linear) or .png (sRGB); required",
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
    const std::string examples = examples_help(
        {"sheer render builtin:windy-hill -o hill.png",
         "sheer render builtin:motor -o blend.png --method blend --size 640x480",
         "sheer render 'builtin:layers?alpha=0.5&depth=1,2' -o layers.exr --samples 1",
         "sheer render builtin:quads -o quads.png --filter gaussian --stats quads.json",
         "sheer render builtin:motor -o noisy.exr --method stochastic --seed 7 --accumulate 16",
         "sheer render builtin:motor -o motor.exr --channels channels.exr --memory-limit 512",
         "sheer render builtin:motor -o side.png --eye 5,3,6 --target 1,0,0 --fov 40",
         "sheer render car.glb -o xray.png --opacity 0.3 --opacity 'Engine*=1'",
         "sheer render tree.obj -o tree.png --mask-as-blend --allow-any-file",
         "sheer render variants.gltf -o second.png --scene 1"});
    command->footer(examples + "\n" + methods_help() + "\n" + scenes_help());
    command->callback([request] { run_render(*request); });
}

}  // namespace sheer
