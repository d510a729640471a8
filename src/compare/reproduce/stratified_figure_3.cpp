// Figure 3 of S. Laine and T. Karras, "Stratified Sampling for Stochastic Transparency", 2011: what
// surfaces, and rows of pixels, know of one another, by the sequence of reference values.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/estimate.h"
#include "compare/metrics.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "image/write_image.h"
#include "reference/stratified_listing.h"
#include "support/math.h"
#include "support/random.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr const char* kSequences[] = {"paper", "vegdahl", "sobol", "random"};
constexpr const char* kOrders[] = {"near-to-far", "far-to-near", "random"};
constexpr int kLayers = 8, kSamples = 8;

View square_view(int side, int samples)
{
    View view;
    view.width = view.height = side;
    view.samples = samples;
    return view;
}

std::string with_sequence(const std::string& sequence)
{
    return stratified_with("sequence=" + sequence);
}

// 0 where there is no variance.
double correlation(const std::vector<double>& a, const std::vector<double>& b)
{
    const auto n = static_cast<double>(a.size());
    double mean_a = 0, mean_b = 0, aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        mean_a += a[i] / n;
        mean_b += b[i] / n;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
        ab += (a[i] - mean_a) * (b[i] - mean_b);
    }
    return aa * bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

// The largest, in absolute numbers, between pixels of 4 to 16 columns or rows apart: farther than
// dithering reaches, so that what is left is a pattern.
double pattern_of(const Image& image)
{
    constexpr int kNear = 4, kFar = 16;
    double largest = 0;
    for (int dy = 0; dy <= kFar; ++dy) {
        for (int dx = 0; dx <= kFar; ++dx) {
            if (std::max(dx, dy) < kNear) continue;
            std::vector<double> a, b;
            for (int y = 0; y + dy < image.height; ++y) {
                for (int x = 0; x + dx < image.width; ++x) {
                    a.push_back(double{image.at(x, y)[0]});
                    b.push_back(double{image.at(x + dx, y + dy)[0]});
                }
            }
            largest = std::max(largest, std::abs(correlation(a, b)));
        }
    }
    return largest;
}

void add_coverage(Page& page, const ReproduceJob& job)
{
    constexpr int kSide = 64;
    const int seeds = job.quick ? 9 : 257;
    const double exact = 1 - own_pow(0.9, kLayers);
    Table table{
        "8 white surfaces of opacity 0.1 over black, 8 samples",
        {"sequence", "drawn", "rmse", "mean coverage", "exact", "off", "+-", "bias", "pattern"},
        {}};
    std::vector<Image> row;
    for (const char* order : kOrders) {
        const Scene scene =
            load("builtin:layers?n=8&alpha=0.1&color=1,1,1&background=0,0,0&order=" +
                 std::string(order));
        const View view = square_view(kSide, kSamples);
        const Image truth = draw_method(scene, view, "exact", job.options);
        for (const char* sequence : kSequences) {
            const std::vector<Image> images =
                draw_seeds(scene, view, with_sequence(sequence), seeds, job.options);
            const Estimate mean = estimate_mean(means_of_channel(images, 0));
            table.rows.push_back({words(sequence), words(order),
                                  number(root_of_mean(mean_squares(images, truth)), 3),
                                  number(mean.mean, 5), number(exact, 5),
                                  signed_number(mean.mean - exact, 6), number(mean.within, 6),
                                  number(bias(moments_of(images), truth), 3),
                                  number(pattern_of(images.front()), 3)});
            if (order == kOrders[0]) row.push_back(enlarge(images.front(), {0, 0, 64, 64}, 4));
        }
    }
    write_image(page.path(".png"), side_by_side(row));
    page.show(page.file(".png"),
              "Drawn from near to far, four times as large: the paper's sequence, Vegdahl's, "
              "Sobol's, independent numbers");
    page.add(table);
    page.say("`builtin:layers`, " + size_text(kSide, kSide) + " pixels, " + std::to_string(seeds) +
             " seeds. *Off*: the mean's distance from the exact one, with its interval of 99 % "
             "confidence; frames are independent, pixels of one frame are not. *rmse*, *bias*: of "
             "pixels, times 255; bias is what more seeds would not average out, and some tenths "
             "of it are chance. *Pattern*: the largest correlation between pixels of one picture, "
             "4 to 16 apart.");
}

// Bits of a number's value.
struct Listing {
    const char* title;
    std::function<std::uint32_t(std::uint32_t number, std::uint32_t pixel, std::uint32_t surface)>
        bits;
};

std::uint32_t reversed(std::uint32_t x)
{
    std::uint32_t result = 0;
    for (int bit = 0; bit < 32; ++bit) result |= (x >> bit & 1) << (31 - bit);
    return result;
}

std::vector<Listing> listings(int samples)
{
    const auto s = static_cast<std::uint32_t>(samples);
    return {{"reversed bits, not scrambled",
             [=](auto number, auto pixel, auto surface) {
                 return reversed(number + pixel * s) + surface;
             }},
            {"paper",
             [=](auto number, auto pixel, auto surface) {
                 return reference::paper_bits(number, pixel, surface, samples);
             }},
            {"vegdahl",
             [=](auto number, auto pixel, auto surface) {
                 return reference::vegdahl_bits(number + pixel * s, hash_u32(surface));
             }},
            {"sobol", [=](auto number, auto pixel, auto surface) {
                 return reference::sobol_bits(number, pixel, surface, samples);
             }}};
}

// Of the reference values of a frame's surfaces at the same samples.
void add_correlations(Page& page, const ReproduceJob& job)
{
    const int frames = job.quick ? 3 : 16;
    constexpr std::uint32_t kPixels = 4096;
    Table table{"Correlation of two surfaces' reference values",
                {"sequence", "largest", "root mean square"},
                {}};
    for (const Listing& listing : listings(kSamples)) {
        double largest = 0, squares = 0, count = 0;
        for (int frame = 0; frame < frames; ++frame) {
            const std::uint32_t key = hash_u32(static_cast<std::uint32_t>(frame) + 1);
            std::vector<std::vector<double>> values(kLayers);
            for (std::uint32_t layer = 0; layer < kLayers; ++layer) {
                for (std::uint32_t i = 0; i < kPixels * kSamples; ++i) {
                    values[layer].push_back(reference::value_of_bits(
                        listing.bits(i % kSamples, i / kSamples, key + layer)));
                }
            }
            for (std::size_t a = 0; a < kLayers; ++a) {
                for (std::size_t b = 0; b < a; ++b) {
                    const double found = correlation(values[a], values[b]);
                    largest = std::max(largest, std::abs(found));
                    squares += found * found;
                    ++count;
                }
            }
        }
        table.rows.push_back(
            {words(listing.title), number(largest, 4), number(std::sqrt(squares / count), 4)});
    }
    page.add(table);
    page.say(
        "Of each two of 8 surfaces that follow on one another, over 8 samples of 4,096 "
        "pixels along the curve, in " +
        std::to_string(frames) +
        " frames. Independent numbers would have a root mean square of 0.0055.");
}

// The mean of a picture's even rows less that of its odd rows.
double even_less_odd(const Image& image)
{
    double difference = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double value = image.at(x, y)[0];
            difference += y % 2 == 0 ? value : -value;
        }
    }
    return 2 * difference / (static_cast<double>(image.width) * image.height);
}

// One layer by one sample a pixel, as the listing has it.
double even_less_odd_of_listing(const Listing& listing, bool hilbert, int side, double alpha)
{
    Image image(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto u = static_cast<std::uint32_t>(x), v = static_cast<std::uint32_t>(y);
            const std::uint32_t pixel =
                hilbert ? reference::hilbert_index(u, v, 16384) : reference::morton_index(u, v);
            const double value = reference::value_of_bits(listing.bits(0, pixel, 0));
            image.at(x, y)[0] = alpha > value ? 1.0f : 0.0f;
        }
    }
    return even_less_odd(image);
}

void add_rows(Page& page, const ReproduceJob& job)
{
    constexpr double kAlpha = 0.3;
    const int seeds = job.quick ? 9 : 257, side = 64;
    Table table{"Even rows less odd rows: one layer of opacity 0.3, 1 sample",
                {"sequence", "curve", "mean difference", "+-", "deviation"},
                {}};
    const Scene scene = load("builtin:layers?n=1&alpha=0.3&color=1,1,1&background=0,0,0");
    for (const std::string curve : {"morton", "hilbert"}) {
        const Listing plain = listings(1).front();
        table.rows.push_back(
            {words(plain.title), words(curve),
             signed_number(even_less_odd_of_listing(plain, curve == "hilbert", side, kAlpha), 5),
             words(""), words("")});
    }
    for (const char* sequence : kSequences) {
        for (const std::string curve : {"morton", "hilbert"}) {
            std::vector<double> differences;
            for (const Image& image :
                 draw_seeds(scene, square_view(side, 1),
                            with_sequence(sequence) + ":dither=" + curve, seeds, job.options)) {
                differences.push_back(even_less_odd(image));
            }
            const Estimate mean = estimate_mean(differences);
            double squares = 0;
            for (const double d : differences) squares += d * d;
            table.rows.push_back({words(sequence), words(curve), signed_number(mean.mean, 5),
                                  number(mean.within, 5), number(std::sqrt(squares / seeds), 5)});
        }
    }
    page.add(table);
    page.say("64x64 pixels; " + std::to_string(seeds) +
             " frames, each with its own random numbers; the first two rows are of one frame "
             "without. *Deviation*: the root mean square of one frame's difference.");
}

}  // namespace

void reproduce_stratified_figure_3(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    add_coverage(page, job);
    job.progress(0.7);
    add_correlations(page, job);
    job.progress(0.8);
    add_rows(page, job);
    page.write();
}

}  // namespace sheer
