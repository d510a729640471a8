// How far rounding may take each method from what its formula gives in exact arithmetic, in parts
// of the largest colour M among fragments and backdrop: the only tolerances of the methods' tests.
//
// u is half a unit of the last place of 1, the relative error of one operation, and n the number of
// fragments. To first order:
//
// Opacity.      1 - a is off by u, T as a product of n of them by 2 n u, and where T is near 1 by
//               n u however small the opacities are. T B then costs (2 n + 2) M u, T B + the rest M
//               u more.
// blend         new = a c + (1 - a) old, a mean, costs 3 roundings of M at most, and passes on no
//               more error than it got: 3 n, and T B.
// exact         term i is T_i a_i c_i, off by (2 i + 2) u; the T_i a_i sum to 1 at most, so the
//               terms to 2 n + 2; adding them up costs n; and T B.
// averages      sum(w a c) / sum(w a) is a mean. Its weights are off by e and lose 1 + n more when
//               they are multiplied and added up, in both sums: 2 (e + n + 2). Times (1 - T), where
//               T's error counts again, and the last product, sum and quotient: 2 n + 6.
// of depth      e for equations 7 to 9: z / 5, z / 200 and their like are off by 3 (of z itself, of
//               the constant, of the product), their sixth power by 18 and 5 products, the rest
//               (sum of three, quotient, opacity) by 5. Clamping adds nothing.
//               e for equation 10: 1 - d is off by 7 u of 1, as d is a difference of numbers of
//               which the largest is divided by zfar - znear, up to 1. From (1 - d)^3 3000 = 0.01
//               on, where 1 - d is 0.0149, the clamp holds: 7 / 0.0149 there, three times as much
//               in the cube, 4 roundings.
// weighted      T = (1 - s / n)^n. s is off by n, 1 - s / n by (n + 1) s / n + 1 of 1; the slope of
// average       the power turns that into 2 n + 1 at most, as n x (1 - x)^(n-1) <= 1; squaring and
//               multiplying add 2 n: 4 n + 1 for T, which counts with the mean and with B.
// stochastic    basic: one of its inputs, untouched; of P passes the mean of P, which costs P + 4.
//               (stratified-stochastic: the same, in one pass.)
//               Alpha corrected: the mean of those, P + 4, times 1 - T, 2 n + 2, and T B.
//               Depth-based: two sums of n P terms, 2 (n P + 2), or, uncorrected, one, whose size
//               is up to n M.
// slab          Of k layers, whose visibility is a quotient, or a product, off by 2 k. Depth based:
//               as above, 2 k more in each term. Else the k parts of the layers: 2 k + 3 each,
//               their sum k.
// mlcb          As slab's layers. Two that become one are a mean, whose weights are off by 1 and 2:
//               3, the products and the sum: 6 of M, which passes on no more error than it got: 6
//               n.
// by a function of depth (moment and its like)
//               The function's values are the same floats in both. Each of the n addends of both
//               sums is off by two products, 2, and by half of 2^-48 on its grid, of a sum that is
//               at least 2^-30 of the opacities' or, where few of them are seen, of a large one:
//               n 2^-18. The sums lose nothing; rounding them, 1. T = e^-d': each optical depth is
//               off by 4, d' by 5 after its rounding, which counts d' e^-d' <= 0.37 times, and the
//               power by 4: 6. So 2 (2 + 1) + 6 + 3 and n 2^-17, and T B. All orders have the same
//               bits.
// layers        One over the other, c = c_A + (1 - A) c_B and A + (1 - A) B: n premultiplied
// colours, of
//               each of which the sums make n, 1 - A and the products 2 n; A is off by 3 n, of
//               which each part counts once more in what lies behind; T = 1 - A and T B: 9 n + 4.
//               Peeling is that too.
//               A tail in addition: as the weighted average. A core's colour that is scaled by
//               (1 - T) / A: both sides of C / A are relatively as wrong, 6 n + 1, T by 5 n + 2,
//               the three operations, and T B.
// adaptive      Each term's T is a product as in `exact`, 2 n; the terms 3 and their sum n.
// phenomeno-    As weighted average with T of its own: the mean of three products, 2 n + 4.
//  logical
// deep-shadow-  Without an error of its own: the same; the sums are up to n M, as what coincides
//  map          does not hide itself. Corrected: 3 n + 3 in both of them, 1 - T, and 6 more.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "methods/every_method.h"

namespace sheer {

inline constexpr double kUnit = 0x1p-24;

struct RoundingBound {
    double as_formula;  // of M: between the method and its formula
    double reordered;   // of M: between two orders of the same fragments; the weights are the same
};

// Of phenomenological's: 1 - 0.99 d is off by 9 u of 1, as d by 7, and no less than 0.01; three
// times as much in the cube, 3 products, and the last.
inline constexpr double kPhenomenologicalWeight = 3 * (9 / 0.01 + 1) + 4;
// What makes of a fragment something opaque or nothing shows one of its inputs, untouched.
inline bool is_alpha_test(const ChosenMethod& method)
{
    const std::string id = method.row->id;
    return id.ends_with("alpha-test") || id.ends_with("alpha-to-coverage") || id == "screen-door";
}

inline double weight_roundings(const std::string& weight)
{
    if (weight == "uniform") return 0;
    // Of d over a range: the logarithm's error, 2 of 6 at most, is smaller than that.
    if (weight == "eq10" || weight == "range") return 3 * 7 / 0.0149 + 4;
    return 18 + 5 + 5;
}

inline RoundingBound rounding_bound(const ChosenMethod& method, std::size_t fragments)
{
    const std::string id = method.row->id;
    const auto n = static_cast<double>(fragments);
    const double backdrop = 2 * n + 3;
    double formula = 0, weights = 0;
    if (id == "blend" || id == "sorted-blend" || id == "alpha-test-then-blend") {
        formula = 3 * n + backdrop;
    } else if (id == "exact") {
        formula = 2 * n + 2 + n + backdrop;
    } else if (id == "weighted-average") {
        formula = 2 * (n + 2) + 2 * (4 * n + 1) + 6;
    } else if (id == "mlab" || id == "z3" || id == "k-buffer" || id.ends_with("-peeling")) {
        formula = 9 * n + 4;
    } else if (id == "adaptive") {
        formula = 3 * n + 3 + backdrop;
    } else if (id == "hybrid") {
        formula = method.value("tail") == "none" ? 9 * n + 4
                  : method.value("tail") == "scaled"
                      ? 2 * (6 * n + 1) + 2 * (5 * n + 2) + 3 + 2
                      : 9 * n + 4 + 2 * (n + 2) + 2 * (4 * n + 1) + 6;
    } else if (id == "wboit") {
        weights = 2 * weight_roundings(method.value("weight"));
        formula = weights + 2 * (n + 2) + 2 * n + 6 + backdrop;
    } else if (id == "phenomenological") {
        weights = 2 * kPhenomenologicalWeight;
        formula = weights + 2 * (n + 2) + 2 * (2 * n + 4) + 6;
    } else if (id == "deep-shadow-map") {
        const bool corrects = method.value("correction") == "on";
        formula =
            backdrop + (corrects ? 2 * (3 * n + 3) + 2 * n + 6 : (3 * n + 3) * std::max(n, 1.0));
    } else if (id == "moment" || id == "mboit" || id == "fourier" || id == "wavelet") {
        formula = 2 * (2 + 1) + 6 + 3 + n * 0x1p-17 / kUnit + backdrop;
        weights = formula;
    } else if (id == "stochastic") {
        const double passes = method.number("sample-passes");
        const bool corrects = method.value("correction") == "on";
        if (method.value("depth-based") == "on") {
            formula = backdrop + (corrects ? 2 * (n * passes + 2) + 2 * n + 6
                                           : (n * passes + 4) * std::max(n, 1.0));
        } else if (corrects) {
            formula = passes + 4 + 2 * n + 2 + backdrop;
        } else if (passes > 1) {
            formula = passes + 4;
        }
    } else if (id == "slab") {
        const double k = method.number("layers");
        const bool corrects = method.value("correction") == "on";
        const bool sums_all = method.value("depth-based") == "on";
        const double sum = sums_all ? n + 2 * k + 4 : 3 * k + 4;
        formula =
            backdrop + (corrects ? 2 * sum + 2 * n + 6 : sum * (sums_all ? std::max(n, 1.0) : 1.0));
    } else if (id == "mlcb") {
        const double sum = 3 * method.number("layers") + 4 + 6 * n;
        formula = backdrop + (method.value("correction") == "on" ? 2 * sum + 2 * n + 6 : sum);
    } else if (id != "none" && id != "stratified-stochastic" && !is_alpha_test(method)) {
        ADD_FAILURE() << "there is no bound for the method '" << id << "'";
    }
    // Both are as far from the same formula, with the weights that they have.
    return {formula * kUnit, 2 * (formula - weights) * kUnit};
}

// One fragment over a backdrop: 1 - a, 1 - T, the mean (a product and a quotient), two products and
// a sum, and 1 - a once more in T B; none of numbers above M.
inline constexpr double kOneFragment = 8 * kUnit;

// Several passes add it up, in both sums of a quotient.
inline double one_fragment_bound(const ChosenMethod& method)
{
    // But peeling finds it in one of them.
    if (std::string(method.row->id).ends_with("-peeling")) return kOneFragment;
    return kOneFragment + 2 * (method.traits().passes - 1) * kUnit;
}

}  // namespace sheer
