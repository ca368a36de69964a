// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/drop_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr int kHalvings = 60;  // down to the last bit of a double

double linearOverlap(double x) { return std::max(0.0, 1.0 - x); }

double areaOverlap(double x) {
  if (x >= 1.0) return 0.0;
  return 2.0 / M_PI * (std::acos(x) - x * std::sqrt(1.0 - x * x));
}

}  // namespace

double overlapAt(double relative_distance, OverlapDefinition definition) {
  return definition == OverlapDefinition::Linear ? linearOverlap(relative_distance)
                                                 : areaOverlap(relative_distance);
}

double distanceOfOverlap(double overlap, OverlapDefinition definition) {
  if (!(overlap >= 0.0 && overlap <= 1.0))
    throw InvalidInput("overlap of drops is " + numberText(overlap) + "; must be in [0, 1]");
  if (definition == OverlapDefinition::Linear) return 1.0 - overlap;
  double near = 0.0;
  double far = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (near + far);
    (areaOverlap(middle) > overlap ? near : far) = middle;
  }
  return far;
}

}  // namespace lamina
