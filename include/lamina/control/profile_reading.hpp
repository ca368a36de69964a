// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/control/cell_atlas.hpp"
#include "lamina/control/cell_estimate.hpp"

namespace lamina {

/// How the points of a profile sensor are read.
struct SightSettings {
  /// Distance along the growth direction within which a point lies on a cell, in layer heights.
  double window_layers = 1.5;
  /// Width of the crown (the level middle of a bead) over the width of the bead.
  double crown_share = 1.0 / 3.0;
  double sigma_mm = 0.02;  ///< standard deviation of a point along the beam
  /// Standard deviation of a point along the line of light, for sensors whose points are not at fixed places
  /// along it.
  double lateral_sigma_mm = 0.0;
  double pose_sigma_mm = 0.0;  ///< standard deviation of the sensor's position along the growth direction
  /// Greatest angle between beam and growth direction; 90: all but undersides are read.
  double greatest_angle_deg = 70;
  /// Near end of the sensor's measuring range, along its z; 0: not limited, unless the far end is.
  double least_depth_mm = 0.0;
  double greatest_depth_mm = 0.0;  ///< far end of that range; 0: not limited
  int trim_points = 0;  ///< number left out at each end of a profile, where drivers overwrite points
};

/// Adds the keys sight.*.
void describe(SettingsSchema& schema, SightSettings& settings);

/// Points of one profile, in their order along its line. A sensor that measures an area gives a profile for
/// each of its rows.
struct SensorProfile {
  std::vector<Point3> points;  ///< [mm, frame of the sensor: z is the viewing direction]
  Eigen::Isometry3d toolpath_from_sensor = Eigen::Isometry3d::Identity();  ///< translation [mm]
  /// Displacement of the sensor in a time of one standard deviation of its time stamps [mm, frame of the
  /// toolpath].
  Eigen::Vector3d stamp_sigma_mm = Eigen::Vector3d::Zero();
};

/// Numbers of points by their use. Each point counts once: as used, or by the first reason for which it was
/// left out.
struct PointCounts {
  std::uint64_t received = 0;
  std::uint64_t used = 0;
  std::uint64_t trimmed = 0;  ///< left out at the ends of the profile
  /// Not finite, or exactly zero, which drivers send in place of a missing point.
  std::uint64_t not_finite = 0;
  std::uint64_t outside_window = 0;  ///< outside the measuring range
  std::uint64_t spray = 0;           ///< single points off their neighbours
  std::uint64_t off_path = 0;        ///< points on no deposited cell
  std::uint64_t grazing = 0;         ///< points seen at an angle above the greatest
  std::uint64_t beside_crown = 0;    ///< points on the flank of a bead
  /// Points of a ray with several, except the one that agrees best with the prediction.
  std::uint64_t mirrored = 0;

  std::uint64_t accounted() const;  ///< sum of all numbers but `received`; equal to `received`
  PointCounts& operator+=(const PointCounts& other);
};

/// A reading of a cell of a layer.
struct LayerReading {
  std::size_t layer = 0;
  std::size_t cell = 0;
  CellReading reading;
};

/// The readings of one profile.
struct ProfileReadings {
  std::vector<LayerReading> readings;  ///< ascending by layer and cell, at most one of each cell
  PointCounts counts;
};

/// The predicted heights of the cells of a layer.
struct LayerPrediction {
  std::size_t layer = 0;
  /// One per cell of the layer; must outlive the prediction.
  const std::vector<CellEstimate>* estimates = nullptr;
};

/// Reads the cells that a profile crosses. A reading is the mean error of the points on the crown of one
/// cell.
///
/// Points are left out, and counted, for these reasons, checked in this order: they lie at the ends of the
/// profile; they are not finite; they lie outside the measuring range; they are spray, off the running median
/// of seven points by more than four standard deviations and by more than 0.3 layer heights, unless three in
/// a row agree; they lie on no deposited cell; they are seen at too great an angle; they lie beside the
/// crown; another point of the same ray agrees better with the prediction. Whether a reading agrees with its
/// cell is decided by `CellEstimate::see`.
///
/// A point that is on cells of two layers belongs to the newest one if it is within one standard deviation of
/// the height predicted there. Otherwise it belongs to the layer below, if its height is more likely by the
/// prediction for that layer, and within four standard deviations of it. A layer without a prediction, or
/// with one for another number of cells, is predicted as planned, with the standard deviation
/// `CellEstimate::kStartSigma`.
///
/// A profile in reverse order gives the same readings to the last bit.
ProfileReadings readProfile(const SensorProfile& profile, const CellAtlas& atlas,
                            const std::vector<LayerPrediction>& predictions, const SightSettings& settings);

/// Standard deviation of a point along the growth direction [mm]. It combines the standard deviations of its
/// depth and of its place along the line of light, each by the part that acts along the growth direction, and
/// that of the sensor's position.
/// @param growth  growth direction in the frame of the sensor; of unit length
double pointSigma(const Eigen::Vector3d& growth, const SightSettings& settings);

}  // namespace lamina
