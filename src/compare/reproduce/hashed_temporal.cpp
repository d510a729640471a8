// Thresholds for temporal antialiasing: section 7.2.3 of C. Wyman and M. McGuire, Improved Alpha
// Testing Using Hashed Sampling (IEEE TVCG 25(2), 2019).
#include <string>
#include <utility>
#include <vector>

#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "reference/exponential_average.h"
#include "support/text.h"

namespace sheer {

namespace {

using reference::StrataOrder;

constexpr std::pair<const char*, StrataOrder> kOrders[] = {
    {"linear", StrataOrder::linear},
    {"alternating", StrataOrder::alternating},
    {"van der Corput", StrataOrder::van_der_corput}};
constexpr double kOpacities[] = {0.125, 0.25, 0.5, 0.75, 0.875};

void add_orders(int n, double weight, Table& table)
{
    for (const auto& [name, order] : kOrders) {
        std::vector<Cell> row = {whole(n), number(weight, 2), words(name)};
        for (const double opacity : kOpacities) {
            row.push_back(number(reference::flicker(opacity, n, weight, order), 4));
        }
        table.rows.push_back(std::move(row));
    }
}

}  // namespace

void reproduce_hashed_temporal(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    page.say(
        "Stratified thresholds, frac(chi + j / n) in frame i, in an exponential average of the "
        "frames, each new one with the weight w: how far apart the average's greatest and least "
        "values are in the end, over n frames, on the mean of all chi. Closed forms. The paper "
        "says of the linear order that it flickers, recommends the alternating one, and that van "
        "der Corput's is even better.");
    Table table{"Peak to peak", {"n", "w", "order"}, {}};
    for (const double opacity : kOpacities) table.columns.push_back("opacity " + fixed(opacity, 3));
    for (const int n : {8, 16}) {
        for (const double weight : {0.05, 0.1, 0.2}) add_orders(n, weight, table);
    }
    page.add(table);
    page.write();
}

}  // namespace sheer
