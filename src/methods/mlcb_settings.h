// What the parameters of `mlcb` say, in the words of slab's, whose layers it has.
#pragma once

#include "methods/slab_settings.h"

namespace sheer {

inline SlabSettings mlcb_settings(const ChosenMethod& method)
{
    const std::string& keep = method.value("keep");
    SlabSettings settings{};
    settings.layers = method.number("layers");
    settings.bits = method.number("bits");
    settings.is_explicit = true;
    settings.stratified = true;
    settings.keep = keep == "purged"    ? SlabKeep::purged
                    : keep == "visible" ? SlabKeep::visible
                                        : SlabKeep::nearest;
    settings.corrects = method.value("correction") == "on";
    return settings;
}

}  // namespace sheer
