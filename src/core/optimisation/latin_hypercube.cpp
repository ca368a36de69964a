// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/optimisation/experiment_design.hpp"

namespace lamina {
namespace {

constexpr std::size_t kExchangesEachPoint = 300;
constexpr double kNearestDistance = 1e-3;  ///< of a range; what is nearer counts as this near

double cellDistance(const DesignSpace& space, const DesignPoint& a, const DesignPoint& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const bool has_order = space[i].kind != VariableKind::Categorical;
    const double difference =
        has_order ? (a[i] - b[i]) / (highOf(space[i]) - lowOf(space[i])) : static_cast<double>(a[i] != b[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

/// What the neighbours of one point add to the sum of distances to the power of -15.
double crowding(const DesignSpace& space, const std::vector<DesignPoint>& points, std::size_t one,
                std::size_t skipped) {
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (i != one && i != skipped)
      sum += std::pow(std::max(cellDistance(space, points[one], points[i]), kNearestDistance), -15.0);
  return sum;
}

/// The value of a part of the range, of `count` equal ones.
double valueOfPart(const Variable& variable, std::size_t part, std::size_t count) {
  const double share = (static_cast<double>(part) + 0.5) / static_cast<double>(count);
  if (variable.kind == VariableKind::Continuous) return variable.low + share * (variable.high - variable.low);
  if (variable.kind == VariableKind::Levels)
    return variable.levels[static_cast<std::size_t>(share * static_cast<double>(variable.levels.size()))];
  return lowOf(variable) + std::floor(share * (highOf(variable) - lowOf(variable) + 1.0));
}

std::vector<DesignPoint> randomHypercube(const DesignSpace& space, std::size_t count, Random& random) {
  std::vector<DesignPoint> points(count);
  std::vector<std::size_t> parts(count);
  for (const Variable& variable : space) {
    std::iota(parts.begin(), parts.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(parts[i - 1], parts[random.below(i)]);
    for (std::size_t i = 0; i < count; ++i) points[i].push_back(valueOfPart(variable, parts[i], count));
  }
  return points;
}

/// Exchanges one value of two points wherever that moves near points apart.
void spread(const DesignSpace& space, std::vector<DesignPoint>& points, Random& random) {
  for (std::size_t k = 0; k < kExchangesEachPoint * points.size(); ++k) {
    const std::size_t a = random.below(points.size());
    const std::size_t b = random.below(points.size());
    const std::size_t i = random.below(space.size());
    if (points[a][i] == points[b][i]) continue;
    const double before = crowding(space, points, a, b) + crowding(space, points, b, a);
    std::swap(points[a][i], points[b][i]);
    if (crowding(space, points, a, b) + crowding(space, points, b, a) >= before)
      std::swap(points[a][i], points[b][i]);
  }
}

/// How many different points a space has; infinite if a variable is continuous.
double sizeOf(const DesignSpace& space) {
  double size = 1.0;
  for (const Variable& variable : space) {
    if (variable.kind == VariableKind::Continuous) return std::numeric_limits<double>::infinity();
    size *= variable.kind == VariableKind::Levels ? static_cast<double>(variable.levels.size())
                                                  : highOf(variable) - lowOf(variable) + 1.0;
  }
  return size;
}

}  // namespace

std::vector<DesignPoint> latinHypercube(const DesignSpace& space, std::size_t count, std::uint64_t seed) {
  if (count < 2 || static_cast<double>(count) > sizeOf(space))
    throw InvalidConfig("Latin hypercube of " + std::to_string(count) +
                        " points; expected at least 2, and at most as many as the space has (" +
                        (std::isinf(sizeOf(space)) ? std::string("no bound")
                                                   : std::to_string(static_cast<long long>(sizeOf(space)))) +
                        ")");
  Random random(seed);
  std::vector<DesignPoint> points = randomHypercube(space, count, random);
  spread(space, points, random);
  std::set<DesignPoint> taken;
  for (DesignPoint& point : points)
    while (!taken.insert(point).second) point = randomPoint(space, random);
  return points;
}

}  // namespace lamina
