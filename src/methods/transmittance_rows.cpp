// The rows of the methods that approximate transmittance as a function of depth, and of the one
// whose weights of depth they improve on.
#include "methods/method.h"
#include "methods/moment_settings.h"

namespace sheer {

StoreVerbs wboit_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs fourier_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs mboit_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs wavelet_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs moment_verbs(TargetSet targets, const ChosenMethod& method, int samples);
ReducedVerbs reduced_moment_verbs(TargetSet targets, const ChosenMethod& method);

namespace {

constexpr Parameter kRange = {
    "range", "drawn|planes", "drawn",
    "where depth goes from near to far: over what is transparent, or between the camera's planes"};

constexpr Parameter kOverestimation = {
    "overestimation", "0.0..1.0", "0.25",
    "between the least and the most that may lie before a fragment"};

constexpr Parameter kStore = {
    "store", "sample|pixel", "sample",
    "a function for each sample, or one for each pixel, of which fragments take the part that they "
    "cover"};

ContinuumPlace sums_of(const char* what)
{
    return {"always", what, "sums", "the weighted mean of all, by total opacity"};
}

// `sums` of exact numbers and `state` of floats.
MethodTraits transmittance_traits(int moment_passes, int sums, int state, bool of_pixels = false)
{
    MethodTraits traits;
    traits.divides = of_pixels;
    traits.passes = moment_passes + 2;
    traits.pass_names = {"opaque"};
    for (int i = 0; i < moment_passes; ++i) traits.pass_names.push_back("moments");
    traits.pass_names.push_back("accumulation");
    const int function = 8 * sums + 4 * state;
    traits.bytes_per_sample = (traits.divides ? 8 : function + 8) + 20;
    traits.bytes_besides = 1 + (traits.divides ? function : 0);
    traits.bytes_per_streamed = 12;
    traits.any_order = Agreement::bits;
    traits.merge = Agreement::bits;
    traits.exact_up_to = 1;
    traits.measures_depth = true;
    return traits;
}

// Pixels keep what they read of the reduced picture, and if they are to, two sums of their own.
MethodTraits reduced_traits(const MomentSettings& settings)
{
    const int numbers = 5 * settings.passes;
    MethodTraits traits = transmittance_traits(0, 5, numbers, true);
    if (settings.is_depth_aware) {
        traits.passes = 3;
        traits.pass_names = {"opaque", "own depth", "accumulation"};
        traits.bytes_besides += 16;
    }
    traits.reduction = settings.reduction;
    traits.reduced_passes = settings.passes;
    traits.reduced_numbers = numbers;
    traits.bytes_of_pictures = 8.0 * numbers / (settings.reduction * settings.reduction);
    return traits;
}

// The paper's table 1: colour in four halves and total alpha in a float; four moments and their
// weight in floats, written; as many halves where the format that is read is another. A pixel's own
// first moment is a float more.
MethodTraits moment_traits(const ChosenMethod& method)
{
    const MomentSettings settings = moment_settings(method);
    MethodTraits traits = settings.reduction > 1
                              ? reduced_traits(settings)
                              : transmittance_traits(settings.passes, 5, 5 * settings.passes,
                                                     method.value("store") == "pixel");
    const double moments = settings.format == MomentFormat::fp32 ? 20 : 30;
    traits.texture_bytes = 12 +
                           settings.passes * moments / (settings.reduction * settings.reduction) +
                           (settings.is_depth_aware ? 4 : 0);
    return traits;
}

std::string moment_refusal(const ChosenMethod& method, int)
{
    const MomentSettings settings = moment_settings(method);
    if (settings.reduction == 1 || settings.format != MomentFormat::nlqm) return "";
    return "format=nlqm can't be mixed between the texels of a resolution below 1; format=fp16 and "
           "unorm16 can";
}

// Colour as above; the numbers in floats, and where they are rounded to 16 bits their weight still.
MethodTraits mboit_traits(const ChosenMethod& method)
{
    const int moments = method.number("moments"), half = moments / 2;
    const bool trigonometric = method.value("basis") == "trigonometric";
    MethodTraits traits =
        transmittance_traits(1, moments + 1, trigonometric ? 4 * half + 2 : 3 * half + 1,
                             method.value("store") == "pixel");
    traits.texture_bytes = 8 + 4 + moments * (method.value("format") == "fp32" ? 4 : 2);
    return traits;
}

MethodTraits fourier_traits(const ChosenMethod& method)
{
    const int numbers = 2 * method.number("terms") + 1;
    MethodTraits traits =
        transmittance_traits(1, numbers, numbers, method.value("store") == "pixel");
    traits.texture_bytes = 12 + 4 * numbers;
    return traits;
}

MethodTraits wavelet_traits(const ChosenMethod& method)
{
    const int cells = 2 << method.number("rank");
    MethodTraits traits =
        transmittance_traits(1, cells + 1, cells, method.value("store") == "pixel");
    traits.texture_bytes = 12 + 4 * cells;
    return traits;
}

MethodTraits wboit_traits(const ChosenMethod& method)
{
    MethodTraits traits;
    traits.bytes_per_sample = 20;
    traits.bytes_per_streamed = 4;
    traits.texture_bytes = 12;
    traits.any_order = traits.merge = Agreement::rounding;
    traits.exact_up_to = 1;
    traits.measures_depth = method.value("weight") == "range";
    return traits;
}

}  // namespace

MethodRow moment_row()
{
    return with_standard_traits(
        {.id = "moment",
         .title = "Moment transparency: transmittance from four moments of optical depth",
         .citation = "Sharpe. Moment Transparency. HPG 2018",
         .continuum = sums_of("four moments of optical depth, no layer"),
         .parameters =
             {{"overestimation", "0.0..1.0|adaptive", "0.25",
               "between the least and the most that may lie before a fragment; adaptive: less "
               "where "
               "there are few (an experiment)"},
              {"format", "fp32|fp16|unorm16|nlqm", "fp32",
               "of what fragments read; nlqm: non-linearly quantised moments (Peters. HPG 2017)"},
              {"moment-passes", "1|2", "1",
               "2: the second moments are of what the first let be seen, and hide it once more"},
              {"resolution", "1|1/2|1/4|1/8", "1",
               "of the picture whose moments pixels read, mixed from the nearest four; below 1 "
               "each "
               "pixel has one function, whatever `store` says"},
              {"upsample", "bilinear|depth-aware", "bilinear",
               "how these are read; depth-aware: what they lack of a pixel's own depth is put in"},
              kRange,
              kStore},
         .traits = {},
         .verbs = moment_verbs,
         .reduced_verbs = reduced_moment_verbs,
         .traits_of = moment_traits,
         .refusal = moment_refusal});
}

MethodRow wboit_row()
{
    return with_standard_traits(
        {.id = "wboit",
         .title = "Weighted blended: weights that fall with distance",
         .citation = "McGuire and Bavoil. Weighted Blended Order-Independent Transparency. "
                     "JCGT 2(2), 2013",
         .continuum = {"always", "sums, no layer", "a sum, weighted by distance",
                       "the weighted mean of all"},
         .parameters =
             {{"weight", "eq7|eq8|eq9|eq10|uniform|range", "eq9",
               "the paper's equation, in metres from the eye, or none; range: equation 10 "
               "with depth from 0 to 1 over what is transparent, by the logarithm"}},
         .traits = {},
         .verbs = wboit_verbs,
         .traits_of = wboit_traits});
}

MethodRow fourier_row()
{
    return with_standard_traits(
        {.id = "fourier",
         .title = "Fourier opacity maps: optical depth as a Fourier series over depth",
         .citation = "Jansen and Bavoil. Fourier Opacity Mapping. I3D 2010",
         .continuum = sums_of("a Fourier series of optical depth, no layer"),
         .parameters = {{"terms", "3|7", "7", "of the series, besides the constant one"},
                        {"window", "none|lanczos", "none", "what damps the highest terms"},
                        kRange,
                        kStore},
         .traits = {},
         .verbs = fourier_verbs,
         .traits_of = fourier_traits});
}

MethodRow mboit_row()
{
    return with_standard_traits(
        {.id = "mboit",
         .title = "Moment-based: transmittance from four, six or eight moments",
         .citation = "Muenstermann, Krumpen, Klein and Peters. Moment-Based Order-Independent "
                     "Transparency. I3D 2018",
         .continuum = sums_of("four to eight moments of optical depth, no layer"),
         .parameters = {{"moments", "4|6|8", "4",
                         "how many numbers; trigonometric ones are two each"},
                        {"basis", "power|trigonometric", "power", "what they are moments of"},
                        {"format", "fp32|unorm16", "fp32", "of what fragments read"},
                        kOverestimation,
                        kRange,
                        kStore},
         .traits = {},
         .verbs = mboit_verbs,
         .traits_of = mboit_traits});
}

MethodRow wavelet_row()
{
    return with_standard_traits(
        {.id = "wavelet",
         .title = "Wavelet transparency: optical depth as a series of Haar's wavelets over depth",
         .citation = "Aizenshtein, Smal and McGuire. Wavelet Transparency. 2022",
         .continuum = sums_of("wavelets of optical depth, no layer"),
         .parameters = {{"rank", "2..4", "3", "of the tree; it has 2^(rank + 1) cells"},
                        kRange,
                        kStore},
         .traits = {},
         .verbs = wavelet_verbs,
         .traits_of = wavelet_traits});
}

}  // namespace sheer
