// Section 6 of E. Enderton et al., "Stochastic Transparency", 2011: what a fragment's random
// numbers depend on shows in motion, where one object presents several fragments to a pixel, and
// where two fragments meet inside of a surface.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "support/math.h"

namespace sheer {

namespace {

constexpr const char* kSeedings[] = {"depth", "primitive", "object", "object-alone"};
constexpr int kSamples = 8;

Options basic_seeded_by(const char* seeding, const ReproduceJob& job)
{
    Options options = job.options;
    options.method = "stochastic:masks=stratified:depth-based=off:correction=off:seed-by=" +
                     std::string(seeding);
    return options;
}

View square_view(int side)
{
    View view;
    view.width = view.height = side;
    view.samples = kSamples;
    return view;
}

// Mean and deviation of numbers that come one by one.
class Tally {
public:
    void add(double value) { values_.push_back(value); }
    double count() const { return static_cast<double>(values_.size()); }
    double mean() const
    {
        double sum = 0;
        for (const double value : values_) sum += value;
        return sum / count();
    }
    double deviation() const { return std::sqrt(central(2) * count() / (count() - 1)); }
    double error_of_mean() const { return deviation() / std::sqrt(count()); }
    // As test_deviation has it, with the fourth moment as it was measured.
    double error_of_deviation() const
    {
        const double variance = central(2);
        return std::sqrt(std::max(0.0, central(4) - variance * variance) / count()) /
               (2 * std::sqrt(variance));
    }

private:
    double central(int order) const
    {
        const double m = mean();
        double sum = 0;
        for (const double value : values_) {
            const double squared = (value - m) * (value - m);
            sum += order == 2 ? squared : squared * squared;
        }
        return sum / count();
    }

    std::vector<double> values_;
};

// Absolute changes, over pixels and channels.
double mean_change(const Image& a, const Image& b)
{
    double sum = 0;
    for (std::size_t p = 0; p < a.pixels.size(); ++p) {
        for (std::size_t c = 0; c < 3; ++c) {
            sum += std::abs(double{a.pixels[p][c]} - double{b.pixels[p][c]});
        }
    }
    return sum / (3.0 * static_cast<double>(a.pixels.size()));
}

// The camera goes to its own right by parts of a pixel, as seen at the motor's middle.
struct Motion {
    int frames;
    double pixels;  // a frame
};

void move_camera(Camera& camera, double metres)
{
    for (std::size_t i = 0; i < 3; ++i) {
        camera.transform[12 + i] += static_cast<float>(metres * camera.transform[i]);
    }
}

double change_over(const Motion& motion, int side, const Options& options, bool new_seeds)
{
    constexpr double kDistance = 10.9;  // of the motor's camera
    double sum = 0;
    Image before;
    for (int frame = 0; frame < motion.frames; ++frame) {
        Scene scene = load("builtin:motor");
        Camera& camera = scene.cameras.front();
        const double pixel = 2 * kDistance * own_tan(camera.yfov / 2.0) / side;
        move_camera(camera, frame * motion.pixels * pixel);
        Options of_frame = options;
        if (new_seeds) of_frame.seed = static_cast<std::uint64_t>(frame);
        Image image = render(scene, square_view(side), of_frame).image;
        if (frame > 0) sum += mean_change(image, before) / (motion.frames - 1);
        before = std::move(image);
    }
    return sum * 255;
}

void add_motion(Page& page, const ReproduceJob& job)
{
    const int side = job.quick ? 100 : 500;
    const int frames = job.quick ? 2 : 9;
    Table table{"Motion",
                {"seeded by", "pixels a frame", "change of exact", "change", "beyond exact",
                 "of what new random numbers change"},
                {}};
    for (const double pixels : {0.0, 0.125, 1.0}) {
        const Motion motion{frames, pixels};
        Options exact = job.options;
        exact.method = "exact";
        const double least = change_over(motion, side, exact, false);
        const double most = change_over(motion, side, basic_seeded_by("primitive", job), true);
        const auto add = [&](const std::string& what, double change) {
            table.rows.push_back({words(what), number(pixels, 3), number(least, 4),
                                  number(change, 4), number(change - least, 4),
                                  number((change - least) / (most - least), 3)});
        };
        for (const char* seeding : kSeedings) {
            add(seeding, change_over(motion, side, basic_seeded_by(seeding, job), false));
        }
        add("new random numbers", most);
    }
    page.add(table);
    page.say("`builtin:motor`, basic method, 8 samples, " + std::to_string(side) + "x" +
             std::to_string(side) + " pixels, " + std::to_string(frames) +
             " frames; the camera moves to its right. Mean absolute change from frame to frame, "
             "times 255.");
}

// Without caps; the camera sees its front and back walls.
Scene make_cylinder()
{
    constexpr int kSides = 64;
    constexpr double kTurn = 6.283185307179586;
    Mesh mesh;
    mesh.name = "cylinder";
    for (std::uint32_t i = 0; i <= kSides; ++i) {
        const double angle = kTurn * i / kSides;
        for (const float y : {-2.0f, 2.0f}) {
            mesh.positions.push_back(
                {static_cast<float>(own_cos(angle)), y, static_cast<float>(own_sin(angle))});
        }
        if (i == kSides) break;
        const std::uint32_t a = 2 * i, b = a + 1, c = a + 2, d = a + 3;
        mesh.indices.insert(mesh.indices.end(), {a, b, c, c, b, d});
    }
    Material white;
    white.shading = Shading::unlit;
    white.opacity = 0.5f;
    white.alpha_mode = AlphaMode::blend;
    white.double_sided = true;
    Scene scene;
    scene.materials = {white};
    scene.meshes = {mesh};
    scene.objects = {{"cylinder", 0, kIdentity, 0, 1}};
    Camera camera;
    camera.orthographic = true;
    camera.transform[14] = 5;  // at z = 5, along -z
    camera.xmag = camera.ymag = 1.25f;
    scene.cameras = {camera};
    scene.background = {0, 0, 0, 1};
    return scene;
}

void add_cylinder(Page& page, const ReproduceJob& job)
{
    Table table{"A cylinder's two walls",
                {"seeded by", "mean", "standard error", "exact", "too transparent by"},
                {}};
    const Scene scene = make_cylinder();
    const View view = square_view(job.quick ? 64 : 256);
    Options exact = job.options;
    exact.method = "exact";
    const Image truth = render(scene, view, exact).image;
    for (const char* seeding : kSeedings) {
        Tally seen, right;
        for (int seed = 0; seed < (job.quick ? 1 : 16); ++seed) {
            Options options = basic_seeded_by(seeding, job);
            options.seed = static_cast<std::uint64_t>(seed);
            const Image image = render(scene, view, options).image;
            for (std::size_t p = 0; p < image.pixels.size(); ++p) {
                if (truth.pixels[p][0] < 0.7499f) continue;
                seen.add(image.pixels[p][0]);
                right.add(truth.pixels[p][0]);
            }
        }
        table.rows.push_back({words(seeding), number(seen.mean(), 5),
                              number(seen.error_of_mean(), 5), number(right.mean(), 5),
                              signed_number(right.mean() - seen.mean(), 5)});
    }
    page.add(table);
    page.say(
        "White, opacity 0.5, over black, so that two walls have 0.75: where one mask serves "
        "both, the back wall is hidden where the front one is and shows nowhere else. *object* "
        "also tells the sides of a surface apart, *object-alone* does not. Over the pixels with "
        "both walls at all samples.");
}

void add_edges(Page& page, const ReproduceJob& job)
{
    Table table{"Noise at an edge inside of a surface",
                {"seeded by", "pixels within one triangle: deviation", "standard error",
                 "pixels with two", "standard error", "ratio"},
                {}};
    const int seeds = job.quick ? 4 : 32;
    const Scene scene = load("builtin:layers?n=1&alpha=0.3&color=1,1,1&background=0,0,0");
    const View view = square_view(job.quick ? 100 : 500);
    for (const char* seeding : kSeedings) {
        Tally inside, edge;
        for (int seed = 0; seed < seeds; ++seed) {
            Options options = basic_seeded_by(seeding, job);
            options.seed = static_cast<std::uint64_t>(seed);
            options.channels = true;
            const Frame frame = render(scene, view, options);
            for (std::size_t p = 0; p < frame.image.pixels.size(); ++p) {
                const bool both = frame.channels->fragments[p] == 2;
                // Of the many pixels inside every 16th is enough.
                if (both) edge.add(frame.image.pixels[p][0]);
                if (!both && p % 16 == 0) inside.add(frame.image.pixels[p][0]);
            }
        }
        table.rows.push_back({words(seeding), number(inside.deviation(), 5),
                              number(inside.error_of_deviation(), 5), number(edge.deviation(), 5),
                              number(edge.error_of_deviation(), 5),
                              number(edge.deviation() / inside.deviation(), 3)});
    }
    page.add(table);
    page.say(
        "One quad of opacity 0.3, white over black, 8 samples at the standard positions; "
        "pixels on its diagonal hold fragments of both triangles, each with a mask of its own "
        "where the seed tells them apart (they have one depth). Exact: 0.06124 for one mask, "
        "0.16202 for naive ones.");
}

}  // namespace

void reproduce_stochastic_seeding(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    add_motion(page, job);
    job.progress(0.7);
    add_cylinder(page, job);
    job.progress(0.75);
    add_edges(page, job);
    page.write();
}

}  // namespace sheer
