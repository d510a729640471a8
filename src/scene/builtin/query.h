// The "key=value&key=value" behind a built-in scene's name.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <sheer/scene.h>

namespace sheer {

struct Range {
    double least, most;  // both allowed
};

class Query {
public:
    // `known` is a query itself, of all keys that the scene has; any other is an error.
    Query(const std::string& scene, const std::string& text, const std::string& known);

    bool has(const std::string& key) const;

    // The value of a key, or `otherwise` where it isn't given. Throws Error with Fault::input that
    // names the scene, the key and what is wrong with the value.
    double number(const std::string& key, double otherwise, Range range) const;
    std::int64_t integer(const std::string& key, std::int64_t otherwise, Range range) const;
    // "0.1,0.2,0.3"
    std::vector<double> numbers(const std::string& key, std::vector<double> otherwise,
                                Range range) const;
    // "1,0,0;0,1,0"
    std::vector<Float3> colors(const std::string& key, std::vector<Float3> otherwise,
                               Range range) const;
    // Which of `choices`; the first where the key isn't given.
    std::size_t choice(const std::string& key, std::span<const char* const> choices) const;

private:
    struct Pair {
        std::string key, value;
    };

    [[noreturn]] void fail(const std::string& key, const std::string& fault) const;
    std::vector<Pair> parse(const std::string& text) const;
    const std::string* find(const std::string& key) const;
    double parse_number(const std::string& key, const std::string& text, Range range) const;

    std::string scene_;
    std::vector<Pair> pairs_;
};

}  // namespace sheer
