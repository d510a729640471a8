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
    "wboit:weight=range",
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
    "hybrid:layers=2:tail=scaled",
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
    "moment",
    "moment:overestimation=0",
    "moment:overestimation=adaptive:moment-passes=2",
    "moment:format=fp16",
    "moment:format=unorm16:moment-passes=2",
    "moment:format=nlqm",
    "mboit",
    "mboit:moments=6",
    "mboit:moments=8:overestimation=0",
    "mboit:moments=4:format=unorm16",
    "mboit:moments=6:format=unorm16",
    "mboit:moments=8:format=unorm16",
    "mboit:basis=trigonometric",
    "mboit:basis=trigonometric:moments=6:format=unorm16",
    "mboit:basis=trigonometric:moments=8",
    "fourier",
    "fourier:terms=3:window=lanczos",
    "wavelet",
    "wavelet:rank=4",
    "slab:layers=8:bits=8:correction=on",
    "slab:layers=2:bits=64:keep=visible:tail=dropped",
    "slab:layers=5:bits=128:keep=nearest",
    "slab:layers=3:bits=16:depth-based=off",
    "slab:layers=32:bits=32:depth-based=off:correction=on",
    "slab:layers=4:bits=infinity",
    "slab:layers=4:bits=infinity:depth-based=off",
    "slab:layers=1:bits=1:coverage=implicit",
    "slab:layers=4:bits=21:coverage=implicit:correction=on:keep=visible",
    "slab:layers=3:bits=8:coverage=implicit:probability=naive:depth-based=off:keep=nearest",
    "slab:layers=4:bits=10:coverage=implicit:sampling=in-depth:tail=dropped",
    "slab:layers=6:bits=8:coverage=implicit:probability=naive:sampling=in-depth:depth-based=off",
    "mlcb",
    "mlcb:layers=1:bits=8:keep=visible:correction=off",
    "mlcb:layers=4:bits=64:keep=nearest",
    "mlcb:layers=32:bits=32:correction=off",
    "alpha-test",
    "alpha-test-then-blend",
    "alpha-test-then-blend:cutoff=0.5",
    "stochastic-alpha-test",
    "stochastic-alpha-test:threshold=sample",
    "hashed-alpha-test",
    "hashed-alpha-test:variant=isotropic:hash=paper",
    "hashed-alpha-test:variant=eight-corners:hash=lowbias",
    "hashed-alpha-test:hash=xxhash:hash-scale=0.05",
    "hashed-alpha-test:variant=isotropic:without=octaves",
    "hashed-alpha-test:without=octaves",
    "hashed-alpha-test:without=third",
    "hashed-alpha-test:without=uniform",
    "hashed-alpha-test:fade-in=6",
    "hashed-alpha-test:fade-in=0.5:variant=isotropic",
    "alpha-to-coverage",
    "hashed-alpha-to-coverage",
    "hashed-alpha-to-coverage:jitter=sample:variant=isotropic",
    "hashed-alpha-to-coverage:decorrelate=off",
    "screen-door",
    "screen-door:square=2:decorrelate=primitive",
    "screen-door:square=8:decorrelate=off:jitter=off",
};

// Of texts whose optical depths come from the bits of floats, there are no others.
inline bool is_of_floats_only(const std::string& method)
{
    for (const char* id : {"moment", "mboit", "fourier", "wavelet"}) {
        if (method.starts_with(id)) return true;
    }
    return false;
}

// Theirs are long, too: those with other parameters than the standard are run on some lists only.
inline bool is_variant_of_long(const std::string& method)
{
    return is_of_floats_only(method) && method.find(':') != std::string::npos;
}

// Whose stores know the order of depth where the floats of a text alone do not.
inline bool has_precise_depths(const std::string& method)
{
    return method.find("peeling") != std::string::npos;
}

}  // namespace sheer::test
