// The rows of the methods that keep a few layers at each sample.
#include "methods/method.h"

namespace sheer {

StoreVerbs k_buffer_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs hybrid_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs mlab_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs z3_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs deep_shadow_map_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs adaptive_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs bucket_peeling_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs depth_peeling_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs dual_depth_peeling_verbs(TargetSet targets, const ChosenMethod& method, int samples);

namespace {

constexpr int kLayerBytes = 24;
constexpr int kPreciseLayerBytes = 28;
constexpr Parameter kLayers = {"layers", "1..32", "4", "kept at each sample, near to far"};

// With the number of layers that there are in a pixel.
MethodTraits layered_traits(const ChosenMethod& method)
{
    MethodTraits traits;
    traits.bytes_per_sample = kLayerBytes * method.number("layers");
    traits.bytes_besides = 4;
    traits.exact_up_to = method.number("layers");
    return traits;
}

// Where two neighbours of one too many become one.
MethodTraits joining_traits(const ChosenMethod& method)
{
    MethodTraits traits = layered_traits(method);
    ++traits.exact_up_to;
    return traits;
}

MethodTraits k_buffer_traits(const ChosenMethod& method)
{
    MethodTraits traits = layered_traits(method);
    if (method.value("merge") == "front") traits.bytes_per_sample += 16;
    if (method.value("merge") == "discard") {
        traits.any_order = Agreement::bits;
        traits.merge = Agreement::bits;
    } else {
        ++traits.exact_up_to;
    }
    return traits;
}

MethodTraits hybrid_traits(const ChosenMethod& method)
{
    MethodTraits traits = layered_traits(method);
    traits.bytes_per_sample += 24;
    traits.any_order = Agreement::rounding;
    traits.merge = Agreement::rounding;
    const std::string& tail = method.value("tail");
    if (tail == "none") traits.any_order = traits.merge = Agreement::bits;
    if (tail == "maule" || tail == "total") ++traits.exact_up_to;
    return traits;
}

MethodTraits adaptive_traits(const ChosenMethod& method)
{
    MethodTraits traits;
    traits.passes = 2;
    traits.pass_names = {"visibility", "accumulation"};
    traits.bytes_per_sample = 12 * method.number("nodes") + 12;
    traits.bytes_besides = 4;
    traits.exact_up_to = method.number("nodes");
    // One step is at the nearest fragment, whoever came first.
    if (traits.exact_up_to == 1) traits.any_order = traits.merge = Agreement::rounding;
    return traits;
}

MethodTraits deep_shadow_traits(const ChosenMethod& method)
{
    MethodTraits traits;
    traits.passes = 2;
    traits.pass_names = {"visibility", "accumulation"};
    traits.bytes_per_sample = 20;
    traits.bytes_per_fragment = 24;
    traits.bytes_per_fragment_and_sample = 16;
    traits.bytes_besides = 12;
    traits.bounded = false;
    traits.any_order = Agreement::rounding;
    traits.merge = Agreement::rounding;
    traits.exact_up_to = 1;  // as what coincides does not hide one another
    traits.within_inputs = method.value("correction") == "on";
    return traits;
}

// `layers`: that a pass finds.
MethodTraits peeling_traits(const ChosenMethod& method, int layers)
{
    MethodTraits traits;
    traits.passes = method.number("peels");
    traits.pass_names = {"peel"};
    traits.bytes_per_sample = 2 * layers * kPreciseLayerBytes;
    traits.any_order = Agreement::bits;
    traits.merge = Agreement::bits;
    traits.bias = Bias::consistent;
    traits.exact_up_to = layers * traits.passes;
    return traits;
}

MethodTraits depth_peeling_traits(const ChosenMethod& method)
{
    return peeling_traits(method, 1);
}

MethodTraits dual_peeling_traits(const ChosenMethod& method)
{
    return peeling_traits(method, 2);
}

// The range pass, one that marks bins, and the peels.
MethodTraits bucket_traits(const ChosenMethod& method)
{
    const bool adaptive = method.value("borders") == "adaptive";
    const int peels = method.number("peels");
    MethodTraits traits;
    traits.passes = (adaptive ? 2 : 1) + peels;
    traits.pass_names = {"range"};
    if (adaptive) traits.pass_names.push_back("bins");
    traits.named_once = traits.passes - peels;
    traits.pass_names.push_back("peel");
    traits.bytes_per_sample =
        (peels > 1 ? 2 : 1) * kPreciseLayerBytes * method.number("buckets") + 8;
    traits.bytes_besides = 5;
    if (adaptive) traits.bytes_per_sample += 128 + 132;
    traits.any_order = Agreement::bits;
    traits.merge = Agreement::bits;
    traits.bias = Bias::consistent;
    traits.exact_up_to = peels;
    return traits;
}

constexpr Parameter kPeels = {"peels", "1..4096", "4096",
                              "passes at most; they end when nothing is left"};

}  // namespace

MethodRow depth_peeling_row()
{
    return with_standard_traits(
        {.id = "depth-peeling",
         .title = "Depth peeling: the nearest layer, then the next, a pass for each",
         .citation = "Everitt. Interactive Order-Independent Transparency. NVIDIA 2001",
         .continuum = {"if it is the nearest behind the layers before", "one layer a pass",
                       "the farther is discarded, until the next pass", "none"},
         .parameters = {kPeels},
         .traits = {},
         .verbs = depth_peeling_verbs,
         .traits_of = depth_peeling_traits});
}

MethodRow dual_depth_peeling_row()
{
    return with_standard_traits(
        {.id = "dual-depth-peeling",
         .title = "Dual depth peeling: the nearest layer and the farthest, a pass for both",
         .citation = "Bavoil and Myers. Order Independent Transparency with Dual Depth Peeling. "
                     "NVIDIA 2008",
         .continuum = {"if it is the nearest or farthest between the layers before",
                       "two layers a pass", "those between are discarded, until the next pass",
                       "none"},
         .parameters = {kPeels},
         .traits = {},
         .verbs = dual_depth_peeling_verbs,
         .traits_of = dual_peeling_traits});
}

MethodRow bucket_peeling_row()
{
    return with_standard_traits(
        {.id = "bucket-peeling",
         .title = "Bucket depth peeling: the nearest layer of each of a few ranges of depth",
         .citation = "Liu, Huang, Liu and Wu. Efficient Depth Peeling via Bucket Sort. HPG 2009",
         .continuum = {"if it is the nearest in its bucket", "one layer a bucket and pass",
                       "the farther is discarded", "none"},
         .parameters = {{"buckets", "1..32", "32", "ranges of depth at each sample"},
                        {"borders", "uniform|adaptive", "uniform",
                         "ranges of one size, or such that each has as many of the bins, of 1024, "
                         "that hold something"},
                        {"peels", "1..4096", "1",
                         "layers that are taken of each, a pass for each; they end when nothing is "
                         "left"}},
         .traits = {},
         .verbs = bucket_peeling_verbs,
         .traits_of = bucket_traits});
}

MethodRow k_buffer_row()
{
    return with_standard_traits(
        {.id = "k-buffer",
         .title = "k-buffer: a few layers, of which the nearest gives way",
         .citation = "Bavoil, Callahan, Lefohn, Comba and Silva. Multi-Fragment Effects on the GPU "
                     "Using the k-Buffer. I3D 2007",
         .continuum = {"always", "K layers",
                       "the nearest goes in front of all; the two nearest become one; or the "
                       "farthest is discarded",
                       "none"},
         .parameters = {kLayers,
                        {"merge", "front|nearest-two|discard", "front",
                         "of a layer too many: the nearest goes to an accumulator in front of "
                         "all, the two nearest become one, or the farthest is forgotten"}},
         .traits = {},
         .verbs = k_buffer_verbs,
         .traits_of = k_buffer_traits});
}

MethodRow hybrid_row()
{
    return with_standard_traits(
        {.id = "hybrid",
         .title = "Hybrid transparency: the nearest layers exactly, an average of all others",
         .citation = "Maule, Comba, Torchelsen and Bastos. Hybrid Transparency. I3D 2013",
         .continuum = {"always", "K layers", "the farthest is discarded",
                       "the opacity-weighted mean of what was discarded"},
         .parameters = {kLayers,
                        {"tail", "maule|total|none|scaled", "maule",
                         "how opaque the others are: as equal ones would be, as they are, not at "
                         "all; or the layers' colour is scaled to what all cover"}},
         .traits = {},
         .verbs = hybrid_verbs,
         .traits_of = hybrid_traits});
}

MethodRow mlab_row()
{
    return with_standard_traits(
        {.id = "mlab",
         .title = "Multi-layer alpha blending: a few layers, of which the farthest two become one",
         .citation = "Salvi and Vaidyanathan. Multi-Layer Alpha Blending. I3D 2014",
         .continuum = {"always", "K layers", "the two farthest become one", "none"},
         .parameters = {kLayers},
         .traits = {},
         .verbs = mlab_verbs,
         .traits_of = joining_traits});
}

MethodRow z3_row()
{
    return with_standard_traits(
        {.id = "z3",
         .title = "Z3: a few layers, of which the two closest in depth become one",
         .citation = "Jouppi and Chang. Z3: An Economical Hardware Technique for High-Quality "
                     "Antialiasing and Transparency. EGGH 1999",
         .continuum = {"always", "K layers", "the two closest in depth become one", "none"},
         .parameters = {kLayers},
         .traits = {},
         .verbs = z3_verbs,
         .traits_of = joining_traits});
}

MethodRow adaptive_row()
{
    return with_standard_traits(
        {.id = "adaptive",
         .title = "Adaptive transparency: visibility as a curve of a few steps",
         .citation = "Salvi, Montgomery and Lefohn. Adaptive Transparency. HPG 2011",
         .continuum = {"always", "K steps of a visibility curve", "the step of the least area goes",
                       "none"},
         .parameters = {{"nodes", "1..32", "8", "steps of the curve at each sample"}},
         .traits = {},
         .verbs = adaptive_verbs,
         .traits_of = adaptive_traits});
}

MethodRow deep_shadow_map_row()
{
    return with_standard_traits(
        {.id = "deep-shadow-map",
         .title = "Deep shadow maps: visibility as straight pieces within a bound of the exact one",
         .citation = "Lokovic and Veach. Deep Shadow Maps. SIGGRAPH 2000",
         .continuum = {"always", "vertices of a visibility curve",
                       "those go that the curve passes within the error",
                       "the sum is scaled to total alpha; none with correction=off"},
         .parameters = {{"error", "0|0.002|0.01|0.05", "0.01", "of the curve, at most"},
                        {"correction", "on|off", "on",
                         "the sum is made to add up to what all fragments cover"}},
         .traits = {},
         .verbs = deep_shadow_map_verbs,
         .traits_of = deep_shadow_traits});
}

}  // namespace sheer
