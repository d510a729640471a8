// The text of masks for one plain number.
#include "methods/stochastic_mask.h"

#include "lanes/lone.h"

namespace sheer {

namespace {

template <class L>
struct MaskText {
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
};
using Text = MaskText<Lone<float>>;

}  // namespace

std::uint64_t stochastic_mask(const MaskedFragment& fragment, std::uint32_t key, int samples)
{
    std::uint32_t seed =
        Text::fragment_seed(fragment.x, fragment.y, Text::identity_seed(fragment.primitive, key));
    const float xi = Text::next_random_real(seed);
    const Text::SampleBits bits = Text::stratified_mask(seed, xi, fragment.opacity, samples);
    const std::uint64_t all = samples == 64 ? ~0ull : (1ull << samples) - 1;
    return (bits.low | static_cast<std::uint64_t>(bits.high) << 32) & all;
}

}  // namespace sheer
