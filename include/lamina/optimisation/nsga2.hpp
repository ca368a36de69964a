// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/search_problem.hpp"

namespace lamina {

/// How new points are derived from those of the population.
enum class Variation {
  Blend,  ///< arithmetic blends of random pairs, and apart from them normal steps of random points
  Sbx,    ///< simulated binary crossover of tournament winners, then polynomial mutation (Deb)
};

/// Settings of NSGA-II.
struct Nsga2Settings {
  Variation variation = Variation::Blend;
  int population = 50;
  int generations = 20;  ///< after the first, random one
  int seed = 1;
  bool takes_corners = false;  ///< whether corners of the space are among the first points

  double crossover_share = 0.7;  ///< Blend: children in a generation, as a share of the population
  double mutation_share = 0.4;   ///< Blend: mutants in a generation, as a share of the population
  double mutation_rate = 0.02;   ///< Blend: share of a mutant's variables that change; at least one does
  double mutation_step = 0.1;    ///< Blend: standard deviation, as a share of a variable's range

  double crossover_probability = 0.95;  ///< Sbx: probability that a pair is crossed
  double crossover_index = 10.0;        ///< Sbx: the greater, the nearer children are to their parents
  double mutation_probability = 0.01;   ///< Sbx: probability that a variable changes
  double mutation_index = 50.0;         ///< Sbx: the greater, the smaller the steps

  /// Points of the first generation that come before corners and random ones; as many as the population
  /// holds. The result is never worse than they are: none of them dominates a point of the front.
  std::vector<DesignPoint> first_points;
  /// Reference point that bounds the hypervolume: the responses of the objectives, in order. Empty: the worst
  /// response of each objective in the first generation that has feasible points, among these.
  std::vector<double> reference;
};

/// Adds the keys nsga2.*.
void describe(SettingsSchema& schema, Nsga2Settings& settings);

/// State of a search after a generation.
struct Generation {
  int index = 0;                  ///< 0 is the random one
  int evaluations = 0;            ///< number of evaluations so far, including failed ones
  int failed = 0;                 ///< number of failed evaluations so far
  double hypervolume = 0.0;       ///< of all points tried so far; never falls but by rounding
  std::vector<Evaluation> front;  ///< feasible points that no other point of the population dominates
};

/// Called with each generation when it is done.
using GenerationListener = std::function<void(const Generation&)>;

/// What a search found.
struct FrontSearch {
  /// Feasible evaluations that no other one dominates, of all generations; each point once, by its responses.
  std::vector<Evaluation> front;
  std::vector<Evaluation> evaluations;  ///< all evaluations, in the order in which they were requested
  std::vector<Generation> generations;
  std::vector<double> reference;  ///< of the hypervolume, as responses; empty if no point was ever feasible
};

/// Number of evaluations a search asks for.
std::int64_t evaluationsOf(const Nsga2Settings& settings);

/// Checks a problem and the settings with which it is to be searched.
/// @throws InvalidConfig naming the setting, variable or response; InvalidInput if a first point is outside
///   the space
void validate(const SearchProblem& problem, const Nsga2Settings& settings);

/// Non-dominated sorting genetic algorithm [Deb2002]. Each generation derives new points from the population,
/// tries them, and keeps the best of old and new ones by front and then by crowding. The same seed gives the
/// same result, whatever the number of threads. A point that cannot be tried, or has an objective that is not
/// finite, counts as an evaluation, is recorded with its error, and becomes a parent only if nothing better
/// is left.
/// @param listener  may be empty
/// @throws as `validate`; Cancelled; what the evaluator throws
FrontSearch searchFront(const SearchProblem& problem, const Nsga2Settings& settings,
                        const GenerationListener& listener, Progress& progress);

}  // namespace lamina
