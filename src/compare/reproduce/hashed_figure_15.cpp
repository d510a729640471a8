// Alpha tests where shading is coarse: figure 15 of C. Wyman and M. McGuire, Improved Alpha Testing
// Using Hashed Sampling (IEEE TVCG 25(2), 2019).
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/alpha_models.h"
#include "compare/reproduce/alpha_plates.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "compare/turns.h"
#include "image/write_image.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr const char* kWays[] = {"alpha-test", "hashed-alpha-test",
                                 "hashed-alpha-test:variant=isotropic"};
constexpr std::size_t kCount = std::size(kWays);

// Pixels' distances from what is looked at: within once, to twice, beyond; as --foveate's.
constexpr const char* kZones[] = {"full rate", "2x2", "4x4"};

std::size_t zone_of(const Foveation& foveation, int x, int y)
{
    const double off = std::hypot(x + 0.5 - static_cast<double>(foveation.x),
                                  y + 0.5 - static_cast<double>(foveation.y));
    const double radius = static_cast<double>(foveation.radius);
    return off <= radius ? 0 : off <= 2 * radius ? 1 : 2;
}

// The mean alpha in each zone.
std::array<double, 3> alphas(const Image& image, const Foveation& foveation)
{
    std::array<double, 3> sums = {}, counts = {};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::size_t zone = zone_of(foveation, x, y);
            const auto at = static_cast<std::size_t>(y * image.width + x);
            sums[zone] += static_cast<double>(image.pixels[at][3]);
            counts[zone] += 1;
        }
    }
    for (std::size_t zone = 0; zone < 3; ++zone) sums[zone] /= counts[zone];
    return sums;
}

// Of opacity, as parts of the truth's: by zone, full rate and foveated, one for each look.
struct Parts {
    std::vector<double> full[3], foveated[3];
};

void measure_models(const ReproduceJob& job, Page& page)
{
    const int pixels = job.quick ? 64 : 256, looks = job.quick ? 6 : 24;
    Table table{"Opacity, as part of the truth's (standard error)",
                {"model", "zone", "method", "full rate", "its error", "foveated", "error"},
                {}};
    for (const AlphaModel& model : alpha_models(job.quick)) {
        Parts parts[kCount];
        for (int i = 0; i < looks; ++i) {
            Scene scene = seen(model, look_number(i, model), pixels);
            View view = view_of(pixels, 1);
            // Looked at is the middle of the left side, so that all zones have a third of it.
            const Foveation foveation{0, 0.5f * static_cast<float>(pixels + 2),
                                      static_cast<float>(pixels + 2) / 3};
            Image drawn[kCount][2];
            for (std::size_t w = 0; w < kCount; ++w) {
                view.foveation = std::nullopt;
                drawn[w][0] = draw_method(scene, view, kWays[w], job.options);
                view.foveation = foveation;
                drawn[w][1] = draw_method(scene, view, kWays[w], job.options);
            }
            mask_as_blend(scene);
            const auto truth =
                alphas(draw_method(scene, view_of(pixels, 16), "exact", job.options), foveation);
            for (std::size_t w = 0; w < kCount; ++w) {
                const auto full = alphas(drawn[w][0], foveation);
                const auto coarse = alphas(drawn[w][1], foveation);
                for (std::size_t zone = 0; zone < 3; ++zone) {
                    if (!(truth[zone] > 0)) continue;
                    parts[w].full[zone].push_back(full[zone] / truth[zone]);
                    parts[w].foveated[zone].push_back(coarse[zone] / truth[zone]);
                }
            }
        }
        for (std::size_t zone = 0; zone < 3; ++zone) {
            for (std::size_t w = 0; w < kCount; ++w) {
                const auto &full = parts[w].full[zone], &coarse = parts[w].foveated[zone];
                table.rows.push_back({words(model.name), words(kZones[zone]), words(kWays[w]),
                                      number(mean_of(full), 3), number(standard_error(full), 3),
                                      number(mean_of(coarse), 3),
                                      number(standard_error(coarse), 3)});
            }
        }
    }
    page.add(table);
}

// A ring around what is at full rate, as the paper's figure has it.
void draw_circle(Image& image, const Foveation& foveation)
{
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double off = std::hypot(x + 0.5 - static_cast<double>(foveation.x),
                                          y + 0.5 - static_cast<double>(foveation.y));
            if (std::abs(off - static_cast<double>(foveation.radius)) > 1) continue;
            image.pixels[static_cast<std::size_t>(y * image.width + x)] = {1, 0.8f, 0, 1};
        }
    }
}

struct Figure {
    Scene scene;
    View view;
};

// Looked at is the left half of the picture.
Figure hill(const ReproduceJob& job)
{
    Figure figure{load(job.quick ? "builtin:windy-hill?alpha=mask&hairs=100&cards=600"
                                 : "builtin:windy-hill?alpha=mask"),
                  {}};
    figure.view.width = job.quick ? 96 : 640;
    figure.view.height = job.quick ? 72 : 480;
    figure.view.samples = 1;
    figure.view.positions = SamplePositions::center;
    const auto width = static_cast<float>(figure.view.width);
    figure.view.foveation = Foveation{0.3f * width, 0.4f * width, 0.2f * width};
    return figure;
}

void show_figure(const ReproduceJob& job, Page& page)
{
    Figure figure = hill(job);
    std::vector<Image> pictures;
    for (const char* way : {"alpha-test", "hashed-alpha-test"}) {
        pictures.push_back(draw_method(figure.scene, figure.view, way, job.options));
        draw_circle(pictures.back(), *figure.view.foveation);
    }
    write_image(page.path(".figure-15.png"), side_by_side(pictures));
    page.show(page.file(".figure-15.png"),
              "builtin:windy-hill?alpha=mask, foveated: alpha test, hashed alpha test");
}

// Of the picture's pixels: at most so many points are shaded of a surface that fills it.
double points_of(const View& view)
{
    double points = 0;
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const auto zone = zone_of(*view.foveation, x, y);
            points += zone == 0 ? 1 : zone == 1 ? 0.25 : 0.0625;
        }
    }
    return points / (static_cast<double>(view.width) * view.height);
}

void measure_cost(const ReproduceJob& job, Page& page)
{
    Figure figure = hill(job);
    const std::optional<Foveation> foveation = figure.view.foveation;
    Table table{"Times on the hill, ms, medians",
                {"rays of ambient occlusion", "full rate", "foveated", "foveated / full",
                 "points of a plain surface"},
                {}};
    for (const int rays : {0, 1}) {
        figure.view.ambient_occlusion.rays = rays;
        std::vector<double> full, coarse, ratios;
        for (int i = 0; i < (job.quick ? 1 : 5); ++i) {
            const auto ms = [&](const std::optional<Foveation>& at) {
                figure.view.foveation = at;
                Options options = job.options;
                options.method = "hashed-alpha-test";
                const Stats stats = render(figure.scene, figure.view, options).stats;
                return stats.ms_raster_shade;
            };
            full.push_back(ms(std::nullopt));
            coarse.push_back(ms(foveation));
            ratios.push_back(coarse.back() / full.back());
        }
        table.rows.push_back({whole(rays), number(median(full), 1), number(median(coarse), 1),
                              number(median(ratios), 3), number(points_of(figure.view), 3)});
    }
    page.add(table);
}

}  // namespace

void reproduce_hashed_figure_15(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    page.say(
        "Alpha-mapped models, looked at in the middle of the picture's left side: full rate within "
        "a third of its width from there, squares of 2x2 pixels to two thirds, of 4x4 beyond. The "
        "truth is the blended picture at full rate, 16 samples a pixel.");
    measure_models(job, page);
    job.progress(0.6);
    show_figure(job, page);
    page.say(
        "*Times* of rasterising and shading: visibility stays at full rate. The last column is how "
        "many points are shaded of a triangle that fills the picture, as part of its pixels.");
    measure_cost(job, page);
    page.write();
}

}  // namespace sheer
