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

/// The time offset of the sensor as found in a recording.
struct FoundTime {
  CalibratedTime time;
  TimeOffset fit;
};

/// The method by which the time offset is found: the given one, or "bobbing" if it is empty.
/// @throws InvalidInput if it is none of "bobbing", "edge" and "overlap"
std::string timeMethod(const std::string& method);

/// Finds the time offset of the sensor in a recording.
/// @param method  as of `timeMethod`
/// @param about   estimate of nozzle_from_sensor, for "edge" and "overlap" [mm]
/// @param date    as `utcText` gives it
/// @throws InvalidInput if the method is none of these; as `offsetByBobbing`, `offsetByPasses`
FoundTime findTime(const SensorRecording& recording, const std::string& method,
                   const Eigen::Isometry3d& about, const CalibrationSettings& settings,
                   const std::string& date);

/// Known dimensions and position of a truncated pyramid [mm].
struct KnownPyramid {
  std::vector<double> size_mm;     ///< width of base, width of top, height; empty: those of `PyramidTarget`
  std::vector<double> touched_mm;  ///< x and y of its middle, as touched by the nozzle; empty: not known
  std::vector<double> top_mm;      ///< height of its top, as touched by the nozzle; empty: not known
};

/// The target over which a recording was made.
/// @param method  "cross", "bed", "plane" or "pyramid"; empty: "cross"
/// @throws InvalidInput if the method is none of these
/// @throws InvalidConfig if a list of the pyramid is neither empty nor as long as stated above, a value is
///   not finite, the base is not wider than the top, or a size is not above 0
SensorTarget sensorTarget(const std::string& method, const KnownPyramid& pyramid,
                          const CalibrationSettings& settings);

/// The sensor's pose as found in recordings of targets.
struct FoundPose {
  CalibratedPose pose;
  SensorPoseFit fit;
  std::vector<std::string> not_observable;  ///< a sentence for each direction that is not observable
};

/// Finds the sensor's pose in recordings of targets.
/// @param about          estimate of the pose, good to 10 mm and 5 deg [mm]
/// @param time_offset_s  of the sensor's time stamps
/// @throws InvalidInput as `fitSensorPose`, or if none of the six directions is determined
FoundPose findPose(const std::vector<SensorView>& views, const Eigen::Isometry3d& about, double time_offset_s,
                   const CalibrationSettings& settings, const CalibrationOrigin& origin);

/// Completes a found pose by the former one. Components that keep their former value also keep its spread,
/// and are no longer named as not found.
CalibratedPose withFormer(const FoundPose& found, const std::optional<CalibratedPose>& former);

/// Dead time and lag of the feeder as found in a scan of its beads.
struct FoundFeeder {
  CalibratedFeeder feeder;
  FeederFit fit;
};

/// Finds dead time and lag of the feeder in a scan of the beads of `feederToolpath`.
/// @param about  estimate of nozzle_from_sensor [mm]
/// @throws InvalidInput as `fitFeeder`
FoundFeeder findFeeder(const SensorRecording& scan, const Eigen::Isometry3d& about, double time_offset_s,
                       const CalibrationSettings& settings, const std::string& date);

/// The time offset of a calibration [s]; 0 if it has none.
double timeOffsetOf(const Calibration& cell);

/// The result as sentences for the operator.
std::vector<std::string> inWords(const FoundTime& found);
std::vector<std::string> inWords(const FoundPose& found);
std::vector<std::string> inWords(const FoundFeeder& found);

}  // namespace lamina
