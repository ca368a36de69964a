// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/base/settings.hpp"
#include "lamina/control/cell_atlas.hpp"
#include "lamina/control/cell_estimate.hpp"

namespace lamina {

/// How points of a profile sensor are read.
struct SightSettings {
  double window_layers = 1.5;      ///< reach of a cell along its growth, in layer heights
  double crown_share = 1.0 / 3.0;  ///< of a bead's width around its middle: what should be level
  double sigma_mm = 0.02;          ///< of a point along the beam
  double spacing_mm = 0.1;         ///< of neighbouring points of a profile
  double pose_sigma_mm = 0.0;      ///< of the sensor's place along the growth
  double greatest_angle_deg = 70;  ///< between beam and growth; 90: all but undersides
  double least_depth_mm = 0.0;     ///< of the sensor's window, along its z
  double greatest_depth_mm = 0.0;  ///< 0: no window
  int trim_points = 0;             ///< at both ends of a profile, that drivers overwrite
};

/// Adds the keys sight.*.
void describe(SettingsSchema& schema, SightSettings& settings);

/// Points of one profile, in the order along its line. Of a patch each row is a profile.
struct SensorProfile {
  std::vector<Point3> points;  ///< [mm, frame of the sensor: z is the viewing direction]
  Eigen::Isometry3d toolpath_from_sensor = Eigen::Isometry3d::Identity();  ///< translation [mm]
  /// Way of the sensor within a standard deviation of its stamps [mm, frame of the toolpath].
  Eigen::Vector3d stamp_sigma_mm = Eigen::Vector3d::Zero();
};

/// What became of each point: every one counts once, as used or under the first cause that kept it from that.
struct PointCounts {
  std::uint64_t received = 0;
  std::uint64_t used = 0;
  std::uint64_t trimmed = 0;         ///< at the ends of the profile
  std::uint64_t not_finite = 0;      ///< or exactly zero, which drivers send for no point
  std::uint64_t outside_window = 0;  ///< of the sensor
  std::uint64_t spray = 0;           ///< alone off its neighbours
  std::uint64_t off_path = 0;        ///< on no laid cell
  std::uint64_t grazing = 0;         ///< seen too much from the side
  std::uint64_t beside_crown = 0;    ///< where the bead need not be level
  std::uint64_t mirrored = 0;        ///< another return of the same column agrees better

  std::uint64_t accounted() const;  ///< the sum of all but received, and the same as that
  PointCounts& operator+=(const PointCounts& other);
};

/// A reading of a cell of a layer.
struct LayerReading {
  std::size_t layer = 0;
  std::size_t cell = 0;
  CellReading reading;
};

/// What a profile says.
struct ProfileReadings {
  std::vector<LayerReading> readings;  ///< by layer and cell, ascending, each once
  PointCounts counts;
};

/// What is expected of the cells of a layer.
struct LayerPrediction {
  std::size_t layer = 0;
  const std::vector<CellEstimate>* estimates = nullptr;  ///< one per cell of the layer; outlives its use
};

/// Reads the cells that a profile crosses: the mean error of the points on the crown of each bead.
///
/// Left out, in this order, and counted: the ends of the profile; points that are none; points outside the
/// sensor's window; spray, which is off the running median of seven points by more than four standard
/// deviations and 0.3 layer heights, unless three in a row agree; points on no laid cell; points seen too
/// much from the side; points beside the crown; and of several returns in a column those that agree less with
/// what is expected. Whether a reading agrees with its cell is for `CellEstimate::see` to say.
///
/// Where a point lies on the crown of the newest layer and more than a standard deviation off it, the one
/// beneath counts if it is more likely by the predictions; where it is more than four standard deviations off
/// both, the newest. Layers without a prediction,
/// or with one of another size, are expected as planned, within `CellEstimate::kStartSigma`.
///
/// The readings are the same to the last bit for a profile that is turned round.
ProfileReadings readProfile(const SensorProfile& profile, const CellAtlas& atlas,
                            const std::vector<LayerPrediction>& predictions, const SightSettings& settings);

/// Standard deviation of a point along the growth direction [mm], seen at an angle with that cosine: of the
/// depth, of the place along the surface, and of the sensor's place.
double pointSigma(double cosine, const SightSettings& settings);

}  // namespace lamina
