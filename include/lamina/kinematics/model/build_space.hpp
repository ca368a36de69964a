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

/// The build space of a machine or robot: where over its bed the tip of its nozzle may be, and in which
/// orientation its head holds the nozzle there. Placing, slicing and planning know nothing else of the
/// machine that will run a toolpath, neither its axes nor their speeds. The space of a machine with linear
/// axes is what these reach with rotary joints at zero. The space of an arm or platform is the box over its
/// bed; only a joint path shows which part of that box can be reached.
///
/// The space is a parallelepiped: tips are `bed_from_axes * values`, with values within `range`.
struct BuildSpace {
  std::string name;  ///< of the machine or robot

  /// Columns: edges of unit length, along linear axes x, y and z or along those of a robot's bed [bed frame,
  /// mm].
  Eigen::Affine3d bed_from_axes = Eigen::Affine3d::Identity();
  Box3 range;                        ///< least and greatest values along the edges [mm]
  std::array<bool, 3> is_endless{};  ///< edges whose greatest value is no limit, like that along a belt

  /// Orientation of the nozzle with its head at rest; z is the tool axis.
  Eigen::Matrix3d bed_from_nozzle = nozzleDown().toRotationMatrix();
  /// Rotary joints that can turn the tool axis relative to the bed; empty for a fixed head.
  std::vector<std::string> rotary_joints;

  /// Map to the coordinates of programs [mm]: those of the bed (the identity), or axis values on a belt
  /// printer.
  Eigen::Affine3d program_from_bed = Eigen::Affine3d::Identity();

  /// Pose of the profile sensor relative to the nozzle tip, along the axes of the bed, z its viewing
  /// direction [mm]; nothing if the machine has none.
  std::optional<Eigen::Isometry3d> tip_from_sensor;
};

/// The build space of one of `kinematicModelNames`.
/// @throws InvalidConfig if there is no machine or robot of that name; lists the available names
BuildSpace buildSpaceByName(const std::string& name);

/// The build space of a machine of linear axes, as `machineFromUrdf` reads it, or of an arm or platform. The
/// space of an arm or platform is as wide as the bounding box of the bed's collision bodies and 1500 mm high,
/// with the nozzle straight down.
/// @throws InvalidConfig as `machineFromUrdf`; for an arm or platform as `kinematicModelFromUrdf`, or if its
///   link `bed` has no collision body
BuildSpace buildSpaceFromUrdf(const std::string& text);

/// Bounding box of all positions of the tip [mm, bed frame].
Box3 boundingBox(const BuildSpace& space);

/// Tool axis with all rotary joints at zero, of unit length [bed frame].
Point3 toolAxis(const BuildSpace& space);

/// Whether the machine can turn the tool axis relative to the bed, by its head or its table.
bool canTurnToolAxis(const BuildSpace& space);

/// The same space with the nozzle straight down, for checks on level layers; the positions of tip and sensor
/// do not change.
BuildSpace withUprightHead(BuildSpace space);

/// Where the sensor's viewing axis meets the plane of a layer through the nozzle tip, relative to the tip
/// [mm, x and y of the layer]; zero if the machine has no sensor.
/// @param bed_from_layers  the identity for layers that are level
/// @throws InvalidConfig if the sensor does not look down on the layer
Point2 sensorOffset(const BuildSpace& space,
                    const Eigen::Quaterniond& bed_from_layers = Eigen::Quaterniond::Identity());

}  // namespace lamina
