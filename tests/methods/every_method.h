// Every row of the table of methods, with every combination of its parameters' values.
#pragma once

#include <algorithm>
#include <set>
#include <string>
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

// Numbers of the pairs of two parameters' values that a choice has; `lists` are all values of each.
inline std::vector<std::size_t> pairs_of(const std::vector<std::vector<std::string>>& lists,
                                         const ChosenMethod& choice)
{
    std::vector<std::size_t> numbers, places;
    std::size_t before = 0;  // pairs of the parameters that were looked at
    for (std::size_t i = 0; i < lists.size(); ++i) {
        const auto found = std::find(lists[i].begin(), lists[i].end(), choice.values[i]);
        places.push_back(static_cast<std::size_t>(found - lists[i].begin()));
        for (std::size_t j = 0; j < i; ++j) {
            numbers.push_back(before + places[i] * lists[j].size() + places[j]);
            before += lists[i].size() * lists[j].size();
        }
    }
    return numbers;
}

// Every combination where there are few; else as many of them as have every pair of two parameters'
// values, each time the one that has most of those missing.
inline std::vector<ChosenMethod> every_choice(const MethodRow& row)
{
    constexpr std::size_t kFew = 16;
    const std::vector<ChosenMethod> all = every_combination(row);
    if (all.size() <= kFew) return all;
    std::vector<std::vector<std::string>> lists;
    for (const Parameter& parameter : row.parameters) lists.push_back(values_of(parameter));
    std::vector<std::vector<std::size_t>> pairs;
    std::vector<char> missing;
    for (const ChosenMethod& choice : all) {
        pairs.push_back(pairs_of(lists, choice));
        for (const std::size_t pair : pairs.back()) {
            missing.resize(std::max(missing.size(), pair + 1));
            missing[pair] = 1;
        }
    }
    const auto gain = [&](const std::vector<std::size_t>& some) {
        return std::count_if(some.begin(), some.end(),
                             [&](std::size_t p) { return missing[p] != 0; });
    };
    std::vector<ChosenMethod> choices;
    while (std::count(missing.begin(), missing.end(), 1) > 0) {
        const auto best =
            std::max_element(pairs.begin(), pairs.end(),
                             [&](const auto& a, const auto& b) { return gain(a) < gain(b); });
        choices.push_back(all[static_cast<std::size_t>(best - pairs.begin())]);
        for (const std::size_t pair : *best) missing[pair] = 0;
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
