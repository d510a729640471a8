// What stochastic layered alpha blending must answer, in double precision, and the exact moments of
// its answer: C. Wyman, "Exploring and expanding the continuum of OIT algorithms", 2016.
//
// Of a pixel whose samples are all at one place: every fragment covers it fully before masking.
// Fragments come in the order of arrival; ties in depth: the smaller id is in front. Two fragments
// must not share both.
//
// Symbols: k layers are kept. b is the number of bits of a mask; alpha_C is what all fragments
// together cover, kept or not, and T = 1 - alpha_C what they let through. svis(z) is the part of
// the light from z that passes the kept layers in front of it.
#pragma once

#include <array>
#include <bitset>
#include <functional>
#include <span>
#include <vector>

#include "reference/methods.h"
#include "reference/stochastic_estimators.h"

namespace sheer::reference {

using SlabMask = std::bitset<128>;  // of b bits: those from 0 to b - 1

struct SlabLayer {
    double depth = 0;
    std::uint32_t id = 0;
    double alpha = 0;
    SlabMask mask;
};

struct SlabStore {
    int bits = 0;                   // b; 0: infinitely many, and layers hide by their alpha
    std::vector<SlabLayer> layers;  // near to far, at most k
};

// Which k layers are kept.
enum class SlabKeep {
    purged,   // those with a bit that no layer in front has; the nearest of them where more than k
    visible,  // as above when they arrive; a layer that is hidden later stays
    nearest,  // the nearest that have a bit, hidden or not: stores merge exactly
};

// masks[i] is that of fragments[i]; 1 <= b <= 128.
SlabStore slab_store(std::span<const Fragment> fragments, std::span<const SlabMask> masks, int k,
                     int b, SlabKeep keep);
// As if b's layers had arrived at a, from near to far; what both have is there once.
SlabStore slab_merge(const SlabStore& a, const SlabStore& b, int k, SlabKeep keep);

// The limit of infinitely many bits: the nearest k fragments that are not fully transparent.
SlabStore slab_store_of_alpha(std::span<const Fragment> fragments, int k);

// b svis(z), for b > 0: how many bits are in no mask of a layer in front of (depth, id).
int slab_visible_bits(const SlabStore& store, double depth, std::uint32_t id);
double slab_visibility(const SlabStore& store, double depth, std::uint32_t id);

enum class SlabResolve {
    depth_corrected,  // D = alpha_C U / U1, + T backdrop; U = sum over all of svis(z) alpha c, U1
                      // the same without c
    depth_based,      // U + T backdrop
    color_corrected,  // alpha_C X / X1, + T backdrop; X = sum over layers of c times the part of
                      // the bits (of 1, where b is infinite: svis(z) alpha) that is theirs
    color,            // X + (1 - X1) backdrop
};

// Of each fragment's straight colour, in the same order, and last of the backdrop. Where U1 or X1
// is 0, the corrected ones have nothing but T backdrop.
std::vector<double> slab_weights(std::span<const Fragment> fragments, const SlabStore& store,
                                 SlabResolve resolve);
// Alpha is treated as a channel in which fragments are 1.
Rgba slab(std::span<const Fragment> fragments, const SlabStore& store, SlabResolve resolve,
          Rgba backdrop);

// The chance that a mask with beta_B of b bits shows behind one with beta_A, 0 <= beta <= b: naive
// bits are set each with the chance alpha_B (beta_B / b in the paper); of stratified masks all with
// beta_B bits are equally likely.
double slab_naive_chance(int b, int beta_a, double alpha_b);
double slab_stratified_chance(int b, int beta_a, int beta_b);

// The chance of a fragment with alpha_B to be inserted where layers with a total alpha_A are in
// front of it. Zero where alpha_B is 0.
using SlabChance = std::function<double(double alpha_a, double alpha_b)>;

// How alpha b becomes a whole number of bits. `random`: up with the chance of its fraction, and
// SlabChance is the mean over that.
enum class SlabRounding { down, up, random };

struct SlabImplicit {
    int b = 1;
    bool stratified = true;
    SlabRounding round_a = SlabRounding::down;
    SlabRounding round_b = SlabRounding::random;
    bool alpha_as_it_is = false;  // naive only: alpha_B is not rounded
};
SlabChance slab_chance(const SlabImplicit& implicit);

// Implicit coverage: layers hide by their alpha. `inserts` decides for fragments[i], given the
// alpha of what is in front of it in the store when it arrives; the farthest of k + 1 goes.
SlabStore slab_implicit_store(std::span<const Fragment> fragments, int k,
                              const std::function<bool(std::size_t i, double alpha_a)>& inserts);

// Stratified in depth: from near to far, a fragment is kept whenever the sum of its and all nearer
// fragments' chances, plus xi in [0, 1), passes a whole number; up to k of them.
SlabStore slab_systematic_store(std::span<const Fragment> fragments, int k,
                                const SlabChance& chance, double xi);

// Moments of red, green, blue and alpha, and in `kept` the chance of each fragment to be in the
// store when all have arrived.
struct SlabMoments {
    std::array<Moments, 4> channels;
    std::vector<double> kept;
};

// Over all masks of all fragments: 2^(b n) cases, fewer where masks have no chance; b up to 16.
SlabMoments slab_moments(std::span<const Fragment> fragments, int k, int b, SlabKeep keep,
                         MaskChance chance, SlabResolve resolve, Rgba backdrop);
// Over all decisions whether fragments are inserted, each made by its own throw: 2^n cases.
SlabMoments slab_implicit_moments(std::span<const Fragment> fragments, int k,
                                  const SlabChance& chance, SlabResolve resolve, Rgba backdrop);
// Over xi, uniform in [0, 1).
SlabMoments slab_systematic_moments(std::span<const Fragment> fragments, int k,
                                    const SlabChance& chance, SlabResolve resolve, Rgba backdrop);

}  // namespace sheer::reference
