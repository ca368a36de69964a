// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lamina/calibration/calibration_program.hpp"
#include "lamina/calibration/sensor_recording.hpp"

namespace lamina {

/// A flat surface, on which all recorded points lie.
struct PlaneTarget {
  bool is_bed = false;  ///< whether it is the bed, at height 0; otherwise it is any plane at rest
};

/// A square truncated pyramid on a flat surface. In its own frame the base is at height 0, the top at
/// `height_mm`.
struct PyramidTarget {
  double base_mm = 40.0;
  double top_mm = 20.0;
  double height_mm = 10.0;
  /// An estimate; z of the pyramid points up [mm].
  Eigen::Isometry3d bed_from_pyramid = Eigen::Isometry3d::Identity();
  bool is_place_known = false;  ///< whether its x and y are known, as touched by the nozzle
  bool is_top_known = false;    ///< whether its z is known, as touched by the nozzle
};

/// A cross in a square, of beads (`crossBeads`) on the bed at height 0.
struct CrossTarget {
  std::vector<CalibrationBead> beads;
  double bead_width_mm = 0.8;
  double bead_height_mm = 0.3;
};

using SensorTarget = std::variant<PlaneTarget, PyramidTarget, CrossTarget>;

/// A target and the recording that was made over it.
struct SensorView {
  SensorTarget target;
  SensorRecording recording;
};

/// Settings of the fit of the sensor's pose.
struct SensorPoseSettings {
  double time_offset_s = 0.0;       ///< of the sensor's time stamps
  double max_sigma_mm = 0.05;       ///< shifts with a greater standard deviation count as not found
  double max_sigma_deg = 0.05;      ///< rotations with a greater standard deviation count as not found
  double noise_mm = 0.005;          ///< least value assumed for the standard deviation of a point
  std::size_t most_points = 12000;  ///< greatest number of points of a view that are used, evenly chosen
};

/// A direction in the space of the sensor's pose, and how well the recordings determine it. The six
/// components of a pose are x, y, z of the nozzle and rotations about these, each in units of the greatest
/// standard deviation allowed.
struct ObservedDirection {
  std::array<double, 6> share{};  ///< components of the direction; of unit length
  double singular_value = 0.0;    ///< of the Jacobian in units of the noise: 1 is determined just well enough
};

/// The pose of a sensor as fitted to recordings.
struct SensorPoseFit {
  Eigen::Isometry3d nozzle_from_sensor = Eigen::Isometry3d::Identity();  ///< [mm]
  /// Standard deviations along x, y, z of the nozzle [mm] and of rotations about these [deg]; 0 for what is
  /// kept.
  std::array<double, 6> sigma{};
  std::array<bool, 6> is_kept{};              ///< not determined, so that the former value is kept
  std::vector<ObservedDirection> directions;  ///< six, the best determined first
  /// Robust root mean square distance of points from their targets; at least `noise_mm`.
  double rms_mm = 0.0;
  std::size_t points = 0;  ///< number of points used
};

/// Fits the sensor's pose so that the points of all views lie on their targets, by the method of Levenberg
/// and Marquardt with Huber's loss. Components of the pose that the recordings determine worse than the
/// settings allow keep their former value. They are chosen one by one; where a tilt has nearly the same
/// effect as a shift, the tilt is kept.
///
/// @param about  estimate of the pose, good to 10 mm and 5 deg [mm]
/// @throws InvalidInput if there is no view, a view has fewer than 100 points at times for which the pose of
///   the nozzle is known, or the cross is not found in it
SensorPoseFit fitSensorPose(const std::vector<SensorView>& views, const Eigen::Isometry3d& about,
                            const SensorPoseSettings& settings);

/// The name of a component of the pose: "x", "y", "z", "turn about x", ..., all of the nozzle.
/// @param direction  0 to 5
const char* directionName(std::size_t direction);

/// The names of the components that kept their former value, separated by commas; empty if all were found.
std::string directionsNotFound(const SensorPoseFit& fit);

/// A sentence for each component that is not observable, naming the components that have the same effect;
/// none if all are observable.
std::vector<std::string> observability(const SensorPoseFit& fit, const SensorPoseSettings& settings);

}  // namespace lamina
