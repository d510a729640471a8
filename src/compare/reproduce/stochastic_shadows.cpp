// Figure 5 of E. Enderton et al., "Stochastic Transparency", 2011: noise of stochastic shadow maps
// by masks and correction, and the errors that the paper leaves to the eye.
#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "image/write_image.h"

namespace sheer {

namespace {

constexpr int kSamples = 8;  // of a pixel and of a texel: "all images are eight-sample MSAA"

struct Part {
    const char* letter;
    const char* caption;
    ShadowMasks masks;
    bool correction;
};

constexpr Part kParts[] = {
    {"a", "naive", ShadowMasks::naive, false},
    {"b", "stratified", ShadowMasks::stratified, false},
    {"c", "stratified, alpha corrected", ShadowMasks::stratified, true},
    {"d", "naive, alpha corrected (not in the paper)", ShadowMasks::naive, true},
    {"e", "tracked (not in the paper)", ShadowMasks::tracked, false},
    {"f", "systematic (not in the paper)", ShadowMasks::systematic, false},
    {"g", "systematic, alpha corrected (not in the paper)", ShadowMasks::systematic, true},
};
constexpr const char* kReference = "h";

// Of large triangles: where several share a texel, each has a mask of its own, and stratifying them
// helps little.
constexpr const char* kCloths = "builtin:cloth?detail=1";

// Transparent cloths and, opaque and white, the floor below them, where nothing else hides noise.
Scene cloths_over_floor()
{
    constexpr float kHeight = -0.905f;  // just below the cloths, metres
    Scene scene = load(kCloths);
    Material white;
    white.name = "floor";
    white.base_color = {0.8f, 0.8f, 0.8f};
    Mesh floor;
    floor.name = "floor";
    floor.positions = {
        {-1.4f, kHeight, -2}, {-1.4f, kHeight, 1.4f}, {2, kHeight, 1.4f}, {2, kHeight, -2}};
    floor.indices = {0, 1, 2, 0, 2, 3};
    floor.material = static_cast<std::uint32_t>(scene.materials.size());
    Object object;
    object.name = "floor";
    object.mesh = static_cast<std::uint32_t>(scene.meshes.size());
    for (const Object& other : scene.objects) object.id = std::max(object.id, other.id + 1);
    scene.materials.push_back(white);
    scene.meshes.push_back(floor);
    scene.objects.push_back(object);
    return scene;
}

View shadowed_view(const ReproduceJob& job)
{
    View view;
    view.width = view.height = job.quick ? 100 : 500;
    view.samples = kSamples;
    view.eye = Float3{1.5f, 2.4f, 4.4f};
    view.target = Float3{0.34f, -0.36f, -0.25f};
    view.fov = 23.0f;
    view.shadows.size = job.quick ? 128 : 512;
    view.shadows.samples = kSamples;
    return view;
}

Image draw(const Scene& scene, const View& view, const ReproduceJob& job, int seed)
{
    Options options = job.options;
    options.method = "exact";
    options.seed = static_cast<std::uint64_t>(seed);
    return render(scene, view, options).image;
}

std::vector<Cell> row_of(const Part& part, const Moments& moments, const Image& exact)
{
    const std::array<double, 3> mean = bias_mean(moments, exact);
    return {words(part.letter),
            words(part.caption),
            number(rmse(moments, exact), 3),
            number(noise(moments), 3),
            number(bias(moments, exact), 3),
            signed_number(mean[0], 4),
            signed_number(mean[1], 4),
            signed_number(mean[2], 4)};
}

std::string setting_text(const View& view)
{
    const std::string size = std::to_string(view.shadows.size);
    return "`" + std::string(kCloths) + "` over a white floor, " + std::to_string(view.width) +
           "x" + std::to_string(view.height) + " pixels, " + std::to_string(kSamples) +
           " samples; maps of " + size + "x" + size + " texels, " + std::to_string(kSamples) +
           " samples a texel, of which one texel's are looked up. All but the shadows is exact. "
           "The paper says no more than that its images have eight samples; its scene is its own.";
}

std::string meaning_text(int seeds)
{
    return "Against exact shadows, in linear colour times 255, over pixels, red, green and blue, "
           "and over " +
           std::to_string(seeds) +
           " seeds. *Noise* is the deviation over seeds, *bias* what more seeds would not average "
           "out, the map's resolution too, *bias mean* its signed mean.";
}

}  // namespace

void reproduce_stochastic_figure_5(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const int seeds = job.quick ? 4 : 8;
    const Scene scene = cloths_over_floor();
    View view = shadowed_view(job);
    const double pictures = 1 + seeds * static_cast<int>(std::size(kParts));
    double done = 0;
    const auto draw_one = [&](int seed) {
        Image image = draw(scene, view, job, seed);
        job.progress(++done / pictures);
        return image;
    };

    Page page(entry, job);
    Table table{"Errors of shadows",
                {"picture", "map", "rmse", "noise", "bias", "bias mean r", "g", "b"},
                {}};
    std::vector<Image> row;
    std::string caption;
    const auto show = [&](const std::string& letter, const std::string& what, const Image& image) {
        write_image(page.path("." + letter + ".exr"), image);
        write_image(page.path("." + letter + ".png"), image);
        caption += (caption.empty() ? "(" : "; (") + letter + ") " + what;
        row.push_back(image);
    };
    view.shadows.kind = ShadowKind::exact;
    const Image exact = draw_one(0);
    view.shadows.kind = ShadowKind::stochastic;
    for (const Part& part : kParts) {
        view.shadows.masks = part.masks;
        view.shadows.correction = part.correction;
        std::vector<Image> images;
        for (int seed = 0; seed < seeds; ++seed) images.push_back(draw_one(seed));
        table.rows.push_back(row_of(part, moments_of(images), exact));
        show(part.letter, part.caption, images.front());
    }
    show(kReference, "exact shadows", exact);
    write_image(page.path(".png"), side_by_side(row));

    page.say(setting_text(view));
    page.show(page.file(".png"), caption);
    page.add(table);
    page.say(meaning_text(seeds));
    page.write_text(".csv", table.csv());
    page.write();
}

}  // namespace sheer
