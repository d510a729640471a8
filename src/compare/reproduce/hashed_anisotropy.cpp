// The shape of hashed noise on surfaces seen at an angle: figures 7 and 14 of C. Wyman and M.
// McGuire, Improved Alpha Testing Using Hashed Sampling (IEEE TVCG 25(2), 2019).
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/alpha_plates.h"
#include "compare/reproduce/chart.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/noise_shape.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "image/write_image.h"
#include "support/math.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr double kRightAngle = 1.57079632679489662;
constexpr const char* kVariants[] = {"isotropic", "anisotropic", "eight-corners"};

std::string method_of(const char* variant)
{
    return std::string("hashed-alpha-test:variant=") + variant;
}

NoiseLengths lengths_of(const Plates& like, const char* variant, const ReproduceJob& job)
{
    constexpr int kSizes = 4;
    NoiseLengths lengths;
    for (int i = 0; i < kSizes; ++i) {
        Plates plates = like;
        plates.place = place_number(i);
        plates.pixel = std::exp2(-8 - (i + 0.5) / kSizes);
        lengths.add(draw_plates(plates, method_of(variant), job.options), plates.side, kSizes);
    }
    lengths.finish();
    return lengths;
}

void measure_plates(const ReproduceJob& job, Page& page)
{
    Table table{"Pixels along which noise is alike",
                {"tilt", "axes", "variant", "across", "down", "across / down", "1 / cos"},
                {}};
    const std::vector<double> tilts =
        job.quick ? std::vector<double>{0, 75} : std::vector<double>{0, 45, 60, 75, 82};
    for (const double tilt : tilts) {
        std::vector<Series> lines;
        for (const bool turned : {false, true}) {
            for (const char* variant : kVariants) {
                Plates plates;
                plates.side = job.quick ? 128 : 512;
                plates.tilt = tilt / 90 * kRightAngle;
                plates.turned = turned;
                const NoiseLengths lengths = lengths_of(plates, variant, job);
                table.rows.push_back({number(tilt, 0), words(turned ? "turned" : "along"),
                                      words(variant), number(lengths.across, 2),
                                      number(lengths.down, 2),
                                      number(lengths.across / lengths.down, 2),
                                      number(1 / own_cos(plates.tilt), 2)});
                if (turned) continue;
                lines.push_back({std::string(variant) + ", across", {}, lengths.along_x});
                lines.push_back({std::string(variant) + ", down", {}, lengths.along_y});
            }
        }
        for (Series& line : lines) {
            for (std::size_t i = 1; i <= line.y.size(); ++i) {
                line.x.push_back(static_cast<double>(i));
            }
        }
        const std::string suffix = "." + fixed(tilt, 0) + ".svg";
        page.write_text(
            suffix, log_linear_chart("Autocorrelation, tilted by " + fixed(tilt, 0) + " degrees",
                                     lines, "pixels apart"));
        page.show(page.file(suffix), "autocorrelation, tilted by " + fixed(tilt, 0) + " degrees");
    }
    page.add(table);
}

struct Shown {
    const char* method;
    int samples;
};

struct Figure {
    const char* source;
    const char* suffix;
    std::vector<Shown> all;
};

// Side by side; the truth last.
void show_figure(const ReproduceJob& job, const Figure& figure, Page& page)
{
    Scene scene = load(figure.source);
    View view;
    view.width = view.height = job.quick ? 60 : 240;
    view.camera = "grazing";
    std::vector<Image> pictures;
    std::string caption = std::string(figure.source) + ", from left to right: ";
    const auto draw = [&](const std::string& method, int samples) {
        view.samples = samples;
        view.positions = samples == 1 ? SamplePositions::center : SamplePositions::standard;
        pictures.push_back(draw_method(scene, view, method, job.options));
    };
    for (const Shown& shown : figure.all) {
        draw(shown.method, shown.samples);
        caption += std::string(shown.method) + " (" + std::to_string(shown.samples) + "); ";
    }
    mask_as_blend(scene);
    draw("exact", 64);
    write_image(page.path(figure.suffix), side_by_side(pictures));
    page.show(page.file(figure.suffix), caption + "blended (64)");
}

}  // namespace

void reproduce_hashed_anisotropy(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    page.say(
        "A plate of opacity 1/2, tilted about the picture's horizontal axis by so many degrees; "
        "whether a pixel passes, and the pixel so many to the right or below. A pixel is 1 / cos "
        "of the tilt as high on the plate as it is wide, and so is a cell that is as large along "
        "each axis as a pixel is high: noise is that much wider than high. Axes: the space of "
        "the noise is the picture's, or turned about two of its axes. The mean over four "
        "distances within an octave.");
    measure_plates(job, page);
    job.progress(0.7);
    show_figure(job,
                {"builtin:fence",
                 ".figure-7.png",
                 {{"alpha-test", 1},
                  {"hashed-alpha-test:variant=isotropic", 1},
                  {"hashed-alpha-test:variant=anisotropic", 1}}},
                page);
    show_figure(job,
                {"builtin:checker",
                 ".figure-14.png",
                 {{"alpha-test", 1},
                  {"hashed-alpha-test:variant=isotropic", 1},
                  {"hashed-alpha-test:variant=anisotropic", 1},
                  {"hashed-alpha-to-coverage:variant=isotropic", 8},
                  {"hashed-alpha-to-coverage:variant=anisotropic", 8}}},
                page);
    page.write();
}

}  // namespace sheer
