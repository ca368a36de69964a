// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/statistics/kruskal_wallis.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <string>

#include "base/plain_doubles.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

struct Ranked {
  double value = 0.0;
  std::size_t group = 0;
};

/// Sums of ranks by group, and the sum of t³ - t over all sets of t equal values.
struct RankSums {
  std::vector<double> of_group;
  double ties = 0.0;
};

std::vector<Ranked> sortedValues(const std::vector<std::vector<double>>& groups) {
  if (groups.size() < 2)
    throw InvalidInput("there are " + std::to_string(groups.size()) + " groups; must be at least 2");
  std::vector<Ranked> all;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (groups[g].empty()) throw InvalidInput("group " + std::to_string(g) + " has no values");
    for (const double value : groups[g]) {
      if (!std::isfinite(value))
        throw InvalidInput("a value of group " + std::to_string(g) + " is not finite");
      all.push_back({value, g});
    }
  }
  std::sort(all.begin(), all.end(), [](const Ranked& a, const Ranked& b) { return a.value < b.value; });
  return all;
}

RankSums rankSums(const std::vector<Ranked>& sorted, std::size_t groups) {
  RankSums sums{std::vector<double>(groups, 0.0), 0.0};
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin;
    while (end < sorted.size() && sorted[end].value == sorted[begin].value) ++end;
    const double rank = 0.5 * static_cast<double>(begin + 1 + end);
    for (std::size_t i = begin; i < end; ++i) sums.of_group[sorted[i].group] += rank;
    const auto t = static_cast<double>(end - begin);
    sums.ties += t * t * t - t;
    begin = end;
  }
  return sums;
}

/// @param variance  of a single rank
void compareAll(const std::vector<std::vector<double>>& groups, double variance, KruskalWallis& test) {
  for (std::size_t a = 0; a < groups.size(); ++a)
    for (std::size_t b = a + 1; b < groups.size(); ++b) {
      const double difference = test.mean_ranks[a] - test.mean_ranks[b];
      const double error = std::sqrt(
          0.5 * variance *
          (1.0 / static_cast<double>(groups[a].size()) + 1.0 / static_cast<double>(groups[b].size())));
      test.comparisons.push_back(
          {a, b, difference, probabilityOfRangeAbove(std::abs(difference) / error, groups.size())});
    }
}

}  // namespace

KruskalWallis testRanks(const std::vector<std::vector<double>>& groups) {
  const std::vector<Ranked> sorted = sortedValues(groups);
  const RankSums sums = rankSums(sorted, groups.size());
  const auto n = static_cast<double>(sorted.size());
  // The variance of a rank: n (n + 1) / 12, less with ties.
  const double variance = n * (n + 1.0) / 12.0 - sums.ties / (12.0 * (n - 1.0));
  if (!(variance > 0.0)) throw InvalidInput("all values are equal; ranks report nothing");
  KruskalWallis test;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto count = static_cast<double>(groups[g].size());
    test.mean_ranks.push_back(sums.of_group[g] / count);
    const double from_middle = test.mean_ranks[g] - 0.5 * (n + 1.0);
    test.h += count * from_middle * from_middle / variance;
  }
  test.degrees_of_freedom = groups.size() - 1;
  test.probability =
      boost::math::cdf(boost::math::complement(boost::math::chi_squared_distribution<double, PlainDoubles>(
                                                   static_cast<double>(test.degrees_of_freedom)),
                                               test.h));
  compareAll(groups, variance, test);
  return test;
}

double probabilityOfRangeAbove(double q, std::size_t count) {
  constexpr double kFarOut = 8.5;  // standard deviations beyond which nothing is left of a normal value
  const boost::math::normal_distribution<double, PlainDoubles> normal;
  const auto k = static_cast<double>(count);
  // The least value is at x, the other k - 1 between x and x + q.
  const auto density = [&](double x) {
    const double between = boost::math::cdf(normal, x + q) - boost::math::cdf(normal, x);
    return k * boost::math::pdf(normal, x) * std::pow(between, k - 1.0);
  };
  const double within = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(density, -kFarOut - q,
                                                                                      kFarOut, 12, 1e-12);
  return std::clamp(1.0 - within, 0.0, 1.0);
}

}  // namespace lamina
