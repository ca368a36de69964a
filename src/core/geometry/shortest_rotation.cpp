// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/shortest_rotation.hpp"

namespace lamina {

// Compiled once: for opposite directions Eigen instantiates a singular value decomposition.
Eigen::Quaterniond shortestRotation(const Point3& from, const Point3& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

}  // namespace lamina
