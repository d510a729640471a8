// A fragment's hashed thresholds, as the method's parameters have them. Needs
// hashed_threshold.glsl, fragment_list.glsl.
layout(constant_id = 1) const uint kVariant = 1;  // isotropic, anisotropic, eight corners
layout(constant_id = 2) const float kHashScale = 1.0;
layout(constant_id = 3) const int kHash = 1;
layout(constant_id = 4) const bool kOctaves = true;
layout(constant_id = 5) const bool kUniform = true;
layout(constant_id = 6) const bool kThird = true;

HashCells cells_of(Fragment f)
{
    vec3 place = vec3(f.place[0], f.place[1], f.place[2]);
    vec3 dx = vec3(f.place[3], f.place[4], f.place[5]);
    vec3 dy = vec3(f.place[6], f.place[7], f.place[8]);
    float one = isotropic_scale(dx, dy, kHashScale);
    vec3 each = kVariant == 0 ? vec3(one) : anisotropic_scales(dx, dy, kHashScale);
    HashCells cells;
    if (!kOctaves) {
        cells = continuous_cells(place, each);
    } else if (kVariant == 0) {
        cells = isotropic_cells(place, one);
    } else {
        cells = anisotropic_cells(place, each);
    }
    if (!kThird) cells.coarse.z = cells.fine.z = 0.0;
    return cells;
}

float threshold_of(HashCells cells)
{
    return kVariant == 2 ? threshold_of_corners(cells, kHash, kUniform)
                         : threshold_of_cells(cells, kHash, kUniform);
}
