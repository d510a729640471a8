// The same picture, bit for bit, whatever the number of threads and the vector instructions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include <sheer/sheer.h>

#include "methods/method.h"
#include "same_bits.h"

namespace sheer {

// The order of submission is not seen: identities break ties.
TEST(Bits, AnyOrderOfSubmission)
{
    View view;
    view.width = view.height = 120;
    std::mt19937 random(11);
    for (const char* source : {"builtin:quads", "builtin:motor", "builtin:layers?n=9&depth=1,2,2,2",
                               SHEER_SOURCE_DIR "/scenes/tea_table.glb"}) {
        Scene scene = load(source);
        const Image expected = render(scene, view, {}).image;
        for (int round = 0; round < 3; ++round) {
            std::shuffle(scene.objects.begin(), scene.objects.end(), random);
            EXPECT_EQ(render(scene, view, {}).image.pixels, expected.pixels) << source;
        }
    }
}

// Neither is it by any method that says so, with its standard values.
TEST(Bits, AnyOrderOfSubmissionToEveryMethodThatTakesIt)
{
    View view;
    view.width = view.height = 90;
    std::mt19937 random(12);
    std::size_t methods = 0;
    for (const MethodRow& row : method_table()) {
        if (choose_method(row.id).traits().any_order != Agreement::bits) continue;
        ++methods;
        Options options;
        options.method = row.id;
        for (const char* source : {"builtin:quads", SHEER_SOURCE_DIR "/scenes/tea_table.glb"}) {
            Scene scene = load(source);
            const Image expected = render(scene, view, options).image;
            for (int round = 0; round < 2; ++round) {
                std::shuffle(scene.objects.begin(), scene.objects.end(), random);
                EXPECT_EQ(render(scene, view, options).image.pixels, expected.pixels)
                    << row.id << ", " << source;
            }
        }
    }
    EXPECT_GT(methods, 10u);
}

// Standard values; the methods' own tests have the others.
TEST(Bits, EveryMethodWithAnyNumberOfThreads)
{
    const Scene scene = load(SHEER_SOURCE_DIR "/scenes/tea_table.glb");
    View view;
    view.width = 110;
    view.height = 70;
    for (const MethodRow& row : method_table()) {
        Options options;
        options.method = row.id;
        options.threads = 1;
        const Image expected = render(scene, view, options).image;
        for (const int threads : {2, 7}) {
            options.threads = threads;
            EXPECT_EQ(render(scene, view, options).image.pixels, expected.pixels)
                << row.id << ", " << threads << " threads";
        }
    }
}

TEST(Bits, EveryLevelAndAnyNumberOfThreads)
{
    View view;
    view.width = 150;
    view.height = 110;
    for (const char* method : {"exact", "blend"}) {
        for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
            view.samples = samples;
            expect_same_bits("builtin:quads", view, method);
        }
        view.samples = 8;
        view.filter = Filter::gaussian;
        expect_same_bits("builtin:quads", view, method);
        view.filter = Filter::box;
        view.positions = SamplePositions::center;
        expect_same_bits("builtin:quads", view, method);
        view.positions = SamplePositions::standard;
        expect_same_bits("builtin:motor", view, method);
        expect_same_bits(SHEER_SOURCE_DIR "/scenes/tea_table.glb", view, method);
    }
}

// Textures, reflections, ribbons, glass.
TEST(Bits, EveryLevelShadesAlike)
{
    View view;
    view.width = 150;
    view.height = 110;
    for (const char* source : {"builtin:cloth", "builtin:foliage", "builtin:hair?strands=2000",
                               "builtin:fence", "builtin:burning-house"}) {
        expect_same_bits(source, view, "exact");
    }
    const char* folder = std::getenv("SHEER_SCENES");
    if (folder == nullptr) GTEST_SKIP() << "SHEER_SCENES names no folder with real files";
    for (const char* file :
         {"ToyCar/ToyCar.glb", "StainedGlassLamp/StainedGlassLamp.glb",
          "TransmissionTest/TransmissionTest.glb", "LightsPunctualLamp/LightsPunctualLamp.glb"}) {
        expect_same_bits(std::string(folder) + "/gltf/" + file, view, "exact");
    }
}

}  // namespace sheer
