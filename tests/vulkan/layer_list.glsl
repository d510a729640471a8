// A sample's layers, for the methods that keep a few. Needs layers.glsl, fragment_list.glsl.
layout(constant_id = 1) const int kLayers = 4;

float beyond_any = uintBitsToFloat(0x7f800000u);  // infinity

Layer layers[kLayers];

void clear_layers()
{
    for (int k = 0; k < kLayers; ++k) layers[k] = layer_clear(beyond_any);
}

Layer layer_here(Fragment f)
{
    return layer_of(covers(f), layer_clear(beyond_any), depth_here(f), f.primitive, color_of(f),
                    f.opacity);
}

// What is left behind the last.
Layer exchange_layers(Layer f)
{
    for (int k = 0; k < kLayers; ++k) layer_exchange(layers[k], f);
    return f;
}

// One over the other.
Layer all_layers()
{
    Layer all = layer_clear(beyond_any);
    for (int k = 0; k < kLayers; ++k) all = layer_over(all, layers[k]);
    return all;
}
