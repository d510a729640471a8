// Random numbers one after the other, for what is made one piece after the other.
#pragma once

#include <cmath>

#include "scene/builtin/shapes.h"
#include "support/math.h"
#include "support/random.h"

namespace sheer {

// A sequence for each (kind, item): a strand or a leaf stays the same whatever the number of
// others. Where two draws meet in one expression they stand in braces, which fix their order.
class Draws {
public:
    Draws(std::uint32_t kind, std::uint64_t item)
        : random_{(static_cast<std::uint64_t>(kind) << 40) ^ item}
    {
    }

    double unit() { return random_.uniform(next_++); }  // in [0, 1)
    double between(double low, double high) { return low + unit() * (high - low); }
    double angle() { return 2 * shapes::kPi * unit(); }
    // The mean of three: most draws fall in the middle of (-1, 1).
    double bell()
    {
        double sum = unit();
        sum += unit();
        sum += unit();
        return sum / 1.5 - 1;
    }
    // The product of two: most draws fall near 0.
    double small()
    {
        const double first = unit();
        return first * unit();
    }
    shapes::Vec direction()  // evenly over the unit sphere
    {
        const double y = between(-1, 1), phi = angle(), r = std::sqrt(1 - y * y);
        return {r * own_cos(phi), y, r * own_sin(phi)};
    }
    std::uint32_t below(std::uint32_t count)
    {
        return static_cast<std::uint32_t>((random_.bits(next_++) >> 32) * count >> 32);
    }

private:
    CounterRandom random_;
    std::uint64_t next_ = 0;
};

}  // namespace sheer
