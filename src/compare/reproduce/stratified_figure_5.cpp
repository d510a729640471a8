// Figure 5 of S. Laine and T. Karras, "Stratified Sampling for Stochastic Transparency", 2011: how
// many of 16 samples the farther of two surfaces of opacity 0.5 has in the end.
#include <algorithm>
#include <cmath>
#include <string>

#include <sheer/sheer.h>

#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"

namespace sheer {

namespace {

constexpr int kSamples = 16;

struct Part {
    const char* letter;
    const char* title;
    const char* parameters;
    const char* order;
    const char* paper;
    const char *least, *most;  // of that
};

constexpr Part kParts[] = {
    {"a", "neither compaction nor sorting", ":compaction=off:sort=off", "near-to-far", "0 to 8",
     "0", "8"},
    {"b", "compaction", ":sort=off", "near-to-far", "4", "4", "4"},
    {"c", "compaction", ":sort=off", "far-to-near", "0 to 8", "0", "8"},
    {"d", "compaction and sorting", "", "far-to-near", "4", "4", "4"},
    {"", "compaction and sorting", "", "near-to-far", "4", "4", "4"},
};

constexpr const char* kTooFew = "too few pixels to meet what is possible but rare";

// Green in front of nothing else: its samples, pixel by pixel.
struct Counts {
    double mean = 0, deviation = 0;
    int least = kSamples, most = 0;
};

Counts count_far_samples(const Part& part, const ReproduceJob& job)
{
    const Scene scene =
        load("builtin:layers?alpha=0.5,0.5&color=1,0,0;0,1,0&depth=1,2&background=0,0,0&order=" +
             std::string(part.order));
    View view;
    view.width = view.height = job.quick ? 64 : 256;
    view.samples = kSamples;
    view.positions = SamplePositions::center;
    Options options = job.options;
    options.method = "stratified-stochastic" + std::string(part.parameters);
    const Image image = render(scene, view, options).image;
    Counts counts;
    double squares = 0;
    for (const Float4& pixel : image.pixels) {
        const int count = static_cast<int>(std::lround(pixel[1] * kSamples));
        counts.least = std::min(counts.least, count);
        counts.most = std::max(counts.most, count);
        counts.mean += count;
        squares += count * count;
    }
    const auto pixels = static_cast<double>(image.pixels.size());
    counts.mean /= pixels;
    counts.deviation = std::sqrt(squares / pixels - counts.mean * counts.mean);
    return counts;
}

}  // namespace

void reproduce_stratified_figure_5(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    Table table{"Samples of the farther surface",
                {"part", "with", "drawn", "paper", "least", "most", "mean", "deviation"},
                {}};
    Claims claims{"none: these are whole numbers, over all pixels", {}};
    for (const Part& part : kParts) {
        const Counts counts = count_far_samples(part, job);
        table.rows.push_back({words(part.letter), words(part.title), words(part.order),
                              words(part.paper), whole(counts.least), whole(counts.most),
                              number(counts.mean, 4), number(counts.deviation, 4)});
        const std::string with = std::string(part.title) + ", " + part.order;
        claims.all.push_back({with + ": least", part.least, double(counts.least), 0, kTooFew});
        claims.all.push_back({with + ": most", part.most, double(counts.most), 0, kTooFew});
    }
    page.add(table);
    page.compare(claims);
    page.say(
        "Two surfaces of opacity 0.5 that fill the picture, 16 samples at the pixel's centre; "
        "4 of them are the farther one's share.");
    page.write();
}

}  // namespace sheer
