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

// The paper's table 1: colour in four halves and total alpha in a float; four moments and their
// weight in floats, written; as many halves where the format that is read is another.
MethodTraits moment_traits(const ChosenMethod& method)
{
    const MomentSettings settings = moment_settings(method);
    MethodTraits traits = transmittance_traits(settings.passes, 5, 5 * settings.passes,
                                               method.value("store") == "pixel");
    traits.texture_bytes = 12 + settings.passes * 20;
    if (settings.format != MomentFormat::fp32) traits.texture_bytes += settings.passes * 10;
    return traits;
}

// Colour as above; the numbers in floats, and where they are rounded to 16 bits their weight still.
MethodTraits mboit_traits(const ChosenMethod& method)
{
    const int moments = method.number("moments"), half = moments / 2;
    const bool trigonometric = method.value("basis") == "trigonometric";
    MethodTraits traits =
        transmittance_traits(1, moments + 1, trigonometric ? 4 * half + 2 : 3 * half + 1);
    traits.texture_bytes = 8 + 4 + moments * (method.value("format") == "fp32" ? 4 : 2);
    return traits;
}

MethodTraits fourier_traits(const ChosenMethod& method)
{
    const int numbers = 2 * method.number("terms") + 1;
    MethodTraits traits = transmittance_traits(1, numbers, numbers);
    traits.texture_bytes = 12 + 4 * numbers;
    return traits;
}

MethodTraits wavelet_traits(const ChosenMethod& method)
{
    const int cells = 2 << method.number("rank");
    MethodTraits traits = transmittance_traits(1, cells + 1, cells);
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
              kRange,
              kStore},
         .traits = {},
         .verbs = moment_verbs,
         .traits_of = moment_traits});
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
                        kRange},
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
                        kRange},
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
         .parameters = {{"rank", "2..4", "3", "of the tree; it has 2^(rank + 1) cells"}, kRange},
         .traits = {},
         .verbs = wavelet_verbs,
         .traits_of = wavelet_traits});
}

}  // namespace sheer
