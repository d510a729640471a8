// Stochastic transparency: shaders/sheer/stochastic.glsl at every sample.
//
// A fragment goes to the samples of its mask, a sample a lane. 20 bytes a sample; alpha correction
// keeps the transmittance of each besides, and several passes the sum of what each of them showed.
#if defined(SHEER_STOCHASTIC_TILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_STOCHASTIC_TILE_INL_H
#undef SHEER_STOCHASTIC_TILE_INL_H
#else
#define SHEER_STOCHASTIC_TILE_INL_H
#endif

#include "methods/nearest_samples-inl.h"
#include "methods/stochastic_settings.h"
#include "methods/total_alpha-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct StochasticText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/stochastic.glsl"
};

// Masks: StochasticMasks, TrackedMasks<S>.
template <int S, class Masks>
struct StochasticTile : SampleStore<S, NearestSamples<S, StochasticText>> {
    using Base = SampleStore<S, NearestSamples<S, StochasticText>>;
    using typename Base::L;
    using typename Base::real;
    using typename Base::real3;
    using typename Base::Text;
    using Method = NearestSamples<S, StochasticText>;

    const SampleSet& set;
    StochasticSettings settings;
    Masks masks;
    TotalAlpha<S> total_alpha{0};  // for alpha correction
    SampleValues<4> shown;  // by the passes before this one: sums of colour and of what is won
    int pass = 0;

    explicit StochasticTile(const StoreShape& shape)
        : Base(shape),
          set(*shape.samples),
          settings(stochastic_settings(*shape.method)),
          masks(shape)
    {
        if (settings.corrects) total_alpha = TotalAlpha<S>(set.count);
        if (several()) shown = SampleValues<4>(set.count);
    }
    bool several() const { return settings.passes > 1; }
    // Total alpha is of all fragments.
    const float* hidden_behind() const
    {
        return settings.corrects ? nullptr : masks.farthest.data();
    }

    void clear(const TilePlace& place)
    {
        masks.clear(place);
        if (settings.corrects) total_alpha.clear();
        if (several()) std::fill_n(shown.values.data(), shown.values.size(), 0.0f);
        pass = 0;
        begin_pass();
    }
    void begin_pass()
    {
        masks.begin_pass(pass);
        // Ids and colours are looked at only where a depth was kept.
        this->for_each([&](std::size_t pixel, std::size_t s) HWY_ATTR {
            Method::beyond_any().store(this->values() + Method::kChannels * pixel * this->count() +
                                       s);
        });
    }

    // What the samples of this pass show so far, and those of the passes before it.
    struct Shown {
        real3 color;
        real weight;
    };
    HWY_INLINE Shown shown_so_far(std::size_t pixel, std::size_t s) const
    {
        const auto store = this->load(pixel, s);
        const real one(1.0f), none(0.0f);
        const real empty = Text::stochastic_transmittance(store, Method::beyond_any());
        Shown result{Text::stochastic_resolve(store, Method::beyond_any(), {none, none, none}),
                     one - empty};
        if (!several()) return result;
        const float* before = shown.channel(pixel, 0) + s;
        result.color = result.color + load_color<Text>(before, this->count());
        result.weight = result.weight + real::load(before + 3 * this->count());
        return result;
    }

    void insert(const FragmentStream& f, int of_pass)
    {
        if (of_pass != pass) {
            this->for_each([&](std::size_t pixel, std::size_t s) HWY_ATTR {
                const Shown sum = shown_so_far(pixel, s);
                float* at = shown.channel(pixel, 0) + s;
                save_color<Text>(sum.color, at, this->count());
                sum.weight.store(at + 3 * this->count());
            });
            pass = of_pass;
            begin_pass();
        }
        if (settings.corrects && pass == 0) total_alpha.insert(f);
        with_sample_count<S>(set.count, [&](auto samples) HWY_ATTR { insert_all<samples>(f); });
    }

    template <int Samples>
    void insert_all(const FragmentStream& f)
    {
        if constexpr (Masks::kWait) {
            if (masks.settings.depth_before) return insert_in_turn<Samples>(f);
        }
        masks.template for_each_run<Samples>(f, {this->values(), Method::kChannels},
                                             [&](const FragmentRun& run, std::size_t k) HWY_ATTR {
                                                 return insert_run<Samples>(f, run, k);
                                             });
    }

    template <int Samples>
    static constexpr std::size_t kBlocks = (Samples + L::kCount - 1) / L::kCount;

    // Inserts a run's candidates, of which k is the first. Returns the next run's first.
    template <int Samples>
    HWY_INLINE std::size_t insert_run(const FragmentStream& f, const FragmentRun& run,
                                      std::size_t k)
    {
        // Copies, which what is stored below cannot alias.
        const DepthPlane plane = run.depth;
        const std::size_t end = run.first + run.count;
        const float *red = f.red.data(), *green = f.green.data(), *blue = f.blue.data();
        const float* depth = f.depth.data();
        const std::uint32_t* pixels = f.pixel.data();
        float *stores = this->values(), *far = masks.farthest.data();
        real offset[kBlocks<Samples>];
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            offset[b] = sample_depth_offset<L>(plane, set, b * L::kCount);
        }
        const typename L::whole id(run.primitive);
        return two_at_once(masks, k, end, [&](std::size_t first, auto count) HWY_ATTR {
            std::size_t i[count], pixel[count];
            for (std::size_t c = 0; c < count; ++c) {
                i[c] = masks.number(first + c);
                pixel[c] = pixels[i[c]];
            }
            real most[count];
            for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
                const std::size_t s = b * L::kCount;
                typename Text::StochasticStore fragment[count];
                typename Method::Change change[count];
                const auto at = [&](std::size_t c) HWY_ATTR {
                    return stores + (Method::kChannels * pixel[c] * Samples + s);
                };
                typename L::mask taken[count], tied[count];
                for (std::size_t c = 0; c < count; ++c) {
                    const std::size_t n = i[c];
                    fragment[c] = {sample_depth<L>(plane, offset[b], depth[n]),
                                   id,
                                   {real(red[n]), real(green[n]), real(blue[n])}};
                    taken[c] = L::mask_of_bits(masks.word(first + c, s));
                    change[c] = Method::change(taken[c], fragment[c], at(c));
                    tied[c] = Method::ties(taken[c], fragment[c], at(c));
                }
                if ((tied[0] | tied[count - 1]).any()) {
                    for (std::size_t c = 0; c < count; ++c) {
                        change[c] = Method::change_by_ids(taken[c], fragment[c], at(c), Samples);
                    }
                }
                for (std::size_t c = 0; c < count; ++c) {
                    most[c] = b == 0 ? change[c].depth : L::max(most[c], change[c].depth);
                }
                for (std::size_t c = 0; c < count; ++c) {
                    Method::store(change[c], fragment[c], at(c), Samples);
                }
            }
            for (std::size_t c = 0; c < count; ++c) far[pixel[c]] = most[c].greatest();
        });
    }

    // The depth test before the number of samples is drawn: a fragment's mask waits for what those
    // before it have left.
    template <int Samples>
    HWY_INLINE void insert_in_turn(const FragmentStream& f)
    {
        for (int r = 0; r < f.run_count; ++r) {
            const FragmentRun& run = f.runs[r];
            for (std::size_t i = run.first; i < run.first + run.count; ++i) {
                insert_one<Samples>(f, run, i);
            }
        }
    }
    template <int Samples>
    HWY_INLINE void insert_one(const FragmentStream& f, const FragmentRun& run, std::size_t i)
    {
        const std::size_t pixel = f.pixel[i];
        typename Text::StochasticStore fragment;
        fragment.id = typename L::whole(run.primitive);
        fragment.color = color_of<Text>(f, i);
        real depth[kBlocks<Samples>];
        std::uint64_t open = 0;
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            const std::size_t s = b * L::kCount;
            fragment.depth = depth[b] = sample_depth<L>(run.depth, set, f.depth[i], s);
            const auto nearer = Text::stochastic_nearer(this->load(pixel, s), fragment);
            open |= static_cast<std::uint64_t>((nearer & sample_mask<L>(f, i, s)).bits()) << s;
        }
        if (open == 0) return;
        const std::uint64_t taken =
            masks.taken_of(open, static_cast<std::uint32_t>(pixel), run, f.depth[i], f.opacity[i]);
        for (std::size_t b = 0; b < kBlocks<Samples>; ++b) {
            const std::size_t s = b * L::kCount;
            fragment.depth = depth[b];
            const auto of_block = L::mask_of_bits(static_cast<std::uint32_t>(taken >> s));
            this->save(Text::stochastic_insert(this->load(pixel, s), of_block, fragment), pixel, s);
        }
    }

    void merge(const StochasticTile& other)
    {
        Base::merge(other);
        if (settings.corrects) total_alpha.merge(other.total_alpha);
        for (std::size_t i = 0; i < static_cast<std::size_t>(shown.values.size()); ++i) {
            shown.values[i] += other.shown.values[i];
        }
    }

    void resolve(SampleColors& backdrop) const
    {
        if (settings.corrects) return resolve_corrected(backdrop);
        if (!several()) return Base::resolve(backdrop);
        const real part(1.0f / static_cast<float>(settings.passes)), one(1.0f);
        this->for_each([&](std::size_t pixel, std::size_t s) HWY_ATTR {
            const Shown sum = shown_so_far(pixel, s);
            const auto mean = [&](real3 behind, real& transmittance) HWY_ATTR {
                transmittance = one - part * sum.weight;
                return Text::over(part * sum.color, transmittance, behind);
            };
            resolve_samples<Text>(backdrop, pixel, s, mean);
        });
    }
    void resolve_corrected(SampleColors& backdrop) const
    {
        this->for_each([&](std::size_t pixel, std::size_t s) HWY_ATTR {
            const Shown sum = shown_so_far(pixel, s);
            total_alpha.dim(backdrop, pixel, s, sum.color, sum.weight);
        });
    }
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_STOCHASTIC_TILE_INL_H
