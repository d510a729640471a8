// How far functions of depth are from the transmittance that they stand for: by the number of
// layers, at their own depths, where methods look; and by the gap between two clusters of layers,
// in its middle, where only what is between clusters counts. Sharpe. Moment Transparency. HPG 2018,
// figure 2, shows one case of each.
#include <algorithm>
#include <cmath>

#include "compare/depth_functions.h"
#include "compare/reproduce/chart.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/moment_layers.h"
#include "compare/reproduce/page.h"
#include "support/random.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr const char* kMethods[] = {
    "moment",
    "moment:overestimation=0",
    "moment:moment-passes=2",
    "mboit:moments=6",
    "mboit:moments=8",
    "mboit:basis=trigonometric:moments=4",
    "mboit:basis=trigonometric:moments=6",
    "mboit:basis=trigonometric:moments=8",
    "fourier:terms=3",
    "fourier",
    "wavelet:rank=2",
    "wavelet:rank=4",
    "adaptive",
    "deep-shadow-map",
    "stochastic:depth-based=on",
};

constexpr int kSamples = 8;         // a pixel, of the random one; the others have the same at all
constexpr int kPerCluster = 4;      // layers
constexpr double kWidth = 0x1p-12;  // of a cluster

// Two clusters, anywhere.
Layers clusters(double gap, std::uint64_t trial)
{
    const CounterRandom random{trial};
    const double first = -1 + (2 - gap - 2 * kWidth) * random.uniform(1000);
    Layers layers;
    for (std::uint64_t i = 0; i < 2 * kPerCluster; ++i) {
        const double in_cluster = kWidth * random.uniform(2 * i + 1);
        layers.push_back({first + in_cluster + (i < kPerCluster ? 0 : gap + kWidth), 0});
    }
    set_opacities(random, layers);
    return layers;
}

// Sum of squares, and of how many.
struct Squares {
    double sum = 0, count = 0;
    double root_mean() const { return std::sqrt(sum / count); }
};

void add_errors(const ChosenMethod& method, const PixelFragments& pixel,
                const std::vector<float>& depths, const SampleSet& samples, const ReproduceJob& job,
                std::uint64_t trial, Squares& squares)
{
    const auto steps = transmittance_steps(pixel.fragments, samples);
    const auto values =
        depth_function(method, pixel, depths,
                       {samples, targets_of(job.options.simd), static_cast<std::uint32_t>(trial)});
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const double error = values[i] - transmittance_at(steps, depths[i]);
        squares.sum += error * error;
        squares.count += 1;
    }
}

// Of a pixel of clusters(), whose fragments are in order of their clusters.
std::vector<float> middle_of_gap(const PixelFragments& pixel)
{
    float before = 0, behind = 1e30f;
    for (std::size_t i = 0; i < pixel.fragments.size(); ++i) {
        const float depth = pixel.fragments[i].depth;
        if (i < kPerCluster) {
            before = std::max(before, depth);
        } else {
            behind = std::min(behind, depth);
        }
    }
    return {0.5f * (before + behind)};
}

// What an entry varies.
struct Sweep {
    const char* column;
    std::vector<double> values;
    Layers (*layers)(double value, std::uint64_t trial);
    std::vector<float> (*depths)(const PixelFragments& pixel);  // that are asked for
    const char* where;
    int digits;
};

void run_sweep(const ReproduceEntry& entry, const ReproduceJob& job, const Sweep& sweep,
               const std::string& text)
{
    const int trials = job.quick ? 10 : 300;
    const SampleSet samples = make_sample_set(kSamples, SamplePositions::center);
    Table table{"Root mean square error of transmittance", {"method"}, {}};
    for (const double value : sweep.values) {
        table.columns.push_back(fixed(value, sweep.digits));
    }
    std::vector<Series> series;
    double done = 0;
    for (const char* text_of_method : kMethods) {
        const ChosenMethod method = choose_method(text_of_method);
        Series line{text_of_method, sweep.values, {}};
        std::vector<Cell> row = {words(text_of_method)};
        for (const double value : sweep.values) {
            Squares squares;
            for (int trial = 0; trial < trials; ++trial) {
                const auto number = static_cast<std::uint64_t>(trial);
                const PixelFragments pixel = pixel_of(sweep.layers(value, number));
                add_errors(method, pixel, sweep.depths(pixel), samples, job, number, squares);
            }
            line.y.push_back(squares.root_mean());
            row.push_back(scientific(line.y.back()));
        }
        table.rows.push_back(std::move(row));
        series.push_back(std::move(line));
        job.progress(++done / static_cast<double>(std::size(kMethods)));
    }
    Page page(entry, job);
    page.write_text(".svg",
                    log_log_chart("Root mean square error of transmittance", series, sweep.column));
    page.show(page.file(".svg"),
              "Errors " + std::string(sweep.where) + ", by " + std::string(sweep.column));
    page.say(text + " " + std::to_string(trials) + " trials. Layers let a tenth of the light " +
             "through together, and their optical depths vary by a factor of three. Depth goes " +
             "from -1 to 1, with all of it the methods' own. The random method has " +
             std::to_string(kSamples) + " samples.");
    page.add(table);
    page.write();
}

}  // namespace

void reproduce_moment_layers(const ReproduceEntry& entry, const ReproduceJob& job)
{
    run_sweep(entry, job,
              {"layers",
               {1, 2, 4, 8, 16, 32, 64, 128},
               [](double count, std::uint64_t trial) {
                   return random_layers(static_cast<int>(count), trial);
               },
               own_depths,
               "at the layers' depths",
               0},
              "Layers at random depths.");
}

void reproduce_moment_gap(const ReproduceEntry& entry, const ReproduceJob& job)
{
    std::vector<double> gaps;
    for (int i = -10; i <= 0; ++i) gaps.push_back(std::ldexp(1.0, i));
    run_sweep(
        entry, job,
        {"gap between clusters", gaps, clusters, middle_of_gap, "in the middle of the gap", 5},
        "Two clusters of " + std::to_string(kPerCluster) + " layers, each 2^-12 deep.");
}

}  // namespace sheer
