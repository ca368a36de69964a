// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// What the process does at one instant.
struct ProcessSignals {
  double flow_mm3_s = 0.0;   ///< of material: the bead's cross-section times the speed of the tip
  bool is_laser_on = false;  ///< beam or arc
  bool is_wire_fed = false;
  bool is_powder_on = false;
  bool is_gas_on = false;

  friend bool operator==(const ProcessSignals& a, const ProcessSignals& b) {
    return a.flow_mm3_s == b.flow_mm3_s && a.is_laser_on == b.is_laser_on && a.is_wire_fed == b.is_wire_fed &&
           a.is_powder_on == b.is_powder_on && a.is_gas_on == b.is_gas_on;
  }
};

/// Nothing flows and nothing burns: what a machine is left with.
inline ProcessSignals safeSignals() { return {}; }

}  // namespace lamina
