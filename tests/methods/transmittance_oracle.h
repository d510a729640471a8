// What the methods that approximate transmittance make of one sample's fragments, by the
// reference's formulas.
//
// A sample's colour is in two steps: the function (moment_test.cpp and its like hold the texts' to
// the reference's, to what the papers promise of it), and the mean that it weighs, in doubles here
// with the text's function, so that only rounding lies between that and a store.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "methods/method.h"
#include "methods/transmittance_functions.h"
#include "reference/moment_transparency.h"

namespace sheer::test {

using reference::Fragment;
using reference::Rgba;
using Fragments = std::vector<Fragment>;

inline bool approximates_transmittance(const ChosenMethod& method)
{
    const std::string id = method.row->id;
    return id == "moment" || id == "mboit" || id == "fourier" || id == "wavelet";
}

// By the text, and at least what counts as being seen.
inline reference::Transmittance text_transmittance(const ChosenMethod& method,
                                                   const Fragments& fragments)
{
    const std::shared_ptr<TransmittanceFunction> function = transmittance_function(method);
    State state;
    for (int pass = 0; pass < function->passes(); ++pass) {
        Sums sums(function->sums());
        for (const Fragment& f : fragments) {
            const auto place = static_cast<float>(f.depth);
            const float seen = pass == 0 ? 1 : function->transmittance(state, place);
            function->add(sums, place,
                          FloatText::optical_depth(static_cast<float>(f.opacity) * seen));
        }
        state = pass == 0 ? function->prepare(sums) : function->prepare_again(state, sums);
    }
    return [=](double z) {
        const float through = function->transmittance(state, static_cast<float>(z));
        return static_cast<double>(std::max(through, 0x1p-30f));
    };
}

// `fragments` have the depths that decide which of them is in front, `places` of the same from -1
// to 1. The nearest that is opaque takes the backdrop's place.
inline Rgba transmittance_answer(const ChosenMethod& method, const Fragments& fragments,
                                 const std::vector<double>& places, Rgba behind)
{
    const auto nearer = [](const Fragment& a, const Fragment& b) {
        return a.depth < b.depth || (a.depth == b.depth && a.id < b.id);
    };
    const Fragment* opaque = nullptr;
    for (const Fragment& f : fragments) {
        if (f.opacity >= 1 && (opaque == nullptr || nearer(f, *opaque))) opaque = &f;
    }
    if (opaque != nullptr) behind = {opaque->color[0], opaque->color[1], opaque->color[2], 1};
    Fragments shown;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        if (fragments[i].opacity >= 1 || (opaque != nullptr && !nearer(fragments[i], *opaque))) {
            continue;
        }
        shown.push_back(fragments[i]);
        shown.back().depth = places[i];
    }
    return reference::weigh_by_transmittance(shown, text_transmittance(method, shown), behind);
}

}  // namespace sheer::test
