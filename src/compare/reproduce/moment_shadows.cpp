// Moments as shadows: maps of four moments beside stochastic ones, of things whose shadows have no
// edges and of hair. Sharpe. Moment Transparency. HPG 2018, takes its moments from shadow maps.
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "image/write_image.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr EntryScene kScenes[] = {
    {"cloth", "builtin:cloth", "builtin:cloth?detail=1"},
    {"hair", "builtin:hair?strands=15000", "builtin:hair?strands=1000"},
    {"windy-hill", "builtin:windy-hill", "builtin:windy-hill?hairs=500&cards=200"},
};

struct Map {
    const char* name;
    ShadowKind kind;
    int samples, filter;
    ShadowMasks masks = ShadowMasks::stratified;
    float overestimation = 0;
};

constexpr Map kMaps[] = {
    {"no shadows", ShadowKind::none, 1, 1},
    {"stochastic, 8 samples", ShadowKind::stochastic, 8, 1},
    {"stochastic, 16 samples", ShadowKind::stochastic, 16, 1},
    {"systematic, 16 samples", ShadowKind::stochastic, 16, 1, ShadowMasks::systematic},
    {"moments, 1 sample", ShadowKind::moment, 1, 1},
    {"moments, 8 samples", ShadowKind::moment, 8, 1},
    {"moments, 8 samples, filter 2", ShadowKind::moment, 8, 2},
    {"moments, 8 samples, overestimation 0.25", ShadowKind::moment, 8, 1, ShadowMasks::stratified,
     0.25f},
};

// Of a map, as a GPU's textures would have it: a float for each sample; four moments and their
// weight, and what is opaque.
int bytes_a_texel(const Map& map)
{
    if (map.kind == ShadowKind::none) return 0;
    return 4 * map.samples + (map.kind == ShadowKind::moment ? 20 : 0);
}

Image draw(const Scene& scene, const View& view, const ReproduceJob& job, std::uint64_t seed)
{
    Options options = job.options;
    options.method = "exact";
    options.seed = seed;
    return render(scene, view, options).image;
}

void add_scene(const EntryScene& of, const ReproduceJob& job, double& done, Page& page)
{
    const Scene scene = load(of.of(job));
    View view;
    view.width = job.quick ? 80 : 320;
    view.height = job.quick ? 60 : 240;
    view.samples = 4;
    view.shadows.size = job.quick ? 256 : 1024;
    view.shadows.kind = ShadowKind::exact;
    const Image exact = draw(scene, view, job, 0);
    Table table{of.name,
                {"map", "bytes a texel", "rmse", "noise", "bias", "mean, red", "green", "blue"},
                {}};
    std::vector<Image> row;
    std::string caption;
    for (const Map& map : kMaps) {
        view.shadows.kind = map.kind;
        view.shadows.samples = map.samples;
        view.shadows.filter = map.filter;
        view.shadows.masks = map.masks;
        view.shadows.overestimation = map.overestimation;
        std::vector<Image> images;
        const std::uint64_t seeds = map.kind == ShadowKind::stochastic && !job.quick ? 4 : 2;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            images.push_back(map.kind == ShadowKind::stochastic || seed == 0
                                 ? draw(scene, view, job, seed)
                                 : images.front());
        }
        const Moments moments = moments_of(images);
        const auto mean = bias_mean(moments, exact);
        table.rows.push_back({words(map.name), whole(bytes_a_texel(map)),
                              number(rmse(moments, exact), 3), number(noise(moments), 3),
                              number(bias(moments, exact), 3), signed_number(mean[0], 2),
                              signed_number(mean[1], 2), signed_number(mean[2], 2)});
        const bool shown = map.filter == 1 && map.samples == 8;
        if (shown) {
            row.push_back(images.front());
            caption += std::string(map.name) + "; ";
        }
        job.progress(++done / static_cast<double>(std::size(kScenes) * std::size(kMaps)));
    }
    row.push_back(exact);
    const std::string suffix = "." + std::string(of.name) + ".png";
    write_image(page.path(suffix), side_by_side(row));
    page.show(page.file(suffix), std::string(of.name) + ": " + caption + "exact shadows");
    page.add(table);
}

}  // namespace

void reproduce_moment_shadows(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    page.say(
        "All but the shadows is exact. Errors are in linear colour times 255, over all pixels, "
        "red, green and blue, against shadows by rays; the map's resolution is part of them. "
        "Maps of moments are not random. Bytes are those of a GPU's textures.");
    double done = 0;
    for (const EntryScene& of : kScenes) add_scene(of, job, done, page);
    page.write();
}

}  // namespace sheer
