// The papers' constants, of the maps to [0, 1]; their inverses are computed.
#include "reference/rounded_moments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace sheer::reference {
namespace {

using Numbers = std::vector<double>;
using Matrix = std::vector<Numbers>;  // rows

// numbers[i] = sum over j of rows[i][j] b[picked[j]] + offsets[i], for `places[i]`.
struct Map {
    std::vector<std::size_t> picked;
    Matrix rows;
    Numbers offsets;
};

Matrix transposed(const Matrix& m)
{
    Matrix result(m[0].size(), Numbers(m.size()));
    for (std::size_t i = 0; i < m.size(); ++i) {
        for (std::size_t j = 0; j < m[i].size(); ++j) result[j][i] = m[i][j];
    }
    return result;
}

// Tables that are meant for a row vector on their left are transposed.
std::vector<Map> maps_of(RoundedMoments kind)
{
    const double root = std::sqrt(3.0);
    switch (kind) {
        case RoundedMoments::shadow:
            return {{{0, 1, 2, 3},
                     transposed({{-2.07224649, 13.7948857237, 0.105877704, 9.7924062118},
                                 {32.23703778, -59.4683975703, -1.9077466311, -33.7652110555},
                                 {-68.571074599, 82.0359750338, 9.3496555107, 47.9456096605},
                                 {39.3703274134, -35.364903257, -6.6543490743, -23.9728048165}}),
                     {0.035955884801, 0, 0, 0}}};
        case RoundedMoments::four:
            return {{{0, 2}, transposed({{1.5, root / 2}, {-2, -2 * root / 9}}), {0.5, 0.5}},
                    {{1, 3}, transposed({{4, 0.5}, {-4, 0.5}}), {0, 0}}};
        case RoundedMoments::six:
            return {
                {{0, 2, 4},
                 transposed({{2.5, -1.87499864450, 1.26583039016},
                             {-10, 4.20757543111, -1.47644882902},
                             {8, -1.83257678661, 0.71061660238}}),
                 {0.5, 0.5, 0.5}},
                {{1, 3, 5},
                 transposed(
                     {{4, 9, -0.57759806484}, {-4, -24, 4.61936647543}, {0, 16, -3.07953906655}}),
                 {0, 0, 0.018888946}}};
        case RoundedMoments::eight: break;
    }
    return {{{0, 2, 4, 6},
             {{3.48044635732474, -27.5760737514826, 55.1267384344761, -31.5311110403183},
              {1.26797185782836, -0.928755808743913, -2.07520453231032, 1.23598848322588},
              {-2.1671560004294, 6.17950199592966, -0.276515571579297, -4.23583042392097},
              {0.974332879165755, -0.443426830933027, -0.360491648368785, 0.310149466050223}},
             {0.5, 0.5, 0.5, 0.5}},
            {{1, 3, 5, 7},
             {{0.280504133158527, -0.757633844606942, 0.392179589334688, -0.887531871812237},
              {-2.01362265883247, 0.221551373038988, -1.06107954265125, 2.83887201588367},
              {-7.31010494985321, 13.9855979699139, -0.114305766176437, -7.4361899359832},
              {-15.8954215629556, 79.6186327084103, -127.457278992502, 63.7349456687829}},
             {0.972481993925964, 1, 0.999179192513328, 0.991778293073131}}};
}

// By Gauss, with the largest pivot.
Numbers solve(Matrix m, Numbers right)
{
    const std::size_t n = right.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t largest = k;
        for (std::size_t i = k + 1; i < n; ++i) {
            if (std::abs(m[i][k]) > std::abs(m[largest][k])) largest = i;
        }
        std::swap(m[k], m[largest]);
        std::swap(right[k], right[largest]);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const double factor = m[i][k] / m[k][k];
            for (std::size_t j = k; j < n; ++j) m[i][j] -= factor * m[k][j];
            right[i] -= factor * right[k];
        }
    }
    for (std::size_t k = 0; k < n; ++k) right[k] /= m[k][k];
    return right;
}

}  // namespace

Numbers to_unit_range(const Numbers& b, RoundedMoments kind)
{
    Numbers numbers = b;
    for (const Map& map : maps_of(kind)) {
        for (std::size_t i = 0; i < map.picked.size(); ++i) {
            double sum = map.offsets[i];
            for (std::size_t j = 0; j < map.picked.size(); ++j) {
                sum += map.rows[i][j] * b[map.picked[j]];
            }
            numbers[map.picked[i]] = sum;
        }
    }
    return numbers;
}

Numbers from_unit_range(const Numbers& numbers, RoundedMoments kind)
{
    Numbers b = numbers;
    for (const Map& map : maps_of(kind)) {
        Numbers right;
        for (std::size_t i = 0; i < map.picked.size(); ++i) {
            right.push_back(numbers[map.picked[i]] - map.offsets[i]);
        }
        const Numbers solved = solve(map.rows, right);
        for (std::size_t i = 0; i < map.picked.size(); ++i) b[map.picked[i]] = solved[i];
    }
    return b;
}

double rounded_to_16_bits(double x)
{
    return std::round(std::clamp(x, 0.0, 1.0) * 65535) / 65535;
}

}  // namespace sheer::reference
