// One ray of ambient occlusion a pixel, by hashed samples: figure 8 of C. Wyman and M. McGuire,
// Improved Alpha Testing Using Hashed Sampling (IEEE TVCG 25(2), 2019).
#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <sheer/sheer.h>

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

struct Way {
    const char* name;
    RaySamples samples;
    RayCells cells;
};
constexpr Way kWays[] = {{"isotropic", RaySamples::hashed, RayCells::isotropic},
                         {"anisotropic", RaySamples::hashed, RayCells::anisotropic},
                         {"random", RaySamples::random, RayCells::anisotropic}};

AmbientOcclusion rays(const Way& way, int count = 1)
{
    return {count, 0, way.samples, way.cells};
}

void light_by_sky(Scene& scene)
{
    scene.sun.color = {0, 0, 0};
    scene.lights.clear();
    scene.sky.up = scene.sky.down = {1, 1, 1};
}

void add_quad(Scene& scene, const Float3 (&corners)[4])
{
    Mesh mesh;
    mesh.positions.assign(corners, corners + 4);
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
    Object object;
    object.mesh = object.id = static_cast<std::uint32_t>(scene.objects.size());
    scene.objects.push_back(object);
}

// A plate, tilted about the picture's horizontal axis, and at its left a wall at right angles to it
// that hides half of the sky.
struct BesideWall {
    Scene scene;
    View view;

    BesideWall(double tilt, int side, double pixel)
    {
        const auto cosine = static_cast<float>(own_cos(tilt)),
                   sine = static_cast<float>(own_sin(tilt));
        const auto at = [&](float x, float along, float out) {
            return Float3{x, cosine * along + sine * out, cosine * out - sine * along};
        };
        Material material;
        material.double_sided = true;
        scene.materials = {material};
        const float far = 4096;
        add_quad(scene, {at(0, -far, 0), at(far, -far, 0), at(far, far, 0), at(0, far, 0)});
        add_quad(scene, {at(0, -far, 0), at(0, far, 0), at(0, far, far), at(0, -far, far)});
        light_by_sky(scene);
        const auto half = static_cast<float>(0.5 * side * pixel);
        Camera camera;
        camera.orthographic = true;
        camera.xmag = camera.ymag = half;
        camera.znear = 0.01f;
        camera.transform[12] = 1.5f * half;
        camera.transform[13] = 0.371f;
        camera.transform[14] = 16 - 0.371f * sine / cosine;
        scene.cameras = {camera};
        view.width = view.height = side;
        view.samples = 1;
        view.positions = SamplePositions::center;
    }
};

std::vector<double> reds(const Image& image)
{
    std::vector<double> values;
    for (const Float4& pixel : image.pixels) values.push_back(static_cast<double>(pixel[0]));
    return values;
}

void measure_shapes(const ReproduceJob& job, Page& page)
{
    constexpr int kSizes = 4;
    Table table{"Pixels along which noise is alike",
                {"tilt", "samples", "across", "down", "across / down", "1 / cos", "open"},
                {}};
    const std::vector<double> tilts =
        job.quick ? std::vector<double>{0, 75} : std::vector<double>{0, 45, 60, 75, 82};
    const int side = job.quick ? 96 : 384;
    for (const double degrees : tilts) {
        const double tilt = degrees / 90 * kRightAngle;
        for (const Way& way : kWays) {
            NoiseLengths lengths;
            double open = 0;
            for (int i = 0; i < kSizes; ++i) {
                BesideWall plate(tilt, side, std::exp2(-8 - (i + 0.5) / kSizes));
                plate.view.ambient_occlusion = rays(way);
                const auto pixels =
                    reds(draw_method(plate.scene, plate.view, "exact", job.options));
                lengths.add(pixels, side, kSizes);
                for (const double p : pixels)
                    open += p / static_cast<double>(pixels.size() * kSizes);
            }
            lengths.finish();
            table.rows.push_back({number(degrees, 0), words(way.name), number(lengths.across, 2),
                                  number(lengths.down, 2), number(lengths.across / lengths.down, 2),
                                  number(1 / own_cos(tilt), 2), number(open, 3)});
        }
    }
    page.add(table);
}

constexpr EntryScene kScenes[] = {
    {"motor", "builtin:motor?alpha=1", "builtin:motor?alpha=1&detail=0.1"},
    {"tree", "builtin:tree?cards=6000", "builtin:tree?cards=100"},
};

// In short the first alone.
std::span<const EntryScene> scenes_of(const ReproduceJob& job)
{
    return std::span(kScenes).first(job.quick ? 1 : std::size(kScenes));
}

struct Seen {
    Scene scene;
    View view;
};

Seen seen_by_sky(const EntryScene& source, const ReproduceJob& job, int width)
{
    Seen seen{load(source.of(job)), {}};
    light_by_sky(seen.scene);
    seen.view.width = job.quick ? 40 : width;
    seen.view.height = seen.view.width * 3 / 4;
    seen.view.samples = 1;
    seen.view.positions = SamplePositions::center;
    return seen;
}

// A truth of a thousand rays a pixel takes minutes at the size that is good to look at.
constexpr int kMeasured = 160, kShown = 320;

// Over all pixels, of red, green and blue: the mean of differences, or the root of their squares'.
double mean_change(const Image& a, const Image& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            sum += std::abs(static_cast<double>(a.pixels[i][c] - b.pixels[i][c]));
        }
    }
    return 255 * sum / (3 * static_cast<double>(a.pixels.size()));
}

double root_of_squares(const Image& a, const Image& b)
{
    return root_of_mean(mean_squares({a}, b));
}

// So many pixels to the right, by the samples: what is seen stays, but for its place on the screen.
Image draw_moved(const Seen& seen, const AmbientOcclusion& occlusion, double pixels, int frame,
                 const ReproduceJob& job)
{
    View view = seen.view;
    view.ambient_occlusion = occlusion;
    view.positions = SamplePositions::standard;
    view.sample_shift = {static_cast<int>(-256 * pixels), 0};
    Options options = job.options;
    options.frame = frame;
    return draw_method(seen.scene, view, "hashed-alpha-test", options);
}

void measure_motion(const ReproduceJob& job, Page& page)
{
    Table table{"Change from one frame to the next, mean of differences times 255",
                {"scene", "pixels", "isotropic", "anisotropic", "random", "64 rays",
                 "isotropic / random", "anisotropic / random"},
                {}};
    const AmbientOcclusion truth = rays(kWays[2], job.quick ? 16 : 64);
    for (const EntryScene& source : scenes_of(job)) {
        const Seen seen = seen_by_sky(source, job, kMeasured);
        const auto moves = job.quick ? std::vector{0.0, 0.25} : std::vector{0.0, 0.125, 0.25, 0.5};
        for (const double pixels : moves) {
            std::vector<double> changes;
            for (const AmbientOcclusion& occlusion :
                 {rays(kWays[0]), rays(kWays[1]), rays(kWays[2]), truth}) {
                changes.push_back(mean_change(draw_moved(seen, occlusion, 0, 0, job),
                                              draw_moved(seen, occlusion, pixels, 1, job)));
            }
            table.rows.push_back({words(source.name), number(pixels, 3), number(changes[0], 2),
                                  number(changes[1], 2), number(changes[2], 2),
                                  number(changes[3], 2), number(changes[0] / changes[2], 2),
                                  number(changes[1] / changes[2], 2)});
        }
    }
    page.add(table);
}

void measure_rays(const ReproduceJob& job, Page& page)
{
    Table table{"Root mean square error of N rays, times 255",
                {"scene", "N", "isotropic", "anisotropic", "random", "ms"},
                {}};
    const std::vector<int> counts = job.quick ? std::vector{1, 4} : std::vector{1, 4, 16, 64};
    for (const EntryScene& source : scenes_of(job)) {
        Seen seen = seen_by_sky(source, job, kMeasured);
        const auto draw = [&](const AmbientOcclusion& occlusion, Options options) {
            seen.view.ambient_occlusion = occlusion;
            options.method = "hashed-alpha-test";
            return render(seen.scene, seen.view, options);
        };
        Options averaged = job.options;
        averaged.frame = 1;
        averaged.accumulate = job.quick ? 1 : 16;
        const Image truth = draw(rays(kWays[2], job.quick ? 16 : 64), averaged).image;
        for (const int count : counts) {
            std::vector<Cell> row = {words(source.name), whole(count)};
            double ms = 0;
            for (const Way& way : kWays) {
                const Frame frame = draw(rays(way, count), job.options);
                row.push_back(number(root_of_squares(frame.image, truth), 2));
                ms = frame.stats.ms_total;
            }
            row.push_back(number(ms, 0));
            table.rows.push_back(std::move(row));
        }
    }
    page.add(table);
}

// The whole scene with anisotropic cells, and below it a part of it by each way, enlarged.
void show_figure(const ReproduceJob& job, Page& page)
{
    for (const EntryScene& source : scenes_of(job)) {
        Seen seen = seen_by_sky(source, job, kShown);
        std::vector<Image> whole, parts;
        const int width = seen.view.width / 8, height = seen.view.height / 8;
        const Crop crop{seen.view.width / 2 - width, seen.view.height / 2, width, height};
        for (const Way& way : kWays) {
            seen.view.ambient_occlusion = rays(way);
            whole.push_back(draw_method(seen.scene, seen.view, "hashed-alpha-test", job.options));
            parts.push_back(enlarge(whole.back(), crop, 8));
        }
        const std::string suffix = "." + std::string(source.name) + ".png";
        write_image(page.path(suffix), one_below_another(std::vector<Image>{side_by_side(whole),
                                                                            side_by_side(parts)}));
        page.show(page.file(suffix),
                  std::string(source.name) +
                      ", one ray a pixel, and a part of it: isotropic, anisotropic, random");
    }
}

}  // namespace

void reproduce_hashed_figure_8(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    page.say(
        "Under a sky that is white all around, one ray from each pixel's point, which either meets "
        "something or not. *Isotropic* and *anisotropic*: its two random numbers are those of the "
        "cells of hashed alpha testing. *Random*: others at every point, and in every frame. The "
        "first table is of a plate tilted by so many degrees, of whose sky a wall beside it hides "
        "half.");
    measure_shapes(job, page);
    job.progress(0.2);
    page.say("The picture moves by so many pixels, and its number in the film changes.");
    measure_motion(job, page);
    job.progress(0.5);
    page.say(
        "Against the mean of 16 frames of 64 random rays. *ms*: of the picture by random rays.");
    measure_rays(job, page);
    job.progress(0.9);
    show_figure(job, page);
    page.write();
}

}  // namespace sheer
