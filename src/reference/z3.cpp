#include "reference/z3.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <tuple>
#include <vector>

namespace sheer::reference {
namespace {

struct Layer {
    double depth = 0, slope_x = 0, slope_y = 0;
    std::uint32_t id = 0;
    std::uint64_t mask = 0;
    double color[3] = {0, 0, 0};  // premultiplied
    double alpha = 0;
};

Layer layer_of(const SlopedFragment& sloped)
{
    const Fragment& f = sloped.fragment;
    const double a = f.opacity;
    return {f.depth,  sloped.slope_x, sloped.slope_y,
            f.id,     sloped.mask,    {a * f.color[0], a * f.color[1], a * f.color[2]},
            f.opacity};
}

bool nearer(const Layer& a, const Layer& b)
{
    return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
}

Layer join(const Layer& front, const Layer& behind, Z3Depth depth)
{
    const auto part = [&](std::uint64_t mask) {
        return static_cast<double>(std::popcount(mask)) / std::popcount(front.mask | behind.mask);
    };
    const double of_front = part(front.mask);
    const double alone = part(behind.mask & ~front.mask), both = part(behind.mask & front.mask);
    const double of_behind = alone + both * (1 - front.alpha);
    Layer joined = front;
    joined.mask |= behind.mask;
    for (int c = 0; c < 3; ++c) {
        joined.color[c] = of_front * front.color[c] + of_behind * behind.color[c];
    }
    joined.alpha = of_front * front.alpha + of_behind * behind.alpha;
    if (depth == Z3Depth::mean) {
        joined.depth = (front.depth + behind.depth) / 2;
        joined.slope_x = (front.slope_x + behind.slope_x) / 2;
        joined.slope_y = (front.slope_y + behind.slope_y) / 2;
    }
    return joined;
}

void join_closest(std::vector<Layer>& layers, Z3Depth depth, bool* doubtful = nullptr)
{
    const auto gap = [&](std::size_t i) { return layers[i + 1].depth - layers[i].depth; };
    std::size_t closest = 0;
    for (std::size_t i = 1; i + 1 < layers.size(); ++i) {
        if (gap(i) < gap(closest)) closest = i;
    }
    const auto as_float = [&](std::size_t i) { return static_cast<float>(gap(i)); };
    for (std::size_t i = 0; doubtful != nullptr && i + 1 < layers.size(); ++i) {
        if (gap(i) != gap(closest) && as_float(i) == as_float(closest)) *doubtful = true;
    }
    layers[closest] = join(layers[closest], layers[closest + 1], depth);
    layers.erase(layers.begin() + static_cast<std::ptrdiff_t>(closest) + 1);
}

void insert_sorted(std::vector<Layer>& layers, const Layer& layer)
{
    layers.insert(std::upper_bound(layers.begin(), layers.end(), layer, nearer), layer);
}

Rgba seen_by(std::vector<Layer> layers, std::size_t s, SamplePoint sample, Rgba backdrop)
{
    std::erase_if(layers, [&](const Layer& layer) { return (layer.mask >> s & 1) == 0; });
    for (Layer& layer : layers) {
        layer.depth += layer.slope_x * (sample.x / 256.0 - 0.5);
        layer.depth += layer.slope_y * (sample.y / 256.0 - 0.5);
    }
    std::sort(layers.begin(), layers.end(), nearer);
    Rgba sum;
    double through = 1;
    for (const Layer& layer : layers) {
        sum.r += through * layer.color[0];
        sum.g += through * layer.color[1];
        sum.b += through * layer.color[2];
        through *= 1 - layer.alpha;
    }
    return {sum.r + through * backdrop.r, sum.g + through * backdrop.g,
            sum.b + through * backdrop.b, 1 - through * (1 - backdrop.a)};
}

}  // namespace

Rgba z3_pixel(std::span<const SlopedFragment> fragments, int layers, Z3Depth depth,
              std::span<const SamplePoint> samples, Rgba backdrop)
{
    std::vector<Layer> kept;
    for (const SlopedFragment& f : fragments) {
        insert_sorted(kept, layer_of(f));
        if (kept.size() > static_cast<std::size_t>(layers)) join_closest(kept, depth);
    }
    Rgba mean;
    const auto n = static_cast<double>(samples.size());
    for (std::size_t s = 0; s < samples.size(); ++s) {
        const Rgba one = seen_by(kept, s, samples[s], backdrop);
        mean = {mean.r + one.r / n, mean.g + one.g / n, mean.b + one.b / n, mean.a + one.a / n};
    }
    return mean;
}

Rgba z3(std::span<const Fragment> fragments, int layers, Z3Depth depth, Rgba backdrop,
        bool* doubtful)
{
    std::vector<Layer> kept;
    for (const Fragment& f : fragments) {
        insert_sorted(kept, layer_of({f, 0, 0, 1}));
        if (kept.size() <= static_cast<std::size_t>(layers)) continue;
        join_closest(kept, depth, doubtful);
        if (doubtful == nullptr) continue;
        for (Layer& layer : kept)
            layer.depth = static_cast<double>(static_cast<float>(layer.depth));
    }
    return seen_by(kept, 0, {128, 128}, backdrop);
}

}  // namespace sheer::reference
