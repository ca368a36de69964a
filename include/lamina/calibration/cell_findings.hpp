// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "lamina/calibration/calibration_file.hpp"
#include "lamina/calibration/calibration_settings.hpp"
#include "lamina/calibration/feeder_fit.hpp"
#include "lamina/calibration/sensor_pose.hpp"
#include "lamina/calibration/time_offset.hpp"

namespace lamina {

/// What a recording shows of the sensor's clock.
struct FoundTime {
  CalibratedTime time;
  TimeOffset fit;
};

/// By what the time offset is found: that method, or "bobbing" if it is empty.
/// @throws InvalidInput if it is none of "bobbing", "edge" and "overlap"
std::string timeMethod(const std::string& method);

/// @param method  as of `timeMethod`
/// @param about   where the sensor sits as far as is known, for edge and overlap [mm]
/// @param date    as `utcText` gives it
/// @throws InvalidInput if the method is none of these; as `offsetByBobbing`, `offsetByPasses`
FoundTime findTime(const SensorRecording& recording, const std::string& method,
                   const Eigen::Isometry3d& about, const CalibrationSettings& settings,
                   const std::string& date);

/// What is known of a truncated pyramid beforehand [mm].
struct KnownPyramid {
  std::vector<double> size_mm;     ///< width of base and top, height; none: those of `PyramidTarget`
  std::vector<double> touched_mm;  ///< x and y of its middle, as touched by the nozzle; none: not known
  std::vector<double> top_mm;      ///< height of its top, as touched by the nozzle; none: not known
};

/// What a recording is over.
/// @param method  "cross", "bed", "plane" or "pyramid"; empty: "cross"
/// @throws InvalidInput if the method is none of these; InvalidConfig if the pyramid has other than 3, 2 or
///   0, and 1 or 0 values, one of them is not finite, or its base is not wider than its top, and all above 0
SensorTarget sensorTarget(const std::string& method, const KnownPyramid& pyramid,
                          const CalibrationSettings& settings);

/// What recordings show of the sensor's pose.
struct FoundPose {
  CalibratedPose pose;
  SensorPoseFit fit;
  std::vector<std::string> not_observable;  ///< a sentence each (`observability`)
};

/// @param about          the pose as known so far: within 10 mm and 5 deg [mm]
/// @param time_offset_s  of the sensor's stamps
/// @throws InvalidInput as `fitSensorPose`
FoundPose findPose(const std::vector<SensorView>& views, const Eigen::Isometry3d& about, double time_offset_s,
                   const CalibrationSettings& settings, const CalibrationOrigin& origin);

/// What a scan of beads shows of the feeder.
struct FoundFeeder {
  CalibratedFeeder feeder;
  FeederFit fit;
};

/// @param about  where the sensor sits as far as is known [mm]
/// @throws InvalidInput as `fitFeeder`
FoundFeeder findFeeder(const SensorRecording& scan, const Eigen::Isometry3d& about, double time_offset_s,
                       const CalibrationSettings& settings, const std::string& date);

/// Of the calibration so far; 0 where it has none.
double timeOffsetOf(const Calibration& cell);

/// What was found, as sentences for a person.
std::vector<std::string> inWords(const FoundTime& found);
std::vector<std::string> inWords(const FoundPose& found);
std::vector<std::string> inWords(const FoundFeeder& found);

}  // namespace lamina
