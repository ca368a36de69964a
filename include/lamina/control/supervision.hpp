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

/// What can go wrong in the loop. The values are the numbers of the alarms.
enum class LoopAlarm : std::uint16_t {
  Silent = 6101,        ///< no cloud
  NoTransform = 6102,   ///< clouds, but no pose of the nozzle at their time stamps
  Stuck = 6103,         ///< profiles without finite points, or all the same
  Contested = 6104,     ///< too many readings contested and not believed
  TimeOffset = 6105,    ///< the sensor's time offset, or the sensor on its mount, has moved
  Inconsistent = 6106,  ///< innovations are larger or smaller than the filter expects
  Step = 6110,          ///< the mean error jumped from one layer to the next
  Deviation = 6111,     ///< too many cells are off by more than the alarm's height
  Lump = 6112,          ///< something is higher than the head's clearance
  Saturated = 6113,     ///< corrections have reached their limits
  Diverging = 6114,     ///< the error grows from layer to layer
  Growth = 6115,        ///< the gain learnt is out of a feeder's plausible range
  MapLate = 6116        ///< a layer's map did not arrive in time, or was not applied
};

/// Whether the cause of an alarm lasts until it is seen to be gone (6101, 6102, 6103, 6105); any other cause
/// is over once it has happened. A lump is among the latter: its removal shows before the next layer, for
/// which a held print waits.
bool isCondition(LoopAlarm alarm);

/// The reaction to an alarm.
enum class LoopReaction : std::uint8_t {
  Warn,
  LeaveOut,  ///< the measurements of the layer are not used
  Coast,
  Open,
  Replan,
  Hold  ///< the print waits for the operator; it is never aborted
};

/// An alarm, the reaction to it, and its text.
struct RaisedAlarm {
  LoopAlarm alarm = LoopAlarm::Silent;
  LoopReaction reaction = LoopReaction::Warn;
  std::string reason;  ///< what is wrong, the value with its unit, and what was expected
};

/// The reason why a loop coasts instead of being active.
enum class CoastingFor : std::uint8_t {
  Nothing,
  Sight,       ///< until a layer is measured
  TimeOffset,  ///< until the sensor is calibrated
  Suspect      ///< until the operator makes a request
};

/// The state of the loop, with what it remembers of the layers before. It is a value: the same events lead to
/// the same status.
struct LoopStatus {
  LoopState state = LoopState::Off;
  std::string reason = {};
  CoastingFor coasting_for = CoastingFor::Nothing;
  int unmeasured_layers = 0;  ///< number in a row; so are the four that follow
  int saturated_layers = 0;
  int growing_layers = 0;
  int deviating_layers = 0;
  int inconsistent_layers = 0;
  bool has_figures = false;  ///< whether a layer was measured: what follows is of the last one
  std::size_t layer = 0;     ///< number of that layer
  double mean_error_mm = 0.0;
  double rmse_mm = 0.0;
};

/// Whether the loop judges what happens: not while it is off or blocked.
bool isRunning(LoopState state);
/// Whether so many layers in a row were not measured that the loop does not continue by itself.
bool isSightLost(const LoopStatus& status);

/// The status after an event, and the alarms that it raised.
struct LoopStep {
  LoopStatus status;
  std::vector<RaisedAlarm> alarms;
};

/// A request of the operator.
enum class LoopRequest : std::uint8_t { Off, Identify, Active };

/// The status after a request. `Off` is always granted. Any other is granted if the report allows the loop to
/// start; otherwise the loop is blocked, with the reason of the report. A request also ends `Open`, `Blocked`
/// and coasting of any kind.
LoopStatus afterRequest(LoopRequest request, const StabilityReport& report);

/// State of the sensor and its transforms at a time.
struct SensorWatch {
  bool is_scanning = false;         ///< whether clouds are expected
  double silent_s = 0.0;            ///< time since the last cloud
  double unplaced_s = 0.0;          ///< time since the last cloud whose frame tf knew, while others come
  double blind_s = 0.0;             ///< time since the last cloud with a known pose of the nozzle
  double variance_mm2 = 1.0;        ///< variance of points between profiles taken while the sensor moves
  int profiles = 0;                 ///< number of profiles in a row that gave the variance
  std::string sensor = {};          ///< name of these profiles' sensor; empty if it has none
  bool is_seen_otherwise = false;   ///< whether another sensor measures, in this layer or the one before
  double time_offset_s = 0.0;       ///< observed less calibrated time offset
  double time_offset_sigmas = 0.0;  ///< magnitude of `time_offset_s` in standard deviations
  std::string offset_sensor = {};   ///< name of the sensor of that offset; empty if it has none
  std::string moved = {};           ///< how a sensor that has moved shows it; empty if none has
  double map_late_s = 0.0;          ///< time for which the layer has waited for its map
};

/// Whether profiles of that number and variance are those of a stuck sensor.
bool isStuck(int profiles, double variance_mm2);
/// Whether a sensor is stuck and its clouds are left out, as another one measures.
bool isLeftOut(const SensorWatch& watch);

/// Judges what the sensor does. A stuck sensor is a warning if another one measures. Without effect while the
/// loop is off or blocked.
LoopStep afterWatch(const LoopStatus& status, const SensorWatch& watch, const LoopSettings& settings);

/// Judges a layer that is done; without effect while the loop is off or blocked.
LoopStep afterLayer(const LoopStatus& status, const LayerFigures& figures, const LoopSettings& settings);

/// The status after the layers left were planned again, `raised_mm` higher than before: the loop is active,
/// and the counts of layers are 0.
LoopStatus afterReplan(const LoopStatus& status, double raised_mm);

/// Judges whether the head is clear of the layer that is about to begin; without effect while the loop is off
/// or blocked.
/// @param lump_mm       height above the nozzle of the highest cell or lump in the way of the head
/// @param clearance_mm  height of the lowest part of the head above the nozzle tip
LoopStep beforeLayer(const LoopStatus& status, double lump_mm, double clearance_mm);

}  // namespace lamina
