// Choosing a method and its parameters' values by text.
#include <gtest/gtest.h>

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
              "method: there is no method 'exakt'; there are blend, sorted-blend, exact, "
              "depth-peeling, dual-depth-peeling, bucket-peeling, stochastic, "
              "stratified-stochastic, k-buffer, hybrid, mlab, z3, adaptive, deep-shadow-map, "
              "weighted-average, wboit, phenomenological");
    EXPECT_EQ(message("exact:k=3"), "method: exact has no parameter 'k'; it has none");
    EXPECT_EQ(message("exact:k"), "method: 'k' is not NAME=VALUE");
}

}  // namespace sheer
