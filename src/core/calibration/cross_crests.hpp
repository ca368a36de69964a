// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "view_points.hpp"

namespace lamina {

/// A short piece of a bead as one pass saw it: the mean of its points, weighted by their height over the bed,
/// lies on the bead's middle line, whatever the shape of its section.
struct Crest {
  std::vector<std::size_t> points;  ///< of the view
  std::vector<double> weights;      ///< of sum 1
  Point2 normal = Point2::UnitX();  ///< across the bead
  double offset_mm = 0.0;           ///< of the middle line along the normal
};

/// Distance of a crest from its bead, across it [mm].
double crestDistance(const Crest& crest, const ViewPoints& view, const Eigen::Isometry3d& nozzle_from_sensor);

/// The crests of a cross, with the sensor's pose known within a bead's width.
std::vector<Crest> crestsOf(const CrossTarget& target, const ViewPoints& view,
                            const Eigen::Isometry3d& nozzle_from_sensor);

/// Shifts the sensor by up to 12 mm and turns it by up to 5 deg about the bed's normal so that what is higher
/// than the bed lies on the beads.
/// @param nozzle_from_sensor  by which the bed is level and at height 0 about
/// @throws InvalidInput if less than 60 % of that does
Eigen::Isometry3d placedOverCross(const CrossTarget& target, const ViewPoints& view,
                                  const Eigen::Isometry3d& nozzle_from_sensor);

}  // namespace lamina
