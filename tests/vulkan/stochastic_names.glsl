// Whether a tile's fragment takes a sample, as the method's parameters have it. Needs
// stochastic_masks.glsl, fragment_list.glsl.
layout(constant_id = 1) const bool kStratified = true;
layout(constant_id = 2) const uint kSeedBy = 1;  // depth, primitive, object, object-alone
layout(constant_id = 3) const bool kDithered = false;
layout(constant_id = 4) const bool kCorrects = false;

bool takes(Fragment f)
{
    uint place = pixel % kTilePixels;
    uint x = tile.x + place % kTileSize, y = tile.y + place / kTileSize;
    uint[4] names =
        uint[](floatBitsToUint(f.center), f.primitive, 2 * f.object + f.back_facing, f.object);
    uint identity = identity_seed(names[kSeedBy], tile.key);
    uint own = fragment_seed(x, y, identity);
    SampleBits bits;
    if (kStratified) {
        float xi = kDithered ? dithered_xi(x, y, identity, own) : next_random_real(own);
        bits = stratified_mask(own, xi, f.opacity, kSamples);
    } else {
        bits = naive_mask(own, f.opacity, kSamples);
    }
    return covers(f) && has_sample(bits.low, bits.high);
}
