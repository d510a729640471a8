// Section 5 of E. Enderton et al., "Stochastic Transparency", 2011, and its figure 6: how many
// layers depth peeling draws in the time of the final algorithm. Theirs is a GPU of 2010.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "compare/turns.h"
#include "image/write_image.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kDepthBased = "stochastic:masks=stratified:depth-based=on:correction=on";
constexpr int kSamples = 8;
// Over the geometry in the paper: total alpha, stochastic depth, accumulation.
constexpr int kPaperPasses = 3;
constexpr int kPeels[] = {1, 2, 3, 5, 10, 20, 40}, kFewPeels[] = {1, 5, 40};
constexpr int kMostPeels = 4096;  // more than any pixel has layers here

std::string peeling(int peels)
{
    return "depth-peeling:peels=" + std::to_string(peels);
}

// What is drawn in turns, and how long it took in each round.
struct Taken {
    std::string method;
    int samples;
    int passes;                        // over the geometry, did nothing keep the fragments
    std::vector<double> ms = {};       // all of a frame
    std::vector<double> ms_pass = {};  // geometry, rasterising and shading
    Image image = {};
    double rmse = 0;  // against the exact picture at the same samples

    double median_ms() const { return median(ms); }
    double again(std::size_t round) const { return ms[round] + (passes - 1) * ms_pass[round]; }
};

Taken take_peels(int peels, int samples)
{
    return {.method = peeling(peels), .samples = samples, .passes = peels};
}

// The median over the rounds of one time by another.
template <class Time>
double ratio(const Taken& a, const Taken& b, Time&& time)
{
    std::vector<double> ratios;
    for (std::size_t i = 0; i < a.ms.size(); ++i) ratios.push_back(time(a, i) / time(b, i));
    return median(ratios);
}
double time_ratio(const Taken& a, const Taken& b)
{
    return ratio(a, b, [](const Taken& taken, std::size_t i) { return taken.ms[i]; });
}
double again_ratio(const Taken& a, const Taken& b)
{
    return ratio(a, b, [](const Taken& taken, std::size_t i) { return taken.again(i); });
}

class Rounds {
public:
    Rounds(const ReproduceJob& job, const Scene& scene, View view, double begun, double share)
        : job_(job), scene_(scene), view_(view), done_(begun), share_(share)
    {
    }

    void draw(std::vector<Taken>& all)
    {
        // The round before the first warms caches, memory and clock up.
        const int first = job_.quick ? 0 : -1, end = job_.quick ? 1 : 3;
        const double pictures = static_cast<double>(all.size()) * (end - first);
        for (int round = first; round < end; ++round) {
            for (Taken& taken : all) {
                draw_one(taken, round >= 0);
                job_.progress(done_ += share_ / pictures);
            }
        }
        for (Taken& taken : all) {
            taken.rmse = compare_images(taken.image, exact(taken.samples)).rmse;
        }
    }
    const Image& exact(int samples)
    {
        Image& image = samples == kSamples ? exact_ : exact_at_1_;
        if (image.pixels.empty()) {
            view_.samples = samples;
            image = draw_method(scene_, view_, "exact", job_.options);
        }
        return image;
    }

private:
    void draw_one(Taken& taken, bool counts)
    {
        view_.samples = taken.samples;
        Options options = job_.options;
        options.method = taken.method;
        Frame frame = render(scene_, view_, options);
        taken.image = std::move(frame.image);
        if (!counts) return;
        taken.ms.push_back(frame.stats.ms_total);
        taken.ms_pass.push_back(frame.stats.ms_geometry + frame.stats.ms_raster_shade);
    }

    const ReproduceJob& job_;
    const Scene& scene_;
    View view_;
    Image exact_, exact_at_1_;
    double done_, share_;
};

View view_of(const ReproduceJob& job)
{
    View view;
    view.width = view.height = job.quick ? 64 : 500;
    return view;
}

std::vector<Cell> row_of(const Taken& taken, const Taken& stochastic)
{
    const bool all = taken.passes == kMostPeels;
    return {words(taken.method),
            whole(taken.samples),
            number(taken.median_ms(), 1),
            number(time_ratio(taken, stochastic), 2),
            number(all ? kNone : again_ratio(taken, stochastic), 2),
            number(taken.rmse, 2)};
}

const std::vector<std::string> kColumns = {
    "method", "samples", "ms", "x depth-based", "x, each pass rasterising", "rmse same S"};

// How many peels take as long as `stochastic`: between those that were measured along a line; NaN
// where one takes longer, and all where none does.
double peels_in_time(const std::vector<const Taken*>& peeled,
                     const std::function<double(const Taken&)>& ratio_of)
{
    double before = kNone, peels_before = kNone;
    for (const Taken* taken : peeled) {
        const double now = ratio_of(*taken), peels = taken->passes;
        if (now > 1) return peels_before + (peels - peels_before) * (1 - before) / (now - before);
        before = now;
        peels_before = peels;
    }
    return peels_before;
}

void show(Page& page, const char* name, const std::vector<Image>& images, const char* caption)
{
    const std::string suffix = "." + std::string(name) + ".png";
    write_image(page.path(suffix), side_by_side(images));
    page.show(page.file(suffix), caption);
}

constexpr const char* kMachines =
    "times of a GPU of 2010 beside a CPU's; the layers of both scenes are other";

void add_motor(Page& page, const ReproduceJob& job, Claims& claims)
{
    const Scene scene = load(job.quick ? "builtin:motor?detail=0.2" : "builtin:motor");
    std::vector<Taken> all = {{.method = kDepthBased, .samples = kSamples, .passes = kPaperPasses},
                              take_peels(10, 1),
                              take_peels(10, kSamples),
                              take_peels(kMostPeels, 1),
                              take_peels(kMostPeels, kSamples)};
    Rounds rounds(job, scene, view_of(job), 0, 0.2);
    rounds.draw(all);
    show(page, "motor", {all[0].image, all[1].image, rounds.exact(1)},
         "The motor: depth-based with 8 samples; ten peels, 1 sample; exact, 1 sample");
    Table table{"The motor", kColumns, {}};
    table.columns.emplace_back("paper");
    for (const Taken& taken : all) {
        table.rows.push_back(row_of(taken, all.front()));
        table.rows.back().push_back(printed(&taken == &all[1] ? "1.5" : ""));
    }
    page.add(table);
    claims.all.push_back({"motor, ten peels, 1 sample, each pass rasterising, x depth-based", "1.5",
                          again_ratio(all[1], all[0]), 0.25 * 1.5, kMachines});
}

void add_windy_hill(Page& page, const ReproduceJob& job, Claims& claims)
{
    const Scene scene =
        load(job.quick ? "builtin:windy-hill?hairs=1000&cards=500" : "builtin:windy-hill");
    View view = view_of(job);
    view.shadows.kind = ShadowKind::stochastic;
    view.shadows.size = job.quick ? 128 : 1024;
    std::vector<Taken> all = {{.method = kDepthBased, .samples = kSamples, .passes = kPaperPasses}};
    for (const int samples : {1, kSamples}) {
        for (const int peels : job.quick ? std::span<const int>(kFewPeels) : kPeels) {
            all.push_back(take_peels(peels, samples));
        }
    }
    Rounds rounds(job, scene, view, 0.2, 0.8);
    rounds.draw(all);
    const auto five = std::find_if(all.begin() + 1, all.end(), [](const Taken& taken) {
        return taken.passes == 5 && taken.samples == kSamples;
    });
    show(page, "hill", {all[0].image, five->image, rounds.exact(kSamples)},
         "The windy hill, 8 samples: depth-based; five peels, as in figure 6; exact");

    Table table{"The windy hill", kColumns, {}};
    for (const Taken& taken : all) table.rows.push_back(row_of(taken, all.front()));
    Table layers{"Layers of the windy hill in the time of the depth-based method",
                 {"samples", "peels", "peels, each pass rasterising", "paper"},
                 {}};
    for (const int samples : {1, kSamples}) {
        std::vector<const Taken*> peeled;
        for (auto taken = all.begin() + 1; taken != all.end(); ++taken) {
            if (taken->samples == samples) peeled.push_back(&*taken);
        }
        const auto in_time = [&](double (*ratio_of)(const Taken&, const Taken&)) {
            return peels_in_time(peeled,
                                 [&](const Taken& taken) { return ratio_of(taken, all.front()); });
        };
        const double again = in_time(again_ratio);
        layers.rows.push_back(
            {whole(samples), number(in_time(time_ratio), 1), number(again, 1), printed("5")});
        claims.all.push_back({"windy hill, peels in the same time, each pass rasterising, " +
                                  std::to_string(samples) + (samples == 1 ? " sample" : " samples"),
                              "5", again, 0.25 * 5, kMachines});
    }
    page.add(layers);
    page.add(table);
}

}  // namespace

void reproduce_stochastic_peeling(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    const View view = view_of(job);
    page.say("Depth peeling beside the depth-based, alpha corrected method with " +
             std::to_string(kSamples) + " samples, " + size_text(view.width, view.height) +
             " pixels; the windy hill with a stochastic shadow map, which both draw. The paper's "
             "times are a GPU's of 2010. It peeled ten layers of the motor without antialiasing "
             "in 1.5 times the time of the stochastic method, and five of the windy hill in the "
             "same time.");
    Claims claims{"a quarter: a GPU's times of 2010 beside a CPU's", {}};
    add_motor(page, job, claims);
    add_windy_hill(page, job, claims);
    page.compare(claims);
    page.say(
        "Medians over rounds in turns. Here a tile is rasterised and shaded once, and every pass "
        "goes over its fragments; in the paper every pass draws the scene. *Each pass rasterising* "
        "adds what that would take: geometry, rasterising and shading once more for each pass "
        "after the first, of which the stochastic method has " +
        std::to_string(kPaperPasses) +
        " in the paper. *rmse same S*: in linear colour times 255, against the exact picture at "
        "the same samples and with the same shadows. `peels=" +
        std::to_string(kMostPeels) + "`: all there are.");
    page.write();
}

}  // namespace sheer
