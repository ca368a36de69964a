// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "lamina/planning/planner.hpp"

namespace lamina::test {

constexpr double kLayerHeight = 0.2;               // mm
constexpr double kLayerPitch = 0.2 + 0.05 * M_PI;  // mm, of a bead of 0.4 x 0.2 mm

/// A part of that many layers by its section at each: `contours(i)` for the i-th.
template <class Contours>
std::vector<Layer> layersOf(int count, Contours contours) {
  std::vector<Layer> layers;
  for (int i = 0; i < count; ++i)
    layers.push_back({{kLayerHeight * i, kLayerHeight * (i + 1)}, {contours(i), {}}});
  return layers;
}

/// Planned and validated.
inline Toolpath plan(const std::vector<Layer>& layers, const PlanSettings& settings) {
  NoProgress progress;
  Toolpath toolpath = planToolpath("part", layers, settings, progress);
  validate(toolpath);
  return toolpath;
}

}  // namespace lamina::test
