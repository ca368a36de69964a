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

/// A flat place of which all points are.
struct PlaneTarget {
  bool is_bed = false;  ///< the bed at height 0, else any plane at rest
};

/// A truncated pyramid on a flat place, square, its base at height 0 of its own frame and its top at
/// `height_mm`.
struct PyramidTarget {
  double base_mm = 40.0;
  double top_mm = 20.0;
  double height_mm = 10.0;
  Eigen::Isometry3d bed_from_pyramid = Eigen::Isometry3d::Identity();  ///< about; z of the pyramid up [mm]
  bool is_place_known = false;  ///< its x and y, as touched by the nozzle
  bool is_top_known = false;    ///< its z, as touched by the nozzle
};

/// Beads deposited as a cross in a square (`crossBeads`) on the bed at height 0.
struct CrossTarget {
  std::vector<CalibrationBead> beads;
  double bead_width_mm = 0.8;
  double bead_height_mm = 0.3;
};

using SensorTarget = std::variant<PlaneTarget, PyramidTarget, CrossTarget>;

/// A target and what was recorded over it.
struct SensorView {
  SensorTarget target;
  SensorRecording recording;
};

struct SensorPoseSettings {
  double time_offset_s = 0.0;  ///< of the sensor's stamps
  double max_sigma_mm = 0.05;  ///< a greater standard deviation counts as not found
  double max_sigma_deg = 0.05;
  double noise_mm = 0.005;          ///< standard deviation of a point, at least
  std::size_t most_points = 12000;  ///< of a view that are used, evenly chosen
};

/// A direction of the sensor's pose, and how well the recordings determine it. In order: x, y, z of the
/// nozzle and turns about them.
struct ObservedDirection {
  std::array<double, 6> share{};  ///< of unit length, in units of the greatest deviations allowed
  double singular_value = 0.0;    ///< of the Jacobian, in these units and of the noise: 1 is just found
};

/// Where a sensor sits, by what it saw.
struct SensorPoseFit {
  Eigen::Isometry3d nozzle_from_sensor = Eigen::Isometry3d::Identity();  ///< [mm]
  /// Standard deviations along x, y, z of the nozzle [mm] and of turns about them [deg]; 0 for what is kept.
  std::array<double, 6> sigma{};
  std::array<bool, 6> is_kept{};              ///< not found: the former value stays
  std::vector<ObservedDirection> directions;  ///< six, the best determined first
  double rms_mm = 0.0;                        ///< distance of points from their targets
  std::size_t points = 0;
};

/// Fits the sensor's pose so that points lie on their targets, those of all views at once, by Levenberg and
/// Marquardt with Huber's loss. Directions that the recordings determine worse than the settings allow keep
/// their former value: single shifts and turns, tilts before shifts where one looks like the other.
///
/// @param about  the pose as known so far: within 10 mm and 5 deg [mm]
/// @throws InvalidInput if a view has fewer than 100 points at times at which poses are known, or the cross
///   is not found in it
SensorPoseFit fitSensorPose(const std::vector<SensorView>& views, const Eigen::Isometry3d& about,
                            const SensorPoseSettings& settings);

/// "x", "y", "z", "turn about x", ... of the nozzle.
const char* directionName(std::size_t direction);

/// What kept its former value, with commas between; empty if all was found.
std::string directionsNotFound(const SensorPoseFit& fit);

/// A sentence for each direction that is not observable, and what it is mixed with; none if all are.
std::vector<std::string> observability(const SensorPoseFit& fit, const SensorPoseSettings& settings);

}  // namespace lamina
