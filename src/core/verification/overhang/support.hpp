// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "lamina/verification/overhang/overhang_settings.hpp"
#include "verification/overhang/bead_grid.hpp"
#include "verification/overhang/deposited_beads.hpp"

namespace lamina {

/// A place of a bead that is being deposited [frame of the layers].
struct LayingPlace {
  Point3 middle = Point3::Zero();       ///< of the section [mm]
  Point3 along = Point3::UnitX();       ///< of unit length; zero for a drop
  Point3 tool_axis = -Point3::UnitZ();  ///< of unit length, z negative
  Bead section;
  std::size_t bead = 0;  ///< index; those before it are deposited already
};

/// What carries beads: the bed, and the beads deposited before (`findOverhangs`).
class Support {
 public:
  /// @param beads     must outlive the support
  /// @param sideways  the most that any tool axis goes along the layers, per depth
  Support(const std::vector<DepositedBead>& beads, const Eigen::Isometry3d& bed_from_layers,
          const OverhangSettings& settings, double sideways);

  bool carries(const LayingPlace& place) const;

 private:
  bool bedCarries(const LayingPlace& place) const;
  bool beadsCarry(const LayingPlace& place) const;
  double besideMiddle(const Bead& section) const { return (0.5 - settings_.overlap) * section.width_mm; }

  const std::vector<DepositedBead>& beads_;
  OverhangSettings settings_;
  Point3 up_;         ///< away from the bed
  double bed_level_;  ///< along `up_` [mm]
  Bead largest_;      ///< greatest width and height of all sections
  BeadGrid grid_;
};

}  // namespace lamina
