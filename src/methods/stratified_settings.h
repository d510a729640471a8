// What the parameters of `stratified-stochastic` say.
#pragma once

#include "methods/method.h"

namespace sheer {

enum class Dither { none, morton, hilbert };
// As shaders/sheer/stratified_stochastic.glsl numbers them.
enum class Sequence { paper, vegdahl, sobol, random };

struct StratifiedSettings {
    bool tracking;    // else each fragment is a surface of its own
    bool compaction;  // else a sample's number is its own
    bool sort;        // by the depths that are kept; else samples have their numbers in turn
    Dither dither;
    Sequence sequence;
};

inline StratifiedSettings stratified_settings(const ChosenMethod& method)
{
    const std::string &dither = method.value("dither"), &sequence = method.value("sequence");
    return {method.value("tracking") == "on", method.value("compaction") == "on",
            method.value("sort") == "on",
            dither == "hilbert"  ? Dither::hilbert
            : dither == "morton" ? Dither::morton
                                 : Dither::none,
            sequence == "paper"     ? Sequence::paper
            : sequence == "vegdahl" ? Sequence::vegdahl
            : sequence == "sobol"   ? Sequence::sobol
                                    : Sequence::random};
}

}  // namespace sheer
