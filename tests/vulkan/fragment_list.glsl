// Tiles' fragments for a compute shader that runs a text on them, one invocation for each sample of
// each pixel. text_runner.h fills the buffers. Needs prelude.glsl, over.glsl.
layout(local_size_x = 64) in;

layout(constant_id = 0) const int kSamples = 1;
const uint kTileSize = 32;
const uint kTilePixels = 1024;

struct Fragment {
    uint low, high;  // covered samples
    uint primitive, object;
    float red, green, blue, opacity;
    float center, dx, dy, least, most;  // depth at the pixel's centre, and its plane
    uint back_facing;
    float place[9];  // on the surface, and its change along a pixel to the right and down
    float level;     // of its texture, times how oblique it is seen
};

struct Tile {
    uint x, y, key;     // its first pixel in the picture; of the random numbers
    uint orthographic;  // or perspective
    float near, far;    // far 0: none
    float from, scale;  // of warped depth
    float brightest;    // a power of two that no colour is above
};

layout(std430, set = 0, binding = 0) readonly buffer Fragments
{
    Fragment fragments[];
};
layout(std430, set = 0, binding = 1) readonly buffer Lists
{
    uint first[];
};
layout(std430, set = 0, binding = 2) readonly buffer Offsets
{
    vec2 offsets[];
};
layout(std430, set = 0, binding = 3) readonly buffer Tiles
{
    Tile tiles[];
};
// Fragment i in the order of depth at sample s: element s * fragments.length() + i.
layout(std430, set = 0, binding = 4) readonly buffer Sorted
{
    uint sorted[];
};
layout(std430, set = 0, binding = 5) buffer Colors
{
    float colors[];
};  // backdrop, then result
layout(std430, set = 0, binding = 6) writeonly buffer Kept
{
    float kept[];
};

uint pixel = gl_GlobalInvocationID.x / uint(kSamples);
Tile tile = tiles[pixel / kTilePixels];
uint at = gl_GlobalInvocationID.x % uint(kSamples);  // the sample

// The pixel's fragments, in order of arrival, are [list_begin(), list_end()).
uint list_begin()
{
    return first[pixel];
}
uint list_end()
{
    return first[pixel + 1];
}

bool has_sample(uint low, uint high)
{
    return ((at < 32 ? low : high) >> (at & 31) & 1) != 0;
}
bool covers(Fragment f)
{
    return has_sample(f.low, f.high);
}

vec3 color_of(Fragment f)
{
    return vec3(f.red, f.green, f.blue);
}

float clamp_depth(Fragment f, float depth)
{
    depth = select(depth > f.least, depth, f.least);
    return select(depth < f.most, depth, f.most);
}

float depth_here(Fragment f)
{
    return clamp_depth(f, f.center + (offsets[at].x * f.dx + offsets[at].y * f.dy));
}

uint color_at(uint channel)
{
    return (4 * pixel + channel) * kSamples + at;
}

vec3 backdrop()
{
    return vec3(colors[color_at(0)], colors[color_at(1)], colors[color_at(2)]);
}

// What was resolved over the backdrop.
void put(vec3 color, float transmittance)
{
    colors[color_at(0)] = color.r;
    colors[color_at(1)] = color.g;
    colors[color_at(2)] = color.b;
    colors[color_at(3)] = over_alpha(transmittance, colors[color_at(3)]);
}

// What the store holds.
void keep(vec3 color, float a, float b)
{
    float values[5] = float[](color.r, color.g, color.b, a, b);
    for (uint c = 0; c < 5; ++c) kept[(5 * pixel + c) * kSamples + at] = values[c];
}
