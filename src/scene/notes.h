// What a file holds and is not drawn: one line for each kind of thing, with how many there are.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace sheer {

class Notes {
public:
    // "<things>: <count>, <consequence>". Counts of the same two texts add up.
    void add(const std::string& things, const std::string& consequence, std::size_t count = 1);
    std::vector<std::string> lines() const;

private:
    std::map<std::pair<std::string, std::string>, std::size_t> counts_;
};

}  // namespace sheer
