// Figure 6 of S. Laine and T. Karras, "Stratified Sampling for Stochastic Transparency", 2011: what
// sorting the samples does where the farther of two surfaces is drawn first.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/estimate.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "image/write_image.h"

namespace sheer {

namespace {

constexpr int kSamples = 16;

struct Part {
    const char* letter;
    const char* title;
    std::string method;
};

const Part kParts[] = {{"a", "compaction", stratified_with("sort=off")},
                       {"b", "compaction and sorting", kStratified},
                       {"c", "the comparison", kDepthTested}};

// A few triangles of a mesh, in its order, as one of their own.
Mesh cut_piece(const Mesh& mesh, std::size_t first, std::size_t last)
{
    Mesh piece;
    piece.name = mesh.name;
    piece.material = mesh.material;
    for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t vertex = mesh.indices[i];
        piece.indices.push_back(static_cast<std::uint32_t>(piece.positions.size()));
        piece.positions.push_back(mesh.positions[vertex]);
        piece.normals.push_back(mesh.normals[vertex]);
        piece.texcoords[0].push_back(mesh.texcoords[0][vertex]);
    }
    return piece;
}

// The triangles of all cloths in random order, as the paper has them: each cloth's are, so that
// pieces of the cloths by turns will do.
Scene mix_cloths(const Scene& cloths)
{
    constexpr std::size_t kPiece = 3 * 16;  // indices
    Scene mixed = cloths;
    mixed.meshes.clear();
    mixed.objects.clear();
    const std::size_t most = cloths.meshes.front().indices.size();  // all have as many
    for (std::size_t first = 0; first < most; first += kPiece) {
        for (const Object& cloth : cloths.objects) {
            const auto index = static_cast<std::uint32_t>(mixed.meshes.size());
            mixed.meshes.push_back(
                cut_piece(cloths.meshes[cloth.mesh], first, std::min(most, first + kPiece)));
            mixed.objects.push_back({cloth.name, index, cloth.transform, index, 1});
        }
    }
    return mixed;
}

enum class Drawn { otherwise, near_to_far, far_to_near };

// How the two layers of a pixel that has two were drawn: blending in the order of submission is
// exact where that is from far to near.
std::vector<Drawn> order_of_layers(const Scene& scene, const View& view, Options options)
{
    constexpr float kRounding = 1e-5f;
    options.channels = true;
    options.method = "exact";
    const Frame exact = render(scene, view, options);
    const Image blended = draw_method(scene, view, "blend", options);
    std::vector<Drawn> orders;
    for (std::size_t p = 0; p < blended.pixels.size(); ++p) {
        float off = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            off = std::max(off, std::abs(blended.pixels[p][c] - exact.image.pixels[p][c]));
        }
        const bool two = exact.channels->fragments[p] == 2;
        orders.push_back(!two              ? Drawn::otherwise
                         : off < kRounding ? Drawn::far_to_near
                                           : Drawn::near_to_far);
    }
    return orders;
}

// White where the farther layer came first, black where the nearer one did.
Image draw_orders(const std::vector<Drawn>& orders, int side)
{
    Image image(side, side);
    for (std::size_t p = 0; p < orders.size(); ++p) {
        const float grey = orders[p] == Drawn::far_to_near   ? 1.0f
                           : orders[p] == Drawn::near_to_far ? 0.0f
                                                             : 0.2f;
        image.pixels[p] = {grey, grey, grey, 1};
    }
    return image;
}

void add_orders(Page& page, const Scene& scene, View view, int seeds, const ReproduceJob& job)
{
    view.positions = SamplePositions::center;
    const std::vector<Drawn> orders = order_of_layers(scene, view, job.options);
    const Image exact = draw_method(scene, view, "exact", job.options);
    Table table{"Pixels with two layers, by the order in which these were drawn",
                {"part", "with", "near to far", "far to near", "far to near by near to far",
                 "least", "most"},
                {}};
    std::vector<Image> row;
    const int part = view.width / 5;
    const Crop crop{view.width * 2 / 5, view.width * 2 / 5, part, part};
    for (const Part& p : kParts) {
        const std::vector<Image> images = draw_seeds(scene, view, p.method, seeds, job.options);
        const auto squares = [&](Drawn drawn) {
            return mean_squares(images, exact, [&](std::size_t i) { return orders[i] == drawn; });
        };
        const auto near = squares(Drawn::near_to_far), far = squares(Drawn::far_to_near);
        const RatioEstimate ratio = estimate_ratio(far, near);
        table.rows.push_back({words(p.letter), words(p.title), number(root_of_mean(near), 3),
                              number(root_of_mean(far), 3), number(ratio.ratio, 3),
                              number(ratio.least, 3), number(ratio.most, 3)});
        write_image(page.path("." + std::string(p.letter) + ".png"), images.front());
        row.push_back(enlarge(images.front(), crop, 3));
    }
    row.push_back(enlarge(exact, crop, 3));
    row.push_back(enlarge(draw_orders(orders, view.width), crop, 3));
    write_image(page.path(".png"), side_by_side(row));
    page.show(page.file(".png"),
              "Without sorting, with it, the comparison, exact; white: the farther of two layers "
              "came first, black: the nearer one, grey: other than two layers");
    page.add(table);
    const auto count = [&](Drawn drawn) {
        return std::to_string(std::count(orders.begin(), orders.end(), drawn));
    };
    page.say(
        "`builtin:cloth`, the triangles of both cloths in random order, " +
        std::to_string(kSamples) + " samples at the pixel's centre, " + std::to_string(view.width) +
        "x" + std::to_string(view.width) + " pixels, " + std::to_string(seeds) +
        " seeds; root mean square errors in linear colour times 255. " + count(Drawn::near_to_far) +
        " pixels with two layers were drawn from near to far, " + count(Drawn::far_to_near) +
        " from far to near. The ratio has its interval of 99 % confidence.");
}

void add_all(Page& page, const Scene& scene, const View& view, int seeds, const ReproduceJob& job)
{
    Table table{"All pixels, standard positions", {"part", "with", "rmse"}, {}};
    const Image exact = draw_method(scene, view, "exact", job.options);
    for (const Part& p : kParts) {
        const auto images = draw_seeds(scene, view, p.method, seeds, job.options);
        table.rows.push_back({words(p.letter), words(p.title),
                              number(root_of_mean(mean_squares(images, exact)), 3)});
    }
    page.add(table);
}

}  // namespace

void reproduce_stratified_figure_6(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const Scene scene = mix_cloths(load("builtin:cloth"));
    const int seeds = job.quick ? 5 : 17;
    View view;
    view.width = view.height = job.quick ? 100 : 500;
    view.samples = kSamples;
    Page page(entry, job);
    add_orders(page, scene, view, seeds, job);
    job.progress(0.6);
    add_all(page, scene, view, seeds, job);
    page.write();
}

}  // namespace sheer
