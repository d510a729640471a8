// The six techniques of Sharpe. Moment Transparency. HPG 2018, table 1, and its two scenes.
#pragma once

#include <sheer/render.h>

namespace sheer {

struct MomentTechnique {
    const char* name;    // the paper's
    const char* method;  // here
    const char* bytes;   // a pixel, in the paper
};

// Overestimation is a fourth, as in the paper, with two moments passes too, of which it does not
// say.
inline constexpr MomentTechnique kMomentTechniques[] = {
    {"WBOIT", "wboit", "12"},
    {"MT", "moment", "32"},
    {"MT_NLQM", "moment:format=nlqm", "42"},
    {"TMP", "moment:moment-passes=2", "52"},
    {"MT_LR", "moment:resolution=1/8", "12.3125"},
    {"TMP_LR", "moment:resolution=1/8:moment-passes=2", "12.625"},
};

inline constexpr EntryScene kBurningHouse = {"burning-house", "builtin:burning-house",
                                             "builtin:burning-house?particles=200&grass=0.1"};
inline constexpr EntryScene kGrassAndSmoke = {"grass-and-smoke", "builtin:grass-and-smoke",
                                              "builtin:grass-and-smoke?particles=60"};

// What is drawn of both.
inline View moment_view(bool quick)
{
    View view;
    view.width = quick ? 64 : 640;
    view.height = quick ? 48 : 480;
    view.samples = 1;
    return view;
}

}  // namespace sheer
