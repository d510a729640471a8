// One pixel of stratified stochastic transparency: S. Laine, T. Karras, "Stratified sampling for
// stochastic transparency", 2011, figures 4 and 7, step by step, and the same with parts of it
// switched off.
//
// Written from the paper alone, as plain loops; it shares nothing with the method that it judges.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace sheer::reference {

// A number's value in [0, 1), given the number, the pixel's index and the surface's id.
using AlphaReference =
    std::function<double(std::uint32_t number, std::uint32_t pixel, std::uint32_t surface)>;

// Figure 4's with its constants: 32 bits, of which the value is the upper 24.
std::uint32_t paper_bits(std::uint32_t number, std::uint32_t pixel, std::uint32_t surface,
                         int samples);
// P. Vegdahl's hash, "Building a better LK hash", 2021, of a number.
std::uint32_t vegdahl_bits(std::uint32_t number, std::uint32_t seed);
// I. Sobol's second dimension: bit i of the value is the parity of the bits j <= i of the reversed
// index for which i over j is odd.
std::uint32_t sobol_bits(std::uint32_t number, std::uint32_t pixel, std::uint32_t surface,
                         int samples);
double value_of_bits(std::uint32_t bits);

// Along the curves through side x side pixels; the side is a power of two.
std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t side);
std::uint32_t morton_index(std::uint32_t x, std::uint32_t y);

// A fragment at the samples of a pixel.
struct PixelFragment {
    std::uint64_t covered = 0;          // sample s: bit s
    std::array<double, 64> depth = {};  // at each sample
    double opacity = 0;
    std::uint32_t id = 0;              // of equal depths the smaller is in front
    std::array<double, 3> color = {};  // straight
};

struct StratifiedSwitches {
    bool tracking = true;    // off: every fragment is a surface of its own
    bool compaction = true;  // off: a sample's number is its own
    bool sort = true;        // off: samples get their numbers in their own order
    // Instead of the paper's values: W. Madow, L. Madow, "On the theory of systematic sampling",
    // 1944. With x a surface's value of number 0 and a the opacity, number n takes its sample where
    // floor(x + (n + 1) a) is more than floor(x + n a); both in whole 2^-24, a rounded up.
    bool systematic = false;
};

struct StratifiedPixel {
    int samples;            // up to 64
    std::uint32_t index;    // on the curve
    std::uint32_t surface;  // the first surface's id
    AlphaReference reference;
    StratifiedSwitches switches = {};
};

// For each sample which of the fragments, in the order in which they are drawn, owns it in the end;
// -1: none.
std::vector<int> stratified_owners(std::span<const PixelFragment> fragments,
                                   const StratifiedPixel& pixel);

}  // namespace sheer::reference
