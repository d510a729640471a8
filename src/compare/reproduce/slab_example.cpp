// The talk's pixel of four fragments: red, then blue behind it, then green in front, then an opaque
// yellow behind everything. C. Wyman, "Exploring and Expanding the Continuum of OIT Algorithms",
// HPG 2016, draws it into 16 samples, loses yellow there and says that blue could be lost as well;
// then into layers with coverage masks, which insert what is not occluded and of which more than k
// are discarded.
//
// Every pixel of the picture is a trial. Colours are of ones and zeros and nothing is behind, so
// that a pixel tells how much of it each surface has.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/choose.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"

namespace sheer {

namespace {

constexpr const char* kSource =
    "builtin:layers?depth=0.5,0.7,0.3,0.9&alpha=0.5,0.5,0.5,1"
    "&color=1,0,0;0,0,1;0,1,0;1,1,0&background=0,0,0";
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Near to far.
enum Surface : std::size_t { kGreen, kRed, kBlue, kYellow, kSurfaces };
constexpr const char* kNames[kSurfaces] = {"green", "red", "blue", "yellow"};
constexpr double kTruth[kSurfaces] = {0.5, 0.25, 0.125, 0.125};

struct Store {
    const char* title;
    const char* method;
    int samples;
    int bits;  // of the masks; 0: endless
    int layers;
};

constexpr Store kStores[] = {
    {"stochastic transparency, 16 samples", "stochastic:depth-based=off:correction=off", 16, 16, 4},
    {"SLAB, k = 4, b = 16", "slab:layers=4:bits=16:depth-based=off", 1, 16, 4},
    {"SLAB, k = 2, b = 16", "slab:layers=2:bits=16:depth-based=off", 1, 16, 2},
    {"SLAB, k = 4, b = 64", "slab:layers=4:bits=64:depth-based=off", 1, 64, 4},
    {"SLAB, k = 4, b = 128", "slab:layers=4:bits=128:depth-based=off", 1, 128, 4},
    {"SLAB, k = 4, b without end", "slab:layers=4:bits=infinity:depth-based=off", 1, 0, 4},
};

using Parts = std::array<double, kSurfaces>;

// Of a pixel: what each surface has of it. Alpha is what all of them have together; yellow alone
// is in two channels.
Parts parts_of(const Float4& pixel)
{
    const double r = static_cast<double>(pixel[0]), g = static_cast<double>(pixel[1]);
    const double b = static_cast<double>(pixel[2]), all = static_cast<double>(pixel[3]);
    const double yellow = r + g + b - all;
    return {g - yellow, r - yellow, b, yellow};
}

// The chance that nothing is seen of a surface, every mask of half of the samples alike: near to
// far, by how many samples are covered and how many surfaces are kept.
Parts chances_of_loss(int samples, int layers)
{
    const auto none = std::vector<std::vector<double>>(
        kSurfaces + 1, std::vector<double>(static_cast<std::size_t>(samples) + 1));
    auto chances = none;
    chances[0][0] = 1;
    Parts lost{};
    for (std::size_t surface = 0; surface < kSurfaces; ++surface) {
        const int taken = surface == kYellow ? samples : samples / 2;
        auto next = none;
        for (std::size_t kept = 0; kept <= surface; ++kept) {
            for (int before = 0; before <= samples; ++before) {
                for (int more = 0; more <= std::min(taken, samples - before); ++more) {
                    const double chance = chances[kept][static_cast<std::size_t>(before)] *
                                          choose(samples - before, more) *
                                          choose(before, taken - more) / choose(samples, taken);
                    const bool seen = more > 0 && static_cast<int>(kept) < layers;
                    lost[surface] += seen ? 0 : chance;
                    next[kept + (seen ? 1 : 0)][static_cast<std::size_t>(before + more)] += chance;
                }
            }
        }
        chances = std::move(next);
    }
    return lost;
}

struct Trials {
    double pixels = 0;
    Parts mean{}, lost{};  // of all pixels
};

Trials draw(const Store& store, int side, Options options)
{
    View view;
    view.width = view.height = side;
    view.samples = store.samples;
    view.positions = SamplePositions::center;
    view.background = Float4{0, 0, 0, 0};
    options.method = store.method;
    const Image image = render(load(kSource), view, options).image;
    Trials trials;
    trials.pixels = static_cast<double>(image.pixels.size());
    for (const Float4& pixel : image.pixels) {
        const Parts parts = parts_of(pixel);
        for (std::size_t s = 0; s < kSurfaces; ++s) {
            trials.mean[s] += parts[s] / trials.pixels;
            // No mask has less than a 128th.
            trials.lost[s] += parts[s] < 1.0 / 256 ? 1 / trials.pixels : 0;
        }
    }
    return trials;
}

double z_of(double measured, double chance, double pixels)
{
    if (chance <= 0 || chance >= 1) return kNone;
    return (measured - chance) / std::sqrt(chance * (1 - chance) / pixels);
}

}  // namespace

void reproduce_slab_example(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    const int side = job.quick ? 100 : 500;
    page.say(
        "Red at .5, blue at .7, green at .3, each of opacity .5, then an opaque yellow at .9, in "
        "this order; " +
        std::to_string(side * side) + " pixels, each with masks of its own.");
    Table parts{"What each surface has of a pixel, in the mean", {"store"}, {}};
    parts.columns.insert(parts.columns.end(), std::begin(kNames), std::end(kNames));
    parts.rows.push_back({words("so it is")});
    for (const double truth : kTruth) parts.rows.back().push_back(number(truth, 4));
    Table losses{
        "Pixels that lose a surface", {"store", "surface", "% of pixels", "exact", "z"}, {}};
    double done = 0;
    for (const Store& store : kStores) {
        const Trials trials = draw(store, side, job.options);
        const Parts expected = store.bits > 0 ? chances_of_loss(store.bits, store.layers) : Parts{};
        parts.rows.push_back({words(store.title)});
        for (std::size_t s = 0; s < kSurfaces; ++s) {
            parts.rows.back().push_back(number(trials.mean[s], 4));
            losses.rows.push_back(
                {words(store.title), words(kNames[s]), number(100 * trials.lost[s], 3),
                 number(100 * expected[s], 3),
                 signed_number(z_of(trials.lost[s], expected[s], trials.pixels), 1)});
        }
        job.progress(++done / static_cast<double>(std::size(kStores)));
    }
    page.add(parts);
    page.add(losses);
    page.say(
        "*Exact*: of masks of half of the samples or bits, every choice alike; *z*: the measured "
        "part's distance from "
        "it in standard errors. As the talk says: 16 samples can lose yellow, and blue; layers "
        "with as many bits lose "
        "them as often, since they insert only what is not occluded; with k = 2 what is behind the "
        "second is discarded; "
        "and more bits lose less and less, which is what SLAB has them for.");
    page.write();
}

}  // namespace sheer
