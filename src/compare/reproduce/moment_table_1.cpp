// Table 1 of Sharpe. Moment Transparency. HPG 2018: memory and render times of six techniques, with
// their errors, which the paper shows in pictures only.
#include <array>
#include <limits>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/moment_techniques.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/stratified_seeds.h"
#include "compare/turns.h"
#include "methods/method.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr std::size_t kCount = std::size(kMomentTechniques);

// Milliseconds of a GTX 1070, as printed: of stage 2, of stage 3, and in total.
struct PaperTimes {
    const char *stage2, *stage3, *total;
};

struct TableScene {
    EntryScene scene;
    std::array<PaperTimes, kCount> paper;
};

constexpr TableScene kScenes[] = {
    {kBurningHouse,
     {{{"0", "7.7", "7.8"},
       {"22.2", "9.1", "31.4"},
       {"22.2", "9.0", "31.3"},
       {"53.0", "9.3", "62.4"},
       {"1.4", "9.1", "10.6"},
       {"2.9", "9.3", "12.3"}}}},
    {kGrassAndSmoke,
     {{{"0", "11.1", "11.2"},
       {"36.5", "13.4", "50.0"},
       {"36.5", "13.2", "49.8"},
       {"88.0", "14.2", "102.3"},
       {"1.1", "13.4", "14.6"},
       {"2.5", "14.2", "16.8"}}}},
};

constexpr const char* kOncePerFragment =
    "here a tile is rasterised and shaded once for all passes, in the paper once for each; and "
    "what a fragment costs more than WBOIT's is arithmetic, which a GPU hides behind memory";

// The paper's stage 2: what makes moments.
double ms_moments(const Stats& stats)
{
    double ms = 0;
    for (const PassTime& pass : stats.ms_passes) {
        if (pass.name == "moments" || pass.name == "reduced moments") ms += pass.ms;
    }
    return ms;
}

std::vector<std::string> methods()
{
    std::vector<std::string> all;
    for (const MomentTechnique& technique : kMomentTechniques) all.emplace_back(technique.method);
    return all;
}

void add_memory(Page& page)
{
    Table table{
        "Memory", {"technique", "method", "bytes a pixel, paper", "in its formats, here"}, {}};
    Claims claims{"none: they are counted", {}};
    for (const MomentTechnique& technique : kMomentTechniques) {
        const double bytes = choose_method(technique.method).traits().texture_bytes;
        table.rows.push_back({words(technique.name), words(technique.method),
                              printed(technique.bytes), number(bytes, 4)});
        claims.all.push_back(
            {std::string(technique.name) + ", bytes a pixel", technique.bytes, bytes, 0, ""});
    }
    page.add(table);
    page.compare(claims);
}

void add_errors(const Scene& scene, const TableScene& of, const ReproduceJob& job, Page& page)
{
    const View view = moment_view(job.quick);
    const Image exact = draw_method(scene, view, "exact", job.options);
    Table table{
        std::string(of.scene.name) + ": errors",
        {"technique", "rmse", "x WBOIT's", "largest", "mean, red", "green", "blue", "rmse from MT"},
        {}};
    double of_wboit = 0;
    Image mt;
    for (const MomentTechnique& technique : kMomentTechniques) {
        const Image image = draw_method(scene, view, technique.method, job.options);
        if (technique.name == std::string("MT")) mt = image;
        const Difference d = compare_images(image, exact);
        if (of_wboit == 0) of_wboit = d.rmse;
        const double from_mt = mt.pixels.empty() ? std::numeric_limits<double>::quiet_NaN()
                                                 : compare_images(image, mt).rmse;
        table.rows.push_back({words(technique.name), number(d.rmse, 3),
                              number(d.rmse / of_wboit, 3), number(d.largest, 1),
                              signed_number(d.bias_mean[0], 2), signed_number(d.bias_mean[1], 2),
                              signed_number(d.bias_mean[2], 2), number(from_mt, 3)});
        if (technique.name != std::string("MT_NLQM")) continue;
        page.compare({"half a step of 8 bits, below which nothing can be observed",
                      {{std::string(of.scene.name) + ": MT_NLQM from MT", "0", from_mt, 0.5, ""}}});
    }
    page.add(table);
}

void add_times(Scene& scene, const TableScene& of, const ReproduceJob& job, double done, Page& page)
{
    const auto progress = [&](double part) {
        job.progress((done + part) / static_cast<double>(std::size(kScenes)));
    };
    const auto timings = time_methods(take_turns(scene, moment_view(job.quick), job.options,
                                                 {methods(), job.quick ? 1 : 7, progress}));
    Table table{
        std::string(of.scene.name) + ": times",
        {"technique", "stage 2, ms", "the rest, ms", "total, ms", "least", "most", "x WBOIT",
         "x blend", "paper's stage 2, ms", "paper's stage 3", "paper's total", "paper's x WBOIT"},
        {}};
    Claims claims{"a quarter: of times over WBOIT's, a GPU's beside a CPU's", {}};
    const double of_wboit = timings[0].stats.ms_total;
    for (std::size_t i = 0; i < kCount; ++i) {
        const Timing& timing = timings[i];
        const PaperTimes& paper = of.paper[i];
        const double total = timing.stats.ms_total, stage2 = ms_moments(timing.stats);
        const double theirs = std::stod(paper.total) / std::stod(of.paper[0].total);
        table.rows.push_back(
            {words(kMomentTechniques[i].name), number(stage2, 1), number(total - stage2, 1),
             number(total, 1), number(timing.total_min, 1), number(timing.total_max, 1),
             number(total / of_wboit, 2), number(timing.ratio_to_blend, 2), printed(paper.stage2),
             printed(paper.stage3), printed(paper.total), number(theirs, 2)});
        if (i == 0) continue;
        claims.all.push_back(
            {std::string(of.scene.name) + ", " + kMomentTechniques[i].name + ", times over WBOIT's",
             fixed(theirs, 2), total / of_wboit, 0.25 * theirs, kOncePerFragment});
    }
    page.add(table);
    page.compare(claims);
}

}  // namespace

void reproduce_moment_table_1(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const View view = moment_view(job.quick);
    Page page(entry, job);
    page.say(size_text(view.width, view.height) +
             " pixels, one sample a pixel, as in the paper. Its scenes are not public: these are "
             "made after its pictures. Errors are in linear colour times 255, over all pixels, "
             "red, green and blue, against the exact picture of the same samples. Stage 2 makes "
             "moments; *the rest* is all else, rasterising and shading included, which the paper "
             "does once in each stage. Overestimation is 0.25.");
    add_memory(page);
    double done = 0;
    for (const TableScene& of : kScenes) {
        Scene scene = load(of.scene.of(job));
        add_errors(scene, of, job, page);
        add_times(scene, of, job, done++, page);
    }
    page.write();
}

}  // namespace sheer
