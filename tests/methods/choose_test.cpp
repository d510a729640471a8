// Choosing a method and its parameters' values by text.
#include <gtest/gtest.h>

#include <string>

#include <sheer/error.h>

#include "methods/method.h"

namespace sheer {

TEST(Methods, ChoosingByText)
{
    EXPECT_STREQ(choose_method("exact").row->id, "exact");
    const auto message = [](const char* text) -> std::string {
        try {
            choose_method(text);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("exakt"),
              "method: there is no method 'exakt' (did you mean 'exact'?); there are blend, "
              "sorted-blend, exact, "
              "alpha-test, alpha-test-then-blend, stochastic-alpha-test, hashed-alpha-test, "
              "alpha-to-coverage, hashed-alpha-to-coverage, screen-door, "
              "depth-peeling, dual-depth-peeling, bucket-peeling, stochastic, "
              "stratified-stochastic, slab, k-buffer, hybrid, mlab, mlcb, z3, adaptive, "
              "deep-shadow-map, weighted-average, wboit, phenomenological, fourier, moment, mboit, "
              "wavelet");
    EXPECT_EQ(message("wboit:wieght=eq8"),
              "method: wboit has no parameter 'wieght' (did you mean 'weight'?); it has weight");
    EXPECT_TRUE(message("stochastic:masks=tabel").ends_with("'tabel' (did you mean 'table'?)"));
    EXPECT_EQ(message("exact:k=3"), "method: exact has no parameter 'k'; it has none");
    for (const std::string value : {"1.5", "-0.1", "nan", "", "0.5x", "ad"}) {
        EXPECT_EQ(message(("moment:overestimation=" + value).c_str()),
                  "method: moment: overestimation is 0.0..1.0|adaptive, not '" + value + "'");
    }
    EXPECT_EQ(choose_method("moment:overestimation=0.5").real("overestimation"), 0.5);
    EXPECT_EQ(message("exact:k"), "method: 'k' is not NAME=VALUE");
}

}  // namespace sheer
