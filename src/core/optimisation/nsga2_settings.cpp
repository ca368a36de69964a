// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/nsga2.hpp"

namespace lamina {

void describe(SettingsSchema& schema, Nsga2Settings& settings) {
  schema.choice("nsga2.variation", settings.variation, {{"blend", Variation::Blend}, {"sbx", Variation::Sbx}},
                "How new points are made of old ones: blends of random pairs, or simulated binary crossover "
                "of tournament winners.");
  schema.integer("nsga2.population", settings.population, {4, 100000}, "Number of points that are kept.");
  schema.integer("nsga2.generations", settings.generations, {0, 1000000},
                 "Number of generations after the first, random one.");
  schema.integer("nsga2.seed", settings.seed, {0, 2147483647}, "The same seed gives the same front.");
  schema.flag("nsga2.corners", settings.takes_corners,
              "Whether corners of the space are among the first points, half of them at most.");
  schema.number("nsga2.crossover_share", settings.crossover_share, {0.0, 10.0},
                "Blend: children a generation, of the population.");
  schema.number("nsga2.mutation_share", settings.mutation_share, {0.0, 10.0},
                "Blend: mutants a generation, of the population.");
  schema.number("nsga2.mutation_rate", settings.mutation_rate, {0.0, 1.0},
                "Blend: share of the variables of a mutant that change; at least one does.");
  schema.number("nsga2.mutation_step", settings.mutation_step, Bounds::above(0.0, 1.0),
                "Blend: standard deviation of a change, of the range of the variable.");
  schema.number("nsga2.crossover_probability", settings.crossover_probability, {0.0, 1.0},
                "Sbx: that a pair is crossed.");
  schema.number("nsga2.crossover_index", settings.crossover_index, {1.0, 100.0},
                "Sbx: the greater, the nearer children are to their parents.");
  schema.number("nsga2.mutation_probability", settings.mutation_probability, {0.0, 1.0},
                "Sbx: that a variable changes.");
  schema.number("nsga2.mutation_index", settings.mutation_index, {1.0, 100.0},
                "Sbx: the greater, the smaller the changes.");
}

}  // namespace lamina
