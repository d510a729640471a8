// Every row of the table of methods, with every combination of its parameters' values.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "methods/method.h"
#include "support/text.h"

namespace sheer {

// Of a range: both ends and the standard value, if it is a number.
inline std::vector<std::string> values_of(const Parameter& parameter)
{
    std::set<std::string> values;
    for (const auto& choice : split(parameter.values, '|')) {
        const std::size_t dots = choice.find("..");
        values.emplace(choice.substr(0, dots));
        if (dots == std::string::npos) continue;
        values.emplace(choice.substr(dots + 2));
        values.emplace(parameter.standard);
    }
    return {values.begin(), values.end()};
}

inline bool is_refused(const ChosenMethod& method, int samples)
{
    return method.row->refusal != nullptr && !method.row->refusal(method, samples).empty();
}

// All combinations that some number of samples allows.
inline std::vector<ChosenMethod> every_combination(const MethodRow& row)
{
    std::vector<std::string> texts = {row.id};
    for (const Parameter& parameter : row.parameters) {
        std::vector<std::string> longer;
        for (const std::string& text : texts) {
            for (const std::string& value : values_of(parameter)) {
                longer.push_back(text + ":" + parameter.name + "=" + value);
            }
        }
        texts = std::move(longer);
    }
    std::vector<ChosenMethod> choices;
    for (const std::string& text : texts) {
        ChosenMethod choice = choose_method(text);
        if (!is_refused(choice, 1)) choices.push_back(std::move(choice));
    }
    return choices;
}

// Pairs of parameters with their values.
using Pairs = std::set<std::tuple<std::size_t, std::size_t, std::string, std::string>>;

inline Pairs pairs_of(const ChosenMethod& choice)
{
    Pairs pairs;
    for (std::size_t i = 0; i < choice.values.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            pairs.emplace(i, j, choice.values[i], choice.values[j]);
        }
    }
    return pairs;
}

// Every combination where there are few; else as many of them as have every pair of two parameters'
// values, each time the one that has most of those missing.
inline std::vector<ChosenMethod> every_choice(const MethodRow& row)
{
    constexpr std::size_t kFew = 16;
    const std::vector<ChosenMethod> all = every_combination(row);
    if (all.size() <= kFew) return all;
    std::vector<Pairs> pairs;
    Pairs missing;
    for (const ChosenMethod& choice : all) {
        pairs.push_back(pairs_of(choice));
        missing.insert(pairs.back().begin(), pairs.back().end());
    }
    const auto gain = [&](const Pairs& some) {
        return std::count_if(some.begin(), some.end(),
                             [&](const auto& pair) { return missing.count(pair) != 0; });
    };
    std::vector<ChosenMethod> choices;
    while (!missing.empty()) {
        const auto best =
            std::max_element(pairs.begin(), pairs.end(),
                             [&](const Pairs& a, const Pairs& b) { return gain(a) < gain(b); });
        choices.push_back(all[static_cast<std::size_t>(best - pairs.begin())]);
        for (const auto& pair : *best) missing.erase(pair);
    }
    return choices;
}

inline const std::vector<ChosenMethod>& every_method()
{
    static const std::vector<ChosenMethod> all = [] {
        std::vector<ChosenMethod> made;
        for (const MethodRow& row : method_table()) {
            for (const ChosenMethod& choice : every_choice(row)) made.push_back(choice);
        }
        // What pairs of values do not meet: as many layers as bits, where order does not matter.
        for (const char* text : {"slab", "slab:layers=4:bits=4", "slab:layers=8:bits=8",
                                 "slab:layers=4:bits=4:depth-based=off", "mlcb",
                                 "mlcb:layers=4:bits=4:correction=off"}) {
            made.push_back(choose_method(text));
        }
        return made;
    }();
    return all;
}

inline std::string name_of(const ChosenMethod& method)
{
    const std::string parameters = method.parameters_text();
    return method.row->id + (parameters.empty() ? "" : ":" + parameters);
}

}  // namespace sheer
