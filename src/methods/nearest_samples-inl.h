// How the nearest fragment of each sample (shaders/sheer/stochastic.glsl) lies in a tile's memory:
// depth, id and colour. For SampleStore.
#if defined(SHEER_NEAREST_SAMPLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_NEAREST_SAMPLES_INL_H
#undef SHEER_NEAREST_SAMPLES_INL_H
#else
#define SHEER_NEAREST_SAMPLES_INL_H
#endif

#include <limits>

#include "methods/samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// TextOf<L> has the words of stochastic.glsl.
template <int S, template <class> class TextOf>
struct NearestSamples {
    using L = Lanes<S>;
    using Text = TextOf<L>;
    using Store = typename Text::StochasticStore;
    using real3 = typename Text::real3;
    using real = typename L::real;
    using whole = typename L::whole;
    using mask = typename L::mask;
    static constexpr int kChannels = 5;

    static HWY_INLINE real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    static HWY_INLINE Store clear() { return Text::stochastic_clear(beyond_any()); }
    static HWY_INLINE Store merge(Store a, Store b)
    {
        return Text::stochastic_insert(a, b.depth < beyond_any(), b);
    }
    static HWY_INLINE real3 resolve(Store s, real3 backdrop, real& transmittance)
    {
        transmittance = Text::stochastic_transmittance(s, beyond_any());
        return Text::stochastic_resolve(s, beyond_any(), backdrop);
    }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        return {real::load(at), whole::bits_of(real::load(at + samples)),
                load_color<Text>(at + 2 * samples, samples)};
    }
    // stochastic_insert into what lies in memory. Returns the depths that it keeps.
    static HWY_INLINE real insert(mask taken, const Store& fragment, float* at, std::size_t samples)
    {
        const Change of_all = ties(taken, fragment, at).any()
                                  ? change_by_ids(taken, fragment, at, samples)
                                  : change(taken, fragment, at);
        store(of_all, fragment, at, samples);
        return of_all.depth;
    }
    // The same in steps: what comes of it, and storing that.
    struct Change {
        mask wins;
        real depth;  // that is kept
    };
    static HWY_INLINE Change change(mask taken, const Store& fragment, const float* at)
    {
        const real kept = real::load(at);
        const mask wins = taken & (fragment.depth < kept);
        return {wins, L::select(wins, fragment.depth, kept)};
    }
    // Where there are ties, ids decide. Read for all, they would wait for what was stored in part
    // just before.
    static HWY_INLINE mask ties(mask taken, const Store& fragment, const float* at)
    {
        return taken & (fragment.depth == real::load(at));
    }
    static HWY_INLINE Change change_by_ids(mask taken, const Store& fragment, const float* at,
                                           std::size_t samples)
    {
        Store kept;
        kept.depth = real::load(at);
        kept.id = whole::bits_of(real::load(at + samples));
        const mask wins = Text::stochastic_wins(kept, taken, fragment);
        return {wins, L::select(wins, fragment.depth, kept.depth)};
    }
    static HWY_INLINE void store(const Change& change, const Store& fragment, float* at,
                                 std::size_t samples)
    {
        change.depth.store(at);
        fragment.id.as_real().store_where(change.wins, at + samples);
        fragment.color.x.store_where(change.wins, at + 2 * samples);
        fragment.color.y.store_where(change.wins, at + 3 * samples);
        fragment.color.z.store_where(change.wins, at + 4 * samples);
    }
    static HWY_INLINE void save(const Store& s, float* at, std::size_t samples)
    {
        s.depth.store(at);
        s.id.as_real().store(at + samples);
        save_color<Text>(s.color, at + 2 * samples, samples);
    }
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_NEAREST_SAMPLES_INL_H
