// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/control/loop_settings.hpp"
#include "lamina/control/profile_reading.hpp"
#include "lamina/control/stability.hpp"
#include "lamina/control/supervision.hpp"
#include "lamina/deposition/path_follower.hpp"

namespace lamina {

/// What is known of the sensor, and of the process apart from what the loop learns.
struct CellCalibration {
  double time_offset_s = 0.0;  ///< true time is the stamp less this
  bool is_time_offset_trusted = false;
  double time_offset_sigma_s = 0.0;
  bool is_place_trusted = false;  ///< place of the sensor at the nozzle, by tf
  double place_error_mm = 0.0;
  double feeder_uncertainty_s = 0.0;  ///< uncertainty of dead time plus lag
  double levelling_mm = 0.0;          ///< standard deviation of the process's own levelling; 0 if not known
  double standoff = 0.0;    ///< relative loss of growth per layer height that the nozzle is too far away
  double gain_ratio = 1.0;  ///< actual over learnt growth, worst case
  std::string file;         ///< with the results of a calibration; empty for none
  std::string machine;      ///< of the file; empty without one
  /// Place of the sensor by the file [mm]; that of tf if there is none.
  std::optional<Eigen::Isometry3d> nozzle_from_sensor;
  std::vector<std::string> sources;  ///< sentences on clock, place and feeder: value and origin
};

/// Settings of the loop over one print.
struct LoopRunSettings {
  LoopRequest request = LoopRequest::Off;  ///< at the start of a print
  LoopSettings loop;
  SightSettings sight;
  FollowingSettings following;
  CellCalibration calibration;
  double cell_mm = 0.5;
  double settle_mm = 0.0;  ///< distance of the nozzle past a cell before it is read; 0: a bead's width
  double settle_s = 0.0;   ///< time after that until the cell is solid
  double reorder_s = 0.5;  ///< time for which poses and clouds wait for older ones
  double head_clearance_mm = 5.0;  ///< of the head above the nozzle tip
  std::string material;            ///< name of it
  bool keeps_memory = false;       ///< whether news hold the memory after each layer
  std::string learned;             ///< file of a map learnt from previous parts (`readPartMap`); empty: none
};

/// Adds the keys request, loop.*, sight.*, following.*, sensor.*, feeder.*, process.*, head.clearance_mm and
/// monitor.*.
void describe(SettingsSchema& schema, LoopRunSettings& settings);

/// The input of `checkStability`, for the fastest motion and widest bead of a toolpath.
LoopCalibration calibrationFor(const Toolpath& toolpath, const LoopRunSettings& settings);

}  // namespace lamina
