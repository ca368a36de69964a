// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/settings.hpp"
#include "lamina/control/loop_settings.hpp"
#include "lamina/control/profile_reading.hpp"
#include "lamina/control/stability.hpp"
#include "lamina/control/supervision.hpp"
#include "lamina/deposition/path_follower.hpp"

namespace lamina {

/// What is known of the sensor, and of the process beside what the loop learns.
struct CellCalibration {
  double time_offset_s = 0.0;  ///< true time is the stamp less this
  bool is_time_offset_trusted = false;
  double time_offset_sigma_s = 0.0;
  bool is_place_trusted = false;  ///< of the sensor at the nozzle, as tf has it
  double place_error_mm = 0.0;
  double feeder_uncertainty_s = 0.0;  ///< of its dead time and lag
  double levelling_mm = 0.0;          ///< of the process; 0 if not known
  double standoff = 0.0;              ///< loss of growth per nozzle too far away, in layer heights
  double gain_ratio = 1.0;            ///< real over learnt growth, at worst
  std::string file;                   ///< of results of a calibration; empty for none
  std::string machine;                ///< that the file is of; empty without one
  /// Where the sensor sits by the file [mm]; without it tf says so.
  std::optional<Eigen::Isometry3d> nozzle_from_sensor;
  std::vector<std::string> sources;  ///< a sentence each: what is known of clock, place, feeder, and whence
};

/// The loop over one print.
struct LoopRunSettings {
  LoopRequest request = LoopRequest::Off;  ///< at the start of a print
  LoopSettings loop;
  SightSettings sight;
  FollowingSettings following;
  CellCalibration calibration;
  double cell_mm = 0.5;
  double settle_mm = 0.0;  ///< that the nozzle has left a cell behind before it is read; 0: a bead's width
  double settle_s = 0.0;   ///< since the nozzle was so far away: until it is solid
  double reorder_s = 0.5;  ///< by the stamps, that what comes waits for what is older
  double head_clearance_mm = 5.0;  ///< of the head above the nozzle tip
  std::string material;            ///< its name
  bool keeps_memory = false;       ///< whether news hold what it takes to go on after a layer
  std::string learned;             ///< file of a map learnt from parts before (`readPartMap`); empty: none
};

/// Adds the keys request, loop.*, sight.*, following.*, sensor.*, feeder.*, process.*, head.clearance_mm and
/// monitor.*.
void describe(SettingsSchema& schema, LoopRunSettings& settings);

/// What `checkStability` asks for, of layers at their fastest and widest.
LoopCalibration calibrationFor(const Toolpath& toolpath, const LoopRunSettings& settings);

}  // namespace lamina
