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
  Stuck = 6103,         ///< profiles without numbers, or all the same
  Contested = 6104,     ///< too many readings contested and not believed
  TimeOffset = 6105,    ///< the sensor's time offset has moved
  Inconsistent = 6106,  ///< innovations are larger, or smaller, than the filter expects
  Step = 6110,          ///< the mean error jumped from one layer to the next
  Deviation = 6111,     ///< too many cells are off by more than the alarm's height
  Lump = 6112,          ///< something is higher than the head's clearance
  Saturated = 6113,     ///< corrections have reached their limits
  Diverging = 6114,     ///< the error grows from layer to layer
  Growth = 6115,        ///< the gain learnt is out of range for a feeder
  MapLate = 6116        ///< a layer's map did not come in time
};

/// The reaction to an alarm.
enum class LoopReaction : std::uint8_t {
  Warn,
  LeaveOut,  ///< measurements of the layer are not used
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
  Suspect      ///< until the operator requests otherwise
};

/// The state of the loop and what it keeps of the layers before. It is a value: the same events lead to the
/// same status.
struct LoopStatus {
  LoopState state = LoopState::Off;
  std::string reason = {};
  CoastingFor coasting_for = CoastingFor::Nothing;
  int unmeasured_layers = 0;  ///< number in a row, as the counts below
  int saturated_layers = 0;
  int growing_layers = 0;
  int deviating_layers = 0;
  int inconsistent_layers = 0;
  bool has_figures = false;
  std::size_t layer = 0;       ///< the last one measured
  double mean_error_mm = 0.0;  ///< of that layer
  double rmse_mm = 0.0;
};

/// The status after an event, and the alarms that it raised.
struct LoopStep {
  LoopStatus status;
  std::vector<RaisedAlarm> alarms;
};

/// A request of the operator.
enum class LoopRequest : std::uint8_t { Off, Identify, Active };

/// The status after a request. `Off` is always granted. Any other is granted if the report allows the loop to
/// start; else the loop is blocked, with the reason of the report. A request also ends `Open`, `Blocked` and
/// any coasting that does not end by itself.
LoopStatus afterRequest(LoopRequest request, const StabilityReport& report);

/// The behaviour of the sensor and its transforms at an instant.
struct SensorWatch {
  bool is_scanning = false;         ///< a cloud is due
  double silent_s = 0.0;            ///< time since the last cloud
  double blind_s = 0.0;             ///< time since the last cloud with a known pose of the nozzle
  double variance_mm2 = 1.0;        ///< of points between profiles taken while moving
  int profiles = 0;                 ///< number that the variance is of
  double time_offset_s = 0.0;       ///< observed less calibrated time offset
  double time_offset_sigmas = 0.0;  ///< magnitude of that in standard deviations
  double map_late_s = 0.0;          ///< time for which the layer has waited for its map
};
/// Judges that behaviour.
LoopStep afterWatch(const LoopStatus& status, const SensorWatch& watch, const LoopSettings& settings);

/// Judges a layer that is done; without effect while the loop is off or blocked.
LoopStep afterLayer(const LoopStatus& status, const LayerFigures& figures, const LoopSettings& settings);

/// The status after the layers left were planned anew, `raised_mm` higher than before. The counts of layers
/// are reset, and the loop is active.
LoopStatus afterReplan(const LoopStatus& status, double raised_mm);

/// Judges a layer that is about to begin.
/// @param lump_mm       height of the highest believed cell in the way of the head, above the nozzle
/// @param clearance_mm  of the head above the nozzle tip
LoopStep beforeLayer(const LoopStatus& status, double lump_mm, double clearance_mm);

}  // namespace lamina
