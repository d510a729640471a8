// What peeling keeps of a tile: a pass begins where the one before ended, and ends the work when it
// finds nothing.
#if defined(SHEER_PEELING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_PEELING_INL_H
#undef SHEER_PEELING_INL_H
#else
#define SHEER_PEELING_INL_H
#endif

#include "methods/layers-inl.h"
#include "methods/precise_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Method: what SampleStore wants, and
//   wants(rough, at, samples): whether it may take the layer,
//   insert(layer, at, samples): whether it took the layer at any of the samples,
//   begin(peel): what a pass begins with.
template <int S, class Method>
struct PeelingTile : SampleStore<S, Method> {
    using Base = SampleStore<S, Method>;
    using typename Base::Text;

    const SampleSet& set;
    int pass = 0;
    bool found = false;  // in this pass

    explicit PeelingTile(const StoreShape& shape) : Base(shape), set(*shape.samples) {}

    void clear(const TilePlace&)
    {
        Base::clear();
        pass = 0;
        found = false;
    }

    void insert(const FragmentStream& f, int number)
    {
        if (number != pass) begin(number);
        bool any = false;
        const auto place = [&](std::size_t pixel, std::size_t s) HWY_ATTR {
            return this->values() + Method::kChannels * pixel * this->count() + s;
        };
        for_each_precise_layer<S, Text>(
            f, set,
            [&](std::size_t pixel, std::size_t s, const auto& rough)
                HWY_ATTR { return Method::wants(rough, place(pixel, s), this->count()); },
            [&](std::size_t pixel, std::size_t s, const auto& layer)
                HWY_ATTR { any |= Method::insert(layer, place(pixel, s), this->count()); });
        found |= any;
    }
    void begin(int number)
    {
        pass = number;
        found = false;
        this->for_each([&](std::size_t pixel, std::size_t s)
                           HWY_ATTR { this->save(Method::begin(this->load(pixel, s)), pixel, s); });
    }

    void merge(const PeelingTile& other)
    {
        Base::merge(other);
        found |= other.found;
    }

    bool done() const { return !found; }
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_PEELING_INL_H
