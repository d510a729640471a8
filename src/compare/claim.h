// Numbers that are printed somewhere beside ours.
#pragma once

#include <string>
#include <vector>

namespace sheer {

// One number of a paper's beside ours, which agrees within `band`.
struct Claim {
    std::string what;
    std::string paper;  // as printed: "0.17"
    double ours;        // NaN, which agrees with nothing, if it could not be had
    double band;
    std::string otherwise;  // what is known of why, if it does not agree

    double difference() const;  // ours less the paper's
    bool agrees() const;
};

struct Claims {
    std::string band;  // what it is and why
    std::vector<Claim> all;
};

// What a number that is printed with so many digits may be off: half a unit of the last.
double half_unit(const std::string& as_in_the_paper);

}  // namespace sheer
