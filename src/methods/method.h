// A method: one row of one table, and the store that it keeps for each pixel of a tile.
//
// The four verbs: `clear`, nothing in front of the background; `insert`, fragments arrive; `merge`,
// two stores of the same pixels become one; `resolve`, the colour over a backdrop.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sheer/scene.h>

#include "lanes/targets.h"
#include "raster/fragments.h"
#include "raster/opaque_tile.h"
#include "raster/sample_set.h"

namespace sheer {

// Colours of a tile's samples, linear and premultiplied. Channel c (red, green, blue, alpha) of
// sample s of pixel p is element (4 p + c) * samples + s.
struct SampleColors {
    int samples = 0;
    AlignedArray<float> values;

    SampleColors() = default;
    explicit SampleColors(int samples_per_pixel)
        : samples(samples_per_pixel), values(kTilePixels * 4 * samples_per_pixel)
    {
    }
    float* channel(std::size_t pixel, std::size_t c)
    {
        return values.data() + (4 * pixel + c) * static_cast<std::size_t>(samples);
    }
    const float* channel(std::size_t pixel, std::size_t c) const
    {
        return values.data() + (4 * pixel + c) * static_cast<std::size_t>(samples);
    }
};

struct StoreShape {
    const SampleSet* samples;  // outlives the store
};

// How a store is worked with, for one SIMD level. `store` is what `make` gave; `backdrop` holds the
// colours behind everything transparent and is replaced by the result.
struct StoreVerbs {
    std::shared_ptr<void> (*make)(const StoreShape& shape);
    void (*clear)(void* store);
    void (*insert)(void* store, const FragmentStream& stream, int pass);
    void (*merge)(void* store, const void* other);  // null: the method's stores do not merge
    void (*resolve)(void* store, SampleColors& backdrop);
};

template <class Store>
StoreVerbs verbs_of()
{
    StoreVerbs verbs;
    verbs.make = [](const StoreShape& shape) -> std::shared_ptr<void> {
        return std::make_shared<Store>(shape);
    };
    verbs.clear = [](void* store) { static_cast<Store*>(store)->clear(); };
    verbs.insert = [](void* store, const FragmentStream& stream, int pass) {
        static_cast<Store*>(store)->insert(stream, pass);
    };
    verbs.merge = [](void* store, const void* other) {
        static_cast<Store*>(store)->merge(*static_cast<const Store*>(other));
    };
    verbs.resolve = [](void* store, SampleColors& backdrop) {
        static_cast<Store*>(store)->resolve(backdrop);
    };
    return verbs;
}

enum class Bias {
    exact,       // the answer itself
    unbiased,    // right on average over seeds
    consistent,  // right in the limit of its parameters
    neither,
};

struct Parameter {
    const char* name;
    const char* values;  // "a|b|c", or "least..most" for whole numbers
    const char* standard;
    const char* what;
};

struct MethodRow {
    const char* id;
    const char* title;
    const char* citation;
    std::vector<Parameter> parameters;
    int passes;                 // over the fragments
    const char* bytes_formula;  // of the store, a pixel; S: samples, N: the pixel's fragments
    double (*bytes_per_pixel)(int samples, double fragments_per_pixel);
    bool bounded;            // the store does not grow with the number of fragments
    bool order_independent;  // the same picture for every order of arrival
    bool coloured;           // honours coloured transmittance
    Bias bias;
    int exact_up_to;  // fragments a sample; -1: any number; 0: none
    bool bench_only;
    StoreVerbs (*verbs)(TargetSet targets, int samples);
};

// The one table, in the order in which help and reports list it.
std::span<const MethodRow> method_table();

// A row and its parameters' values, chosen by ID[:NAME=VALUE]...
struct ChosenMethod {
    const MethodRow* row;
    std::vector<std::string> values;  // one for each parameter of the row

    std::string parameters_text() const;  // NAME=VALUE:NAME=VALUE
};

// Throws Error(Fault::input) that names what does not exist and what does.
ChosenMethod choose_method(std::string_view text);

}  // namespace sheer
