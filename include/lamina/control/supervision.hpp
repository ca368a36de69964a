// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/control/height_loop.hpp"
#include "lamina/control/loop_settings.hpp"
#include "lamina/control/loop_state.hpp"
#include "lamina/control/stability.hpp"

namespace lamina {

/// What can go wrong in the loop; the numbers are those of the alarms.
enum class LoopAlarm : std::uint16_t {
  Silent = 6101,        ///< no cloud
  NoTransform = 6102,   ///< clouds, but no pose of the nozzle at their stamps
  Stuck = 6103,         ///< profiles that are no numbers, or always the same
  Contested = 6104,     ///< too many points that are not believed
  TimeOffset = 6105,    ///< the sensor's time offset has moved
  Inconsistent = 6106,  ///< the filter is surprised more, or less, than it expects
  Step = 6110,          ///< the mean error jumped from one layer to the next
  Deviation = 6111,     ///< too many cells are off by more than the alarm's height
  Lump = 6112,          ///< higher than the head's clearance
  Saturated = 6113,     ///< corrections have come to their limits
  Diverging = 6114,     ///< the error grows from layer to layer
  Growth = 6115,        ///< the gain learnt is beyond what feeders do
  MapLate = 6116        ///< a layer's map did not come in time
};

/// What is done about it.
enum class LoopReaction : std::uint8_t {
  Warn,
  LeaveOut,  ///< what was measured of the layer is not used
  Coast,
  Open,
  Replan,
  Hold  ///< the print waits for the operator; it is never aborted
};

struct RaisedAlarm {
  LoopAlarm alarm = LoopAlarm::Silent;
  LoopReaction reaction = LoopReaction::Warn;
  std::string reason;  ///< what, the value with its unit, what was expected
};

/// Why a loop that should be active coasts.
enum class CoastingFor : std::uint8_t {
  Nothing,
  Sight,       ///< until a layer is measured
  TimeOffset,  ///< until the sensor is calibrated
  Suspect      ///< until the operator says so
};

/// Where the loop is, and what it remembers of the layers before. A value: the same events lead to the same
/// status.
struct LoopStatus {
  LoopState state = LoopState::Off;
  std::string reason = {};
  CoastingFor coasting_for = CoastingFor::Nothing;
  int unmeasured_layers = 0;  ///< running, as those below
  int saturated_layers = 0;
  int growing_layers = 0;
  int deviating_layers = 0;
  int inconsistent_layers = 0;
  bool has_figures = false;
  std::size_t layer = 0;       ///< measured last
  double mean_error_mm = 0.0;  ///< of that layer
  double rmse_mm = 0.0;
};

/// The status after an event, and the alarms that it raised.
struct LoopStep {
  LoopStatus status;
  std::vector<RaisedAlarm> alarms;
};

/// What the operator asks for.
enum class LoopRequest : std::uint8_t { Off, Identify, Active };

/// Off at any time. Else the loop is blocked where the report refuses it, with its reason; a request is also
/// what ends `Open`, `Blocked` and a coasting that does not end by itself.
LoopStatus afterRequest(LoopRequest request, const StabilityReport& report);

/// What the sensor and its transforms do, at an instant.
struct SensorWatch {
  bool is_scanning = false;         ///< a cloud is due
  double silent_s = 0.0;            ///< since the last cloud
  double blind_s = 0.0;             ///< since the last cloud that a pose of the nozzle was known for
  double variance_mm2 = 1.0;        ///< of the profiles seen while moving, at their points
  int profiles = 0;                 ///< that the variance is of
  double time_offset_s = 0.0;       ///< by which the time offset seen differs from the calibrated one
  double time_offset_sigmas = 0.0;  ///< the same in standard deviations, without sign
  double map_late_s = 0.0;          ///< the layer has waited for its map
};
LoopStep afterWatch(const LoopStatus& status, const SensorWatch& watch, const LoopSettings& settings);

/// Judges a layer that is done. While the loop is off or blocked, nothing is judged.
LoopStep afterLayer(const LoopStatus& status, const LayerFigures& figures, const LoopSettings& settings);

/// The layers left were planned anew, their heights counted from a plan that much higher: what was judged of
/// the layers before holds no more, and the loop is active.
LoopStatus afterReplan(const LoopStatus& status, double raised_mm);

/// Judges a layer that is about to begin.
/// @param lump_mm       highest believed cell under the head's way, above the nozzle
/// @param clearance_mm  of the head
LoopStep beforeLayer(const LoopStatus& status, double lump_mm, double clearance_mm);

}  // namespace lamina
