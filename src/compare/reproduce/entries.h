// One function for each entry of the table in reproduce.cpp, each in a file of its own name.
#pragma once

#include "compare/reproduce/reproduce.h"

namespace sheer {

using Reproduce = void(const ReproduceEntry&, const ReproduceJob&);

Reproduce reproduce_stochastic_examples;
Reproduce reproduce_stochastic_bias;
Reproduce reproduce_stochastic_visibility;
Reproduce reproduce_stochastic_figure_1;
Reproduce reproduce_stochastic_figure_2;
Reproduce reproduce_stochastic_figure_4;
Reproduce reproduce_stochastic_figure_5;
Reproduce reproduce_stochastic_cost;
Reproduce reproduce_stochastic_peeling;
Reproduce reproduce_stochastic_seeding;
Reproduce reproduce_stochastic_adaptive;
Reproduce reproduce_stratified_table_1;
Reproduce reproduce_stratified_figure_1;
Reproduce reproduce_stratified_tracking;
Reproduce reproduce_stratified_figure_3;
Reproduce reproduce_stratified_figure_5;
Reproduce reproduce_stratified_figure_6;
Reproduce reproduce_stratified_figure_8;
Reproduce reproduce_stratified_figure_9;
Reproduce reproduce_stratified_figure_10;
Reproduce reproduce_stratified_combined;
Reproduce reproduce_hashed_distance;
Reproduce reproduce_hashed_parts;
Reproduce reproduce_hashed_anisotropy;
Reproduce reproduce_hashed_stability;
Reproduce reproduce_hashed_temporal;
Reproduce reproduce_hashed_cost;
Reproduce reproduce_hashed_occlusion;
Reproduce reproduce_hashed_foveation;
Reproduce reproduce_slab_knob;
Reproduce reproduce_slab_strips;
Reproduce reproduce_surfaces_in_samples;
Reproduce reproduce_order_dependence;
Reproduce reproduce_continuum_table;
Reproduce reproduce_moment_table_1;
Reproduce reproduce_moment_figure_1;
Reproduce reproduce_moment_figure_3;
Reproduce reproduce_moment_layers;
Reproduce reproduce_moment_gap;
Reproduce reproduce_moment_stores;
Reproduce reproduce_moment_shadows;
Reproduce reproduce_truth_convergence;

}  // namespace sheer
