// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina::test {

/// A request for lines `spacing_mm` apart, of beads that fill 0.4 mm or of drops `spacing_mm` wide.
inline InfillRequest requestOf(double spacing_mm, double angle_rad) {
  InfillRequest request;
  request.spacing_mm = spacing_mm;
  request.pitch_mm = 0.4;
  request.angle_rad = angle_rad;
  request.settings.drops.diameter_mm = spacing_mm;
  request.settings.drops.pitch_mm = spacing_mm;
  return request;
}

/// Of beads that lie side by side.
inline InfillRequest solidRequestOf(double pitch_mm, double angle_rad) {
  InfillRequest request = requestOf(pitch_mm, angle_rad);
  request.pitch_mm = pitch_mm;
  return request;
}

}  // namespace lamina::test
