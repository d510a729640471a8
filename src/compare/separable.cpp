// Loops over a row's pixels inside of those over the weights: the compiler makes vectors of them,
// and no sum changes its order.
#include "compare/separable.h"

namespace sheer {

namespace {

void add_weighted(std::span<const double> from, double weight, std::span<double> to)
{
    for (std::size_t x = 0; x < to.size(); ++x) to[x] += weight * from[x];
}

}  // namespace

Rows filter_along_x(const Rows& rows, std::span<const double> weights)
{
    Rows result(rows.width() + 1 - weights.size(), rows.count());
    for (std::size_t y = 0; y < rows.count(); ++y) {
        for (std::size_t i = 0; i < weights.size(); ++i) {
            add_weighted(rows[y].subspan(i, result.width()), weights[i], result[y]);
        }
    }
    return result;
}

Rows filter_along_y(const Rows& rows, std::span<const double> weights)
{
    Rows result(rows.width(), rows.count() + 1 - weights.size());
    for (std::size_t y = 0; y < result.count(); ++y) {
        for (std::size_t i = 0; i < weights.size(); ++i) {
            add_weighted(rows[y + i], weights[i], result[y]);
        }
    }
    return result;
}

}  // namespace sheer
