// The k-buffer.
// Bavoil, Callahan, Lefohn, Comba and Silva. Multi-Fragment Effects on the GPU Using the k-Buffer.
// I3D 2007.
//
// Keeps a few layers, near to far. Of one too many the nearest gives way, for fragments that come
// nearly in order, near to far:
//   for (int i = 0; i < LAYERS; ++i) layer_exchange(layers[i], f);
//   mask overflows = k_buffer_overflows(f, beyond_any);
//   Layer nearest = layers[0];
//   for (int i = 0; i < LAYERS; ++i)
//       layers[i] = layer_select(overflows, i + 1 < LAYERS ? layers[i + 1] : f, layers[i]);
// and goes under all that were emitted before, which are in front of the layers at the end,
//   emitted = k_buffer_join(overflows, emitted, nearest);
// or becomes one with the next nearest:
//   layers[0] = k_buffer_join(overflows, nearest, layers[0]);
// Exact for up to LAYERS + 1 fragments, and for any number that come from near to far or, where two
// become one, from far to near; else it depends on the order of arrival. Or the farthest is
// forgotten, which is what f then is: exact for LAYERS fragments, in any order.
// Needs prelude.glsl, over.glsl, layers.glsl.

SHEER_FN mask k_buffer_overflows(Layer fallen, real beyond_any)
{
    return fallen.depth < beyond_any;
}

SHEER_FN Layer k_buffer_join(mask overflows, Layer front, Layer behind)
{
    return layer_select(overflows, layer_over(front, behind), front);
}
