// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How joints may be moved by hand.
struct JogSettings {
  double lease_s = 0.2;           ///< time for which an order holds unless the next one arrives
  double reaction_s = 0.05;       ///< time from an order to the first point that it changes
  double rate_hz = 100.0;         ///< points per second
  double joint_share = 0.1;       ///< greatest speed of joints, as a share of each one's greatest speed
  double tip_mm_s = 250.0;        ///< greatest speed of the nozzle tip
  double turn_deg_s = 30.0;       ///< greatest angular speed of the nozzle
  double limit_margin_deg = 2.0;  ///< margin that is kept from the limits of a rotary joint
  double limit_margin_mm = 2.0;   ///< margin that is kept from the limits of a linear joint
  double least_margin_deg = 2.0;  ///< margin that motions of the nozzle keep from singularities
  /// Distance beyond the point of rest over which the tip must be free of collisions; at most the distance
  /// that the tip covers in 0.1 s.
  double clearance_mm = 10.0;
  /// Box in which the tip may be: least x, y, z, greatest x, y, z [bed frame]; empty for no limit.
  std::vector<double> workspace_mm;
};

/// Adds the keys jog.*.
void describe(SettingsSchema& schema, JogSettings& settings);

}  // namespace lamina
