// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbx_variation.hpp"

#include <algorithm>
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

}  // namespace

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

}  // namespace lamina
