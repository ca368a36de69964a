// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/cell_frame.hpp"

#include <cstdio>

namespace lamina {
namespace {

constexpr double kSameCellMm = 0.01;
constexpr double kSameCellRad = 1e-5;

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

}  // namespace lamina
