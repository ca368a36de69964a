// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/retraction.hpp"

namespace lamina {

bool isRetracted(double distance_mm, TravelOver over, const TravelSettings& settings) {
  return distance_mm > settings.retraction_threshold_mm &&
         (over == TravelOver::Anything || isRetractedInside(distance_mm, settings));
}

bool isRetractedInside(double way_mm, const TravelSettings& settings) {
  return way_mm > settings.comb_longest_mm;
}

}  // namespace lamina
