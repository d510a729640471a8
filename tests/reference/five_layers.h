// Five layers, near to far, whose exact colour over nothing is (.6428, .3428, .1068) and lets .0672
// through, in all 120 orders of arrival.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "reference/reference.h"

namespace sheer::reference {

inline const std::vector<Fragment> kFiveLayers = {{0.2, 0.5, {1, 0, 0}, 1},
                                                  {0.4, 0.4, {0, 1, 0}, 2},
                                                  {0.5, 0.3, {0, 0, 1}, 3},
                                                  {0.7, 0.6, {1, 1, 0}, 4},
                                                  {0.9, 0.2, {1, 1, 1}, 5}};

inline void for_every_order(const std::function<void(const std::vector<Fragment>&)>& visit)
{
    std::vector<Fragment> fragments = kFiveLayers;
    do {
        visit(fragments);
    } while (
        std::next_permutation(fragments.begin(), fragments.end(),
                              [](const Fragment& a, const Fragment& b) { return a.id < b.id; }));
}

// Over the 120 orders, of the root mean square error over red, green and blue.
struct Spread {
    double mean = 0, most = 0;
    std::set<std::string> results;  // to six decimals
};

inline Spread spread_of(const std::function<Rgba(const std::vector<Fragment>&)>& method)
{
    Spread spread;
    for_every_order([&](const std::vector<Fragment>& fragments) {
        const Rgba got = method(fragments), exact = composite(fragments, {});
        const double squares = std::pow(got.r - exact.r, 2) + std::pow(got.g - exact.g, 2) +
                               std::pow(got.b - exact.b, 2);
        const double error = std::sqrt(squares / 3);
        spread.mean += error / 120;
        spread.most = std::max(spread.most, error);
        std::string text;
        for (const double c : {got.r, got.g, got.b}) text += std::to_string(c + 1e-9) + " ";
        spread.results.insert(text);
    });
    return spread;
}

}  // namespace sheer::reference
