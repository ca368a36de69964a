// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <map>
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
  double time_offset_s = 0.0;  ///< true time is the time stamp less this
  bool is_time_offset_trusted = false;
  double time_offset_sigma_s = 0.0;
  SettingTable other_time_offsets_s;  ///< of further sensors, by the frame of their clouds
  /// Standard deviations of these offsets; `time_offset_sigma_s` for a sensor without one.
  SettingTable other_time_offset_sigmas_s;
  bool is_place_trusted = false;      ///< whether the sensor's pose at the nozzle is known
  double place_error_mm = 0.0;        ///< error of that pose along the path
  double feeder_uncertainty_s = 0.0;  ///< uncertainty of dead time plus lag
  double levelling_mm = 0.0;          ///< standard deviation of the process's own levelling; 0 if not known
  /// Relative loss of growth per layer height of excess nozzle stand-off.
  double standoff = 0.0;
  double gain_ratio = 1.0;  ///< worst-case ratio of actual growth to growth by the learnt gain
  std::string file;         ///< name of the calibration file; empty for none
  std::string machine;      ///< machine that the file names; empty without one
  /// Sensor pose from the calibration file [mm]; nothing if tf gives the pose, or it is not known.
  std::optional<Eigen::Isometry3d> nozzle_from_sensor;
  /// Values of time offset, sensor pose and feeder delay with their origins, one sentence each.
  std::vector<std::string> sources;
};

/// Settings of the loop over one print.
struct LoopRunSettings {
  LoopRequest request = LoopRequest::Off;  ///< at the start of a print
  LoopSettings loop;
  SightSettings sight;
  FollowingSettings following;
  CellCalibration calibration;
  double cell_mm = 0.5;
  /// Length deposited after a cell before the cell is read; 0: the greatest bead width of the layer.
  double settle_mm = 0.0;
  double settle_s = 0.0;           ///< time from then on until the cell is solid and is read
  double reorder_s = 0.5;          ///< window of time stamps within which poses and clouds are put in order
  double head_clearance_mm = 5.0;  ///< height of the lowest part of the head above the nozzle tip
  std::string material;            ///< name of the material
  bool keeps_memory = false;       ///< whether `LoopNews` contains the `LoopMemory` of its last layer
  /// File with a map learnt from previous parts (`readPartMap`); empty for none.
  std::string learned;
};

/// Adds the keys request, loop.*, sight.*, following.*, sensor.*, feeder.*, process.*, head.clearance_mm and
/// monitor.*.
void describe(SettingsSchema& schema, LoopRunSettings& settings);

/// Time by which the stamps of further sensors are late, by the frame of their clouds [s].
/// @throws InvalidConfig naming the entry if one is not a number from -60 to 60
std::map<std::string, double> otherTimeOffsets(const SettingTable& offsets_s);

/// Standard deviations of the time offsets of several sensors [s].
struct TimeOffsetSigmas {
  double calibrated_s = 0.0;               ///< of each sensor that is not among the others
  std::map<std::string, double> others_s;  ///< by the frame of their clouds

  /// @param frame  with or without a leading slash
  double of(const std::string& frame) const;
  double greatest() const;
};

/// @throws InvalidConfig naming the entry of `other_time_offset_sigmas_s` that is not a number from 0 to 60
TimeOffsetSigmas timeOffsetSigmas(const CellCalibration& calibration);

/// The input of `checkStability` for the fastest motion and the widest bead of a toolpath.
LoopCalibration calibrationFor(const Toolpath& toolpath, const LoopRunSettings& settings);

}  // namespace lamina
