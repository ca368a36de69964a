// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "view_points.hpp"

namespace lamina {

/// A short piece of a bead in one pass of the sensor. The mean of its points, weighted by their height over
/// the bed, lies on the centre line of the bead, whatever the shape of its cross-section.
struct Crest {
  std::vector<std::size_t> points;  ///< indices of its points among those of the view
  std::vector<double> weights;      ///< weight of each point; their sum is 1
  Point2 normal = Point2::UnitX();  ///< direction across the bead
  double offset_mm = 0.0;           ///< position of the centre line along that normal
};

/// Distance of a crest from its bead, measured across the bead [mm].
double crestDistance(const Crest& crest, const ViewPoints& view, const Eigen::Isometry3d& nozzle_from_sensor);

/// The crests of a cross, with the sensor's pose known to within a bead's width.
std::vector<Crest> crestsOf(const CrossTarget& target, const ViewPoints& view,
                            const Eigen::Isometry3d& nozzle_from_sensor);

/// The sensor's pose, shifted by up to 12 mm and turned by up to 5 deg about the bed's normal so that points
/// above the bed lie on the beads.
/// @param nozzle_from_sensor  pose with which the bed comes out level and near height 0
/// @throws InvalidInput if less than 60 % of the points above the bed lie on beads
Eigen::Isometry3d placedOverCross(const CrossTarget& target, const ViewPoints& view,
                                  const Eigen::Isometry3d& nozzle_from_sensor);

}  // namespace lamina
