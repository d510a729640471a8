// A cross-bilateral filter of what is transparent, guided by total alpha.
#pragma once

#include <sheer/render.h>

namespace sheer {

// `transparent`: what a method added to the dimmed background, and total alpha, which is without
// noise; as large as the image. Its mean around each pixel p, with weights
//   exp(-|p - q|^2 / (2 sigma_s^2)) exp(-(alpha_p - alpha_q)^2 / (2 sigma_r^2))
// takes its place in `image`. After section 6 of Enderton et al., Stochastic Transparency, which
// gives no widths; with the defaults noise falls by a quarter to two fifths on smooth surfaces and
// smoke, and detail of hair and leaves is lost.
void apply_post_filter(const PostFilter& filter, const Image& transparent, int threads,
                       Image& image);

}  // namespace sheer
