// Phenomenological transparency: shaders/sheer/phenomenological.glsl at every sample.
//
// A fragment's weight is that of the distance at its pixel's centre, as on a GPU. 28 bytes a
// sample. What becomes of the backdrop is phenomenological_backdrop.cpp's.
#include <optional>

#include "methods/method.h"
#include "methods/phenomenological_backdrop.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/phenomenological.cpp"
#include "lanes/targets.h"

#include <hwy/foreach_target.h>

#include "methods/samples-inl.h"
#include "methods/weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct PhenomenologicalText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/phenomenological.glsl"
};

template <int S>
struct PhenomenologicalMethod {
    using L = Lanes<S>;
    using Text = PhenomenologicalText<L>;
    using Store = typename Text::PhenomenologicalStore;
    using real3 = typename Text::real3;
    using real = typename L::real;
    static constexpr int kChannels = 7;

    static HWY_INLINE Store clear() { return Text::phenomenological_clear(); }
    static HWY_INLINE Store merge(Store a, Store b) { return Text::phenomenological_merge(a, b); }
    static HWY_INLINE real3 resolve(Store s, real3 backdrop, real& transmittance)
    {
        transmittance = Text::phenomenological_transmittance(s);
        return Text::phenomenological_resolve(s, backdrop);
    }
    static HWY_INLINE Store load(const float* at, std::size_t samples)
    {
        return {load_color<Text>(at, samples), real::load(at + 3 * samples),
                load_color<Text>(at + 4 * samples, samples)};
    }
    static HWY_INLINE void save(const Store& s, float* at, std::size_t samples)
    {
        save_color<Text>(s.color, at, samples);
        s.weight.store(at + 3 * samples);
        save_color<Text>(s.transmittance, at + 4 * samples, samples);
    }
};

// Colored: fragments have a part that passes for each channel.
template <int S, bool Colored>
struct PhenomenologicalTile : SampleStore<S, PhenomenologicalMethod<S>> {
    using Base = SampleStore<S, PhenomenologicalMethod<S>>;
    using typename Base::real;
    using typename Base::real3;
    using typename Base::Text;

    EyeSpace eye;
    AlignedArray<float> weights;  // of the stream's fragments
    std::optional<PhenomenologicalBackdrop> changes;

    explicit PhenomenologicalTile(const StoreShape& shape)
        : Base(shape), eye(shape.eye), weights(shape.stream_capacity + FragmentStream::kSlack)
    {
        if (shape.backdrop != nullptr && shape.method->traits().reads_backdrop) {
            changes.emplace(shape);
        }
    }

    void clear(const TilePlace& place)
    {
        Base::clear(place);
        if (changes) changes->clear(place);
    }
    void merge(const PhenomenologicalTile& other)
    {
        Base::merge(other);
        if (changes) changes->merge(*other.changes);
    }
    void resolve(SampleColors& backdrop) const
    {
        if (changes) changes->replace(backdrop);
        Base::resolve(backdrop);
    }

    void insert(const FragmentStream& f, int)
    {
        if (changes) changes->insert(f);
        weigh_fragments(f, eye, weights, [&](auto, auto z, auto a) HWY_ATTR {
            return PhenomenologicalText<WeightBlock>::phenomenological_weight(buffer_depth(eye, z),
                                                                              a);
        });
        this->update(f,
                     [&](const StreamColumns&, std::size_t i, auto store, auto covered) HWY_ATTR {
                         return Text::phenomenological_insert(store, covered, color_of<Text>(f, i),
                                                              real(f.opacity[i]), through(f, i),
                                                              real(weights[i]));
                     });
    }

private:
    static HWY_INLINE real3 through(const FragmentStream& f, std::size_t i)
    {
        if constexpr (Colored) {
            return {real(f.through_red[i]), real(f.through_green[i]), real(f.through_blue[i])};
        }
        const real part = real(1.0f) - real(f.opacity[i]);
        return {part, part, part};
    }
};

template <int S>
using PlainPhenomenologicalTile = PhenomenologicalTile<S, false>;
template <int S>
using ColoredPhenomenologicalTile = PhenomenologicalTile<S, true>;

StoreVerbs phenomenological_store(int samples)
{
    return verbs_for_samples<PlainPhenomenologicalTile>(samples);
}

StoreVerbs phenomenological_colored_store(int samples)
{
    return verbs_for_samples<ColoredPhenomenologicalTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(phenomenological_store);
HWY_EXPORT(phenomenological_colored_store);

StoreVerbs phenomenological_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(phenomenological_store, targets)(samples);
}

StoreVerbs phenomenological_colored_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(phenomenological_colored_store, targets)(samples);
}

}  // namespace sheer
#endif
