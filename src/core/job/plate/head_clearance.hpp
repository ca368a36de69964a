// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "job/plate/plate_overlap.hpp"
#include "lamina/kinematics/cartesian/machine_bodies.hpp"

namespace lamina {

/// A machine's head as it moves over a plate.
struct MovingHead {
  Eigen::Affine3d axes_from_bed = Eigen::Affine3d::Identity();  ///< values of the axes by tip of the nozzle
  std::vector<MachineBody> bodies;
};

/// Order in which parts are printed one after the other: the lowest first; of several as high the one nearest
/// to that before, counted between middles, then in the order given.
std::vector<std::size_t> partOrder(const std::vector<StandingPart>& parts);

/// Refuses an order in which a body of the head could touch a finished part: the boxes of the bodies, swept
/// by all tips over the box of the part being printed, its margin and its height, against the boxes of the
/// parts before. Conservative: what passes is clear.
/// @param margin_mm  by which tips go beyond the box of a part, and beads beyond that of a finished one
/// @throws Unreachable naming both parts and the body's link
void requireHeadClear(const std::vector<StandingPart>& parts, const std::vector<std::size_t>& order,
                      const MovingHead& head, double margin_mm);

}  // namespace lamina
