// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kriging/kriging.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

Variable between(const std::string& name, double low, double high) {
  return {name, VariableKind::Continuous, low, high, {}, {}};
}

DesignSpace plane() { return {between("x", 0.0, 4.0), between("y", -100.0, 100.0)}; }

KrigingSettings fixed(Correlation correlation, int order) {
  return {correlation, order, CorrelationRange::Fixed, 0.7};
}

struct Experiment {
  std::vector<DesignPoint> points;
  std::vector<double> values;
};

/// Random points of a space, and a wavy function of them.
Experiment experiment(const DesignSpace& space, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Experiment made;
  for (std::size_t i = 0; i < count; ++i) {
    made.points.push_back(randomPoint(space, random));
    double value = 50.0;
    for (std::size_t k = 0; k < space.size(); ++k)
      value +=
          20.0 * std::sin(2.0 * static_cast<double>(k + 1) * made.points[i][k] / highOf(space[k]) + value);
    made.values.push_back(value);
  }
  return made;
}

double correlationOf(Correlation kind, const Eigen::VectorXd& scaled) {
  const double r = scaled.norm();
  switch (kind) {
    case Correlation::Exponential:
      return std::exp(-scaled.lpNorm<1>());
    case Correlation::SquaredExponential:
      return std::exp(-0.5 * r * r);
    case Correlation::Matern32:
      return (1.0 + std::sqrt(3.0) * r) * std::exp(-std::sqrt(3.0) * r);
    case Correlation::Matern52:
      break;
  }
  return (1.0 + std::sqrt(5.0) * r + 5.0 / 3.0 * r * r) * std::exp(-std::sqrt(5.0) * r);
}

/// Universal kriging as the textbooks write it [Sacks1989], on two standardised variables with a full
/// quadratic polynomial.
class Textbook {
 public:
  Textbook(const Experiment& experiment, Correlation kind, double range) : kind_(kind), range_(range) {
    const auto n = static_cast<Eigen::Index>(experiment.points.size());
    inputs_.resize(n, 2);
    for (Eigen::Index i = 0; i < n; ++i)
      inputs_.row(i) << experiment.points[static_cast<std::size_t>(i)][0],
          experiment.points[static_cast<std::size_t>(i)][1];
    mean_ = inputs_.colwise().mean();
    inputs_.rowwise() -= mean_;
    deviation_ = inputs_.colwise().norm() / std::sqrt(static_cast<double>(n - 1));
    inputs_.array().rowwise() /= deviation_.array();
    const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(experiment.values.data(), n);
    Eigen::MatrixXd r(n, n);
    f_.resize(n, 6);
    for (Eigen::Index i = 0; i < n; ++i) {
      f_.row(i) = polynomial(inputs_.row(i));
      r.row(i) = correlations(inputs_.row(i)).transpose();
    }
    inverse_ = r.inverse();
    information_ = (f_.transpose() * inverse_ * f_).inverse();
    beta_ = information_ * f_.transpose() * inverse_ * y;
    rest_ = y - f_ * beta_;
    variance_ = rest_.dot(inverse_ * rest_) / static_cast<double>(n - 6);
    likelihood_ = -0.5 * (static_cast<double>(n) * std::log(variance_) + std::log(r.determinant()));
  }

  Prediction at(const DesignPoint& point) const {
    const Eigen::RowVector2d x =
        (Eigen::RowVector2d(point[0], point[1]) - mean_).array() / deviation_.array();
    const Eigen::VectorXd r = correlations(x);
    const Eigen::VectorXd f = polynomial(x).transpose();
    const Eigen::VectorXd u = f_.transpose() * inverse_ * r - f;
    return {f.dot(beta_) + r.dot(inverse_ * rest_),
            variance_ * (1.0 - r.dot(inverse_ * r) + u.dot(information_ * u))};
  }

  /// But for a constant.
  double logLikelihood() const { return likelihood_; }

 private:
  static Eigen::RowVectorXd polynomial(const Eigen::RowVector2d& x) {
    Eigen::RowVectorXd f(6);
    f << 1.0, x[0], x[1], x[0] * x[0], x[0] * x[1], x[1] * x[1];
    return f;
  }
  Eigen::VectorXd correlations(const Eigen::RowVector2d& x) const {
    Eigen::VectorXd r(inputs_.rows());
    for (Eigen::Index i = 0; i < r.size(); ++i)
      r[i] = correlationOf(kind_, (inputs_.row(i) - x).transpose() / range_);
    return r;
  }

  Correlation kind_;
  double range_;
  Eigen::MatrixXd inputs_, f_, inverse_, information_;
  Eigen::RowVector2d mean_, deviation_;
  Eigen::VectorXd beta_, rest_;
  double variance_ = 0.0;
  double likelihood_ = 0.0;
};

const Correlation kAll[] = {Correlation::Exponential, Correlation::SquaredExponential, Correlation::Matern32,
                            Correlation::Matern52};

TEST(KrigingTest, IsThatOfTheTextbooksAtGivenRanges) {
  const Experiment made = experiment(plane(), 15, 3);
  for (const Correlation kind : kAll) {
    const auto surrogate = krigingFit(fixed(kind, 2))(plane(), made.points, made.values);
    const Textbook textbook(made, kind, 0.7);
    Random random(9);
    for (int i = 0; i < 20; ++i) {
      const DesignPoint point = randomPoint(plane(), random);
      const Prediction expected = textbook.at(point);
      EXPECT_NEAR(surrogate->at(point).value, expected.value, 1e-6 * 50.0) << static_cast<int>(kind);
      EXPECT_NEAR(surrogate->at(point).variance, expected.variance, 1e-5 * expected.variance + 1e-7);
      EXPECT_EQ(surrogate->valueAt(point), surrogate->at(point).value);
    }
  }
}

TEST(KrigingTest, InterpolatesItsSamplesWhateverTheyAre) {
  EXPECT_TRUE(rc::check("interpolation", [] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto count = *rc::gen::inRange<std::size_t>(3, 30);
    KrigingSettings settings;
    settings.correlation = kAll[*rc::gen::inRange(0, 4)];
    settings.regression_order = *rc::gen::inRange(0, 3);
    const Experiment made = experiment(plane(), count, seed);
    const auto surrogate = krigingFit(settings)(plane(), made.points, made.values);
    for (std::size_t i = 0; i < count; ++i) {
      RC_ASSERT(std::abs(surrogate->at(made.points[i]).value - made.values[i]) < 1e-6 * 50.0);
      RC_ASSERT(surrogate->at(made.points[i]).variance == 0.0);
    }
  }));
}

TEST(KrigingTest, FittedRangesAreThoseOfGreatestLikelihood) {
  // Equal points and a response that treats both variables alike, so that both ranges are one.
  Experiment made;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      made.points.push_back({i * 1.0, j * 50.0 - 100.0});
      made.values.push_back(std::sin(1.7 * i) + std::sin(1.7 * j) + 0.3 * i * j);
    }
  KrigingSettings settings;
  settings.correlation = Correlation::Matern52;
  const auto surrogate = krigingFit(settings)(plane(), made.points, made.values);
  const std::string described = surrogate->description();
  const double range = std::stod(described.substr(described.find(": x ") + 4));
  const Textbook best(made, Correlation::Matern52, range);
  EXPECT_GT(best.logLikelihood(), Textbook(made, Correlation::Matern52, 1.1 * range).logLikelihood())
      << described;
  EXPECT_GT(best.logLikelihood(), Textbook(made, Correlation::Matern52, 0.9 * range).logLikelihood())
      << described;
  const Prediction expected = best.at({1.5, 25.0});
  EXPECT_NEAR(surrogate->at({1.5, 25.0}).value, expected.value, 2e-3);
  EXPECT_NEAR(surrogate->at({1.5, 25.0}).variance, expected.variance, 1e-2 * expected.variance);
}

TEST(KrigingTest, FallsBackToAnOrderTheSamplesDetermine) {
  const DesignSpace space = {{"layer_mm", VariableKind::Levels, 0.0, 0.0, {0.15, 0.3}, {}},
                             between("infill", 20.0, 100.0)};
  Experiment made;
  for (const double layer : {0.15, 0.3})
    for (const double infill : {20.0, 50.0, 100.0}) {
      made.points.push_back({layer, infill});
      made.values.push_back(std::sin(infill) + 10.0 * layer);
    }
  const auto described = [&](std::size_t count) {
    const std::vector<DesignPoint> points(made.points.begin(),
                                          made.points.begin() + static_cast<std::ptrdiff_t>(count));
    const std::vector<double> values(made.values.begin(),
                                     made.values.begin() + static_cast<std::ptrdiff_t>(count));
    return krigingFit(KrigingSettings{})(space, points, values)->description();
  };
  EXPECT_NE(described(6).find("order 1"), std::string::npos) << described(6);  // two levels have no square
  EXPECT_NE(described(2).find("order 0"), std::string::npos) << described(2);
  const Experiment wavy = experiment(plane(), 7, 1);
  EXPECT_NE(krigingFit(KrigingSettings{})(plane(), wavy.points, wavy.values)->description().find("order 2"),
            std::string::npos);
}

TEST(KrigingTest, TakesChoicesWithoutOrder) {
  const DesignSpace space = {
      {"link", VariableKind::Categorical, 0.0, 0.0, {}, {"average", "maximum", "tangential"}},
      between("x", 0.0, 1.0)};
  Experiment made;
  for (const double x : {0.0, 0.3, 0.7, 1.0})
    for (const double link : {0.0, 1.0, 2.0}) {
      made.points.push_back({link, x});
      made.values.push_back(std::cos(4.0 * x) + (link == 1.0 ? 5.0 : 0.0));
    }
  const auto surrogate = krigingFit(fixed(Correlation::Matern52, 1))(space, made.points, made.values);
  // The first and last choice differ by their index only.
  EXPECT_NEAR(surrogate->at({0.0, 0.5}).value, surrogate->at({2.0, 0.5}).value, 1e-9);
  EXPECT_NEAR(surrogate->at({1.0, 0.5}).value - surrogate->at({0.0, 0.5}).value, 5.0, 1e-9);
  EXPECT_NE(surrogate->description().find("link=maximum"), std::string::npos) << surrogate->description();
}

TEST(KrigingTest, ReplicatesCountByTheirMean) {
  const DesignSpace space = {between("x", 0.0, 4.0)};
  const auto surrogate =
      krigingFit(KrigingSettings{})(space, {{0.0}, {1.0}, {1.0}, {2.0}, {4.0}}, {1.0, 2.0, 4.0, 1.0, 0.0});
  EXPECT_NEAR(surrogate->at({1.0}).value, 3.0, 1e-6);
  EXPECT_EQ(surrogate->at({1.0}).variance, 0.0);
}

TEST(KrigingTest, ConstantsAndPolynomialsAreThemselves) {
  const DesignSpace space = {between("x", 0.0, 4.0)};
  const std::vector<DesignPoint> points = {{0.0}, {1.0}, {2.0}, {3.5}, {4.0}};
  const auto constant = krigingFit(KrigingSettings{})(space, points, {7.0, 7.0, 7.0, 7.0, 7.0});
  EXPECT_EQ(constant->at({0.5}).value, 7.0);
  EXPECT_EQ(constant->at({0.5}).variance, 0.0);
  EXPECT_EQ(constant->valueAt({0.5}), 7.0);
  std::vector<double> parabola;
  for (const DesignPoint& point : points) parabola.push_back(3.0 - 2.0 * point[0] + point[0] * point[0]);
  EXPECT_NEAR(krigingFit(KrigingSettings{})(space, points, parabola)->at({3.0}).value, 6.0, 1e-9);
}

TEST(KrigingTest, AVariableNoSampleChangesHasNoInfluence) {
  const auto surrogate = krigingFit(KrigingSettings{})(
      plane(), {{0.0, 5.0}, {1.0, 5.0}, {2.0, 5.0}, {4.0, 5.0}}, {1.0, 2.0, 1.5, 0.0});
  EXPECT_EQ(surrogate->at({1.3, 5.0}).value, surrogate->at({1.3, -90.0}).value);
  EXPECT_EQ(surrogate->description().find(" y "), std::string::npos);
}

TEST(KrigingTest, SameSamplesSameSurrogateToTheLastBit) {
  const Experiment made = experiment(plane(), 20, 8);
  const auto first = krigingFit(KrigingSettings{})(plane(), made.points, made.values);
  for (int i = 0; i < 200; ++i) {
    const auto again = krigingFit(KrigingSettings{})(plane(), made.points, made.values);
    ASSERT_EQ(first->description(), again->description());
    ASSERT_EQ(first->at({1.0, 2.0}).value, again->at({1.0, 2.0}).value);
    ASSERT_EQ(first->at({1.0, 2.0}).variance, again->at({1.0, 2.0}).variance);
  }
}

TEST(KrigingTest, SaysNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const Experiment made = experiment(plane(), 12, 8);
  krigingFit(KrigingSettings{})(plane(), made.points, made.values)->at({1.0, 2.0});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(KrigingTest, RefusesWhatItCannotLearnFrom) {
  EXPECT_THROW(krigingFit(KrigingSettings{})(plane(), {{0.0, 0.0}}, {1.0}), InvalidInput);
  EXPECT_THROW(krigingFit(KrigingSettings{})(plane(), {{0.0, 0.0}, {0.0, 0.0}}, {1.0, 2.0}), InvalidInput);
  EXPECT_THROW(krigingFit(KrigingSettings{})(plane(), {{0.0, 0.0}, {1.0, 0.0}}, {1.0}), InvalidInput);
  EXPECT_THROW(krigingFit(KrigingSettings{})(plane(), {{0.0, 0.0}, {1.0, 0.0}}, {1.0, NAN}), InvalidInput);
}

}  // namespace
}  // namespace lamina
