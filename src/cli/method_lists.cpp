// What is in a list that nobody wrote.
#include "cli/method_lists.h"

#include "cli/view_options.h"
#include "methods/method.h"
#include "support/text.h"

namespace sheer {

namespace {

std::vector<std::string> all_methods(MethodsFor purpose)
{
    std::vector<std::string> methods;
    for (const MethodRow& row : method_table()) {
        if (purpose == MethodsFor::bench || !row.bench_only) methods.emplace_back(row.id);
    }
    return methods;
}

std::vector<std::string> parse_methods(const std::string& text, MethodsFor purpose)
{
    std::vector<std::string> methods;
    for (const std::string& part : split(text, ',')) {
        if (part != "all") {
            methods.push_back(part);
            continue;
        }
        for (std::string& method : all_methods(purpose)) methods.push_back(std::move(method));
    }
    return methods;
}

}  // namespace

std::span<const std::string> usual_methods()
{
    static const std::vector<std::string> kUsual = {
        // the answer, and what engines ship
        "exact", "blend", "sorted-blend",
        // random, right on average
        "stochastic", "stochastic:depth-based=on:correction=on", "stratified-stochastic",
        // a few layers
        "hybrid", "mlab", "adaptive",
        // sums
        "wboit", "moment"};
    return kUsual;
}

void add_methods_list(CLI::App& command, std::vector<std::string>& methods, MethodsFor purpose)
{
    std::string otherwise = "all";
    if (purpose == MethodsFor::bench) {
        methods = all_methods(purpose);
    } else {
        methods.assign(usual_methods().begin(), usual_methods().end());
        otherwise = std::to_string(methods.size()) + " usual ones, see below";
    }
    add_value(command, "--methods", "ID[:NAME=VALUE]...,...",
              "Methods, with commas; all: the whole table\n(" + otherwise + ")",
              [&methods, purpose](auto&, auto& text) { methods = parse_methods(text, purpose); });
}

}  // namespace sheer
