// Multi-layer alpha blending (MLAB).
// Salvi and Vaidyanathan. Multi-Layer Alpha Blending. I3D 2014.
//
// Keeps a few layers, near to far. The two farthest of one too many become one:
//   for (int i = 0; i < LAYERS; ++i) layer_exchange(layers[i], f);
//   layers[LAYERS - 1] = mlab_merge(layers[LAYERS - 1], f);
// Exact for up to LAYERS + 1 fragments, and for any number in order of depth, from either side;
// else it depends on the order of arrival, as a fragment may belong between two that are one
// already. What passes through all is always exact.
// Needs prelude.glsl, over.glsl, layers.glsl.

SHEER_FN Layer mlab_merge(Layer last, Layer fallen)
{
    return layer_over(last, fallen);
}
