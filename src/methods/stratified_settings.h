// What the parameters of `stratified-stochastic` say of tracked masks. Those of `stochastic` have
// the standard values, but for masks=systematic.
#pragma once

#include <string_view>

#include "methods/method.h"

namespace sheer {

enum class Dither { none, morton, hilbert };
// As shaders/sheer/stratified_stochastic.glsl numbers them; systematic numbers last.
enum class Sequence { paper, vegdahl, sobol, random, systematic };

struct StratifiedSettings {
    bool tracking = true;    // else each fragment is a surface of its own
    bool compaction = true;  // else a sample's number is its own
    bool sort = true;        // by the depths that are kept; else samples have their numbers in turn
    Dither dither = Dither::hilbert;
    Sequence sequence = Sequence::paper;
};

inline StratifiedSettings stratified_settings(const ChosenMethod& method)
{
    if (method.row->id != std::string_view("stratified-stochastic")) {
        StratifiedSettings standard;
        if (method.value("masks") == "systematic") standard.sequence = Sequence::systematic;
        return standard;
    }
    const std::string &dither = method.value("dither"), &sequence = method.value("sequence");
    return {method.value("tracking") == "on", method.value("compaction") == "on",
            method.value("sort") == "on",
            dither == "hilbert"  ? Dither::hilbert
            : dither == "morton" ? Dither::morton
                                 : Dither::none,
            sequence == "paper"     ? Sequence::paper
            : sequence == "vegdahl" ? Sequence::vegdahl
            : sequence == "sobol"   ? Sequence::sobol
            : sequence == "random"  ? Sequence::random
                                    : Sequence::systematic};
}

}  // namespace sheer
