// One function of depth for each sample or one for each pixel: what that does to errors, memory and
// times, of all methods that have both.
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/moment_techniques.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/stratified_seeds.h"
#include "compare/turns.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr int kSamples = 8;

constexpr const char* kMethods[] = {
    "moment",
    "moment:moment-passes=2",
    "mboit",
    "mboit:moments=8",
    "mboit:basis=trigonometric:moments=8",
    "fourier",
    "wavelet",
};

constexpr EntryScene kScenes[] = {
    {"motor", "builtin:motor", "builtin:motor?detail=0.2"},
    {"hair", "builtin:hair?strands=15000", "builtin:hair?strands=500"},
    kBurningHouse,
    kGrassAndSmoke,
};

// WBOIT for scale, then each method with both stores.
std::vector<std::string> all_methods()
{
    std::vector<std::string> all = {"wboit"};
    for (const std::string method : kMethods) {
        all.push_back(method);
        all.push_back(method + ":store=pixel");
    }
    return all;
}

void add_scene(const EntryScene& of, const ReproduceJob& job, double done, Page& page)
{
    View view;
    view.width = job.quick ? 48 : 320;
    view.height = job.quick ? 36 : 240;
    view.samples = kSamples;
    Scene scene = load(of.of(job));
    const Image exact = draw_method(scene, view, "exact", job.options);
    const std::vector<std::string> methods = all_methods();
    const auto progress = [&](double part) {
        job.progress((done + part) / static_cast<double>(std::size(kScenes)));
    };
    const auto timings =
        time_methods(take_turns(scene, view, job.options, {methods, job.quick ? 1 : 5, progress}));
    Table table{
        of.name, {"method", "rmse", "largest", "bytes a pixel", "ms", "x WBOIT", "x blend"}, {}};
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const Difference d =
            compare_images(draw_method(scene, view, methods[i], job.options), exact);
        const Stats& stats = timings[i].stats;
        table.rows.push_back({words(methods[i]), number(d.rmse, 3), number(d.largest, 1),
                              number(stats.bytes_per_pixel, 0), number(stats.ms_total, 1),
                              number(stats.ms_total / timings[0].stats.ms_total, 2),
                              number(timings[i].ratio_to_blend, 2)});
    }
    page.add(table);
}

}  // namespace

void reproduce_moment_stores(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    page.say(std::to_string(kSamples) +
             " samples a pixel. Errors are in linear colour times 255, over all pixels, red, green "
             "and blue, against the exact picture of the same samples; bytes are those of the "
             "store here.");
    double done = 0;
    for (const EntryScene& scene : kScenes) add_scene(scene, job, done++, page);
    page.write();
}

}  // namespace sheer
