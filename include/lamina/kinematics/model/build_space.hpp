// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The build space of a machine or robot: where over its bed the tip of its nozzle may be, and how its head
/// holds the nozzle there. Placing, slicing and planning know nothing else of the machine that will run a
/// toolpath, neither its axes nor their speeds. The space of linear axes is what they reach with rotary
/// joints at zero. The space of an arm or platform is the box over its bed; only a joint path shows which
/// part of that box can be reached.
///
/// A parallelepiped: tips are `bed_from_axes * values`, with values within `range`.
struct BuildSpace {
  std::string name;  ///< of the machine or robot

  /// Columns: edges of unit length, along linear axes x, y and z or along those of a robot's bed [bed frame,
  /// mm].
  Eigen::Affine3d bed_from_axes = Eigen::Affine3d::Identity();
  Box3 range;                        ///< least and greatest values along the edges [mm]
  std::array<bool, 3> is_endless{};  ///< edges whose greatest value is no limit, as along a belt

  /// Turn of the nozzle with its head at rest; z is the tool axis.
  Eigen::Matrix3d bed_from_nozzle = nozzleDown().toRotationMatrix();
  std::vector<std::string>
      rotary_joints;  ///< that can turn the tool axis over the bed; none for a fixed head

  /// To the coordinates that programs speak [mm]: those of the bed (the identity), or axis values on a belt.
  Eigen::Affine3d program_from_bed = Eigen::Affine3d::Identity();

  /// The profile sensor as seen from the tip, along the axes of the bed, z its viewing direction [mm];
  /// nothing if none is described.
  std::optional<Eigen::Isometry3d> tip_from_sensor;
};

/// One of `kinematicModelNames`.
/// @throws InvalidConfig if there is none of that name; names those there are
BuildSpace buildSpaceByName(const std::string& name);

/// The build space of a machine of linear axes as `machineFromUrdf` reads it, or of an arm or platform. The
/// space of the latter is as wide as the box of the bed's collision bodies and 1500 mm high, with the nozzle
/// straight down.
/// @throws InvalidConfig as `machineFromUrdf`; of an arm or platform as `kinematicModelFromUrdf`, or if its
///   link `bed` has no collision body
BuildSpace buildSpaceFromUrdf(const std::string& text);

/// Box of all tips [mm, bed frame].
Box3 boundingBox(const BuildSpace& space);

/// Tool axis with all rotary joints at zero, of unit length [bed frame].
Point3 toolAxis(const BuildSpace& space);

/// Whether head or table can turn the tool axis over the bed.
bool canTurnToolAxis(const BuildSpace& space);

/// The space with the nozzle straight down, and its tips and its sensor where they were: for checks on level
/// layers.
BuildSpace withUprightHead(BuildSpace space);

/// Where the sensor's line of sight meets the plane of a layer through the nozzle tip, seen from the tip [mm,
/// x and y of the layer]; the tip itself if no sensor is described.
/// @param bed_from_layers  the identity for layers that are level
/// @throws InvalidConfig if the sensor does not look down on the layer
Point2 sensorOffset(const BuildSpace& space,
                    const Eigen::Quaterniond& bed_from_layers = Eigen::Quaterniond::Identity());

}  // namespace lamina
