// sheer bench: the methods' times on one scene, measured in turns.
#include "cli/bench.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include <sheer/sheer.h>

#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/method_lists.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/view_options.h"
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
    int repeat = 11;
    bool json = false;
};

void run_bench(BenchRequest request)
{
    for (const int samples : request.samples) {
        request.given.view.samples = samples;
        check_view_options(request.given);
    }
    for (const std::string& method : request.methods) {
        check_option("--methods", [&] { return choose_method(method); });
    }
    Scene scene = load_scene(request.scene, request.given.options.memory_limit);

    std::vector<Timing> timings;
    {
        ProgressBar bar("measuring");
        const auto settings = static_cast<double>(request.samples.size());
        for (std::size_t i = 0; i < request.samples.size(); ++i) {
            request.given.view.samples = request.samples[i];
            const auto progress = [&](double part) {
                bar.update((static_cast<double>(i) + part) / settings);
            };
            const Turns turns = take_turns(scene, request.given.view, request.given.options,
                                           {request.methods, request.repeat, progress});
            std::ranges::copy(time_methods(turns), std::back_inserter(timings));
        }
    }
    if (request.json) {
        print(json_text({{"scene", request.scene.source}, {"results", bench_rows(timings)}}));
        return;
    }
    const Stats& any = timings.front().stats;
    print(one_line(request.scene.source) + ": " + std::to_string(any.width) + "x" +
          std::to_string(any.height) + ", " + counted(any.triangles, "triangle") + ", " +
          counted(any.fragments, "fragment") + ", medians of " +
          counted(static_cast<std::uint64_t>(request.repeat), "round") + "\n\n" +
          bench_table(timings));
}

void add_own_options(CLI::App& command, BenchRequest& request)
{
    add_scene_options(command, request.scene);
    add_methods_list(command, request.methods, MethodsFor::bench);
    add_samples_list(command, request.samples);
    add_value(command, "--repeat", "N", "Rounds, after one that isn't measured (11)",
              [&request](auto& option, auto& text) {
                  request.repeat = parse_whole(option, text, 1, 10'000);
              });
    command.add_flag("--json", request.json, "Print the results for programs, not a table")
        ->disable_flag_override();
}

constexpr const char* kMeaning =
    "Every round runs each method once; the numbers are medians over the rounds. Nanoseconds are\n"
    "those of one thread: time x threads / count. 'x blend': total time over that of the method\n"
    "'blend' in the same round, which runs for this even if it is not listed. 'x base': total "
    "time\n"
    "over the time of one blended pass over the visible transparent geometry with full shading,\n"
    "which is that of 'blend' without shadow maps, the final resolve, and what opaque surfaces\n"
    "alone take in the same round. Base of table 1 of Enderton et al., Stochastic Transparency.\n";

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
                       "sheer bench builtin:motor --methods none,blend,exact --repeat 21 --json",
                       "sheer bench scene.glb --methods exact --simd avx2",
                       "sheer bench scan.ply --opacity 0.5 --samples 4"});
    command->footer(std::string(kMeaning) + "\n" + examples + "\n" + methods_help() + "\n" +
                    scenes_help());
    command->callback([request] { run_bench(*request); });
}

}  // namespace sheer
