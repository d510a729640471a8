// What shadows must not depend on, and what they cost.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <sheer/error.h>
#include <sheer/sheer.h>

#include "same_bits.h"
#include "shadows/sheets.h"

namespace sheer {

using test::exact_shadows, test::stochastic_shadows;

TEST(ShadowBits, SameBitsOnEveryLevelAndAnyNumberOfThreads)
{
    View view;
    view.width = 120;
    view.height = 90;
    view.samples = 4;
    for (const char* source : {"builtin:cloth", "builtin:hair?strands=2000", "builtin:motor"}) {
        const Scene scene = load(source);
        std::vector<Shadows> kinds = {stochastic_shadows(1, 3), stochastic_shadows(16, 1)};
        kinds.push_back(stochastic_shadows(4, 2));
        kinds.back().correction = true;
        kinds.push_back(stochastic_shadows(64, 1));
        kinds.back().footprint = Footprint::random;
        kinds.push_back(stochastic_shadows(32, 1));
        kinds.back().masks = ShadowMasks::tracked;
        kinds.push_back(stochastic_shadows(4, 2));
        kinds.back().masks = ShadowMasks::systematic;
        kinds.back().correction = true;
        kinds.push_back(stochastic_shadows(4, 2));
        kinds.back().kind = ShadowKind::moment;
        if (std::string(source) == "builtin:cloth") kinds.push_back(exact_shadows());
        for (const Shadows& shadows : kinds) {
            view.shadows = shadows;
            expect_same_bits(scene, view, "exact", source);
        }
    }
}

TEST(ShadowBits, TheOrderOfObjectsIsNotSeen)
{
    Scene scene = load("builtin:motor");
    View view;
    view.width = view.height = 90;
    view.shadows = stochastic_shadows(8, 1);
    const Image expected = render(scene, view, {}).image;
    std::reverse(scene.objects.begin(), scene.objects.end());
    EXPECT_EQ(render(scene, view, {}).image.pixels, expected.pixels);
}

TEST(ShadowBits, TheirTimeIsOneOfThePasses)
{
    const Scene scene = test::sheets_over_floor({0.5f});
    const auto passes =
        render(scene, test::floor_view(stochastic_shadows(8, 1)), {}).stats.ms_passes;
    ASSERT_FALSE(passes.empty());
    EXPECT_EQ(passes.front().name, "shadow");
    const auto without = render(scene, test::floor_view({}), {}).stats.ms_passes;
    EXPECT_EQ(without.front().name, "fragments");
}

TEST(ShadowBits, MemoryLimitsCountTheMaps)
{
    const Scene scene = test::sheets_over_floor({0.5f});
    Shadows shadows = stochastic_shadows(64, 1);
    shadows.size = 4096;  // 4 GiB
    Options options;
    options.memory_limit = std::uint64_t{1} << 30;
    EXPECT_THROW(render(scene, test::floor_view(shadows), options), Error);
}

}  // namespace sheer
