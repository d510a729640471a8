// sheer bench: the methods' times on one scene, measured in turns.
#include "cli/bench.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>

#include <sheer/sheer.h>

#include "cli/bench_over.h"
#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/method_lists.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/view_options.h"
#include "compare/scaling.h"
#include "methods/method.h"
#include "support/progress.h"
#include "support/text.h"

namespace sheer {

namespace {

struct BenchRequest {
    SceneOptions scene;
    ViewOptions given;
    std::vector<std::string> methods;
    std::vector<int> samples = {8};
    std::optional<Over> over;
    int repeat = 11;
    bool json = false;
};

std::vector<Setting> settings_of(const BenchRequest& request, const CLI::App& command)
{
    if (request.over) {
        return settings_over(*request.over, request.given, request.samples, command);
    }
    std::vector<Setting> settings;
    for (const int samples : request.samples) {
        settings.push_back({.given = request.given});
        settings.back().given.view.samples = samples;
    }
    return settings;
}

// Methods take turns at each setting, one setting after the other.
std::vector<Timing> measure(const BenchRequest& request, const std::vector<Setting>& settings,
                            Scene& scene)
{
    const std::vector<Object> once = scene.objects;
    const bool masks = std::ranges::any_of(request.methods, tests_masks);
    if (settings.back().layers > 1 &&
        repeat_transparent(scene, settings.back().layers, masks).size() == once.size()) {
        throw Error(Fault::input, "--over layers: nothing in the scene is transparent");
    }
    std::vector<Timing> timings;
    ProgressBar bar("measuring");
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const auto progress = [&](double part) {
            bar.update((static_cast<double>(i) + part) / static_cast<double>(settings.size()));
        };
        scene.objects = once;
        scene.objects = repeat_transparent(scene, settings[i].layers, masks);
        const Turns turns = take_turns(scene, settings[i].given.view, settings[i].given.options,
                                       {request.methods, request.repeat, progress});
        std::ranges::copy(time_methods(turns), std::back_inserter(timings));
    }
    return timings;
}

void print_tables(const BenchRequest& request, const std::vector<Setting>& settings,
                  const std::vector<Timing>& timings)
{
    const std::string rounds =
        "medians of " + counted(static_cast<std::uint64_t>(request.repeat), "round") + "\n\n";
    const std::string source = one_line(request.scene.source) + ": ";
    if (request.over) {
        print(source + rounds +
              scaling_table({request.over->axis, settings, timings, request.methods}));
        return;
    }
    const Timing& first = timings.front();
    const Stats& any = first.stats;
    print(source + size_text(any.width, any.height) + ", " + counted(any.triangles, "triangle") +
          ", " + counted(first.fragments, "fragment") + ", " + rounds +
          bench_table(timings, request.methods));
}

void run_bench(const BenchRequest& request, const CLI::App& command)
{
    const std::vector<Setting> settings = settings_of(request, command);
    for (const Setting& setting : settings) check_view_options(setting.given);
    for (const std::string& method : request.methods) {
        check_option("--methods", [&] { return choose_method(method); });
    }
    Scene scene = load_scene(request.scene, request.given.options.memory_limit);
    const std::vector<Timing> timings = measure(request, settings, scene);
    if (!request.json) {
        print_tables(request, settings, timings);
        return;
    }
    Json json = {{"scene", request.scene.source}, {"results", bench_rows(timings)}};
    if (request.over) {
        json["scaling"] = scaling_json({request.over->axis, settings, timings, request.methods});
        for (std::size_t i = 0; i < timings.size(); ++i) {
            json["results"][i]["layers"] = settings[i / request.methods.size()].layers;
        }
    }
    print(json_text(json));
}

void add_own_options(CLI::App& command, BenchRequest& request)
{
    add_scene_options(command, request.scene);
    add_methods_list(command, request.methods, MethodsFor::bench);
    add_samples_list(command, request.samples);
    add_value(command, "--over", "AXIS[=VALUE,...]",
              "Measure while one thing grows: threads, size, samples,\n"
              "layers (what is transparent is drawn 1, 2, 4, 8 times);\n"
              "how times grow with it is fitted",
              [&request](auto& option, auto& text) { request.over = parse_over(option, text); });
    add_value(command, "--repeat", "N", "Rounds, after one that isn't measured (11)",
              [&request](auto& option, auto& text) {
                  request.repeat = parse_whole(option, text, 1, 10'000);
              });
    command.add_flag("--json", request.json, "Print the results for programs, not a table")
        ->disable_flag_override();
}

constexpr const char* kBenchMeaning =
    "Every round runs each method once; the numbers are medians over the rounds. Nanoseconds are\n"
    "those of one thread: time x threads / count. 'x blend': total time over that of the method\n"
    "'blend' in the same round, which runs for this even if it is not listed. 'x base': total "
    "time\n"
    "over the time of one blended pass over the visible transparent geometry with full shading,\n"
    "which is that of 'blend' without shadow maps, the final resolve, and what opaque surfaces\n"
    "alone take in the same round. Base of table 1 of Enderton et al., Stochastic Transparency.\n"
    "With --over, exponents e are those of time ~ x^e, fitted between logarithms, with their\n"
    "standard errors. x is the number of fragments over size and layers, where 1 means in\n"
    "proportion to them; that of samples; that of threads, where -1 is perfect. 'fragments' is\n"
    "the time of rasterising, shading and storing what is transparent.\n";

}  // namespace

void add_bench_command(CLI::App& tool)
{
    CLI::App* command = tool.add_subcommand("bench", "Measure the methods' times on a scene");
    const auto request = std::make_shared<BenchRequest>();
    add_own_options(*command, *request);
    add_override_options(*command, request->scene);
    add_view_options(*command, request->given);
    const std::string examples =
        examples_help({"sheer bench builtin:motor",
                       "sheer bench builtin:motor --size 500x500 --samples 1,8,64 --threads 1",
                       "sheer bench builtin:motor --over layers --methods blend,exact --threads 1",
                       "sheer bench builtin:motor --over size=320x240,640x480,1280x960 --json",
                       "sheer bench builtin:motor --methods none,blend,exact --repeat 21 --json",
                       "sheer bench scene.glb --methods exact --simd avx2",
                       "sheer bench scan.ply --opacity 0.5 --samples 4"});
    command->footer(std::string(kBenchMeaning) + "\n" + examples + "\n" + methods_help() + "\n" +
                    scenes_help());
    command->callback([request, command] { run_bench(*request, *command); });
}

}  // namespace sheer
