// Figure 8 of S. Laine and T. Karras, "Stratified Sampling for Stochastic Transparency", 2011:
// dozens of layers, where stratification is in vain; and where it costs something.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/estimate.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "image/write_image.h"
#include "reference/stratified_listing.h"
#include "support/random.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr int kSamples = 16;

struct Compared {
    Image ours, comparison, exact;  // of the first seed
    double ours_rmse, comparison_rmse;
    RatioEstimate ratio;
};

Compared compare(const Scene& scene, const View& view, int seeds, const ReproduceJob& job)
{
    Compared result;
    result.exact = draw_method(scene, view, "exact", job.options);
    std::vector<Image> ours = draw_seeds(scene, view, kStratified, seeds, job.options);
    std::vector<Image> comparison = draw_seeds(scene, view, kDepthTested, seeds, job.options);
    const auto squares = mean_squares(ours, result.exact);
    const auto by_squares = mean_squares(comparison, result.exact);
    result.ours_rmse = root_of_mean(squares);
    result.comparison_rmse = root_of_mean(by_squares);
    result.ratio = estimate_ratio(squares, by_squares);
    result.ours = std::move(ours.front());
    result.comparison = std::move(comparison.front());
    return result;
}

std::vector<Cell> cells_of(const Compared& compared)
{
    return {number(compared.ours_rmse, 3), number(compared.comparison_rmse, 3),
            number(compared.ratio.ratio, 3), number(compared.ratio.least, 3),
            number(compared.ratio.most, 3)};
}

const std::vector<std::string> kColumns = {"ours", "comparison", "ratio", "least", "most"};

void add_smoke(Page& page, const ReproduceJob& job)
{
    const int seeds = job.quick ? 5 : 17;
    const Scene scene = load("builtin:smoke");
    View view;
    view.width = view.height = job.quick ? 100 : 500;
    view.samples = kSamples;
    const Compared compared = compare(scene, view, seeds, job);
    write_image(page.path(".png"), side_by_side(std::vector<Image>{
                                       compared.ours, compared.comparison, compared.exact}));
    page.show(page.file(".png"), "The paper's method, the comparison, exact");
    Table table{"Smoke, 16 samples", kColumns, {cells_of(compared)}};
    page.add(table);
    Claims claims{"0.10: \"never performs worse than the comparison method\", on another cloud",
                  {}};
    claims.all.push_back({"smoke: the ratio of the errors", "1", compared.ratio.ratio, 0.10,
                          "numbers that are no aligned 2^k ones are not stratified (last table)"});
    page.compare(claims);
    page.say("`builtin:smoke`, opacity 0.05, " + size_text(view.width, view.height) + " pixels, " +
             std::to_string(seeds) +
             " seeds; root mean square errors in linear colour times 255, against the exact "
             "picture at the same samples; *least* and *most*: the ratio's interval of 99 % "
             "confidence.");
}

void add_layers(Page& page, const ReproduceJob& job)
{
    const int seeds = job.quick ? 5 : 17;
    View view;
    view.width = view.height = job.quick ? 40 : 100;
    view.samples = kSamples;
    view.positions = SamplePositions::center;
    Table table{"Layers over the whole picture, 16 samples", {"opacity", "layers", "drawn"}, {}};
    table.columns.insert(table.columns.end(), kColumns.begin(), kColumns.end());
    double done = 0;
    for (const double opacity : {0.05, 0.3, 0.5}) {
        for (const int count : {8, 64}) {
            for (const std::string order : {"near-to-far", "far-to-near", "random"}) {
                // Of two colours in turn, so that it matters which layer takes a sample.
                std::string source = "builtin:layers?n=" + std::to_string(count) +
                                     "&alpha=" + fixed(opacity, 2) + "&background=0,0,0&order=";
                source += order;
                source += "&color=";
                for (int i = 0; i < count; ++i) source += i % 2 == 0 ? "1,1,0;" : "1,0,1;";
                source.pop_back();
                const Scene scene = load(source);
                table.rows.push_back({number(opacity, 2), whole(count), words(order)});
                const auto cells = cells_of(compare(scene, view, seeds, job));
                table.rows.back().insert(table.rows.back().end(), cells.begin(), cells.end());
                job.progress(0.5 + 0.4 * ++done / 18);
            }
        }
    }
    page.add(table);
    page.say("`builtin:layers`, yellow and magenta in turn, all samples at the pixel's centre, " +
             size_text(view.width, view.height) + " pixels.");
}

// How many of n reference values are below an opacity: 0 or 1 more than the whole part of the
// mean, at best.
void add_spans(Page& page, const ReproduceJob& job)
{
    const std::uint32_t pixels = job.quick ? 2000 : 20000;
    Table table{"Variance of the number of samples that a fragment takes",
                {"opacity", "of n samples", "least possible", "the first n of 16 numbers", "ratio"},
                {}};
    for (const double opacity : {0.05, 0.3}) {
        for (const std::uint32_t n : {4u, 7u, 8u, 11u, 13u, 16u}) {
            double mean = 0, squares = 0;
            for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
                double count = 0;
                for (std::uint32_t i = 0; i < n; ++i) {
                    const auto bits = reference::paper_bits(i, pixel, hash_u32(1), kSamples);
                    count += opacity > reference::value_of_bits(bits) ? 1 : 0;
                }
                mean += count / pixels;
                squares += count * count / pixels;
            }
            const double part = opacity * n - std::floor(opacity * n);
            const double least = part * (1 - part), found = squares - mean * mean;
            table.rows.push_back({number(opacity, 2), whole(n), number(least, 4), number(found, 4),
                                  number(found / least, 3)});
        }
    }
    page.add(table);
    page.say(
        "A fragment that finds n samples open takes those of its first n numbers that are "
        "below its opacity; the comparison takes the nearest two whole numbers of opacity "
        "times n, which is the least variance there is. Over " +
        std::to_string(pixels) + " pixels along the curve.");
}

}  // namespace

void reproduce_stratified_figure_8(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    add_smoke(page, job);
    job.progress(0.5);
    add_layers(page, job);
    add_spans(page, job);
    page.write();
}

}  // namespace sheer
