// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/statistics/kolmogorov_smirnov.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <string>

#include "base/plain_doubles.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

/// A matrix times ten to a power: powers of it would leave the range of doubles.
struct Scaled {
  Eigen::MatrixXd matrix;
  int exponent = 0;
};

Scaled product(const Scaled& a, const Scaled& b) {
  Scaled result{a.matrix * b.matrix, a.exponent + b.exponent};
  const Eigen::Index middle = result.matrix.rows() / 2;
  if (result.matrix(middle, middle) > 1e140) {
    result.matrix *= 1e-140;
    result.exponent += 140;
  }
  return result;
}

Scaled power(Scaled base, std::size_t exponent) {
  Scaled result{Eigen::MatrixXd::Identity(base.matrix.rows(), base.matrix.cols()), 0};
  for (; exponent != 0; exponent /= 2, base = product(base, base))
    if (exponent % 2 != 0) result = product(result, base);
  return result;
}

/// The matrix of Marsaglia, Tsang and Wang for d = (k - h) / n.
Eigen::MatrixXd transitions(Eigen::Index k, double h) {
  const Eigen::Index m = 2 * k - 1;
  Eigen::MatrixXd matrix(m, m);
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j < m; ++j) matrix(i, j) = i - j + 1 < 0 ? 0.0 : 1.0;
  for (Eigen::Index i = 0; i < m; ++i) {
    const auto times = static_cast<double>(i + 1);
    matrix(i, 0) -= std::pow(h, times);
    matrix(m - 1, i) -= std::pow(h, static_cast<double>(m - i));
  }
  if (2.0 * h > 1.0) matrix(m - 1, 0) += std::pow(2.0 * h - 1.0, static_cast<double>(m));
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j <= std::min(i, m - 1); ++j)
      matrix(i, j) /= std::tgamma(static_cast<double>(i - j + 2));
  return matrix;
}

double probabilityOfDistance(std::size_t count, double distance) {
  const auto n = static_cast<double>(count);
  const double s = distance * distance * n;
  if (s > 7.24 || (s > 3.76 && n > 99))
    return std::min(1.0, 2.0 * std::exp(-(2.000071 + 0.331 / std::sqrt(n) + 1.409 / n) * s));
  const auto k = static_cast<Eigen::Index>(n * distance) + 1;
  const double h = static_cast<double>(k) - n * distance;
  const Scaled powered = power({transitions(k, h), 0}, count);
  double below = powered.matrix(k - 1, k - 1);
  int exponent = powered.exponent;
  for (std::size_t i = 1; i <= count; ++i) {
    below *= static_cast<double>(i) / n;
    if (below < 1e-140) {
      below *= 1e140;
      exponent -= 140;
    }
  }
  return std::clamp(1.0 - below * std::pow(10.0, exponent), 0.0, 1.0);
}

}  // namespace

KolmogorovSmirnov testNormality(const std::vector<double>& values, double mean, double deviation) {
  if (values.empty()) throw InvalidInput("a sample has 0 values; must have at least 1");
  if (!(deviation > 0.0) || !std::isfinite(deviation) || !std::isfinite(mean))
    throw InvalidInput("standard deviation is " + numberText(deviation) + "; must be above 0");
  std::vector<double> sorted = values;
  for (const double value : sorted)
    if (!std::isfinite(value)) throw InvalidInput("a value of the sample is not finite");
  std::sort(sorted.begin(), sorted.end());
  const boost::math::normal_distribution<double, PlainDoubles> normal(mean, deviation);
  const auto n = static_cast<double>(sorted.size());
  KolmogorovSmirnov test;
  test.count = sorted.size();
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double expected = boost::math::cdf(normal, sorted[i]);
    test.distance = std::max(
        {test.distance, static_cast<double>(i + 1) / n - expected, expected - static_cast<double>(i) / n});
  }
  test.probability = probabilityOfDistance(test.count, test.distance);
  return test;
}

}  // namespace lamina
