// Stores of methods that leave of each fragment something opaque or nothing: the nearest fragment
// at every sample, of those that keep it. 20 bytes a sample.
#if defined(SHEER_ALPHA_TESTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_ALPHA_TESTS_INL_H
#undef SHEER_ALPHA_TESTS_INL_H
#else
#define SHEER_ALPHA_TESTS_INL_H
#endif

#include "methods/farthest-inl.h"
#include "methods/nearest_samples-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct NearestText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/stochastic.glsl"
};

using FragmentLanes = Lanes<16>;

// Samples that fragments keep, a fragment a lane: sample s in bit s, from 32 on in `high`.
struct KeptSamples {
    FragmentLanes::whole low, high;
};

// All of them or none.
HWY_INLINE KeptSamples all_samples(FragmentLanes::mask kept)
{
    const auto bits = FragmentLanes::zero_unless(kept, FragmentLanes::whole(~0u));
    return {bits, bits};
}

// Where fragments are in the picture.
struct PixelPlaces {
    FragmentLanes::whole x, y;
};
HWY_INLINE PixelPlaces pixel_places(const TilePlace& tile, const FragmentStream& f, std::size_t i)
{
    using whole = FragmentLanes::whole;
    static_assert(kTileSize == 1 << 5);
    const whole pixel = whole::load(f.pixel.data() + i);
    return {whole(tile.x) + (pixel & whole(kTileSize - 1)), whole(tile.y) + pixel.shift_right<5>()};
}

// Asks `keeps` for each fragment of a stream, into low and high. Not inlined, so that thresholds
// are compiled once and not for each number of samples.
template <class Keeps>
HWY_NOINLINE void mark_kept_samples(const Keeps& keeps, const FragmentStream& f,
                                    const std::uint32_t* names, std::uint32_t* low,
                                    std::uint32_t* high)
{
    using whole = FragmentLanes::whole;
    for (std::size_t i = 0; i < static_cast<std::size_t>(f.size); i += FragmentLanes::kCount) {
        const KeptSamples bits =
            keeps.keep(f, i, Keeps::kNamed ? whole::load(names + i) : whole(0u));
        (bits.low & whole::load(f.samples.data() + i)).store(low + i);
        (bits.high & whole::load(f.samples_high.data() + i)).store(high + i);
    }
}

// Keeps decides: Keeps(shape), clear(place), and keep(stream, i, names) for fragments i, i + 1,
// ..., where names are what it makes of their runs by name(run), 0 if it has none.
template <int S, class Keeps>
class AlphaTestTile : public SampleStore<S, NearestSamples<S, NearestText>> {
    using Method = NearestSamples<S, NearestText>;
    using Base = SampleStore<S, Method>;
    using typename Base::L;
    using typename Base::real;
    using typename Base::Text;

public:
    explicit AlphaTestTile(const StoreShape& shape)
        : Base(shape),
          set_(*shape.samples),
          keeps_(shape),
          low_(shape.stream_capacity + FragmentStream::kSlack),
          high_(shape.stream_capacity + FragmentStream::kSlack),
          names_(shape.stream_capacity + FragmentStream::kSlack)
    {
    }

    void clear(const TilePlace& place)
    {
        Base::clear(place);
        keeps_.clear(place);
        farthest_.clear();
    }
    const float* hidden_behind() const { return farthest_.data(); }

    void insert(const FragmentStream& f, int)
    {
        if constexpr (Keeps::kNamed) name_fragments(f);
        mark_kept_samples(keeps_, f, names_.data(), low_.data(), high_.data());
        with_sample_count<S>(set_.count, [&](auto samples) HWY_ATTR {
            for (int r = 0; r < f.run_count; ++r) insert_run<samples>(f, f.runs[r]);
        });
    }

private:
    void name_fragments(const FragmentStream& f)
    {
        for (int r = 0; r < f.run_count; ++r) {
            const FragmentRun& run = f.runs[r];
            std::fill_n(names_.data() + run.first, run.count, keeps_.name(run));
        }
    }

    template <int Samples>
    HWY_INLINE void insert_run(const FragmentStream& f, const FragmentRun& run)
    {
        constexpr std::size_t kBlocks = (Samples + L::kCount - 1) / L::kCount;
        const DepthPlane plane = run.depth;
        real offset[kBlocks];
        for (std::size_t b = 0; b < kBlocks; ++b) {
            offset[b] = sample_depth_offset<L>(plane, set_, b * L::kCount);
        }
        typename Text::StochasticStore fragment;
        fragment.id = typename L::whole(run.primitive);
        const std::uint32_t *low = low_.data(), *high = high_.data();
        float* far = farthest_.data();
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            if ((low[i] | high[i]) == 0) continue;
            fragment.color = color_of<Text>(f, i);
            float* stores = this->values() + Method::kChannels * f.pixel[i] * Samples;
            real most;
            for (std::size_t b = 0; b < kBlocks; ++b) {
                const std::size_t s = b * L::kCount;
                const auto here = L::mask_of_bits((s < 32 ? low[i] : high[i]) >> (s & 31));
                fragment.depth = sample_depth<L>(plane, offset[b], f.depth[i]);
                const real depths = Method::insert(here, fragment, stores + s, Samples);
                most = b == 0 ? depths : L::max(most, depths);
            }
            far[f.pixel[i]] = most.greatest();
        }
    }

    const SampleSet& set_;
    Keeps keeps_;
    Farthest farthest_;
    AlignedArray<std::uint32_t> low_, high_, names_;  // of the stream's fragments
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_ALPHA_TESTS_INL_H
