// Changes to a scene that was read: what of it is to be seen through.
#include <string_view>
#include <vector>

#include <sheer/sheer.h>

namespace sheer {

namespace {

// Takes one character of UTF-8 away; of broken text, at least one byte.
void drop_character(std::string_view& text)
{
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; };
    do text.remove_prefix(1);
    while (!text.empty() && continues(text.front()));
}

// When the text does not fit behind a star, that star takes one character more. Stars before it
// need not be looked at again: what they could take, the last one can, too.
bool matches(std::string_view pattern, std::string_view text)
{
    bool starred = false;
    std::string_view behind_star, left;  // what the last star has not taken
    while (!text.empty()) {
        if (pattern.starts_with('*')) {
            pattern.remove_prefix(1);
            starred = true;
            behind_star = pattern;
            left = text;
        } else if (pattern.starts_with('?')) {
            pattern.remove_prefix(1);
            drop_character(text);
        } else if (!pattern.empty() && pattern.front() == text.front()) {
            pattern.remove_prefix(1);
            text.remove_prefix(1);
        } else if (starred) {
            drop_character(left);
            pattern = behind_star;
            text = left;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*') == std::string_view::npos;
}

}  // namespace

std::size_t set_opacity(Scene& scene, std::string_view pattern, float opacity)
{
    std::size_t count = 0;
    std::vector<char> in_match;  // of the groups
    for (const Group& group : scene.groups) {
        const bool inherits = group.parent >= 0 && in_match[static_cast<std::size_t>(group.parent)];
        in_match.push_back(inherits || matches(pattern, group.name));
    }
    for (Object& object : scene.objects) {
        const bool grouped =
            object.group >= 0 && in_match[static_cast<std::size_t>(object.group)] != 0;
        if (!grouped && !matches(pattern, object.name) &&
            !matches(pattern, mesh_name(scene, object)) &&
            !matches(pattern, material_of(scene, object).name)) {
            continue;
        }
        object.opacity = opacity;
        ++count;
    }
    return count;
}

void mask_as_blend(Scene& scene)
{
    for (Material& material : scene.materials) {
        if (material.alpha_mode == AlphaMode::mask) material.alpha_mode = AlphaMode::blend;
    }
}

}  // namespace sheer
