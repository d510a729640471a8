// sheer bench: the methods' times on one scene, measured in turns.
//
// Each round runs every method once (A B C, A B C, ...), so that a machine that slows down or is
// busy for a while does so for all of them.
#include "cli/bench.h"

#include <algorithm>
#include <memory>

#include <sheer/sheer.h>

#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/view_options.h"
#include "methods/method.h"
#include "scene/transparency.h"
#include "support/memory.h"
#include "support/progress.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr const char* kBlend = "blend";

struct BenchRequest {
    SceneOptions scene;
    ViewOptions given;
    std::vector<std::string> methods;
    std::vector<int> samples = {8};
    int repeat = 11;
    bool json = false;
};

struct Contenders {
    std::vector<std::string> methods;
    std::size_t blend = 0;
    std::size_t shown = 0;  // the first ones
};

Contenders choose_contenders(const std::vector<std::string>& methods)
{
    Contenders contenders{methods, 0, methods.size()};
    const auto is_blend = [](const std::string& text) {
        return check_option("--methods", [&] { return choose_method(text); }).row->id ==
               std::string(kBlend);
    };
    // All are looked at, for their faults.
    bool found = false;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (!is_blend(methods[i]) || found) continue;
        found = true;
        contenders.blend = i;
    }
    if (!found) {
        contenders.blend = methods.size();
        contenders.methods.emplace_back(kBlend);
    }
    return contenders;
}

bool has_opaque(const Scene& scene)
{
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
        return !is_transparent(scene.materials[scene.meshes[object.mesh].material], object);
    });
}

Turns take_turns(const Scene& scene, const BenchRequest& request, const Contenders& contenders,
                 const std::function<void()>& rendered)
{
    Turns turns{std::vector<Measurement>(contenders.methods.size()), contenders.blend, false};
    // The round before the first warms caches, memory and clock up.
    for (int round = -1; round < request.repeat; ++round) {
        for (std::size_t i = 0; i < contenders.methods.size(); ++i) {
            Options options = request.given.options;
            options.method = contenders.methods[i];
            reset_peak_memory();
            Stats stats = render(scene, request.given.view, options).stats;
            if (round >= 0) turns.measurements[i].rounds.push_back(std::move(stats));
            turns.measurements[i].shown = i < contenders.shown;
            rendered();
        }
    }
    turns.has_opaque = has_opaque(scene);
    return turns;
}

void run_bench(BenchRequest request)
{
    for (const int samples : request.samples) {
        request.given.view.samples = samples;
        check_view_options(request.given);
    }
    const Contenders contenders = choose_contenders(request.methods);
    const Scene scene = load_scene(request.scene);

    std::vector<Turns> all;
    {
        ProgressBar bar("measuring");
        const double renders =
            static_cast<double>(request.samples.size() * contenders.methods.size()) *
            (request.repeat + 1);
        int done = 0;
        for (const int samples : request.samples) {
            request.given.view.samples = samples;
            all.push_back(
                take_turns(scene, request, contenders, [&] { bar.update(++done / renders); }));
        }
    }
    if (request.json) {
        print(json_text({{"scene", request.scene.source}, {"results", bench_rows(all)}}));
        return;
    }
    const Stats& any = all.front().measurements.front().rounds.front();
    print(one_line(request.scene.source) + ": " + std::to_string(any.width) + "x" +
          std::to_string(any.height) + ", " + counted(any.triangles, "triangle") + ", " +
          counted(any.fragments, "fragment") + ", medians of " +
          counted(static_cast<std::uint64_t>(request.repeat), "round") + "\n\n" + bench_table(all));
}

std::vector<std::string> all_methods()
{
    std::vector<std::string> ids;
    for (const MethodRow& row : method_table()) ids.emplace_back(row.id);
    return ids;
}

void add_own_options(CLI::App& command, BenchRequest& request)
{
    add_scene_options(command, request.scene);
    add_value(command, "--methods", "ID[:NAME=VALUE]...,...", "Methods, with commas (all)",
              [&request](auto&, auto& text) { request.methods = split(text, ','); });
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
    "'blend' in the same round, which runs for this even if it is not listed. 'x base': the same\n"
    "without the final resolve of both; unknown (-, null) for scenes with opaque surfaces, whose\n"
    "time would have to be taken off and is not measured apart yet.\n";

}  // namespace

void add_bench_command(CLI::App& tool)
{
    CLI::App* command = tool.add_subcommand("bench", "Measure the methods' times on a scene");
    const auto request = std::make_shared<BenchRequest>();
    request->methods = all_methods();
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
