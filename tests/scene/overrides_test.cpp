// Which objects a pattern names, and what changes of a scene and what does not.
#include <gtest/gtest.h>

#include <sheer/sheer.h>

namespace sheer::test {
namespace {

// An object called `object`, of a mesh called `mesh`, of a material called `material`.
void add(Scene& scene, const std::string& object, const std::string& mesh,
         const std::string& material)
{
    const auto number = static_cast<std::uint32_t>(scene.objects.size());
    scene.materials.emplace_back().name = material;
    scene.meshes.emplace_back().name = mesh;
    scene.meshes.back().material = number;
    scene.objects.emplace_back().name = object;
    scene.objects.back().mesh = scene.objects.back().id = number;
}

bool is_match(const std::string& pattern, const std::string& name)
{
    Scene scene;
    add(scene, name, name, name);
    const std::size_t count = set_opacity(scene, pattern, 0.5f);
    EXPECT_EQ(scene.objects[0].opacity, count == 1 ? 0.5f : 1.0f);
    return count == 1;
}

TEST(SetOpacity, MatchesNamesFromEndToEnd)
{
    EXPECT_TRUE(is_match("door", "door"));
    EXPECT_FALSE(is_match("door", "doors"));
    EXPECT_FALSE(is_match("door", "a door"));
    EXPECT_FALSE(is_match("door", "Door"));
    EXPECT_FALSE(is_match("door", ""));
    EXPECT_FALSE(is_match("", "door"));
    EXPECT_TRUE(is_match("", ""));
}

TEST(SetOpacity, StarsStandForAnyText)
{
    EXPECT_TRUE(is_match("*", ""));
    EXPECT_TRUE(is_match("*", "door"));
    EXPECT_TRUE(is_match("do*", "do"));
    EXPECT_TRUE(is_match("*or", "door"));
    EXPECT_TRUE(is_match("d*r", "door"));
    EXPECT_TRUE(is_match("**d**r**", "door"));
    EXPECT_FALSE(is_match("d*x", "door"));
    // The first places that fit are not the right ones.
    EXPECT_TRUE(is_match("*ab", "aab abab"));
    EXPECT_TRUE(is_match("a*b*c", "abbc bac"));
    EXPECT_FALSE(is_match("a*b*cd", "abc bcc"));
    // Tried one way after another, this would take ages.
    std::string stars;
    for (int i = 0; i < 30; ++i) stars += "*a";
    EXPECT_FALSE(is_match(stars + "b", std::string(1000, 'a')));
}

TEST(SetOpacity, QuestionMarksStandForOneCharacter)
{
    EXPECT_TRUE(is_match("d??r", "door"));
    EXPECT_FALSE(is_match("d???r", "door"));
    EXPECT_FALSE(is_match("?", ""));
    EXPECT_TRUE(is_match("?*", "door"));
    EXPECT_TRUE(is_match("T?r", "T\u00fcr"));
    EXPECT_TRUE(is_match("?", "\u20ac"));
    EXPECT_FALSE(is_match("??", "\u20ac"));
    EXPECT_TRUE(is_match("*?", "\xff"));  // no UTF-8
}

TEST(SetOpacity, AnyOfThreeNamesWillDo)
{
    Scene scene;
    add(scene, "left", "door", "wood");
    add(scene, "right", "door", "glass");
    add(scene, "wood", "chair", "steel");
    EXPECT_EQ(set_opacity(scene, "door", 0.5f), 2u);
    EXPECT_EQ(set_opacity(scene, "wood", 0.25f), 2u);
    EXPECT_EQ(set_opacity(scene, "stone", 0), 0u);
    EXPECT_EQ(scene.objects[0].opacity, 0.25f);
    EXPECT_EQ(scene.objects[1].opacity, 0.5f);
    EXPECT_EQ(scene.objects[2].opacity, 0.25f);
    EXPECT_EQ(set_opacity(scene, "*", 1), 3u);
    for (const Object& object : scene.objects) EXPECT_EQ(object.opacity, 1.0f);
}

TEST(SetOpacity, GroupsNameWhatIsBelowThem)
{
    Scene scene;
    add(scene, "a", "", "");
    add(scene, "b", "", "");
    add(scene, "c", "", "");
    scene.groups = {{"machine", -1}, {"arm", 0}, {"hand", 1}, {"foot", 0}};
    scene.objects[0].group = 2;
    scene.objects[1].group = 3;
    const auto matching = [&](const char* pattern) { return set_opacity(scene, pattern, 0.5f); };
    EXPECT_EQ(matching("machine"), 2u);
    EXPECT_EQ(matching("arm"), 1u);
    EXPECT_EQ(matching("foot"), 1u);
    EXPECT_EQ(matching("?a*"), 2u);  // hand and machine
    EXPECT_EQ(matching("c"), 1u);
    EXPECT_EQ(matching("leg"), 0u);
}

TEST(MaskAsBlend, ChangesMasksAlone)
{
    Scene scene;
    for (const AlphaMode mode : {AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend}) {
        scene.materials.emplace_back().alpha_mode = mode;
    }
    mask_as_blend(scene);
    EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(scene.materials[1].alpha_mode, AlphaMode::blend);
    EXPECT_EQ(scene.materials[2].alpha_mode, AlphaMode::blend);
}

}  // namespace
}  // namespace sheer::test
