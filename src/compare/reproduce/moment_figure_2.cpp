// Figure 2 of B. Sharpe, "Moment Transparency", HPG 2018: a transmittance function beside what
// moments make of it, with more and more fragments. The paper prints pictures and these words:
// moments are "a good match for 2 and 3 samples only", overestimation of 25 % "is an improvement,
// although it overshadows in the front", two passes overshadow "with 2 and 3 samples, but [are] an
// improvement for anything higher".
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "compare/depth_chart.h"
#include "compare/depth_functions.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/moment_layers.h"
#include "compare/reproduce/page.h"

namespace sheer {

namespace {

constexpr int kCounts[] = {2, 3, 4, 6, 10, 20};  // of fragments

struct Technique {
    const char* title;
    const char* method;
};
constexpr Technique kTechniques[] = {
    {"moments", "moment:overestimation=0"},
    {"overestimation of 25 %", "moment:overestimation=0.25"},
    {"two moments passes", "moment:overestimation=0:moment-passes=2"},
};

void write_chart(const Layers& layers, const DepthFunctionSetting& setting, Page& page)
{
    const PixelFragments pixel = pixel_of(layers);
    const auto steps = transmittance_steps(pixel.fragments, setting.samples);
    const std::vector<float> depths = depths_to_ask(steps, pixel.eye);
    std::vector<double> distances;
    DepthCurve truth{"exact", {}};
    for (const float depth : depths) {
        distances.push_back(distance_of(depth, pixel.eye));
        truth.values.push_back(transmittance_at(steps, depth));
    }
    std::vector<DepthCurve> curves = {truth};
    for (const Technique& technique : kTechniques) {
        curves.push_back({technique.title,
                          depth_function(choose_method(technique.method), pixel, depths, setting)});
    }
    const std::string count = std::to_string(layers.size()) + " fragments";
    const std::string suffix = "." + std::to_string(layers.size()) + ".svg";
    page.write_text(suffix, depth_chart(count, distances, curves));
    page.show(page.file(suffix), count);
}

// At the fragments' own depths, where methods look.
struct Errors {
    double squares = 0, sum = 0, count = 0;
    double sum_in_front = 0, count_in_front = 0;  // of the nearer half of the fragments

    void add(double error, bool in_front)
    {
        squares += error * error;
        sum += error;
        count += 1;
        sum_in_front += in_front ? error : 0;
        count_in_front += in_front ? 1 : 0;
    }
};

Errors errors_of(const Technique& technique, int count, int trials,
                 const DepthFunctionSetting& setting)
{
    const ChosenMethod method = choose_method(technique.method);
    Errors errors;
    for (int trial = 0; trial < trials; ++trial) {
        const PixelFragments pixel =
            pixel_of(random_layers(count, static_cast<std::uint64_t>(trial)));
        const auto steps = transmittance_steps(pixel.fragments, setting.samples);
        const std::vector<float> depths = own_depths(pixel);
        const auto values = depth_function(method, pixel, depths, setting);
        for (std::size_t i = 0; i < depths.size(); ++i) {
            const auto before = std::count_if(depths.begin(), depths.end(),
                                              [&](float depth) { return depth < depths[i]; });
            errors.add(values[i] - transmittance_at(steps, depths[i]), 2 * before < count - 1);
        }
    }
    return errors;
}

}  // namespace

void reproduce_moment_figure_2(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const int trials = job.quick ? 50 : 1000;
    const SampleSet samples = make_sample_set(1, SamplePositions::center);
    const DepthFunctionSetting setting{samples, targets_of(job.options.simd)};
    Page page(entry, job);
    page.say(
        "Fragments at random depths that let a tenth of the light through together; the charts are "
        "of one such "
        "pixel each, the table of " +
        std::to_string(trials) +
        ", at the fragments' own depths. Below 0 a function overshadows: it lets less through than "
        "there is. "
        "*In front*: of the nearer half of the fragments.");
    Table table{"Errors of transmittance",
                {"fragments", "function", "root mean square", "mean", "mean in front"},
                {}};
    double done = 0;
    for (const int count : kCounts) {
        write_chart(random_layers(count, 0), setting, page);
        for (const Technique& technique : kTechniques) {
            const Errors errors = errors_of(technique, count, trials, setting);
            table.rows.push_back({whole(count), words(technique.title),
                                  number(std::sqrt(errors.squares / errors.count), 4),
                                  signed_number(errors.sum / errors.count, 4),
                                  signed_number(errors.sum_in_front / errors.count_in_front, 4)});
        }
        job.progress(++done / static_cast<double>(std::size(kCounts)));
    }
    page.add(table);
    page.write();
}

}  // namespace sheer
