// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/genetic_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

double rangeOf(const Variable& variable) { return highOf(variable) - lowOf(variable); }

/// The better of two drawn at random.
const Fittest& chosenFrom(const std::vector<Fittest>& population, Random& random) {
  const Fittest& one = population[random.below(population.size())];
  const Fittest& other = population[random.below(population.size())];
  return isBetter(other.merit, one.merit) ? other : one;
}

void mutate(const DesignSpace& space, DesignPoint& point, const GeneticSettings& settings, Random& random) {
  const std::size_t i = random.below(space.size());
  if (space[i].kind == VariableKind::Categorical) {
    const std::uint64_t count = space[i].choices.size();
    point[i] =
        static_cast<double>((static_cast<std::uint64_t>(point[i]) + 1 + random.below(count - 1)) % count);
    return;
  }
  point[i] += random.uniform(-settings.mutation_step, settings.mutation_step) * rangeOf(space[i]);
}

std::vector<DesignPoint> offspringOf(const DesignSpace& space, const std::vector<Fittest>& population,
                                     const GeneticSettings& settings, Random& random) {
  std::vector<DesignPoint> children;
  while (children.size() < population.size()) {
    DesignPoint first = chosenFrom(population, random).point;
    DesignPoint second = chosenFrom(population, random).point;
    for (std::size_t i = 0; i < space.size(); ++i)
      if (random.uniform(0.0, 1.0) < 0.5) std::swap(first[i], second[i]);
    for (DesignPoint* child : {&first, &second}) {
      if (random.uniform(0.0, 1.0) < settings.mutation_probability) mutate(space, *child, settings, random);
      if (children.size() < population.size()) children.push_back(nearestWithin(space, std::move(*child)));
    }
  }
  return children;
}

bool isLess(const Fittest& a, const Fittest& b) { return isBetter(a.merit, b.merit); }

/// A value beyond the given one in a direction: the next allowed one, or a step.
double beyond(const Variable& variable, double value, double step) {
  if (variable.kind == VariableKind::Continuous) return value + step * rangeOf(variable);
  const double sign = step > 0.0 ? 1.0 : -1.0;
  if (variable.kind != VariableKind::Levels) return value + sign;
  const auto& levels = variable.levels;
  auto level = std::find(levels.begin(), levels.end(), value);
  if (sign > 0.0) return level + 1 == levels.end() ? value : *(level + 1);
  return level == levels.begin() ? value : *(level - 1);
}

}  // namespace

void describe(SettingsSchema& schema, GeneticSettings& settings) {
  schema.integer("genetic.individuals", settings.individuals, {2, 100000}, "Individuals of a generation.");
  schema.integer("genetic.generations", settings.generations, {1, 100000}, "Generations of the search.");
  schema.number("genetic.mutation_probability", settings.mutation_probability, {0.0, 1.0},
                "Probability that a child is changed in one variable.");
  schema.number("genetic.mutation_step", settings.mutation_step, Bounds::above(0.0, 1.0),
                "Greatest change of a variable, as a share of its range.");
}

bool isBetter(const Merit& a, const Merit& b) {
  if (std::isnan(a.violation) || std::isnan(a.cost)) return false;
  if (std::isnan(b.violation) || std::isnan(b.cost)) return true;
  return a.violation != b.violation ? a.violation < b.violation : a.cost < b.cost;
}

Fittest searchGenetically(const DesignSpace& space, const MeritOf& merit_of, const GeneticSettings& settings,
                          std::uint64_t seed, Progress& progress) {
  validate(space);
  Random random(seed);
  std::vector<Fittest> population(static_cast<std::size_t>(settings.individuals));
  for (Fittest& individual : population) {
    individual.point = randomPoint(space, random);
    individual.merit = merit_of(individual.point);
  }
  Fittest best = *std::min_element(population.begin(), population.end(), isLess);
  for (int generation = 0; generation < settings.generations; ++generation) {
    throwIfCancelled(progress, "search");
    progress.report("search", static_cast<double>(generation) / settings.generations);
    const std::vector<DesignPoint> children = offspringOf(space, population, settings, random);
    for (std::size_t i = 0; i < children.size(); ++i) population[i] = {children[i], merit_of(children[i])};
    *std::max_element(population.begin(), population.end(), isLess) = best;
    best = *std::min_element(population.begin(), population.end(), isLess);
  }
  return best;
}

Fittest refined(const DesignSpace& space, const MeritOf& merit_of, Fittest start) {
  constexpr double kFinest = 1e-6;
  constexpr int kMostTrials = 2000;
  Fittest best = std::move(start);
  std::vector<double> steps(space.size(), 0.125);
  int trials = 0;
  for (bool goes_on = true; goes_on && trials < kMostTrials;) {
    goes_on = false;
    for (std::size_t i = 0; i < space.size(); ++i) {
      if (space[i].kind == VariableKind::Categorical || std::abs(steps[i]) < kFinest) continue;
      bool is_improved = false;
      for (const double sign : {1.0, -1.0}) {
        DesignPoint point = best.point;
        point[i] = beyond(space[i], point[i], sign * steps[i]);
        point = nearestWithin(space, std::move(point));
        const Merit merit = merit_of(point);
        ++trials;
        if (!isBetter(merit, best.merit)) continue;
        best = {std::move(point), merit};
        is_improved = true;
        break;
      }
      steps[i] *= is_improved ? 2.0 : 0.5;
      steps[i] = std::min(steps[i], 0.5);
      goes_on = true;
    }
  }
  return best;
}

}  // namespace lamina
