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
  /// Axis values [mm] from the position of the nozzle tip in the bed frame.
  Eigen::Affine3d axes_from_bed = Eigen::Affine3d::Identity();
  std::vector<MachineBody> bodies;
};

/// Order in which parts are printed one after the other: the lowest first; of several of the same height the
/// one whose middle is nearest to that of the part before, then the first in the order given.
std::vector<std::size_t> partOrder(const std::vector<StandingPart>& parts);

/// Refuses an order in which a body of the head could touch a finished part. The bounding boxes of the
/// bodies, swept by all tips over the box of the part being printed and what lies beside it, are compared
/// with the boxes of the parts before. While a tool with an offset works, the head is displaced from the
/// nozzle by this offset. Conservative: an order that passes has no collision, but one that is refused may
/// have none either.
/// @param margin_mm  by which tips go beyond the box of the part being printed, and beads beyond the box of a
///   finished one
/// @throws Unreachable naming both parts and the body's link
void requireHeadClear(const std::vector<StandingPart>& parts, const std::vector<std::size_t>& order,
                      const MovingHead& head, double margin_mm);

}  // namespace lamina
