// The methods whose texts the tests run.
#pragma once

#include <string>
#include <vector>

namespace sheer::test {

// Every text's every branch.
inline const std::vector<std::string> kMethodsWithTexts = {
    "blend",
    "exact",
    "weighted-average",
    "wboit:weight=eq7",
    "wboit:weight=eq8",
    "wboit:weight=eq9",
    "wboit:weight=eq10",
    "wboit:weight=uniform",
    "stochastic:masks=stratified:seed-by=primitive",
    "stochastic:masks=stratified:seed-by=object",
    "stochastic:masks=stratified:seed-by=depth",
    "stochastic:masks=stratified:seed-by=object-alone",
    "stochastic:masks=naive:seed-by=primitive",
    "stochastic:round=tile-dither",
    "stochastic:correction=on",
    "stochastic:depth-based=on",
    "stochastic:depth-based=on:correction=on",
    "stratified-stochastic",
    "stratified-stochastic:tracking=off:sequence=vegdahl",
    "stratified-stochastic:dither=morton:sequence=sobol",
    "stratified-stochastic:sort=off:sequence=random",
    "stratified-stochastic:sequence=systematic",
    "stratified-stochastic:compaction=off:sort=off:dither=none",
    "mlab",
    "mlab:layers=1",
    "z3",
    "z3:layers=1",
    "z3:layers=3",
    "k-buffer",
    "k-buffer:layers=1",
    "k-buffer:layers=3:merge=nearest-two",
    "k-buffer:layers=2:merge=discard",
    "hybrid",
    "hybrid:layers=1:tail=total",
    "hybrid:layers=2:tail=none",
    "adaptive",
    "adaptive:nodes=1",
    "adaptive:nodes=3",
    "depth-peeling",
    "depth-peeling:peels=3",
    "dual-depth-peeling",
    "dual-depth-peeling:peels=2",
    "bucket-peeling",
    "bucket-peeling:buckets=1",
    "bucket-peeling:buckets=3:peels=3",
    "bucket-peeling:buckets=5:borders=adaptive",
    "bucket-peeling:buckets=4:borders=adaptive:peels=4096",
    "phenomenological",
    "deep-shadow-map",
    "deep-shadow-map:error=0:correction=off",
    "deep-shadow-map:error=0.05",
};

}  // namespace sheer::test
