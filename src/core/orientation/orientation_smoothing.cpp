// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/orientation_smoothing.hpp"

#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kVanished = 1e-9;  // length of an average of unit vectors

}  // namespace

std::vector<Point3> smoothedToolAxes(const std::vector<Point3>& tool_axes, Course course, int window) {
  if (window < 1 || window % 2 == 0)
    throw InvalidConfig("orientation.smoothing_window is " + std::to_string(window) +
                        "; must be odd and at least 1");
  if (window == 1 || tool_axes.size() < 2) return tool_axes;
  std::vector<Point3> smoothed = movingAverages(tool_axes, course, static_cast<std::size_t>(window / 2));
  for (std::size_t i = 0; i < tool_axes.size(); ++i)
    smoothed[i] = smoothed[i].norm() < kVanished ? tool_axes[i] : smoothed[i].normalized();
  return smoothed;
}

}  // namespace lamina
