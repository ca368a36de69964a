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
  double window_layers = 1.5;      ///< reach of a cell along its growth direction, in layer heights
  double crown_share = 1.0 / 3.0;  ///< width of the crown, the level middle of a bead, over that of the bead
  double sigma_mm = 0.02;          ///< standard deviation of a point along the beam
  double spacing_mm = 0.1;         ///< distance of neighbouring points of a profile
  double pose_sigma_mm = 0.0;      ///< standard deviation of the sensor's position along the growth direction
  double greatest_angle_deg = 70;  ///< between beam and growth direction; 90: all but undersides
  double least_depth_mm = 0.0;     ///< near end of the sensor's window, along its z
  double greatest_depth_mm = 0.0;  ///< far end; 0: no window
  int trim_points = 0;             ///< left out at each end of a profile, where drivers overwrite points
};

/// Adds the keys sight.*.
void describe(SettingsSchema& schema, SightSettings& settings);

/// Points of one profile, in their order along its line. Each row of a patch is a profile.
struct SensorProfile {
  std::vector<Point3> points;  ///< [mm, frame of the sensor: z is the viewing direction]
  Eigen::Isometry3d toolpath_from_sensor = Eigen::Isometry3d::Identity();  ///< translation [mm]
  /// Displacement of the sensor within one standard deviation of its stamps [mm, frame of the toolpath].
  Eigen::Vector3d stamp_sigma_mm = Eigen::Vector3d::Zero();
};

/// Numbers of points by their use. Each point counts once, as used or by the first reason to leave it out.
struct PointCounts {
  std::uint64_t received = 0;
  std::uint64_t used = 0;
  std::uint64_t trimmed = 0;         ///< at the ends of the profile
  std::uint64_t not_finite = 0;      ///< or exactly zero, which drivers send in place of a missing point
  std::uint64_t outside_window = 0;  ///< of the sensor
  std::uint64_t spray = 0;           ///< single points off their neighbours
  std::uint64_t off_path = 0;        ///< on no cell that is deposited
  std::uint64_t grazing = 0;         ///< seen at too great an angle
  std::uint64_t beside_crown = 0;    ///< on the flank of a bead
  std::uint64_t mirrored = 0;        ///< returns that agree less than another one of their column

  std::uint64_t accounted() const;  ///< sum of all numbers but `received`, which it equals
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
  std::vector<LayerReading> readings;  ///< by layer and cell, ascending, each once
  PointCounts counts;
};

/// The predicted heights of the cells of a layer.
struct LayerPrediction {
  std::size_t layer = 0;
  const std::vector<CellEstimate>* estimates = nullptr;  ///< one per cell of the layer; outlives its use
};

/// Reads the cells that a profile crosses. A reading is the mean error of the points on the crown of a bead.
///
/// Points are left out, and counted, for these reasons in this order: they lie at the ends of the profile;
/// they are not finite; they lie outside the sensor's window; they are spray, off the running median of seven
/// points by more than four standard deviations and 0.3 layer heights, unless three in a row agree; they lie
/// on no deposited cell; they are seen at too great an angle; they lie beside the crown; another return in
/// their column agrees better with the prediction. Whether a reading agrees with its cell is for
/// `CellEstimate::see` to decide.
///
/// A point on the crown of the newest layer belongs to that layer if it is within one standard deviation of
/// the predicted height. Otherwise it belongs to the layer below if that is more likely by the predictions;
/// but one that is more than four standard deviations off both belongs to the newest layer. A layer without a
/// prediction, or with one of another number of cells, is predicted as planned with the standard deviation
/// `CellEstimate::kStartSigma`.
///
/// A profile in reverse order gives the same readings to the last bit.
ProfileReadings readProfile(const SensorProfile& profile, const CellAtlas& atlas,
                            const std::vector<LayerPrediction>& predictions, const SightSettings& settings);

/// Standard deviation of a point along the growth direction [mm]. It combines those of the depth, of the
/// place along the surface and of the sensor's position.
/// @param cosine  of the angle between beam and growth direction
double pointSigma(double cosine, const SightSettings& settings);

}  // namespace lamina
