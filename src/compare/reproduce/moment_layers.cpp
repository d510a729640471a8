// Layers by numbers of a counter, and their fragments.
#include "compare/reproduce/moment_layers.h"

#include "support/math.h"

namespace sheer {

namespace {

constexpr double kLeft = 0.1;  // what passes through all layers

}  // namespace

void set_opacities(const CounterRandom& random, Layers& layers)
{
    std::vector<double> depths;
    double sum = 0;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        depths.push_back(0.5 + random.uniform(2 * i));
        sum += depths.back();
    }
    for (std::size_t i = 0; i < layers.size(); ++i) {
        layers[i].opacity = 1 - own_exp(own_log(kLeft) * depths[i] / sum);
    }
}

Layers random_layers(int count, std::uint64_t trial)
{
    const CounterRandom random{trial};
    Layers layers;
    for (int i = 0; i < count; ++i) {
        layers.push_back({2 * random.uniform(2 * static_cast<std::uint64_t>(i) + 1) - 1, 0});
    }
    set_opacities(random, layers);
    return layers;
}

PixelFragments pixel_of(const Layers& layers)
{
    PixelFragments pixel(0, 0);
    pixel.eye = {true, 0.1f, 1000.0f, 2.0f, 4.0f};
    for (const Layer& layer : layers) {
        PixelFragment f{};
        f.depth = static_cast<float>(3 + layer.place);
        f.run.depth.least = f.run.depth.most = f.depth;
        f.run.primitive = static_cast<std::uint32_t>(pixel.fragments.size());
        f.samples = ~0ull;
        f.opacity = static_cast<float>(layer.opacity);
        pixel.fragments.push_back(f);
    }
    return pixel;
}

std::vector<float> own_depths(const PixelFragments& pixel)
{
    std::vector<float> depths;
    for (const PixelFragment& f : pixel.fragments) depths.push_back(f.depth);
    return depths;
}

}  // namespace sheer
