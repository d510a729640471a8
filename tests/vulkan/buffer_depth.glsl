// What a depth buffer has of a fragment, for weights by distance. Needs fragment_list.glsl.
float distance_of(Fragment f)
{
    float depth = clamp_depth(f, f.center);
    return tile.orthographic != 0 ? depth : -1 / depth;
}

float depth_in_buffer(float z)
{
    float near = tile.near, far = tile.far;
    if (tile.orthographic != 0) return far > near ? (z - near) / (far - near) : 0;
    return far > 0 ? (near * far / z - far) / (near - far) : 1 - near / z;
}
