// Section 6 of E. Enderton et al., "Stochastic Transparency", 2011, adaptive sampling: "a noise
// level that is uniform and under artist's control", and how many frames that saves.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "cpu/adaptive_frames.h"
#include "image/write_image.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr const char* kDepthBased = "stochastic:masks=stratified:depth-based=on:correction=on";
constexpr int kTile = 32;  // pixels

// Of all tiles that lie in the picture as a whole: the largest mean, over a tile's pixels and over
// red, green and blue, of the variance over seeds.
double largest_variance(const Moments& moments)
{
    const Image& variance = moments.variance;
    double largest = 0;
    for (int y0 = 0; y0 + kTile <= variance.height; y0 += kTile) {
        for (int x0 = 0; x0 + kTile <= variance.width; x0 += kTile) {
            double sum = 0;
            for (int y = y0; y < y0 + kTile; ++y) {
                for (int x = x0; x < x0 + kTile; ++x) {
                    for (std::size_t c = 0; c < 3; ++c) {
                        sum += static_cast<double>(variance.at(x, y)[c]);
                    }
                }
            }
            largest = std::max(largest, sum / (3 * kTile * kTile));
        }
    }
    return largest;
}

double noise_of(double variance)
{
    return kUnitsOfWhite * std::sqrt(variance);
}

struct Adapted {
    Moments moments;
    double frames = 0;  // of a pixel, on average, pilots too
    double most = 0;    // of any pixel
    Image shown;        // of the first seed
    std::vector<float> counts;
};

Adapted adapt(const Scene& scene, const View& view, float target, int seeds, Options options)
{
    Adapted adapted;
    options.method = kDepthBased;
    options.adaptive.noise_target = target;
    options.channels = true;
    std::vector<Image> images;
    for (int seed = 0; seed < seeds; ++seed) {
        options.seed = static_cast<std::uint64_t>(seed);
        Frame frame = render(scene, view, options);
        adapted.frames += frame.stats.frames_per_pixel / seeds;
        images.push_back(std::move(frame.image));
        if (seed == 0) adapted.counts = std::move(frame.channels->frames);
    }
    adapted.most = *std::max_element(adapted.counts.begin(), adapted.counts.end());
    adapted.moments = moments_of(images);
    adapted.shown = std::move(images.front());
    return adapted;
}

// Black for none, white for the most.
Image counts_picture(const Adapted& adapted, const View& view)
{
    Image picture(view.width, view.height);
    for (std::size_t i = 0; i < adapted.counts.size(); ++i) {
        const float grey = adapted.counts[i] / static_cast<float>(adapted.most);
        picture.pixels[i] = {grey, grey, grey, 1};
    }
    return picture;
}

}  // namespace

void reproduce_stochastic_adaptive(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const int seeds = job.quick ? 3 : 4;
    View view;
    view.width = view.height = job.quick ? 96 : 500;
    const Scene scene = load(job.quick ? "builtin:motor?detail=0.3" : "builtin:motor");
    const std::vector<float> targets = job.quick ? std::vector<float>{2} : std::vector<float>{2, 1};
    const double steps = static_cast<double>(targets.size()) + 1;
    const Moments even = moments_of(draw_seeds(scene, view, kDepthBased, seeds, job.options));
    const double even_variance = largest_variance(even);
    job.progress(1 / steps);

    Page page(entry, job);
    Table table{"Frames for an even noise",
                {"noise target", "largest noise of a tile", "noise", "frames", "of which pilots",
                 "most frames", "uniform frames for the same largest noise", "part of those"},
                {}};
    table.rows.push_back({words("none"), number(noise_of(even_variance), 2), number(noise(even), 2),
                          number(1, 1), number(0, 0), number(1, 0), number(1, 1), number(1, 2)});
    for (const float target : targets) {
        const Adapted adapted = adapt(scene, view, target, seeds, job.options);
        const double reached = largest_variance(adapted.moments);
        const double needed = even_variance / reached;
        table.rows.push_back(
            {words(fixed(static_cast<double>(target), 1)), number(noise_of(reached), 2),
             number(noise(adapted.moments), 2), number(adapted.frames, 1), number(kPilotFrames, 0),
             number(adapted.most, 0), number(needed, 1), number(adapted.frames / needed, 2)});
        const std::string suffix = "." + fixed(static_cast<double>(target), 0) + ".png";
        write_image(page.path(suffix),
                    side_by_side(std::vector<Image>{adapted.shown, counts_picture(adapted, view)}));
        page.show(page.file(suffix), "Target " + fixed(static_cast<double>(target), 1) +
                                         ": the picture, and the frames of each pixel, white for "
                                         "the most");
        job.progress(static_cast<double>(table.rows.size()) / steps);
    }
    page.add(table);
    page.say("The motor, depth based and corrected, 8 samples, " +
             size_text(view.width, view.height) +
             " pixels, `--noise-target`; standard deviations "
             "over " +
             std::to_string(seeds) + " seeds in linear colour times 255, of tiles of " +
             size_text(kTile, kTile) +
             " pixels and of the whole picture. *Uniform frames*: as "
             "many as would bring the noisiest tile's variance down to that which was reached, "
             "were all pixels drawn alike.");
    page.write();
}

}  // namespace sheer
