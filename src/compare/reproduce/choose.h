// Chances of masks.
#pragma once

namespace sheer {

// In how many ways k of n can be chosen; 0 where k is not among 0 to n.
inline double choose(int n, int k)
{
    if (k < 0 || k > n) return 0;
    double product = 1;
    for (int i = 0; i < k; ++i) product *= static_cast<double>(n - i) / (i + 1);
    return product;
}

}  // namespace sheer
