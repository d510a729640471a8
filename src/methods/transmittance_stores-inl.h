// The stores of methods that approximate transmittance, made for a method's function of depth.
#if defined(SHEER_TRANSMITTANCE_STORES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_TRANSMITTANCE_STORES_INL_H
#undef SHEER_TRANSMITTANCE_STORES_INL_H
#else
#define SHEER_TRANSMITTANCE_STORES_INL_H
#endif

#include "methods/depth_function-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// One for all methods.
class TransmittanceStore {
public:
    virtual ~TransmittanceStore() = default;
    virtual void clear(const TilePlace& place) = 0;
    virtual void insert(const FragmentStream& f, int pass) = 0;
    // After the same pass, or before any of the other's.
    virtual void merge(const TransmittanceStore& other) = 0;
    virtual void resolve(SampleColors& backdrop) = 0;
    // Of those whose functions of depth are their own.
    virtual float transmittance_at(std::size_t, float) { return 1; }
};

// Of transmittance_samples.cpp, transmittance_pixels.cpp and reduced_pixels.cpp, which know nothing
// of the method.
using OwnFunction = std::unique_ptr<DepthFunction>;
using OwnStore = std::unique_ptr<TransmittanceStore>;
OwnStore make_transmittance_samples(const StoreShape& shape, OwnFunction function);
OwnStore make_transmittance_pixels(const StoreShape& shape, OwnFunction function);
OwnStore make_reduced_pixels(const StoreShape& shape, OwnFunction function);
ReducedVerbs reduced_tile_verbs();  // all but `make`, and what that gives
std::shared_ptr<void> make_reduced_tile(const StoreShape& shape, OwnFunction function);

// A fragment a lane where a pixel has one sample, or is to have one function.
inline OwnStore make_transmittance_store(const StoreShape& shape, OwnFunction function)
{
    if (shape.method->traits().reduction > 1) {
        return make_reduced_pixels(shape, std::move(function));
    }
    if (shape.samples->count == 1 || shape.method->value("store") == "pixel") {
        return make_transmittance_pixels(shape, std::move(function));
    }
    return make_transmittance_samples(shape, std::move(function));
}

template <class Function>
OwnFunction make_function(const StoreShape& shape)
{
    return std::make_unique<DepthFunctionOf<Function>>(*shape.method);
}

// The verbs of a method's store.
template <class Function>
class StoreOf {
public:
    explicit StoreOf(const StoreShape& shape)
        : store_(make_transmittance_store(shape, make_function<Function>(shape)))
    {
    }
    void clear(const TilePlace& place) { store_->clear(place); }
    void insert(const FragmentStream& f, int pass) { store_->insert(f, pass); }
    void merge(const StoreOf& other) { store_->merge(*other.store_); }
    void resolve(SampleColors& backdrop) { store_->resolve(backdrop); }
    float transmittance_at(std::size_t pixel, float depth)
    {
        return store_->transmittance_at(pixel, depth);
    }

private:
    OwnStore store_;
};

template <class Function>
ReducedVerbs reduced_verbs_of()
{
    ReducedVerbs verbs = reduced_tile_verbs();
    verbs.make = [](const StoreShape& shape) {
        return make_reduced_tile(shape, make_function<Function>(shape));
    };
    return verbs;
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_TRANSMITTANCE_STORES_INL_H
