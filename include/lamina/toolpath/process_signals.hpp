// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/toolpath/process_levels.hpp"

namespace lamina {

/// The state of the process at one instant.
struct ProcessSignals {
  double flow_mm3_s = 0.0;   ///< flow of material: the bead's cross-section times the speed of the tip
  bool is_laser_on = false;  ///< whether the beam, or an arc, is on
  bool is_wire_fed = false;
  bool is_powder_on = false;
  bool is_gas_on = false;
  ProcessLevels levels = {};

  friend bool operator==(const ProcessSignals& a, const ProcessSignals& b) {
    return a.flow_mm3_s == b.flow_mm3_s && a.is_laser_on == b.is_laser_on && a.is_wire_fed == b.is_wire_fed &&
           a.is_powder_on == b.is_powder_on && a.is_gas_on == b.is_gas_on && a.levels == b.levels;
  }
};

/// The safe state, in which a machine is left: no flow, everything off, no level stated.
inline ProcessSignals safeSignals() { return {}; }

/// Interpolates between two states: flow, wire and screw linearly, the rest as in the first one.
/// @param share  0 for the first state, 1 for the second
inline ProcessSignals between(const ProcessSignals& from, const ProcessSignals& to, double share) {
  ProcessSignals signals = from;
  signals.flow_mm3_s += share * (to.flow_mm3_s - from.flow_mm3_s);
  for (const ProcessLevel level : kAllProcessLevels)
    if (followsSpeed(level) && to.levels.has(level))
      signals.levels[level] += share * (to.levels[level] - from.levels[level]);
  return signals;
}

}  // namespace lamina
