// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/cell_frame.hpp"

#include <cmath>
#include <cstdio>

#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kSameCellMm = 0.01;
constexpr double kSameCellRad = 1e-5;
constexpr double kSameMassKg = 1e-3;
constexpr double kSameCentreMm = 2e-3;

}  // namespace

bool isSameCellFrame(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm() <= kSameCellMm &&
         Eigen::Quaterniond(a.linear()).angularDistance(Eigen::Quaterniond(b.linear())) <= kSameCellRad;
}

std::string shownCellFrame(const Eigen::Isometry3d& frame) {
  const Eigen::Quaterniond q(frame.linear());
  char shown[160];
  std::snprintf(shown, sizeof shown, "(%.3f, %.3f, %.3f) mm, w x y z %.6f %.6f %.6f %.6f",
                frame.translation().x(), frame.translation().y(), frame.translation().z(), q.w(), q.x(),
                q.y(), q.z());
  return shown;
}

bool isSameLoad(const ToolLoad& one, const ToolLoad& other) {
  return std::abs(one.mass_kg - other.mass_kg) <= kSameMassKg &&
         (one.centre_mm - other.centre_mm).norm() <= kSameCentreMm;
}

std::string shownLoad(const ToolLoad& load) {
  const Point3& centre = load.centre_mm;
  return numberText(load.mass_kg) + " kg with its centre at (" + numberText(centre.x()) + ", " +
         numberText(centre.y()) + ", " + numberText(centre.z()) + ") mm";
}

}  // namespace lamina
