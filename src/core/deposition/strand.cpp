// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/strand.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostTrials = 4;  // a cubic

}  // namespace

double strandRadius(double area_mm2) { return std::sqrt(area_mm2 / M_PI); }

double ballRadius(double volume_mm3) { return std::cbrt(volume_mm3 * 0.75 / M_PI); }

double calibratedRadius(std::vector<RadiusTrial> trials, double volume_mm3) {
  if (trials.size() < 2)
    throw InvalidInput(std::to_string(trials.size()) + " trials of a radius; expected two at least");
  std::stable_sort(trials.begin(), trials.end(), [volume_mm3](const RadiusTrial& a, const RadiusTrial& b) {
    return std::abs(a.volume_mm3 - volume_mm3) < std::abs(b.volume_mm3 - volume_mm3);
  });
  trials.resize(std::min(trials.size(), kMostTrials));
  double radius_mm = 0.0;
  for (const RadiusTrial& trial : trials) {
    double weight = 1.0;
    for (const RadiusTrial& other : trials) {
      if (&other == &trial) continue;
      if (other.volume_mm3 == trial.volume_mm3)
        throw InvalidInput("two trials of a radius gave " + numberText(trial.volume_mm3) +
                           " mm3; expected different volumes");
      weight *= (volume_mm3 - other.volume_mm3) / (trial.volume_mm3 - other.volume_mm3);
    }
    radius_mm += weight * trial.radius_mm;
  }
  return radius_mm;
}

}  // namespace lamina
