// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How joints may be moved by hand.
struct JogSettings {
  double lease_s = 0.2;              ///< for which an order holds without the next one
  double reaction_s = 0.05;          ///< from an order to the first point that it changes
  double rate_hz = 100.0;            ///< points per second
  double joint_share = 0.1;          ///< of the greatest speed of each joint
  double tip_mm_s = 250.0;           ///< greatest speed of the nozzle tip asked for
  double turn_deg_s = 30.0;          ///< greatest turn of the nozzle asked for, per second
  double limit_margin_deg = 2.0;     ///< in front of the limits of a rotary joint
  double limit_margin_mm = 2.0;      ///< in front of those of a linear one
  double least_margin_deg = 2.0;     ///< to a singularity, of motions of the nozzle
  double clearance_mm = 10.0;        ///< way of the tip that must be clear beyond where it would rest
  std::vector<double> workspace_mm;  ///< of the tip: least x, y, z, greatest x, y, z [bed]; empty for any
};

/// Adds the keys jog.*.
void describe(SettingsSchema& schema, JogSettings& settings);

}  // namespace lamina
