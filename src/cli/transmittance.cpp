// sheer transmittance: what light passes through a pixel, and what methods take that for.
#include <algorithm>
#include <bit>
#include <charconv>
#include <filesystem>
#include <memory>
#include <span>

#include <sheer/sheer.h>

#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/output.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/view_options.h"
#include "compare/depth_chart.h"
#include "compare/depth_functions.h"
#include "cpu/frame.h"
#include "support/whole_file.h"

namespace sheer {

namespace {

struct TransmittanceRequest {
    SceneOptions scene;
    std::string output;
    ViewOptions given;
    std::vector<std::string> methods;
    int x = 0, y = 0;
};

std::string pixel_text(const TransmittanceRequest& request)
{
    return std::to_string(request.x) + "," + std::to_string(request.y);
}

void parse_pixel(const std::string& option, const std::string& text, TransmittanceRequest& request)
{
    constexpr int kMost = 1 << 20;
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() != 2) throw Error(Fault::input, option + ": '" + text + "' is no pixel X,Y");
    request.x = parse_whole(option, parts[0], 0, kMost);
    request.y = parse_whole(option, parts[1], 0, kMost);
}

bool is_json(const TransmittanceRequest& request)
{
    const std::string suffix = std::filesystem::path(request.output).extension().string();
    if (suffix != ".svg" && suffix != ".json") {
        throw Error(Fault::input, request.output + ": the name must end in .svg or .json");
    }
    return suffix == ".json";
}

void check_methods(TransmittanceRequest& request, const DepthFunctionSetting& setting)
{
    const std::vector<std::string> known = methods_with_depth_functions(setting);
    if (request.methods.empty()) request.methods = known;
    for (const std::string& text : request.methods) {
        check_makes_picture("--methods", text);
        const ChosenMethod method = choose_method(text);
        check_option("--methods", [&] { check_method(method, setting.samples.count); });
        if (keeps_depth_function(method, setting)) continue;
        std::string ids;
        for (const std::string& id : known) ids += id + ", ";
        throw Error(Fault::input, "--methods: '" + text +
                                      "' keeps no function of depth; these do: " + ids +
                                      "stochastic:depth-based=on, slab:depth-based=on");
    }
}

PixelFragments fragments_of(const Scene& scene, const TransmittanceRequest& request)
{
    PixelFragments pixel(request.x, request.y);
    const PixelRect only{request.x, request.y, request.x + 1, request.y + 1};
    render_takes(scene, request.given.view, request.given.options,
                 {.takes = {}, .sink = &pixel, .only = &only});
    if (pixel.fragments.empty()) {
        throw Error(Fault::input,
                    "--pixel: there is nothing transparent in pixel " + pixel_text(request));
    }
    return pixel;
}

// The functions at the same distances.
struct Functions {
    std::vector<TransmittanceStep> steps;
    std::vector<double> distances;
    std::vector<DepthCurve> curves;  // the true one, then the methods'
};

Functions functions_of(const PixelFragments& pixel, const TransmittanceRequest& request,
                       const DepthFunctionSetting& setting)
{
    Functions result;
    result.steps = transmittance_steps(pixel.fragments, setting.samples);
    const std::vector<float> depths = depths_to_ask(result.steps, pixel.eye);
    DepthCurve truth{"true", {}};
    for (const float depth : depths) {
        result.distances.push_back(distance_of(depth, pixel.eye));
        truth.values.push_back(transmittance_at(result.steps, depth));
    }
    result.curves.push_back(std::move(truth));
    for (const std::string& method : request.methods) {
        result.curves.push_back(
            {method, depth_function(choose_method(method), pixel, depths, setting)});
    }
    return result;
}

Json functions_json(const TransmittanceRequest& request, const PixelFragments& pixel,
                    const Functions& functions)
{
    std::vector<PixelFragment> sorted = pixel.fragments;
    const auto center = [](const PixelFragment& f) {
        return std::clamp(f.depth, f.run.depth.least, f.run.depth.most);
    };
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const auto& a, const auto& b) { return center(a) < center(b); });
    const int samples = request.given.view.samples;
    Json fragments = Json::array(), steps = Json::array(), methods = Json::array();
    for (const PixelFragment& f : sorted) {
        fragments.push_back({{"distance", distance_of(center(f), pixel.eye)},
                             {"opacity", f.opacity},
                             {"coverage", std::popcount(f.samples) / double(samples)}});
    }
    for (const TransmittanceStep& step : functions.steps) {
        steps.push_back(
            {{"distance", distance_of(step.depth, pixel.eye)}, {"behind", step.behind}});
    }
    for (std::size_t i = 1; i < functions.curves.size(); ++i) {
        methods.push_back(
            {{"method", functions.curves[i].title}, {"transmittance", functions.curves[i].values}});
    }
    return {{"scene", request.scene.source},
            {"pixel", {request.x, request.y}},
            {"samples", samples},
            {"fragments", std::move(fragments)},
            {"steps", std::move(steps)},
            {"distances", functions.distances},
            {"true", functions.curves.front().values},
            {"methods", std::move(methods)}};
}

void run_transmittance(TransmittanceRequest request)
{
    check_view_options(request.given);
    const bool as_json = is_json(request);
    check_writable(request.output);
    const View& view = request.given.view;
    if (request.x >= view.width || request.y >= view.height) {
        throw Error(Fault::input, "--pixel: " + pixel_text(request) + " is outside of " +
                                      size_text(view.width, view.height));
    }
    const Options& options = request.given.options;
    const SampleSet samples = make_sample_set(view.samples, view.positions);
    const DepthFunctionSetting setting{samples, targets_of(options.simd),
                                       frame_key(options.seed, 0)};
    check_methods(request, setting);
    const Scene scene = load_scene(request.scene, options.memory_limit);
    const PixelFragments pixel = fragments_of(scene, request);
    const Functions functions = functions_of(pixel, request, setting);
    const std::string text =
        as_json ? json_text(functions_json(request, pixel, functions))
                : depth_chart("Pixel " + pixel_text(request) + " of " + request.scene.source,
                              functions.distances, functions.curves);
    write_whole_file(request.output, std::as_bytes(std::span(text)));
    print(one_line(request.output) + ": pixel " + pixel_text(request) + ", " +
          counted(pixel.fragments.size(), "fragment") + ", " +
          counted(request.methods.size(), "method") + "\n");
}

void add_own_options(CLI::App& command, TransmittanceRequest& request)
{
    add_scene_options(command, request.scene);
    add_value(command, "--pixel", "X,Y", "From the picture's top left corner, from 0; required",
              [&request](auto& option, auto& text) { parse_pixel(option, text, request); })
        ->required();
    add_value(command, "-o,--output", "FILE", "A chart, .svg, or all numbers, .json; required",
              [&request](auto&, auto& text) { request.output = text; })
        ->required();
    add_value(command, "--methods", "ID[:NAME=VALUE]...,...",
              "With commas, methods that keep a function of depth (all\nthat are not random)",
              [&request](auto&, auto& text) { request.methods = split(text, ','); });
    add_value(command, "--samples", "S",
              "Samples a pixel: 1, 2, 4, 8, 16, 32 or 64; functions are\ntheir means (8)",
              [&request](auto& option, auto& text) {
                  request.given.view.samples = parse_whole(option, text, 1, 64);
              });
    add_seed(command, request.given.options);
}

}  // namespace

void add_transmittance_command(CLI::App& tool)
{
    CLI::App* command = tool.add_subcommand(
        "transmittance", "Chart what passes through a pixel, and what methods take that for");
    const auto request = std::make_shared<TransmittanceRequest>();
    add_own_options(*command, *request);
    add_override_options(*command, request->scene);
    add_view_options(*command, request->given);
    const std::string examples = examples_help(
        {"sheer transmittance builtin:smoke --pixel 512,384 -o smoke.svg",
         "sheer transmittance builtin:hair --pixel 500,300 --samples 1 -o hair.svg",
         "sheer transmittance scene.glb --pixel 10,20 -o p.json --methods moment,mboit:moments=8"});
    command->footer(
        "The true function is that of the fragments, sorted: 1 before the nearest, and behind "
        "each\n"
        "the part that it and all before it let through. A method's is what it multiplies a\n"
        "fragment's colour with at that depth, before its sum is scaled to the total alpha.\n\n" +
        examples + "\n" + methods_help() + "\n" + scenes_help());
    command->callback([request] { run_transmittance(*request); });
}

}  // namespace sheer
