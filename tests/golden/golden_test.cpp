// Pictures whose bits are known. Every compiler, instruction set and number of threads gives them.
//
// hashes.txt holds a line for each; a PNG beside it is for people, but for those that every method
// has, of which docs/gallery.md has pictures. Where a hash differs the picture
// made is written to out/golden, with the command that makes it again. SHEER_REMAKE_GOLDEN=1 makes
// all anew: changed hashes come in a commit of their own, with the error against the oracle before
// and after.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "image/write_image.h"
#include "methods/method.h"

namespace sheer {

namespace {

struct Golden {
    std::string name, scene, method;
    int samples;
    Filter filter;
    bool has_picture = true;
};

const Golden kGolden[] = {
    {"layers-exact-8", "builtin:layers", "exact", 8, Filter::box},
    {"quads-exact-1", "builtin:quads", "exact", 1, Filter::box},
    {"quads-exact-8", "builtin:quads", "exact", 8, Filter::box},
    {"quads-blend-64", "builtin:quads", "blend", 64, Filter::box},
    {"motor-exact-8", "builtin:motor", "exact", 8, Filter::box},
    {"motor-blend-8", "builtin:motor", "blend", 8, Filter::box},
    {"motor-exact-16-gaussian", "builtin:motor", "exact", 16, Filter::gaussian},
    {"tea-table-exact-8", SHEER_SOURCE_DIR "/scenes/tea_table.glb", "exact", 8, Filter::box},
    {"cloth-exact-4", "builtin:cloth", "exact", 4, Filter::box},
    {"burning-house-exact-4", "builtin:burning-house", "exact", 4, Filter::box},
    {"tea-table-blend-4", SHEER_SOURCE_DIR "/scenes/tea_table.glb", "blend", 4, Filter::gaussian},
};

// Those, and one of every method with its standard values.
std::vector<Golden> all_golden()
{
    std::vector<Golden> all(std::begin(kGolden), std::end(kGolden));
    for (const MethodRow& row : method_table()) {
        all.push_back({std::string("method-") + row.id, SHEER_SOURCE_DIR "/scenes/tea_table.glb",
                       row.id, 4, Filter::box, false});
    }
    return all;
}

const std::filesystem::path kFolder = SHEER_SOURCE_DIR "/tests/golden";

// FNV-1a, 64 bits, over the pixels' bytes.
std::string hash_of(const Image& image)
{
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const auto& pixel : image.pixels) {
        for (const float c : pixel) {
            std::uint32_t bits = 0;
            std::memcpy(&bits, &c, sizeof bits);
            for (int byte = 0; byte < 4; ++byte) {
                hash = (hash ^ (bits >> (8 * byte) & 255)) * 0x100000001b3ull;
            }
        }
    }
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

Image render_golden(const Golden& golden)
{
    View view;
    view.width = view.height = 160;
    view.samples = golden.samples;
    view.filter = golden.filter;
    Options options;
    options.method = golden.method;
    return render(load(golden.scene), view, options).image;
}

std::map<std::string, std::string> read_hashes()
{
    std::map<std::string, std::string> hashes;
    std::ifstream file(kFolder / "hashes.txt");
    for (std::string name, hash; file >> name >> hash;) hashes[name] = hash;
    return hashes;
}

}  // namespace

TEST(Golden, PicturesHaveTheirBits)
{
    if (std::getenv("SHEER_REMAKE_GOLDEN") != nullptr) {
        std::ofstream file(kFolder / "hashes.txt");
        for (const Golden& golden : all_golden()) {
            const Image image = render_golden(golden);
            file << golden.name << ' ' << hash_of(image) << '\n';
            if (!golden.has_picture) continue;
            write_image((kFolder / (golden.name + ".png")).string(), image);
        }
        return;
    }
    const auto hashes = read_hashes();
    for (const Golden& golden : all_golden()) {
        const Image image = render_golden(golden);
        const auto expected = hashes.find(golden.name);
        ASSERT_NE(expected, hashes.end()) << golden.name;
        if (hash_of(image) == expected->second) continue;
        const std::filesystem::path out = SHEER_SOURCE_DIR "/out/golden";
        std::filesystem::create_directories(out);
        const std::string picture = (out / (golden.name + ".exr")).string();
        write_image(picture, image);
        ADD_FAILURE() << golden.name << ": " << hash_of(image) << ", not " << expected->second
                      << "; see " << picture << ", made by\n  sheer render '" << golden.scene
                      << "' --method " << golden.method << " --samples " << golden.samples
                      << " --filter " << (golden.filter == Filter::box ? "box" : "gaussian")
                      << " --size 160x160 -o " << picture;
    }
}

}  // namespace sheer
