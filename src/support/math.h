// Elementary functions that give the same bits with every compiler and instruction set.
//
// The C library's differ between versions, and between machines with and without fused
// multiply-add. Whatever a picture depends on (cameras, built-in scenes, filters) uses these.
#pragma once

namespace sheer {

// All are within 3 units in the last place over the ranges named, and follow C's rules for
// infinities, signed zeros and NaN.
double own_exp(double x);   // any x
double own_log(double x);   // any x; NaN below 0
double own_log2(double x);  // the same; whole for powers of two
double own_sin(double x);   // |x| <= 2^20; beyond NaN, since the reduction by pi / 2 ends there
double own_cos(double x);   // as own_sin
double own_tan(double x);   // as own_sin
double own_atan2(double y, double x);

// base^exponent for base >= 0 (else NaN). exp(exponent * log(base)): the relative error grows with
// the size of that product, by less than 4e-16 for each unit of it.
double own_pow(double base, double exponent);

}  // namespace sheer
