// A method: one row of one table, and the store that it keeps for each pixel of a tile.
//
// The four verbs: `clear`, nothing in front of the background; `insert`, fragments arrive; `merge`,
// two stores of the same pixels become one; `resolve`, the colour over a backdrop.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <sheer/scene.h>

#include "geometry/tile_grid.h"
#include "geometry/triangles.h"
#include "lanes/targets.h"
#include "raster/fragments.h"
#include "raster/opaque_tile.h"
#include "raster/sample_set.h"

namespace sheer {

// `Channels` floats for each sample of a tile. Channel c of sample s of pixel p is element
// (Channels p + c) * samples + s.
template <int Channels>
struct SampleValues {
    int samples = 0;
    AlignedArray<float> values;

    SampleValues() = default;
    explicit SampleValues(int samples_per_pixel)
        : samples(samples_per_pixel), values(kTilePixels * Channels * samples_per_pixel)
    {
    }
    float* channel(std::size_t pixel, std::size_t c)
    {
        return values.data() + (Channels * pixel + c) * static_cast<std::size_t>(samples);
    }
    const float* channel(std::size_t pixel, std::size_t c) const
    {
        return values.data() + (Channels * pixel + c) * static_cast<std::size_t>(samples);
    }
};

// What becomes of a tile's samples: red, green, blue and alpha, linear and premultiplied. The
// filter's mean of them is the picture.
struct SampleColors : SampleValues<4> {
    // Of a method that divides after the filter (MethodTraits::divides), else empty: red, green and
    // blue of a sum, its weight, and total alpha. The picture gets total alpha times the sum's mean
    // over the weight's mean besides.
    SampleValues<5> fraction;

    SampleColors() = default;
    explicit SampleColors(int samples_per_pixel, bool divides = false)
        : SampleValues<4>(samples_per_pixel)
    {
        if (divides) fraction = SampleValues<5>(samples_per_pixel);
    }
};

struct MethodRow;
struct MethodTraits;
struct FragmentWants;

// A row and its parameters' values, chosen by ID[:NAME=VALUE]...
struct ChosenMethod {
    const MethodRow* row;
    std::vector<std::string> values;  // one for each parameter of the row

    const std::string& value(std::string_view parameter) const;  // of one that the row has
    std::string parameters_text() const;                         // NAME=VALUE:NAME=VALUE
    int number(std::string_view parameter) const;                // of whole numbers
    double real(std::string_view parameter) const;               // of real ones
    FragmentWants wants() const;
    MethodTraits traits() const;  // with these values
};

// Throws Error(Fault::input) that names what does not exist and what does.
ChosenMethod choose_method(std::string_view text);

// What a fragment's depth says of its distance from the eye, along the axis of view, in metres.
struct EyeSpace {
    bool orthographic = false;  // depth is the distance; else -1 / distance
    float znear = 0, zfar = 0;  // of the camera; zfar 0: none
    // Distances between which all lies that is transparent in the picture, for the methods that say
    // so (MethodTraits::measures_depth); the first is the larger where that is not known.
    float nearest = 1, farthest = 0;
};

struct ReducedMoments;
class BackdropPicture;

struct StoreShape {
    const SampleSet* samples;  // outlives the store
    const ChosenMethod* method;
    EyeSpace eye;
    int stream_capacity;                       // most fragments in a stream that is inserted
    std::size_t most_bytes = ~std::size_t{0};  // for a store without bound: what it may take
    // Whether pixels are more than the means of their own samples.
    bool filter_mixes_pixels = true;
    // Of a method with MethodTraits::reduction above 1: of the whole picture, or null: of nothing.
    const ReducedMoments* reduced = nullptr;
    // Of a method with MethodTraits::reads_backdrop, or null: it is as it is.
    const BackdropPicture* backdrop = nullptr;
};

// Where a frame is among those whose mean is one picture.
struct FrameOfPicture {
    std::uint32_t key = 0;  // of random numbers that all of them share
    int number = 0, count = 1;
};

// And among all frames, those of earlier pictures counted.
struct FrameOfFilm {
    std::int64_t number = 0;
    int period = 8;  // of what comes again: Options::period
};

// What a store is cleared for.
struct TilePlace {
    int x = 0, y = 0;       // the tile's first pixel in the picture
    std::uint32_t key = 0;  // of the frame's random numbers
    FrameOfPicture frame = {};
    FrameOfFilm film = {};
};

// How a store is worked with, for one SIMD level. `store` is what `make` gave; `backdrop` holds the
// colours behind everything transparent and is replaced by the result.
struct StoreVerbs {
    std::shared_ptr<void> (*make)(const StoreShape& shape);
    void (*clear)(void* store, const TilePlace& place);
    // False: StoreShape::most_bytes do not hold them all; the store is to be cleared.
    bool (*insert)(void* store, const FragmentStream& stream, int pass);
    void (*merge)(void* store, const void* other);
    void (*resolve)(void* store, SampleColors& backdrop);
    // After a pass: whether further ones would change nothing. Null: all are needed.
    bool (*done)(const void* store) = nullptr;
    // Of a method that keeps a function of depth, after all passes but the last: what that lets
    // pass to the eye from a depth, as fragments have it; the mean over a pixel's samples. Null: it
    // keeps none.
    float (*transmittance)(void* store, std::size_t pixel, float depth) = nullptr;
    // Of a store in which the nearest fragments hide the others: depths, of kTilePixels, behind
    // which a fragment changes nothing, up to date after each `insert`. Null, or null: all count.
    const float* (*hidden_behind)(const void* store) = nullptr;
};

// What a method adds up of a picture of fewer pixels, tile by tile, before the tiles of the picture
// itself are drawn. Of each tile: clear, insert as often as MethodTraits::reduced_passes says,
// write.
struct ReducedVerbs {
    std::shared_ptr<void> (*make)(const StoreShape& shape);
    void (*clear)(void* store);
    // `farthest`: of each of the tile's pixels; what lies behind is not seen.
    void (*insert)(void* store, const FragmentStream& stream, const float* farthest, int pass);
    // The pixels of `rect`, which the tile holds.
    void (*write)(void* store, const PixelRect& rect, ReducedMoments& to);
};

template <class Store>
StoreVerbs verbs_of()
{
    StoreVerbs verbs;
    verbs.make = [](const StoreShape& shape) -> std::shared_ptr<void> {
        return std::make_shared<Store>(shape);
    };
    verbs.clear = [](void* store, const TilePlace& place) {
        static_cast<Store*>(store)->clear(place);
    };
    verbs.insert = [](void* store, const FragmentStream& stream, int pass) {
        if constexpr (std::is_void_v<decltype(static_cast<Store*>(store)->insert(stream, pass))>) {
            static_cast<Store*>(store)->insert(stream, pass);
            return true;
        } else {
            return static_cast<Store*>(store)->insert(stream, pass);
        }
    };
    verbs.merge = [](void* store, const void* other) {
        static_cast<Store*>(store)->merge(*static_cast<const Store*>(other));
    };
    verbs.resolve = [](void* store, SampleColors& backdrop) {
        static_cast<Store*>(store)->resolve(backdrop);
    };
    if constexpr (requires(const Store& store) { store.done(); }) {
        verbs.done = [](const void* store) { return static_cast<const Store*>(store)->done(); };
    }
    if constexpr (requires(Store & store) { store.transmittance_at(std::size_t{}, 0.0f); }) {
        verbs.transmittance = [](void* store, std::size_t pixel, float depth) {
            return static_cast<Store*>(store)->transmittance_at(pixel, depth);
        };
    }
    if constexpr (requires(const Store& store) { store.hidden_behind(); }) {
        verbs.hidden_behind = [](const void* store) {
            return static_cast<const Store*>(store)->hidden_behind();
        };
    }
    return verbs;
}

enum class Bias {
    exact,       // the answer itself
    unbiased,    // right on average over seeds
    consistent,  // right in the limit of its parameters
    neither,
};

// How well two ways to the same store agree.
enum class Agreement {
    none,
    rounding,  // sums of floats in another order
    bits,
};

// The order in which a tile's transparent triangles become fragments.
enum class Submission {
    as_given,          // Scene::objects, and each mesh's triangles
    objects_sorted,    // farthest object first: by the centre of its bounds
    triangles_sorted,  // farthest triangle first: by its centroid
};

// What a method asks of a tile's fragments.
struct FragmentWants {
    Submission submission = Submission::as_given;
    std::optional<PlaceSpace> places;  // FragmentStream::place, in this space
    bool levels = false;               // FragmentStream::level; only with places
    // MASK surfaces come with their opacities, for the method to test; else they are drawn first,
    // where they pass their cutoff.
    bool masks = false;

    bool operator==(const FragmentWants&) const = default;
};

struct Parameter {
    const char* name;
    // "a|b|c", of which any may be "least..most", for whole numbers, or with points for real ones.
    const char* values;
    const char* standard;
    const char* what;
};

// What a method promises. May depend on its parameters.
struct MethodTraits {
    int passes = 1;  // over the fragments; at most, where StoreVerbs::done says so
    // Names of the passes: of the first each its own, the others go round.
    std::vector<const char*> pass_names = {"store"};
    int named_once = 0;
    // Of the store, a pixel.
    int bytes_per_sample = 0, bytes_per_fragment = 0, bytes_besides = 0;
    int bytes_per_fragment_and_sample = 0;  // at most
    int bytes_of_tables = 0;                // of all stores together, at most
    // Of pictures that are made before the tiles, reduced ones or the backdrop's, a pixel.
    double bytes_of_pictures = 0;
    int bytes_per_streamed = 0;  // what the store notes of each fragment of a stream, besides
    // What a GPU's textures for the same take a pixel of one sample, in the paper's formats; 0: the
    // paper does not say.
    double texture_bytes = 0;
    bool random = false;                    // the picture depends on the seed
    bool by_frame = false;                  // on TilePlace::film, though not on the seed
    bool bounded = true;                    // the store does not grow with the number of fragments
    Agreement any_order = Agreement::none;  // of the stores for every order of arrival
    // Of parts with the whole, merged after each pass, which then goes on with what was merged.
    Agreement merge = Agreement::none;
    bool merges_in_order = false;  // where that is none: of arrival
    Bias bias = Bias::neither;
    int exact_up_to = 0;          // fragments a sample; -1: any number; 0: none
    bool within_inputs = true;    // no colour exceeds the largest of fragments and backdrop
    bool divides = false;         // after the filter: SampleColors::fraction
    bool measures_depth = false;  // wants EyeSpace::nearest and farthest
    // Pixels across that are one of a reduced picture, which is drawn first, in so many passes over
    // its fragments, and has so many numbers a pixel.
    int reduction = 1, reduced_passes = 0, reduced_numbers = 0;
    bool reads_backdrop = false;  // wants StoreShape::backdrop

    double bytes_per_pixel(int samples, double fragments_per_pixel) const
    {
        return bytes_per_sample * samples + bytes_per_fragment * fragments_per_pixel +
               bytes_per_fragment_and_sample * fragments_per_pixel * samples + bytes_besides +
               bytes_of_pictures;
    }
    std::string bytes_formula() const;  // in S, the samples, and N, the pixel's fragments
};

// A method's place in Wyman's continuum: what it does with a new fragment.
struct ContinuumPlace {
    const char* contribute = "";  // whether it does
    const char* store = "";       // what is kept of it, and how many of these
    const char* merge = "";       // what becomes of one too many
    const char* normalise = "";   // and of what was given up
};

struct MethodRow {
    const char* id;
    const char* title;
    const char* citation;
    ContinuumPlace continuum;
    std::vector<Parameter> parameters;
    MethodTraits traits;  // with the standard values
    bool bench_only = false;
    StoreVerbs (*verbs)(TargetSet targets, const ChosenMethod& method, int samples);
    // The same for scenes with coloured glass; null: takes the mean over the channels.
    StoreVerbs (*colored_verbs)(TargetSet targets, const ChosenMethod& method,
                                int samples) = nullptr;
    ReducedVerbs (*reduced_verbs)(TargetSet targets, const ChosenMethod& method) = nullptr;
    FragmentWants (*wants)(const ChosenMethod& method) = nullptr;     // null: nothing special
    MethodTraits (*traits_of)(const ChosenMethod& method) = nullptr;  // null: always `traits`
    // Why the values do not go together or not with so many samples, after "method: ID: "; empty
    // if they do. Null: they always do.
    std::string (*refusal)(const ChosenMethod& method, int samples) = nullptr;
};

// The row with `traits` as `traits_of` has them for the standard values.
MethodRow with_standard_traits(MethodRow row);

// Throws Error(Fault::input) where the method can't be used with so many samples.
void check_method(const ChosenMethod& method, int samples);

// The one table, in the order in which help and reports list it.
std::span<const MethodRow> method_table();

}  // namespace sheer
