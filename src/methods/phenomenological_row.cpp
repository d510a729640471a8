// The row of phenomenological transparency.
#include "methods/method.h"
#include "methods/phenomenological_backdrop.h"

namespace sheer {

StoreVerbs phenomenological_verbs(TargetSet targets, const ChosenMethod& method, int samples);
StoreVerbs phenomenological_colored_verbs(TargetSet targets, const ChosenMethod& method,
                                          int samples);

namespace {

MethodTraits phenomenological_traits(const ChosenMethod& method)
{
    MethodTraits traits;
    traits.bytes_per_sample = 28;
    traits.bytes_per_streamed = 4;
    traits.any_order = traits.merge = Agreement::rounding;
    traits.exact_up_to = 1;
    if (phenomenological_settings(method).reads_backdrop()) {
        traits.reads_backdrop = true;
        traits.exact_up_to = 0;  // what is behind is not where and as it is
        traits.bytes_per_sample += PhenomenologicalBackdrop::kBytesPerSample;
        traits.bytes_of_pictures = BackdropPicture::kPixelBytes;
    }
    return traits;
}

}  // namespace

MethodRow phenomenological_row()
{
    return with_standard_traits(
        {.id = "phenomenological",
         .title = "Weighted blending that knows coloured glass: each channel has its transmittance",
         .citation = "McGuire and Mara. Phenomenological Transparency. TVCG 23(5), 2017",
         .continuum = {"always", "sums, no layer", "a sum, weighted by distance",
                       "the weighted mean of all"},
         .parameters =
             {{"diffusion", "0.0..1.0", "0.0",
               "1 - collimation of all that is transparent, which blurs what is behind it"},
              {"refraction", "1.0..3.0", "1.0",
               "eta, the index of all that is transparent, behind which things are displaced"}},
         .traits = {},
         .verbs = phenomenological_verbs,
         .colored_verbs = phenomenological_colored_verbs,
         .traits_of = phenomenological_traits});
}

}  // namespace sheer
