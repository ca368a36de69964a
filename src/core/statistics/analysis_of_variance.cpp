// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/statistics/analysis_of_variance.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

#include "base/plain_doubles.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// Columns of the design that belong to one source.
struct Term {
  std::string name;
  Eigen::MatrixXd columns;
};

/// A column per level but the last: 1 at that level, -1 at the last one.
Eigen::MatrixXd sumContrasts(const Factor& factor) {
  std::vector<std::string> levels = factor.levels;
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  if (levels.size() < 2)
    throw InvalidInput("factor '" + factor.name + "' has " + std::to_string(levels.size()) +
                       " levels; must have at least 2");
  const auto last = static_cast<Eigen::Index>(levels.size()) - 1;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(factor.levels.size()), last);
  for (Eigen::Index row = 0; row < columns.rows(); ++row) {
    const std::string& level = factor.levels[static_cast<std::size_t>(row)];
    const Eigen::Index at = std::lower_bound(levels.begin(), levels.end(), level) - levels.begin();
    if (at < last)
      columns(row, at) = 1.0;
    else
      columns.row(row).setConstant(-1.0);
  }
  return columns;
}

Eigen::MatrixXd products(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd columns(a.rows(), a.cols() * b.cols());
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    for (Eigen::Index j = 0; j < b.cols(); ++j)
      columns.col(i * b.cols() + j) = a.col(i).cwiseProduct(b.col(j));
  return columns;
}

std::vector<Term> termsOf(const std::vector<Factor>& factors) {
  std::vector<Term> terms;
  terms.reserve(factors.size() * (factors.size() + 1) / 2);
  for (const Factor& factor : factors) terms.push_back({factor.name, sumContrasts(factor)});
  for (std::size_t a = 0; a < factors.size(); ++a)
    for (std::size_t b = a + 1; b < factors.size(); ++b)
      terms.push_back(
          {factors[a].name + " x " + factors[b].name, products(terms[a].columns, terms[b].columns)});
  return terms;
}

struct Fit {
  double residual = 0.0;  ///< sum of squares
  Eigen::Index rank = 0;
  Eigen::Index columns = 0;
};

/// @param left_out  index of a term, or the number of them for none
Fit fitOf(const Eigen::VectorXd& response, const std::vector<Term>& terms, std::size_t left_out) {
  Eigen::Index count = 1;
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (t != left_out) count += terms[t].columns.cols();
  Eigen::MatrixXd design(response.size(), count);
  design.col(0).setOnes();
  Eigen::Index at = 1;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (t == left_out) continue;
    design.middleCols(at, terms[t].columns.cols()) = terms[t].columns;
    at += terms[t].columns.cols();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(design);
  return {(response - design * qr.solve(response)).squaredNorm(), qr.rank(), count};
}

Eigen::VectorXd checkedResponse(const std::vector<double>& response, const std::vector<Factor>& factors) {
  if (factors.empty()) throw InvalidInput("there are 0 factors; must be at least 1");
  for (const Factor& factor : factors)
    if (factor.levels.size() != response.size())
      throw InvalidInput("factor '" + factor.name + "' has " + std::to_string(factor.levels.size()) +
                         " observations; must have " + std::to_string(response.size()) + " as the response");
  for (const double value : response)
    if (!std::isfinite(value)) throw InvalidInput("a value of the response is not finite");
  // About the mean, which keeps digits.
  const Eigen::VectorXd values =
      Eigen::Map<const Eigen::VectorXd>(response.data(), static_cast<Eigen::Index>(response.size()));
  return values.array() - values.mean();
}

}  // namespace

AnalysisOfVariance analyseVariance(const std::vector<double>& response, const std::vector<Factor>& factors) {
  const Eigen::VectorXd values = checkedResponse(response, factors);
  const std::vector<Term> terms = termsOf(factors);
  const Fit full = fitOf(values, terms, terms.size());
  if (full.rank < full.columns && full.columns <= values.size())
    throw InvalidInput("the design reports only " + std::to_string(full.rank) + " of " +
                       std::to_string(full.columns) +
                       " effects apart; every pair of levels of two factors must have been observed");
  if (values.size() <= full.columns)
    throw InvalidInput("there are " + std::to_string(values.size()) + " observations for " +
                       std::to_string(full.columns) + " effects; must be more");
  AnalysisOfVariance analysis;
  analysis.residual_sum_of_squares = full.residual;
  analysis.residual_degrees_of_freedom = static_cast<std::size_t>(values.size() - full.rank);
  const auto left = static_cast<double>(analysis.residual_degrees_of_freedom);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    VarianceSource source;
    source.name = terms[t].name;
    source.degrees_of_freedom = static_cast<std::size_t>(terms[t].columns.cols());
    source.sum_of_squares = std::max(0.0, fitOf(values, terms, t).residual - full.residual);
    const auto freedom = static_cast<double>(source.degrees_of_freedom);
    source.f = source.sum_of_squares / freedom / (full.residual / left);
    if (!std::isfinite(source.f))
      throw InvalidInput("the response has no spread but by its factors; there is nothing to judge them by");
    source.probability = boost::math::cdf(boost::math::complement(
        boost::math::fisher_f_distribution<double, PlainDoubles>(freedom, left), source.f));
    analysis.sources.push_back(source);
  }
  return analysis;
}

}  // namespace lamina
