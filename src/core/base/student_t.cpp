// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/student_t.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <string>

#include "base/plain_doubles.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

using StudentT = boost::math::students_t_distribution<double, PlainDoubles>;

StudentT distribution(std::size_t degrees_of_freedom) {
  if (degrees_of_freedom == 0) throw InvalidInput("degrees of freedom are 0; must be at least 1");
  return StudentT(static_cast<double>(degrees_of_freedom));
}

double squaredError(const Sample& sample) {
  if (sample.count < 2)
    throw InvalidInput("a sample has " + std::to_string(sample.count) + " values; must have at least 2");
  return sample.deviation * sample.deviation / static_cast<double>(sample.count);
}

}  // namespace

StudentTest compareMeans(const Sample& a, const Sample& b) {
  const double error = std::sqrt(squaredError(a) + squaredError(b));
  if (!(error > 0.0)) throw InvalidInput("neither sample has any spread; must have, to compare their means");
  StudentTest test;
  test.t = (a.mean - b.mean) / error;
  test.degrees_of_freedom = a.count + b.count - 2;
  test.probability = probabilityAbove(std::abs(test.t), test.degrees_of_freedom);
  return test;
}

double probabilityAbove(double t, std::size_t degrees_of_freedom) {
  return boost::math::cdf(boost::math::complement(distribution(degrees_of_freedom), t));
}

double criticalT(double confidence, std::size_t degrees_of_freedom) {
  if (!(confidence > 0.0 && confidence < 1.0))
    throw InvalidInput("confidence is " + numberText(confidence) + "; must be between 0 and 1");
  return boost::math::quantile(distribution(degrees_of_freedom), confidence);
}

}  // namespace lamina
