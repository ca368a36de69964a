// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "variation.hpp"

#include <algorithm>
#include <cmath>
#include <pagmo/rng.hpp>
#include <pagmo/utils/genetic_operators.hpp>
#include <utility>

namespace lamina {
namespace {

/// Points as pagmo's operators want them: continuous variables first, then whole numbers.
class Chromosomes {
 public:
  explicit Chromosomes(const DesignSpace& space) : space_(space) {
    for (std::size_t i = 0; i < space.size(); ++i)
      if (space[i].kind == VariableKind::Continuous) order_.push_back(i);
    whole_ = space.size() - order_.size();
    for (std::size_t i = 0; i < space.size(); ++i)
      if (space[i].kind != VariableKind::Continuous) order_.push_back(i);
    for (const std::size_t i : order_) {
      const bool is_levels = space[i].kind == VariableKind::Levels;
      bounds_.first.push_back(is_levels ? 0.0 : lowOf(space[i]));
      bounds_.second.push_back(is_levels ? static_cast<double>(space[i].levels.size() - 1)
                                         : highOf(space[i]));
    }
  }

  const std::pair<std::vector<double>, std::vector<double>>& bounds() const { return bounds_; }
  std::size_t whole() const { return whole_; }

  std::vector<double> fromPoint(const DesignPoint& point) const {
    std::vector<double> genes;
    genes.reserve(order_.size());
    for (const std::size_t i : order_) {
      const auto& levels = space_[i].levels;
      const bool is_levels = space_[i].kind == VariableKind::Levels;
      genes.push_back(
          is_levels ? static_cast<double>(std::find(levels.begin(), levels.end(), point[i]) - levels.begin())
                    : point[i]);
    }
    return genes;
  }

  DesignPoint toPoint(const std::vector<double>& genes) const {
    DesignPoint point(genes.size());
    for (std::size_t gene = 0; gene < genes.size(); ++gene) {
      const Variable& variable = space_[order_[gene]];
      const bool is_levels = variable.kind == VariableKind::Levels;
      point[order_[gene]] = is_levels ? variable.levels[static_cast<std::size_t>(genes[gene])] : genes[gene];
    }
    return nearestWithin(space_, std::move(point));
  }

 private:
  const DesignSpace& space_;
  std::vector<std::size_t> order_;  ///< of the variables among the genes
  std::size_t whole_ = 0;
  std::pair<std::vector<double>, std::vector<double>> bounds_;
};

const Parent& winner(const Parent& one, const Parent& other, Random& random) {
  if (one.rank != other.rank) return one.rank < other.rank ? one : other;
  if (one.crowding != other.crowding) return one.crowding > other.crowding ? one : other;
  return random.below(2) == 0 ? one : other;
}

/// All parents twice, each time in another order.
std::vector<const Parent*> shuffledTwice(const std::vector<Parent>& population, Random& random) {
  std::vector<const Parent*> line;
  for (int time = 0; time < 2; ++time) {
    const std::size_t first = line.size();
    for (const Parent& parent : population) line.push_back(&parent);
    for (std::size_t left = population.size(); left > 1; --left)
      std::swap(line[first + left - 1], line[first + random.below(left)]);
  }
  return line;
}

/// As many new points as there are parents: winners of binary tournaments (by front, then by crowding) in
/// pairs, crossed and mutated by pagmo's operators. Integers, levels and choices take the operators for
/// integers, by their indices.
std::vector<DesignPoint> varyBySbx(const DesignSpace& space, const Nsga2Settings& settings,
                                   const std::vector<Parent>& population, Random& random) {
  const Chromosomes chromosomes(space);
  pagmo::detail::random_engine_type engine(static_cast<std::uint32_t>(random.bits()));
  const std::vector<const Parent*> line = shuffledTwice(population, random);
  std::vector<DesignPoint> points;
  points.reserve(population.size() + 1);
  for (std::size_t next = 0; points.size() < population.size(); next += 4) {
    const auto at = [&](std::size_t i) -> const Parent& { return *line[(next + i) % line.size()]; };
    const Parent& one = winner(at(0), at(1), random);
    const Parent& other = winner(at(2), at(3), random);
    auto children = pagmo::sbx_crossover(
        chromosomes.fromPoint(*one.point), chromosomes.fromPoint(*other.point), chromosomes.bounds(),
        chromosomes.whole(), settings.crossover_probability, settings.crossover_index, engine);
    for (std::vector<double>* child : {&children.first, &children.second}) {
      pagmo::polynomial_mutation(*child, chromosomes.bounds(), chromosomes.whole(),
                                 settings.mutation_probability, settings.mutation_index, engine);
      points.push_back(chromosomes.toPoint(*child));
    }
  }
  points.resize(population.size());
  return points;
}

std::size_t childrenOf(const Nsga2Settings& settings) {
  return 2 * static_cast<std::size_t>(std::lround(settings.crossover_share * settings.population / 2.0));
}

std::size_t mutantsOf(const Nsga2Settings& settings) {
  return static_cast<std::size_t>(std::lround(settings.mutation_share * settings.population));
}

const DesignPoint& anyOf(const std::vector<Parent>& population, Random& random) {
  return *population[random.below(population.size())].point;
}

/// Each number of the two mixed in proportions of its own; choices stay or change places.
void blend(const DesignSpace& space, DesignPoint& one, DesignPoint& other, Random& random) {
  for (std::size_t i = 0; i < space.size(); ++i) {
    const double alpha = random.uniform(0.0, 1.0);
    if (space[i].kind == VariableKind::Categorical) {
      if (alpha < 0.5) std::swap(one[i], other[i]);
      continue;
    }
    const double first = one[i];
    const double second = other[i];
    one[i] = alpha * first + (1.0 - alpha) * second;
    other[i] = alpha * second + (1.0 - alpha) * first;
  }
}

double otherChoice(const Variable& variable, double choice, Random& random) {
  const auto count = static_cast<std::uint64_t>(highOf(variable)) + 1;
  const double other = static_cast<double>(random.below(count - 1));
  return other < choice ? other : other + 1.0;
}

/// A normal step in whole numbers, at least one: where the range is short, it would be none almost always.
double wholeStep(double count, const Nsga2Settings& settings, Random& random) {
  const double step = random.normal(0.0, settings.mutation_step * (count - 1.0));
  const double whole = std::round(step);
  return whole == 0.0 ? std::copysign(1.0, step) : whole;
}

double neighbourLevel(const std::vector<double>& levels, double value, const Nsga2Settings& settings,
                      Random& random) {
  const auto index = static_cast<double>(std::find(levels.begin(), levels.end(), value) - levels.begin());
  const auto count = static_cast<double>(levels.size());
  const double other = std::clamp(index + wholeStep(count, settings, random), 0.0, count - 1.0);
  return levels[static_cast<std::size_t>(other)];
}

double mutated(const Variable& variable, double value, const Nsga2Settings& settings, Random& random) {
  const double range = highOf(variable) - lowOf(variable);
  switch (variable.kind) {
    case VariableKind::Categorical:
      return otherChoice(variable, value, random);
    case VariableKind::Levels:
      return neighbourLevel(variable.levels, value, settings, random);
    case VariableKind::Integer:
      return value + wholeStep(range + 1.0, settings, random);
    case VariableKind::Continuous:
      break;
  }
  return value + random.normal(0.0, settings.mutation_step * range);
}

/// Some variables, each at most once, in random order.
std::vector<std::size_t> anyVariables(std::size_t wanted, std::size_t count, Random& random) {
  std::vector<std::size_t> indices(count);
  for (std::size_t i = 0; i < count; ++i) indices[i] = i;
  for (std::size_t i = 0; i < wanted; ++i) std::swap(indices[i], indices[i + random.below(count - i)]);
  indices.resize(wanted);
  return indices;
}

DesignPoint mutant(const DesignSpace& space, DesignPoint point, const Nsga2Settings& settings,
                   Random& random) {
  const double share = std::ceil(settings.mutation_rate * static_cast<double>(space.size()));
  const auto wanted = std::max<std::size_t>(1, static_cast<std::size_t>(share));
  for (const std::size_t i : anyVariables(wanted, space.size(), random))
    point[i] = mutated(space[i], point[i], settings, random);
  return nearestWithin(space, std::move(point));
}

std::vector<DesignPoint> varyByBlend(const DesignSpace& space, const Nsga2Settings& settings,
                                     const std::vector<Parent>& population, Random& random) {
  std::vector<DesignPoint> points;
  for (std::size_t pair = 0; pair < childrenOf(settings) / 2; ++pair) {
    DesignPoint one = anyOf(population, random);
    DesignPoint other = anyOf(population, random);
    blend(space, one, other, random);
    points.push_back(nearestWithin(space, std::move(one)));
    points.push_back(nearestWithin(space, std::move(other)));
  }
  for (std::size_t i = 0; i < mutantsOf(settings); ++i)
    points.push_back(mutant(space, anyOf(population, random), settings, random));
  return points;
}

/// Low where the bit of an ordered variable is clear; variables past the last bit go with it.
DesignPoint corner(const DesignSpace& space, std::uint64_t bits, Random& random) {
  DesignPoint point = randomPoint(space, random);
  std::size_t bit = 0;
  for (std::size_t i = 0; i < space.size(); ++i) {
    if (space[i].kind == VariableKind::Categorical) continue;
    point[i] = (bits >> bit & 1U) == 0 ? lowOf(space[i]) : highOf(space[i]);
    bit = std::min<std::size_t>(bit + 1, 63);
  }
  return point;
}

}  // namespace

std::size_t offspringOf(const Nsga2Settings& settings) {
  if (settings.variation == Variation::Sbx) return static_cast<std::size_t>(settings.population);
  return childrenOf(settings) + mutantsOf(settings);
}

std::vector<DesignPoint> vary(const DesignSpace& space, const Nsga2Settings& settings,
                              const std::vector<Parent>& population, Random& random) {
  return settings.variation == Variation::Sbx ? varyBySbx(space, settings, population, random)
                                              : varyByBlend(space, settings, population, random);
}

std::vector<DesignPoint> cornersOf(const DesignSpace& space, std::size_t most, Random& random) {
  std::vector<DesignPoint> corners;
  const auto ordered =
      static_cast<std::size_t>(std::count_if(space.begin(), space.end(), [](const Variable& variable) {
        return variable.kind != VariableKind::Categorical;
      }));
  if (ordered == 0) return corners;
  const std::size_t all = ordered < 63 ? std::size_t{1} << ordered : most;
  for (std::uint64_t bits = 0; corners.size() < std::min(most, all); ++bits) {
    corners.push_back(corner(space, bits, random));
    if (corners.size() < std::min(most, all)) corners.push_back(corner(space, ~bits, random));
  }
  return corners;
}

}  // namespace lamina
