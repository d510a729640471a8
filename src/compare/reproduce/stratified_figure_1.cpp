// Figure 1 of S. Laine and T. Karras, "Stratified Sampling for Stochastic Transparency", 2011:
// noise that clumps, edges that show, and several layers.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/estimate.h"
#include "compare/metrics.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "image/write_image.h"

namespace sheer {

namespace {

constexpr const char* kMethods[] = {kDepthTested, kStratified};
// Pixels; a metre each. So chosen that edges go through pixels at many offsets.
constexpr int kSide = 216;
constexpr int kBlock = 8;  // pixels across

struct Strip {
    const char* title;
    int top, height;  // pixels
    float from, to;   // opacities at the left and at the right
    int pieces;       // quads side by side; their edges go through pixels
};

constexpr Strip kStrips[] = {{"ramp from 0 to 1", 0, 64, 0, 1, 1},
                             {"one quad of 0.61", 64, 64, 0.61f, 0.61f, 1},
                             {"five quads of 0.75", 128, 88, 0.75f, 0.75f, 5}};

void add_quad(Scene& scene, const Strip& strip, int piece)
{
    const auto left = static_cast<float>(kSide * piece) / static_cast<float>(strip.pieces);
    const auto right = static_cast<float>(kSide * (piece + 1)) / static_cast<float>(strip.pieces);
    const auto top = static_cast<float>(kSide - strip.top);
    const float bottom = top - static_cast<float>(strip.height);
    Mesh mesh;
    mesh.name = strip.title;
    mesh.positions = {{left, bottom, 0}, {right, bottom, 0}, {right, top, 0}, {left, top, 0}};
    const Float4 first = {1, 1, 1, strip.from}, last = {1, 1, 1, strip.to};
    mesh.colors = {first, last, last, first};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    const auto index = static_cast<std::uint32_t>(scene.meshes.size());
    scene.meshes.push_back(std::move(mesh));
    scene.objects.push_back({strip.title, index, kIdentity, index, 1});
}

Scene make_strips()
{
    Scene scene;
    Material white;
    white.shading = Shading::unlit;
    white.alpha_mode = AlphaMode::blend;
    white.double_sided = true;
    scene.materials = {white};
    for (const Strip& strip : kStrips) {
        for (int piece = 0; piece < strip.pieces; ++piece) add_quad(scene, strip, piece);
    }
    Camera camera;
    camera.orthographic = true;
    constexpr float kHalf = 0.5f * kSide;
    camera.xmag = camera.ymag = kHalf;
    camera.transform[12] = camera.transform[13] = kHalf;
    camera.transform[14] = 1;
    scene.cameras = {camera};
    scene.background = {0, 0, 0, 1};
    return scene;
}

// Of the means of an error over blocks of a part of the picture.
struct BlockErrors {
    double mean_square = 0, largest = 0;  // times 255, absolute
};

BlockErrors block_errors(const Image& image, const Image& exact, const Crop& crop)
{
    BlockErrors errors;
    double count = 0;
    for (int top = crop.y; top + kBlock <= crop.y + crop.height; top += kBlock) {
        for (int left = crop.x; left + kBlock <= crop.x + crop.width; left += kBlock) {
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0;
                for (int i = 0; i < kBlock * kBlock; ++i) {
                    const int x = left + i % kBlock, y = top + i / kBlock;
                    sum += double{image.at(x, y)[c]} - double{exact.at(x, y)[c]};
                }
                const double mean = sum / (kBlock * kBlock) * kUnitsOfWhite;
                errors.mean_square += mean * mean;
                errors.largest = std::max(errors.largest, std::abs(mean));
                ++count;
            }
        }
    }
    errors.mean_square /= count;
    return errors;
}

// How much more of the error is left in the means of blocks than if pixels were independent, whose
// mean square falls with their number: 1 for white noise, less where noise is dithered. Blocks
// begin `offset` pixels from the part's corner.
double clumping(const std::vector<Image>& images, const Image& exact, Crop crop, int offset)
{
    const auto inside = [&](std::size_t p) {
        const int x = static_cast<int>(p) % exact.width, y = static_cast<int>(p) / exact.width;
        return x >= crop.x && x < crop.x + crop.width && y >= crop.y && y < crop.y + crop.height;
    };
    const double of_pixels = root_of_mean(mean_squares(images, exact, inside));
    crop = {crop.x + offset, crop.y + offset, crop.width - offset, crop.height - offset};
    std::vector<double> of_blocks;
    for (const Image& image : images) {
        of_blocks.push_back(block_errors(image, exact, crop).mean_square);
    }
    return root_of_mean(of_blocks) * kBlock / of_pixels;
}

double largest_block_error(const std::vector<Image>& images, const Image& exact, const Crop& crop)
{
    double largest = 0;
    for (const Image& image : images) {
        largest = std::max(largest, block_errors(image, exact, crop).largest);
    }
    return largest;
}

void show_row(Page& page, const std::string& name, const std::vector<Image>& row,
              const std::string& caption)
{
    write_image(page.path("." + name + ".png"), side_by_side(row));
    page.show(page.file("." + name + ".png"),
              caption + ": the comparison, the paper's method, exact");
}

void add_strips(Page& page, const ReproduceJob& job)
{
    const int seeds = job.quick ? 9 : 65;
    const Scene scene = make_strips();
    View view;
    view.width = view.height = kSide;
    view.samples = 16;
    Options options = job.options;
    options.channels = true;
    options.method = "exact";
    const Frame exact = render(scene, view, options);
    Table table{"Quads, 16 samples",
                {"quads", "method", "rmse", "inside", "on edges", "edges by inside", "clumping",
                 "clumping, blocks moved by 4", "largest block error"},
                {}};
    std::vector<Image> whole, large;
    for (const char* method : kMethods) {
        const std::vector<Image> images = draw_seeds(scene, view, method, seeds, job.options);
        for (const Strip& strip : kStrips) {
            const Crop crop{0, strip.top, kSide, strip.height};
            const auto has = [&](std::size_t p, bool edge) {
                const int y = static_cast<int>(p) / kSide;
                return y >= strip.top && y < strip.top + strip.height &&
                       (exact.channels->fragments[p] > 1) == edge;
            };
            const auto error = [&](bool inside, bool edges) {
                return root_of_mean(mean_squares(images, exact.image, [&](std::size_t p) {
                    return (inside && has(p, false)) || (edges && has(p, true));
                }));
            };
            table.rows.push_back({words(strip.title), words(method), number(error(true, true), 3),
                                  number(error(true, false), 3), number(error(false, true), 3),
                                  number(error(false, true) / error(true, false), 3),
                                  number(clumping(images, exact.image, crop, 0), 3),
                                  number(clumping(images, exact.image, crop, kBlock / 2), 3),
                                  number(largest_block_error(images, exact.image, crop), 3)});
        }
        whole.push_back(images.front());
        large.push_back(enlarge(images.front(), {32, 104, 64, 64}, 4));
    }
    whole.push_back(exact.image);
    large.push_back(enlarge(exact.image, {32, 104, 64, 64}, 4));
    show_row(page, "quads", whole, "Quads of " + std::to_string(view.samples) + " samples");
    show_row(page, "quads-large", large, "A part of them, four times as large");
    page.add(table);
    page.say("White quads on black, " + std::to_string(seeds) +
             " seeds; errors are root mean squares in linear colour times 255. *On edges*: over "
             "pixels that hold fragments of two triangles, on the diagonals of quads and, of the "
             "five, between them. *Clumping*: the error of means over 8x8 pixels by what it is "
             "for independent pixels with the same error, 1 for white noise. *Largest block "
             "error*: of such means, at multiples of 8 pixels, over all seeds.");
}

void add_cloth(Page& page, const ReproduceJob& job)
{
    const int seeds = job.quick ? 3 : 9;
    const Scene scene = load("builtin:cloth");
    View view;
    view.width = view.height = job.quick ? 96 : 500;
    view.samples = 64;
    const Image exact = draw_method(scene, view, "exact", job.options);
    Table table{"Cloth, 64 samples", {"method", "rmse", "clumping"}, {}};
    std::vector<Image> large;
    std::vector<std::vector<double>> squares;
    const int part = view.width / 4;
    const Crop crop{view.width * 3 / 8, view.width * 3 / 8, part, part};
    for (const char* method : kMethods) {
        const std::string letter = squares.empty() ? "a" : "b";
        const std::vector<Image> images = draw_seeds(scene, view, method, seeds, job.options);
        squares.push_back(mean_squares(images, exact));
        table.rows.push_back(
            {words(method), number(root_of_mean(squares.back()), 3),
             number(clumping(images, exact, {0, 0, view.width, view.height}, 0), 3)});
        write_image(page.path(".cloth." + letter + ".png"), images.front());
        large.push_back(enlarge(images.front(), crop, 3));
    }
    large.push_back(enlarge(exact, crop, 3));
    show_row(page, "cloth", large, "`builtin:cloth`, a part, three times as large");
    page.add(table);
    const RatioEstimate ratio = estimate_ratio(squares[1], squares[0]);
    page.say("`builtin:cloth`, " + std::to_string(view.width) + "x" + std::to_string(view.height) +
             " pixels, " + std::to_string(seeds) +
             " seeds, against the exact picture at the same samples. The paper's method has " +
             number(ratio.ratio, 3).text + " times the comparison's error (" +
             number(ratio.least, 3).text + " to " + number(ratio.most, 3).text +
             " with 99 % confidence).");
}

}  // namespace

void reproduce_stratified_figure_1(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    add_strips(page, job);
    job.progress(0.3);
    add_cloth(page, job);
    page.write();
}

}  // namespace sheer
