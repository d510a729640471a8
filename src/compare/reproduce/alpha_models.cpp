// Models out of built-in scenes, or made of what these are made of.
#include "compare/reproduce/alpha_models.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <sheer/sheer.h>

#include "scene/builtin/draws.h"
#include "scene/builtin/plant_images.h"
#include "scene/builtin/plants.h"
#include "scene/builtin/stage.h"
#include "support/math.h"

namespace sheer {

namespace {

using shapes::Vec;

constexpr double kGolden = 0.61803398874989485;

double part_of_turn(int i, double step, double from)
{
    const double t = from + i * step;
    return t - std::floor(t);
}

// The MASK surfaces of a scene, unlit.
Scene masks_of(Scene scene)
{
    std::vector<Object> objects;
    for (const Object& object : scene.objects) {
        if (material_of(scene, object).alpha_mode == AlphaMode::mask) objects.push_back(object);
    }
    scene.objects = std::move(objects);
    for (Material& material : scene.materials) material.shading = Shading::unlit;
    scene.background = Float4{0, 0, 0, 0};
    return scene;
}

Float3 least_of(const Mesh& mesh)
{
    Float3 least = mesh.positions.front();
    for (const Float3& p : mesh.positions) {
        for (std::size_t c = 0; c < 3; ++c) least[c] = std::min(least[c], p[c]);
    }
    return least;
}

Float3 most_of(const Mesh& mesh)
{
    Float3 most = mesh.positions.front();
    for (const Float3& p : mesh.positions) {
        for (std::size_t c = 0; c < 3; ++c) most[c] = std::max(most[c], p[c]);
    }
    return most;
}

// Moves the mesh's middle to the origin; what it then reaches to.
float centre(Mesh& mesh)
{
    const Float3 least = least_of(mesh), most = most_of(mesh);
    float radius = 0;
    for (Float3& p : mesh.positions) {
        for (std::size_t c = 0; c < 3; ++c) p[c] -= 0.5f * (least[c] + most[c]);
        radius = std::max({radius, std::abs(p[1]), std::hypot(p[0], p[2])});
    }
    return radius;
}

AlphaModel finish(std::string name, Scene scene, float card)
{
    AlphaModel model{std::move(name), masks_of(std::move(scene)), 1, card, false};
    model.radius = centre(model.scene.meshes[model.scene.objects.front().mesh]);
    return model;
}

// A piece of the built-in fence, half as wide again at both sides as it is high.
AlphaModel fence()
{
    Scene scene = masks_of(load("builtin:fence"));
    Mesh& mesh = scene.meshes[scene.objects.front().mesh];
    const float height = 2.4f, meshes = 32;  // of the netting, metres
    mesh.positions = {{-2 * height, 2 * height, 0},
                      {-2 * height, -2 * height, 0},
                      {2 * height, -2 * height, 0},
                      {2 * height, 2 * height, 0}};
    mesh.normals.clear();
    mesh.texcoords[0] = {{0, 0}, {0, 4 * meshes}, {4 * meshes, 4 * meshes}, {4 * meshes, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return {"fence", std::move(scene), height / 2, 4 * height, true};
}

AlphaModel fern()
{
    Scene scene;
    Mesh mesh;
    Draws draws(77, 1);
    add_fern(mesh, {0, 0, 0}, 1, draws);
    const LeafColors colors = {{0.1, 0.25, 0.03}, {0.3, 0.45, 0.12}, {0.2, 0.4, 0.05}};
    add_mesh(
        scene, std::move(mesh),
        add_card_material(scene, "fronds", make_frond_image("fronds", colors), AlphaMode::mask));
    return finish("fern", std::move(scene), 0.5f);
}

// Strands that part and end at several lengths: .19 of the image, as of the paper's bearded man's
// .32 are ("partly due to artist-added padding").
TextureImage hair_image()
{
    constexpr int kStrands = 26;
    return paint_image(
        "hair", 128, 256, 3,
        [](double u, double v) {
            Paint paint{{0.2, 0.12, 0.06}, 0};
            for (int i = 0; i < kStrands; ++i) {
                Draws draws(78, static_cast<std::uint64_t>(i));
                const double root = draws.between(0.12, 0.88), swing = 0.14 * draws.bell();
                const double length = draws.between(0.45, 1), bow = 0.05 * draws.bell();
                const double x = root + swing * v + bow * own_sin(shapes::kPi * v);
                const double half_width = 0.0095 * (1 - 0.6 * v / length);
                if (v < length && std::abs(u - x) < half_width) paint.alpha = 1;
            }
            return paint;
        },
        {0.2, 0.12, 0.06});
}

// Cards that hang from a head's upper half, in several rows over one another.
AlphaModel hair()
{
    Scene scene;
    Mesh mesh;
    constexpr int kCards = 90;
    for (int i = 0; i < kCards; ++i) {
        Draws draws(79, static_cast<std::uint64_t>(i));
        const double angle = 2 * shapes::kPi * part_of_turn(i, kGolden, 0);
        const double height = 0.02 + 0.09 * std::sqrt((i + 0.5) / kCards);
        const double radius = std::sqrt(std::max(0.0, 0.0121 - height * height));
        const Vec out = {own_cos(angle), 0, own_sin(angle)};
        BentCard card;
        card.foot = radius * out + Vec{0, height, 0};
        card.length = draws.between(0.12, 0.2);
        card.up = 0.35 * out + Vec{0, -0.8, 0};
        card.lean = 0.2 * draws.bell() * out + Vec{0, -0.2, 0};
        card.across = 0.025 * cross({0, 1, 0}, out);
        card.rows = 4;
        add_bent_card(mesh, card);
    }
    add_mesh(scene, std::move(mesh),
             add_card_material(scene, "hair", hair_image(), AlphaMode::mask));
    return finish("hair", std::move(scene), 0.05f);
}

}  // namespace

AlphaModel alpha_tree(int cards)
{
    return finish("tree", load("builtin:tree?cards=" + std::to_string(cards)),
                  0.23f * std::sqrt(60000.0f / static_cast<float>(cards)));
}

std::vector<AlphaModel> alpha_models(bool quick)
{
    std::vector<AlphaModel> models;
    models.push_back(fence());
    models.push_back(alpha_tree(quick ? 600 : 6000));
    models.push_back(fern());
    models.push_back(hair());
    return models;
}

Look look_number(int i, const AlphaModel& model)
{
    Look look;
    const double turn = part_of_turn(i, kGolden, 0.11);
    look.azimuth = model.is_flat ? 1.22 * (turn - 0.5) : 2 * shapes::kPi * turn;
    look.elevation = 0.3 * (part_of_turn(i, 0.7548776662466927, 0.2) - 0.5);
    // The plastic number's powers, which spread points evenly (M. Roberts 2018).
    look.right = part_of_turn(i, 0.7548776662466927, 0.5);
    look.down = part_of_turn(i, 0.5698402909980532, 0.5);
    Draws draws(80, static_cast<std::uint64_t>(i));
    for (float& c : look.place) c = static_cast<float>(draws.between(0, 64)) * model.radius;
    return look;
}

Scene seen(const AlphaModel& model, const Look& look, int pixels)
{
    Scene scene = model.scene;
    const double pixel = 2 * static_cast<double>(model.radius) / pixels;
    const double distance = 8 * static_cast<double>(model.radius);
    const double ca = own_cos(look.azimuth), sa = own_sin(look.azimuth);
    const double ce = own_cos(look.elevation), se = own_sin(look.elevation);
    const Vec right = {ca, 0, -sa}, up = {-sa * se, ce, -ca * se}, back = {sa * ce, se, ca * ce};
    const Vec eye = Vec{look.place[0], look.place[1], look.place[2]} +
                    (distance - look.nearer * pixel) * back - look.right * pixel * right +
                    look.down * pixel * up;
    Camera camera;
    const Vec columns[] = {right, up, back, eye};
    for (std::size_t c = 0; c < 4; ++c) {
        const Float3 column = to_float(columns[c]);
        std::copy(column.begin(), column.end(), camera.transform.begin() + 4 * static_cast<int>(c));
    }
    const double half = static_cast<double>(model.radius) * (pixels + 2) / pixels;
    camera.orthographic = !look.perspective;
    camera.xmag = camera.ymag = static_cast<float>(half);
    camera.yfov = static_cast<float>(2 * own_atan2(half, distance));
    camera.znear = 0.1f * model.radius;
    scene.cameras = {camera};
    for (Object& object : scene.objects) {
        object.transform = kIdentity;
        std::copy(look.place.begin(), look.place.end(), object.transform.begin() + 12);
    }
    return scene;
}

View view_of(int pixels, int samples)
{
    View view;
    view.width = view.height = pixels + 2;
    view.samples = samples;
    view.positions = samples == 1 ? SamplePositions::center : SamplePositions::standard;
    view.background = Float4{0, 0, 0, 0};
    return view;
}

double mean_alpha(const Image& image)
{
    double sum = 0;
    for (const Float4& pixel : image.pixels) sum += static_cast<double>(pixel[3]);
    return sum / static_cast<double>(image.pixels.size());
}

double mean_square_alpha(const Image& a, const Image& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double off =
            static_cast<double>(a.pixels[i][3]) - static_cast<double>(b.pixels[i][3]);
        sum += off * off;
    }
    return sum / static_cast<double>(a.pixels.size());
}

}  // namespace sheer
