// What ambient occlusion must be where geometry says it: a white surface under a white sky has the
// part of it that is open as its radiance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <sheer/sheer.h>

#include "methods/statistics.h"
#include "same_bits.h"
#include "shadows/sheets.h"

namespace sheer {
namespace {

using test::add_mesh;

// A four-cornered face between two edges.
struct Face {
    Float3 corner, edge1, edge2;
};

Mesh mesh_of(const std::vector<Face>& faces)
{
    Mesh mesh;
    for (const Face& face : faces) {
        const auto at = [&](float a, float b) {
            Float3 p = face.corner;
            for (std::size_t c = 0; c < 3; ++c) p[c] += a * face.edge1[c] + b * face.edge2[c];
            return p;
        };
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), {at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
        for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
    }
    return mesh;
}

Mesh box(const Float3& low, const Float3& high)
{
    const Float3 x = {high[0] - low[0], 0, 0}, y = {0, high[1] - low[1], 0},
                 z = {0, 0, high[2] - low[2]};
    return mesh_of({{low, x, y},
                    {low, y, z},
                    {low, z, x},
                    {{low[0], low[1], high[2]}, x, y},
                    {{high[0], low[1], low[2]}, y, z},
                    {{low[0], high[1], low[2]}, z, x}});
}

Material white(float opacity = 1)
{
    Material material = test::sheet_of(opacity);
    if (opacity == 1) material.alpha_mode = AlphaMode::opaque;
    return material;
}

Scene under_white_sky()
{
    Scene scene;
    scene.sun.color = {0, 0, 0};
    scene.sky.up = scene.sky.down = {1, 1, 1};
    return scene;
}

Mesh floor(float half)
{
    return mesh_of({{{-half, 0, -half}, {0, 0, 2 * half}, {2 * half, 0, 0}}});
}

AmbientOcclusion rays(int count, RaySamples samples = RaySamples::hashed,
                      RayCells cells = RayCells::anisotropic)
{
    return {count, 0, samples, cells};
}

const AmbientOcclusion kKinds[] = {rays(1), rays(1, RaySamples::hashed, RayCells::isotropic),
                                   rays(1, RaySamples::random), rays(5),
                                   rays(16, RaySamples::random)};

// Of the floor around a point, straight down.
View look_down(int size, const Float3& at)
{
    View view;
    view.width = view.height = size;
    view.samples = 1;
    view.eye = Float3{at[0], at[1] + 0.05f, at[2] + 1e-4f};
    view.target = at;
    view.fov = 10.0f;
    view.background = Float4{0, 0, 0, 0};
    return view;
}

// The value of all the picture's pixels that show something.
void expect_everywhere(const Image& image, float value)
{
    std::size_t shown = 0;
    for (const Float4& pixel : image.pixels) {
        if (pixel[3] == 0) continue;
        ++shown;
        ASSERT_EQ(pixel[0], value);
    }
    EXPECT_GT(shown, image.pixels.size() / 8);
}

TEST(AmbientOcclusion, NothingHidesTheSkyFromAPlane)
{
    Scene scene = under_white_sky();
    add_mesh(scene, floor(100), white());
    View view = look_down(48, {0.3f, 0, 0.2f});
    for (const AmbientOcclusion& kind : kKinds) {
        view.ambient_occlusion = kind;
        expect_everywhere(render(scene, view, {}).image, 1);
    }
    // At a glance, where places are known worst.
    view.eye = Float3{7, 0.2f, 3};
    view.target = Float3{0, 0, 0};
    view.fov = 40.0f;
    view.samples = 4;
    view.ambient_occlusion = rays(8);
    for (const Float4& pixel : render(scene, view, {}).image.pixels) {
        EXPECT_NEAR(pixel[0], pixel[3], 1e-6f);
    }
}

// Rays that would go into the surface, since its normals lean, go out of it.
TEST(AmbientOcclusion, NorFromWhatIsConvex)
{
    Scene scene = under_white_sky();
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.normals = mesh.positions;
    mesh.indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    add_mesh(scene, mesh, white());
    View view = look_down(48, {0, 0, 0});
    view.eye = Float3{1, 2, 3};
    view.fov = 30.0f;
    for (const AmbientOcclusion& kind : kKinds) {
        view.ambient_occlusion = kind;
        expect_everywhere(render(scene, view, {}).image, 1);
    }
}

TEST(AmbientOcclusion, InsideOfAClosedBoxThereIsNone)
{
    Scene scene = under_white_sky();
    add_mesh(scene, box({-1, -1, -1}, {1, 1, 1}), white());
    View view;
    view.width = view.height = 48;
    view.samples = 1;
    view.eye = Float3{0.1f, 0.2f, 0.3f};
    view.target = Float3{0.5f, -1, 0.4f};
    view.fov = 100.0f;
    for (const AmbientOcclusion& kind : kKinds) {
        view.ambient_occlusion = kind;
        expect_everywhere(render(scene, view, {}).image, 0);
        view.ambient_occlusion.radius = 5;  // more than the diagonal
        expect_everywhere(render(scene, view, {}).image, 0);
    }
    // What is farther does not count.
    view = look_down(48, {0, -1, 0});
    view.ambient_occlusion = rays(4);
    view.ambient_occlusion.radius = 0.9f;
    expect_everywhere(render(scene, view, {}).image, 1);
}

// The part that a wall of height h leaves to a point at the distance d from its foot, very wide:
// (1 + d / sqrt(d^2 + h^2)) / 2, for rays in proportion to the cosine; evenly spread ones that come
// out at 1 - atan(h / d) / pi.
void expect_part(float distance, float height, RaySamples samples, double pixels_alike)
{
    Scene scene = under_white_sky();
    add_mesh(scene, floor(2000), white());
    add_mesh(scene, mesh_of({{{-2000, 0, 0}, {4000, 0, 0}, {0, height, 0}}}), white());
    View view = look_down(96, {0.3f, 0, distance});
    view.ambient_occlusion = rays(1, samples);
    std::vector<double> open = channel_of(render(scene, view, {}).image, 0);
    double sum = 0;
    for (const double value : open) {
        ASSERT_TRUE(value == 0 || value == 1);
        sum += value;
    }
    const double d = static_cast<double>(distance), h = static_cast<double>(height);
    const double expected = 0.5 * (1 + d / std::sqrt(d * d + h * h));
    const auto count = static_cast<double>(open.size());
    // The picture is 9 mm wide: the slope, at most 1 / (2 h), changes the mean by less than the
    // curvature, 1 / h^2, times the square of that; and the wall's ends are h / 2000 away.
    const double bias = 1e-4 + h / 2000 * h / 2000;
    EXPECT_LE(std::abs(sum / count - expected),
              bias + kZ * std::sqrt(expected * (1 - expected) * pixels_alike / count))
        << distance << " from a wall " << height << " high: " << sum / count;
}

TEST(AmbientOcclusion, AWallHidesWhatTheCosineSays)
{
    expect_part(0.02f, 200, RaySamples::random, 1);  // half of the sky
    expect_part(1, 1, RaySamples::random, 1);        // .854; evenly spread rays have .75
    // Hashed numbers are alike in pixels of a cell, which is at most two pixels wide and high; of
    // two sizes that are mixed.
    expect_part(0.02f, 200, RaySamples::hashed, 9);
    expect_part(1, 1, RaySamples::hashed, 9);
}

// Of what is transparent the rest passes, whichever side is met.
TEST(AmbientOcclusion, OccludersHideAsMuchAsTheyDoOfThePicture)
{
    const auto open_below = [](const Material& lid) {
        Scene scene = under_white_sky();
        add_mesh(scene, floor(1), white());
        add_mesh(scene, box({-2, -2, -2}, {2, 2, 2}), lid);
        View view = look_down(24, {0.3f, 0, 0.2f});
        view.ambient_occlusion = rays(4);
        return render(scene, view, {}).image;
    };
    Material lid = white(0.25f);
    expect_everywhere(open_below(lid), 0.75f);
    lid.double_sided = false;
    expect_everywhere(open_below(lid), 0.75f);
    lid.alpha_mode = AlphaMode::mask;
    lid.alpha_cutoff = 0.5f;
    expect_everywhere(open_below(lid), 1);
    lid.alpha_cutoff = 0.25f;
    expect_everywhere(open_below(lid), 0);
    lid.shading = Shading::unlit;
    expect_everywhere(open_below(lid), 1);
}

TEST(AmbientOcclusion, TransparentFragmentsHaveTheirPartOfTheSky)
{
    Scene scene = under_white_sky();
    add_mesh(scene, box({-1, -1, -1}, {1, 1, 1}), white());
    add_mesh(scene, floor(1), white(0.5f));
    View view = look_down(24, {0.3f, 0, 0.2f});
    view.ambient_occlusion = rays(4);
    expect_everywhere(render(scene, view, {}).image, 0);
    view.ambient_occlusion.radius = 0.4f;  // and the box below is in the dark no more
    expect_everywhere(render(scene, view, {}).image, 1);
}

// A wall that hides half of the sky, and a view along its foot.
struct BesideAWall {
    Scene scene = under_white_sky();
    View view;

    BesideAWall()
    {
        add_mesh(scene, floor(64), white());
        add_mesh(scene, mesh_of({{{-64, 0, 0}, {128, 0, 0}, {0, 64, 0}}}), white());
        view.width = view.height = 64;
        view.samples = 1;
        view.background = Float4{0, 0, 0, 0};
        look_at(0);
    }
    // From above, a pixel 1/128 m wide; so many pixels farther along the wall.
    void look_at(int pixels)
    {
        Camera camera;
        camera.orthographic = true;
        camera.xmag = camera.ymag = 0.25f;
        camera.znear = 0.01f;
        const float x = static_cast<float>(pixels) / 128;
        camera.transform = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, x, 1, 0.375f, 1};
        scene.cameras = {camera};
    }
    std::vector<double> draw(int frame = 0) const
    {
        Options options;
        options.frame = frame;
        return channel_of(render(scene, view, options).image, 0);
    }
};

double change(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

TEST(AmbientOcclusion, HashedNoiseIsTheSameInAllFrames)
{
    BesideAWall beside;
    for (const RayCells cells : {RayCells::isotropic, RayCells::anisotropic}) {
        beside.view.ambient_occlusion = rays(1, RaySamples::hashed, cells);
        EXPECT_EQ(beside.draw(0), beside.draw(7));
    }
    beside.view.ambient_occlusion = rays(1, RaySamples::random);
    // Half of the sky is hidden: independent rays differ in half of the pixels.
    EXPECT_GT(change(beside.draw(0), beside.draw(7)), 0.25);
}

TEST(AmbientOcclusion, HashedNoiseMovesWithTheSurface)
{
    constexpr int kPixels = 8;
    BesideAWall beside;
    const auto moved = [&](RaySamples samples) {
        beside.view.ambient_occlusion = rays(1, samples);
        beside.look_at(0);
        const std::vector<double> before = beside.draw();
        beside.look_at(kPixels);
        const std::vector<double> after = beside.draw(1);
        double changes = 0, count = 0;
        for (std::size_t y = 0; y < 64; ++y) {
            for (std::size_t x = 0; x + kPixels < 64; ++x) {
                changes += std::abs(before[64 * y + x + kPixels] - after[64 * y + x]);
                ++count;
            }
        }
        return changes / count;
    };
    // Places that are a rounding off change cells at their sides alone.
    EXPECT_LT(moved(RaySamples::hashed), 0.01);
    EXPECT_GT(moved(RaySamples::random), 0.25);
}

TEST(AmbientOcclusion, RandomRaysAreAveraged)
{
    BesideAWall beside;
    const auto spread = [&](RaySamples samples, int frames) {
        beside.view.ambient_occlusion = rays(1, samples);
        Options options;
        options.accumulate = frames;
        const Image image = render(beside.scene, beside.view, options).image;
        return observe(channel_of(image, 0)).variance;
    };
    EXPECT_LT(spread(RaySamples::random, 16), spread(RaySamples::random, 1) / 4);
    EXPECT_EQ(spread(RaySamples::hashed, 16), spread(RaySamples::hashed, 1));
}

TEST(AmbientOcclusion, SameBitsOnEveryLevelAndAnyNumberOfThreads)
{
    View view;
    view.width = 40;
    view.height = 34;
    view.samples = 4;
    for (const char* source :
         {"builtin:tree?cards=100", "builtin:quads", SHEER_SOURCE_DIR "/scenes/tea_table.glb"}) {
        const Scene scene = load(source);
        for (const AmbientOcclusion& kind : kKinds) {
            if (kind.rays > 5) continue;
            view.ambient_occlusion = kind;
            expect_same_bits(scene, view, "blend", source);
        }
    }
}

TEST(AmbientOcclusion, ChangesNothingButColours)
{
    const Scene scene = load("builtin:tree?cards=600");
    View view;
    view.width = view.height = 64;
    view.background = Float4{0, 0, 0, 0};
    for (const char* method : {"hashed-alpha-test", "alpha-test", "stochastic", "exact"}) {
        Options options;
        options.method = method;
        view.ambient_occlusion = {};
        const Image without = render(scene, view, options).image;
        view.ambient_occlusion = rays(1);
        const Image with = render(scene, view, options).image;
        EXPECT_NE(with.pixels, without.pixels) << method;
        EXPECT_EQ(channel_of(with, 3), channel_of(without, 3)) << method;
    }
}

}  // namespace
}  // namespace sheer
