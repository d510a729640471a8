// Full-screen layers whose random pictures have known moments: as scenes for render(), and as
// fragments for a store of one's own.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "methods/fragment_lists.h"
#include "methods/method.h"
#include "reference/methods.h"

namespace sheer {

struct StochasticLayer {
    double alpha;
    Float3 color;  // multiples of 1/4: means of samples are exact in floats
    double depth;
};
using StochasticLayers = std::vector<StochasticLayer>;  // their place in it is their id

inline constexpr Float3 kBehind = {0, 0, 1};

// Example 1 of Enderton et al.: red over green over blue.
inline StochasticLayers red_over_green()
{
    return {{0.45, {1, 0, 0}, 1}, {0.45, {0, 1, 0}, 2}};
}

inline std::vector<reference::Fragment> fragments_of(const StochasticLayers& layers)
{
    std::vector<reference::Fragment> fragments;
    for (const StochasticLayer& layer : layers) {
        reference::Fragment fragment;
        fragment.depth = layer.depth;
        fragment.opacity = static_cast<double>(static_cast<float>(layer.alpha));
        std::fill_n(fragment.transmittance, 3, 1 - fragment.opacity);
        for (std::size_t c = 0; c < 3; ++c) fragment.color[c] = static_cast<double>(layer.color[c]);
        fragment.id = static_cast<std::uint32_t>(fragments.size());
        fragments.push_back(fragment);
    }
    return fragments;
}

inline std::array<reference::Moments, 4> moments_of(const StochasticLayers& layers,
                                                    reference::Masks masks, int samples)
{
    return reference::stochastic(fragments_of(layers), masks, samples,
                                 {static_cast<double>(kBehind[0]), static_cast<double>(kBehind[1]),
                                  static_cast<double>(kBehind[2]), 1});
}

inline const char* name_of(reference::Masks masks)
{
    return masks == reference::Masks::naive ? "naive" : "stratified";
}

inline std::string method_with(reference::Masks masks)
{
    return std::string("stochastic:masks=") + name_of(masks);
}

// In random order of submission.
inline Scene scene_of(const StochasticLayers& layers)
{
    const auto text = [](const Float3& color) {
        return std::to_string(color[0]) + "," + std::to_string(color[1]) + "," +
               std::to_string(color[2]);
    };
    std::string alpha, color, depth;
    for (const StochasticLayer& layer : layers) {
        const bool first = alpha.empty();
        alpha += (first ? "" : ",") + std::to_string(layer.alpha);
        color += (first ? "" : ";") + text(layer.color);
        depth += (first ? "" : ",") + std::to_string(layer.depth);
    }
    return load("builtin:layers?alpha=" + alpha + "&color=" + color + "&depth=" + depth +
                "&order=random&background=" + text(kBehind));
}

// Without antialiasing, as the papers' analyses are.
inline View centered_view(int size, int samples)
{
    View view;
    view.width = view.height = size;
    view.samples = samples;
    view.positions = SamplePositions::center;
    return view;
}

// Fragments of a whole tile, driven through the verbs of one store. Their places on a surface,
// where methods ask for them, are a test's to fill in.
class DrivenTile {
public:
    using Fault = std::function<void(FragmentStream&)>;

    DrivenTile(const std::string& method, int samples)
        : set_(make_sample_set(samples, SamplePositions::center)),
          method_(choose_method(method)),
          verbs_(method_.row->verbs(targets_of(Simd::best), method_, samples)),
          store_(verbs_.make({&set_, &method_, {true, 0.1f, 0}, kMostFragments})),
          stream_(kMostFragments, false, true),
          colors_(samples, method_.traits().divides)
    {
    }

    // Every sample's colour, the filter being a sample's. `fault` may change the fragments on their
    // way, pass by pass.
    const SampleColors& draw(const StochasticLayers& layers, const TilePlace& place,
                             const Fault& fault = {})
    {
        verbs_.clear(store_.get(), place);
        for (int pass = 0; pass < method_.traits().passes; ++pass) {
            fill(layers);
            if (fault) fault(stream_);
            verbs_.insert(store_.get(), stream_, pass);
        }
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            for (std::size_t c = 0; c < 4; ++c) {
                std::fill_n(colors_.channel(pixel, c), set_.count, c < 3 ? kBehind[c] : 1.0f);
            }
        }
        verbs_.resolve(store_.get(), colors_);
        if (method_.traits().divides) test::add_fraction(colors_);
        return colors_;
    }

    // Tile by tile. `place_of` says for which place a tile's store is cleared.
    Image draw_picture(const StochasticLayers& layers, int size, const Fault& fault,
                       const std::function<TilePlace(int x, int y)>& place_of)
    {
        Image image(size, size);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                if (x % kTileSize != 0 || y % kTileSize != 0) continue;
                draw(layers, place_of(x, y), fault);
                for (int i = 0; i < kTilePixels; ++i) {
                    image.at(x + i % kTileSize, y + i / kTileSize) =
                        mean(static_cast<std::size_t>(i));
                }
            }
        }
        return image;
    }

private:
    static constexpr int kMostFragments = 16 * kTilePixels;

    void fill(const StochasticLayers& layers)
    {
        stream_.clear();
        for (const StochasticLayer& layer : layers) {
            const auto id = static_cast<std::uint32_t>(stream_.run_count);
            const auto depth = static_cast<float>(layer.depth);
            stream_.runs[stream_.run_count++] = {static_cast<std::uint32_t>(stream_.size),
                                                 kTilePixels,
                                                 id,
                                                 id,
                                                 {0, 0, depth, depth, 0, layer.depth, 0, 0}};
            for (std::uint32_t pixel = 0; pixel < kTilePixels; ++pixel) {
                const int at = stream_.size++;
                stream_.pixel[at] = pixel;
                stream_.samples[at] = static_cast<std::uint32_t>(set_.all());
                stream_.samples_high[at] = static_cast<std::uint32_t>(set_.all() >> 32);
                stream_.depth[at] = depth;
                stream_.red[at] = layer.color[0];
                stream_.green[at] = layer.color[1];
                stream_.blue[at] = layer.color[2];
                stream_.opacity[at] = static_cast<float>(layer.alpha);
            }
        }
    }

    Float4 mean(std::size_t pixel) const
    {
        Float4 result = {};
        for (std::size_t c = 0; c < 4; ++c) {
            for (int s = 0; s < set_.count; ++s) result[c] += colors_.channel(pixel, c)[s];
            result[c] /= static_cast<float>(set_.count);
        }
        return result;
    }

    SampleSet set_;
    ChosenMethod method_;
    StoreVerbs verbs_;
    std::shared_ptr<void> store_;
    FragmentStream stream_;
    SampleColors colors_;
};

}  // namespace sheer
