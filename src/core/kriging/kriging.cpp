// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kriging/kriging.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <openturns/AbsoluteExponential.hxx>
#include <openturns/KrigingAlgorithm.hxx>
#include <openturns/Log.hxx>
#include <openturns/MaternModel.hxx>
#include <openturns/MultiStart.hxx>
#include <openturns/SquaredExponential.hxx>
#include <openturns/SymbolicFunction.hxx>
#include <openturns/TBB.hxx>
#include <openturns/TNC.hxx>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/decimals.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/fitness.hpp"

namespace lamina {
namespace {

/// What kriging sees of a design point: numbers of mean 0 and standard deviation 1 over the samples.
/// Variables with an order are one column; a Categorical one of two choices too, one of more is an indicator
/// column for each choice. Columns that no sample changes are left out.
class Regressors {
 public:
  /// @param points  at least two, all different
  /// @throws InvalidInput if they are not
  Regressors(const DesignSpace& space, const std::vector<DesignPoint>& points);

  std::size_t columns() const { return columns_.size(); }
  Eigen::VectorXd of(const DesignPoint& point) const;

  /// The variable behind a column and, of an indicator, its choice.
  std::string nameOf(const DesignSpace& space, std::size_t column) const;

  /// Products of columns that make up a polynomial: (-1, -1) is the constant, (-1, i) column i, (i, j) the
  /// product. Of the indicators of a variable the last one is left out, and so are their squares.
  std::vector<std::pair<int, int>> polynomial(int order) const;

 private:
  struct Column {
    std::size_t variable;
    int choice;  ///< -1 for the value itself
    bool is_redundant;
    double mean;
    double deviation;
  };

  double rawValue(const Column& column, const DesignPoint& point) const;

  std::vector<Column> columns_;
};

Regressors::Regressors(const DesignSpace& space, const std::vector<DesignPoint>& points) {
  if (std::set<DesignPoint>(points.begin(), points.end()).size() != points.size() || points.size() < 2)
    throw InvalidInput("kriging of " + std::to_string(points.size()) +
                       " samples; expected at least 2 at different points");
  for (std::size_t i = 0; i < space.size(); ++i) {
    const bool has_indicators = space[i].kind == VariableKind::Categorical && space[i].choices.size() > 2;
    const int count = has_indicators ? static_cast<int>(space[i].choices.size()) : 1;
    for (int choice = 0; choice < count; ++choice)
      columns_.push_back({i, has_indicators ? choice : -1, has_indicators && choice + 1 == count, 0.0, 0.0});
  }
  const auto n = static_cast<double>(points.size());
  for (Column& column : columns_) {
    for (const DesignPoint& point : points) column.mean += rawValue(column, point) / n;
    double squares = 0.0;
    for (const DesignPoint& point : points) squares += std::pow(rawValue(column, point) - column.mean, 2.0);
    const double range = highOf(space[column.variable]) - lowOf(space[column.variable]);
    column.deviation = std::sqrt(squares / (n - 1.0));
    if (column.deviation < 1e-12 * range) column.deviation = 0.0;
  }
  const auto is_constant = [](const Column& column) { return column.deviation == 0.0; };
  columns_.erase(std::remove_if(columns_.begin(), columns_.end(), is_constant), columns_.end());
}

double Regressors::rawValue(const Column& column, const DesignPoint& point) const {
  const double value = point.at(column.variable);
  return column.choice < 0 ? value : static_cast<double>(value == column.choice);
}

Eigen::VectorXd Regressors::of(const DesignPoint& point) const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(columns_.size()));
  for (std::size_t c = 0; c < columns_.size(); ++c)
    values[static_cast<Eigen::Index>(c)] =
        (rawValue(columns_[c], point) - columns_[c].mean) / columns_[c].deviation;
  return values;
}

std::string Regressors::nameOf(const DesignSpace& space, std::size_t column) const {
  const Variable& variable = space[columns_[column].variable];
  const int choice = columns_[column].choice;
  return choice < 0 ? variable.name
                    : variable.name + "=" + variable.choices[static_cast<std::size_t>(choice)];
}

std::vector<std::pair<int, int>> Regressors::polynomial(int order) const {
  std::vector<std::pair<int, int>> terms = {{-1, -1}};
  if (order < 1) return terms;
  const auto count = static_cast<int>(columns_.size());
  for (int i = 0; i < count; ++i)
    if (!columns_[static_cast<std::size_t>(i)].is_redundant) terms.emplace_back(-1, i);
  if (order < 2) return terms;
  for (int i = 0; i < count; ++i)
    for (int j = i; j < count; ++j) {
      const Column& a = columns_[static_cast<std::size_t>(i)];
      const Column& b = columns_[static_cast<std::size_t>(j)];
      const bool are_indicators = a.choice >= 0 && a.variable == b.variable;
      if (!a.is_redundant && !b.is_redundant && !are_indicators) terms.emplace_back(i, j);
    }
  return terms;
}

using Terms = std::vector<std::pair<int, int>>;

/// Of standardised responses: OpenTURNS refuses a polynomial that is 0, which that of mean 0 may be.
constexpr double kOutputMean = 1.0;
constexpr double kLeastRange = 0.02;
/// Far beyond the samples; smooth correlations become singular at greater ones.
constexpr double kGreatestRange = 10.0;

OT::Point pointOf(const Eigen::VectorXd& values) {
  OT::Point point(static_cast<OT::UnsignedInteger>(values.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) point[static_cast<OT::UnsignedInteger>(i)] = values[i];
  return point;
}

double termAt(const std::pair<int, int>& term, const Eigen::VectorXd& x) {
  return (term.first < 0 ? 1.0 : x[term.first]) * (term.second < 0 ? 1.0 : x[term.second]);
}

/// What samples of one response look like to OpenTURNS.
struct Samples {
  std::vector<Eigen::VectorXd> inputs;
  Eigen::VectorXd outputs;  ///< of mean kOutputMean and standard deviation 1
  double mean = 0.0;
  double deviation = 0.0;
};

Samples samplesOf(const Regressors& regressors, const std::vector<DesignPoint>& points,
                  const std::vector<double>& values) {
  Samples samples;
  for (const DesignPoint& point : points) samples.inputs.push_back(regressors.of(point));
  samples.outputs =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  samples.mean = samples.outputs.mean();
  samples.outputs.array() -= samples.mean;
  samples.deviation = samples.outputs.norm() / std::sqrt(static_cast<double>(values.size() - 1));
  if (samples.deviation > 0.0) samples.outputs /= samples.deviation;
  samples.outputs.array() += kOutputMean;
  return samples;
}

/// A polynomial that samples determine.
struct Regression {
  int order = 0;
  Terms terms;
  bool is_exact = false;  ///< nothing is left for the correlation to explain
};

/// The highest order up to the given one whose coefficients the samples determine, with one to spare.
Regression regressionOf(const Regressors& regressors, const Samples& samples, int highest_order) {
  const auto n = static_cast<Eigen::Index>(samples.inputs.size());
  for (int order = highest_order;; --order) {
    const Terms terms = regressors.polynomial(order);
    const auto p = static_cast<Eigen::Index>(terms.size());
    Eigen::MatrixXd matrix(n, p);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index k = 0; k < p; ++k)
        matrix(i, k) =
            termAt(terms[static_cast<std::size_t>(k)], samples.inputs[static_cast<std::size_t>(i)]);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
    qr.setThreshold(1e-9);
    if (order > 0 && (p >= n || qr.rank() < p)) continue;
    const double rest = (samples.outputs - matrix * qr.solve(samples.outputs)).norm();
    return {order, terms, rest < 1e-9 * std::sqrt(static_cast<double>(n))};
  }
}

OT::Basis basisOf(const Terms& terms, std::size_t columns) {
  OT::Description names(columns);
  for (std::size_t i = 0; i < columns; ++i) names[i] = "x" + std::to_string(i);
  OT::Collection<OT::Function> functions;
  for (const auto& [i, j] : terms) {
    std::string formula = "1";
    if (i >= 0) formula += "*" + names[static_cast<std::size_t>(i)];
    if (j >= 0) formula += "*" + names[static_cast<std::size_t>(j)];
    functions.add(OT::SymbolicFunction(names, {formula}));
  }
  return OT::Basis(functions);
}

OT::CovarianceModel covarianceOf(Correlation correlation, const OT::Point& ranges) {
  const OT::Point amplitude(1, 1.0);
  switch (correlation) {
    case Correlation::Exponential:
      return OT::AbsoluteExponential(ranges, amplitude);
    case Correlation::SquaredExponential:
      return OT::SquaredExponential(ranges, amplitude);
    case Correlation::Matern32:
      return OT::MaternModel(ranges, amplitude, 1.5);
    case Correlation::Matern52:
      break;
  }
  return OT::MaternModel(ranges, amplitude, 2.5);
}

std::string nameOf(Correlation correlation) {
  switch (correlation) {
    case Correlation::Exponential:
      return "exponential";
    case Correlation::SquaredExponential:
      return "squared exponential";
    case Correlation::Matern32:
      return "Matern 3/2";
    case Correlation::Matern52:
      break;
  }
  return "Matern 5/2";
}

/// What OpenTURNS makes of samples.
struct Fit {
  OT::KrigingResult result;
  bool has_fitted_ranges = false;
};

OT::KrigingAlgorithm algorithmFor(const Samples& samples, const Regression& regression,
                                  Correlation correlation, double range) {
  const auto n = static_cast<OT::UnsignedInteger>(samples.inputs.size());
  const auto columns = static_cast<OT::UnsignedInteger>(samples.inputs.front().size());
  OT::Sample inputs(n, columns);
  OT::Sample outputs(n, 1);
  for (OT::UnsignedInteger i = 0; i < n; ++i) {
    inputs[i] = pointOf(samples.inputs[i]);
    outputs(i, 0) = samples.outputs[static_cast<Eigen::Index>(i)];
  }
  OT::KrigingAlgorithm algorithm(inputs, outputs, covarianceOf(correlation, OT::Point(columns, range)),
                                 basisOf(regression.terms, columns));
  algorithm.setOptimizeParameters(false);
  return algorithm;
}

/// Likelihood is climbed from three starts, since it may have several tops.
void fitRangesOf(OT::KrigingAlgorithm& algorithm, std::size_t columns) {
  OT::Sample starts(0, columns);
  for (const double start : {0.3, 1.0, 3.0}) starts.add(OT::Point(columns, start));
  algorithm.setOptimizeParameters(true);
  algorithm.setOptimizationAlgorithm(OT::MultiStart(OT::TNC(), starts));
  algorithm.setOptimizationBounds(
      OT::Interval(OT::Point(columns, kLeastRange), OT::Point(columns, kGreatestRange)));
  algorithm.run();
}

Fit fitted(const Samples& samples, const Regression& regression, const KrigingSettings& settings) {
  if (settings.range == CorrelationRange::Fitted && !regression.is_exact) {
    OT::KrigingAlgorithm algorithm = algorithmFor(samples, regression, settings.correlation, 1.0);
    try {
      fitRangesOf(algorithm, static_cast<std::size_t>(samples.inputs.front().size()));
      return {algorithm.getResult(), true};
    } catch (const OT::Exception&) {
      // The likelihood has no maximum that stands out from rounding: any ranges do.
    }
  }
  OT::KrigingAlgorithm algorithm =
      algorithmFor(samples, regression, settings.correlation, settings.fixed_range);
  algorithm.run();
  return {algorithm.getResult(), false};
}

/// Variance that goes with ranges OpenTURNS did not fit: what the polynomial leaves, for each degree of
/// freedom. At ranges it did fit, its own amplitude holds it already.
double varianceLeft(const OT::KrigingResult& result, const Samples& samples, const Regression& regression) {
  const OT::Sample coefficients = result.getCovarianceCoefficients();
  const OT::Point trend = result.getTrendCoefficients()[0];
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.inputs.size(); ++i) {
    double rest = samples.outputs[static_cast<Eigen::Index>(i)];
    for (std::size_t k = 0; k < regression.terms.size(); ++k)
      rest -= trend[k] * termAt(regression.terms[k], samples.inputs[i]);
    sum += rest * coefficients(i, 0);
  }
  const auto freedom = static_cast<double>(samples.inputs.size() - regression.terms.size());
  return std::max(0.0, sum / freedom);
}

/// One response, interpolated.
class KrigingSurrogate final : public Surrogate {
 public:
  KrigingSurrogate(const DesignSpace& space, const std::vector<DesignPoint>& points,
                   const std::vector<double>& values, const KrigingSettings& settings)
      : regressors_(space, points) {
    const Samples samples = samplesOf(regressors_, points, values);
    mean_ = samples.mean;
    deviation_ = samples.deviation;
    is_constant_ = deviation_ == 0.0 || regressors_.columns() == 0;
    if (is_constant_) {
      description_ = "constant: all samples are equal";
      return;
    }
    const Regression regression = regressionOf(regressors_, samples, settings.regression_order);
    const Fit fit = fitted(samples, regression, settings);
    result_ = fit.result;
    const OT::CovarianceModel model = result_.getCovarianceModel();
    const double amplitude = model.getAmplitude()[0];
    variance_ = fit.has_fitted_ranges ? amplitude * amplitude : varianceLeft(result_, samples, regression);
    variance_scale_ = variance_ / (amplitude * amplitude);
    description_ = describe(space, regression, settings, model.getScale());
  }

  Prediction at(const DesignPoint& point) const override {
    constexpr double kNegligible = 1e-9;
    if (is_constant_) return {mean_, 0.0};
    const double variance =
        variance_scale_ * result_.getConditionalMarginalVariance(pointOf(regressors_.of(point)));
    return {valueAt(point), variance > kNegligible * variance_ ? deviation_ * deviation_ * variance : 0.0};
  }

  double valueAt(const DesignPoint& point) const override {
    if (is_constant_) return mean_;
    const double value = result_.getConditionalMean(pointOf(regressors_.of(point)))[0];
    return mean_ + deviation_ * (value - kOutputMean);
  }

  std::string description() const override { return description_; }

 private:
  std::string describe(const DesignSpace& space, const Regression& regression,
                       const KrigingSettings& settings, const OT::Point& ranges) const {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < regressors_.columns(); ++i)
      texts.push_back(regressors_.nameOf(space, i) + " " + significantText(ranges[i], 4));
    return "kriging, regression of order " + std::to_string(regression.order) + ", " +
           nameOf(settings.correlation) + " correlation, ranges in deviations: " + listed(texts);
  }

  Regressors regressors_;
  double mean_ = 0.0;
  double deviation_ = 0.0;
  bool is_constant_ = false;
  OT::KrigingResult result_;
  double variance_ = 0.0;        ///< of the process
  double variance_scale_ = 1.0;  ///< of what OpenTURNS takes it for
  std::string description_;
};

/// Each point once, with the mean of its values.
struct DistinctSamples {
  std::vector<DesignPoint> points;
  std::vector<double> values;

  DistinctSamples(const std::vector<DesignPoint>& all_points, const std::vector<double>& all_values) {
    if (all_points.size() != all_values.size())
      throw InvalidInput("kriging of " + std::to_string(all_points.size()) + " points with " +
                         std::to_string(all_values.size()) + " values; expected one value a point");
    std::vector<Evaluation> samples;
    for (std::size_t i = 0; i < all_points.size(); ++i) {
      if (!std::isfinite(all_values[i]))
        throw InvalidInput("kriging of a value that is not finite: " + std::to_string(all_values[i]));
      samples.push_back({all_points[i], {all_values[i]}, ""});
    }
    for (const Evaluation& sample : withoutReplicates(samples)) {
      points.push_back(sample.point);
      values.push_back(sample.responses[0]);
    }
  }
};

}  // namespace

void describe(SettingsSchema& schema, KrigingSettings& settings) {
  schema.choice("kriging.correlation", settings.correlation,
                {{"exponential", Correlation::Exponential},
                 {"squared_exponential", Correlation::SquaredExponential},
                 {"matern_3_2", Correlation::Matern32},
                 {"matern_5_2", Correlation::Matern52}},
                "How responses of two points are related by their distance.");
  schema.integer("kriging.regression_order", settings.regression_order, {0, 2},
                 "Order of the polynomial below; lower where samples do not determine it.");
  schema.choice("kriging.range", settings.range,
                {{"fitted", CorrelationRange::Fitted}, {"fixed", CorrelationRange::Fixed}},
                "Whether ranges of the correlation are those of greatest likelihood, or given.");
  schema.number("kriging.fixed_range", settings.fixed_range, {0.01, 100.0},
                "Range of every variable if it is given, in standard deviations of its samples.");
}

SurrogateFit krigingFit(const KrigingSettings& settings) {
  return [settings](const DesignSpace& space, const std::vector<DesignPoint>& points,
                    const std::vector<double>& values) -> std::unique_ptr<Surrogate> {
    const DistinctSamples samples(points, values);
    OT::Log::Show(OT::Log::NONE);
    OT::TBB::Disable();  // its threads sum in any order: last digits would differ from run to run
    try {
      return std::make_unique<KrigingSurrogate>(space, samples.points, samples.values, settings);
    } catch (const OT::Exception& error) {
      throw InvalidInput("kriging of " + std::to_string(samples.points.size()) +
                         " samples fails in OpenTURNS: " + error.what());
    }
  };
}

SurrogateFit krigingFit(const std::vector<SettingText>& settings) {
  KrigingSettings found;
  SettingsSchema schema;
  describe(schema, found);
  for (const SettingText& setting : settings) schema.set(setting.key, setting.text);
  return krigingFit(found);
}

}  // namespace lamina
