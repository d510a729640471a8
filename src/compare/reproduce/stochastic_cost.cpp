// Table 1 of E. Enderton et al., "Stochastic Transparency", 2011: what each pass of the final
// algorithm takes, in milliseconds and as a multiple of one blended pass. Theirs is a GPU of 2010.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/turns.h"

namespace sheer {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kDepthBased = "stochastic:masks=stratified:depth-based=on:correction=on";
constexpr int kSamples = 8, kShadowSamples = 16;

// A cell of table 1 as it is printed; the empty one is a dash.
struct Printed {
    const char* ms = "";
    const char* over_base = "";
};

struct PaperTimes {
    Printed base, shadow, opaque, total_alpha, stochastic_depth, accumulation, other, total;
};

struct Case {
    const char* name;
    const char* source;
    const char* quick_source;
    int shadow_size;  // texels across the map; 0: none
    PaperTimes paper;
};

constexpr PaperTimes kDog = {{"14.7", "1.00"}, {"8.9", "0.61"}, {"1.2", "0.08"}, {"8.6", "0.58"},
                             {"8.7", "0.59"},  {"9.5", "0.64"}, {"1.5", "0.1"},  {"38.4", "2.61"}};
constexpr PaperTimes kWindyHill = {{"9.5", "1.00"}, {"13.1", "1.39"}, {"2.8", "0.30"},
                                   {"6.9", "0.73"}, {"7.0", "0.74"},  {"6.9", "0.73"},
                                   {"1.7", "0.18"}, {"38.4", "4.05"}};
constexpr const char* kDogSource = "builtin:hair?strands=300000";
constexpr const char* kQuickDog = "builtin:hair?strands=5000";
constexpr const char* kHillSource = "builtin:windy-hill";
constexpr const char* kQuickHill = "builtin:windy-hill?hairs=1000&cards=500";

// 16 samples of 512x512 texels are as many as 2,048x2,048, of 1,024x1,024 as 4,096x4,096: the
// paper has both sizes and does not say which was whose.
constexpr Case kCases[] = {
    {"Motor",
     "builtin:motor",
     "builtin:motor?detail=0.3",
     0,
     {{"3.6", "1.00"},
      {},
      {"2.6", "0.71"},
      {"3.3", "0.91"},
      {"2.7", "0.75"},
      {"3.4", "0.93"},
      {"1.6", "0.44"},
      {"13.6", "3.74"}}},
    {"Dog, the smaller map", kDogSource, kQuickDog, 512, kDog},
    {"Dog, the larger map", kDogSource, kQuickDog, 1024, kDog},
    {"WindyHill, the smaller map", kHillSource, kQuickHill, 512, kWindyHill},
    {"WindyHill, the larger map", kHillSource, kQuickHill, 1024, kWindyHill},
};

View view_of(const Case& scene, const ReproduceJob& job)
{
    View view;
    view.width = view.height = job.quick ? 100 : 500;
    view.samples = kSamples;
    if (scene.shadow_size > 0) {
        view.shadows.kind = ShadowKind::stochastic;
        view.shadows.size = job.quick ? scene.shadow_size / 4 : scene.shadow_size;
        view.shadows.samples = kShadowSamples;
    }
    return view;
}

Timing time_case(const Case& scene, const ReproduceJob& job, double done)
{
    Scene loaded = load(job.quick ? scene.quick_source : scene.source);
    const auto progress = [&](double part) {
        job.progress((done + part) / static_cast<double>(std::size(kCases)));
    };
    const TurnsRequest request{{kDepthBased}, job.quick ? 1 : 5, progress};
    return time_methods(take_turns(loaded, view_of(scene, job), job.options, request)).front();
}

constexpr const char* kOncePerFragment =
    "here a tile is rasterised and shaded once for all passes, in the paper once for each";

double ms_pass(const Stats& stats, const std::string& name)
{
    for (const PassTime& pass : stats.ms_passes) {
        if (pass.name == name) return pass.ms;
    }
    return kNone;
}

Table pass_table(const Case& scene, const Timing& timing)
{
    Table table{scene.name, {"pass", "ms", "x base", "paper's ms", "paper's x base"}, {}};
    const PaperTimes& paper = scene.paper;
    const auto add = [&](const char* pass, double ms, const Printed& theirs) {
        table.rows.push_back({words(pass), number(ms, 1), number(ms / timing.ms_base, 2),
                              printed(theirs.ms), printed(theirs.over_base)});
    };
    const Stats& stats = timing.stats;
    add("base", timing.ms_base, paper.base);
    add("shadow", ms_pass(stats, "shadow"), paper.shadow);
    add("opaque", timing.ms_opaque, paper.opaque);
    add("fragments, once for all passes", timing.ms_fragments, {});
    add("total alpha", kNone, paper.total_alpha);
    add("stochastic depth", ms_pass(stats, "stochastic depth"), paper.stochastic_depth);
    add("accumulation", ms_pass(stats, "accumulation"), paper.accumulation);
    add("other", timing.ms_other, paper.other);
    add("total", stats.ms_total, paper.total);
    return table;
}

std::vector<Cell> summary_row(const Case& scene, const Timing& timing, const ReproduceJob& job)
{
    const View view = view_of(scene, job);
    const std::string size = std::to_string(view.shadows.size);
    return {words(scene.name),
            words(job.quick ? scene.quick_source : scene.source),
            words(scene.shadow_size == 0 ? "none" : size + "x" + size),
            number(timing.stats.ms_total, 1),
            number(timing.total_min, 1),
            number(timing.total_max, 1),
            number(timing.ratio_to_base, 2),
            printed(scene.paper.total.over_base),
            number(timing.ratio_to_blend, 2)};
}

}  // namespace

void reproduce_stochastic_cost(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    Table summary{"Total",
                  {"scene", "source", "shadow map", "ms", "least", "most", "x base",
                   "paper's x base", "x blend"},
                  {}};
    std::vector<Table> tables;
    std::optional<Stats> any;
    Claims claims{"a quarter: of times over the base time, a GPU's of 2010 beside a CPU's", {}};
    for (const Case& scene : kCases) {
        const Timing timing = time_case(scene, job, static_cast<double>(tables.size()));
        summary.rows.push_back(summary_row(scene, timing, job));
        tables.push_back(pass_table(scene, timing));
        const char* const paper = scene.paper.total.over_base;
        claims.all.push_back({std::string(scene.name) + ", x base", paper, timing.ratio_to_base,
                              0.25 * std::stod(paper), kOncePerFragment});
        any = timing.stats;
    }
    page.say("Depth-based, alpha corrected, " + std::to_string(kSamples) + " samples, " +
             std::to_string(any->width) + "x" + std::to_string(any->height) + " pixels; " +
             std::to_string(kShadowSamples) + " samples of a shadow map's texel. Measured with " +
             std::to_string(any->threads) + " threads, " + any->simd +
             "; the paper's times are a GPU's of 2010. Only ratios compare, and only where "
             "nothing else ran. As in the paper, the motor has no shadows.");
    page.add(summary);
    page.compare(claims);
    for (const Table& table : tables) page.add(table);
    page.say(
        "*Base*: one blended pass over the visible transparent geometry with full shading and "
        "shadow lookups; `blend` without shadow maps, final resolve and what opaque surfaces "
        "alone take. *Fragments*: geometry, rasterising and shading of what is transparent, "
        "which is done once; the passes after it go over its fragments, total alpha "
        "with the accumulation, where the paper rasterises again for each. *Other*: resolve "
        "and the rest. Medians over rounds, so a column does not add up to the digit.");
    page.write_text(".csv", summary.csv());
    page.write();
}

}  // namespace sheer
