// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/five_axis/five_axis_settings.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath, its part's pose on the bed, and the joint path of the machine that runs it.
struct FiveAxisMotion {
  const Toolpath& toolpath;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< [mm]
  const KinematicModel& machine;
  const JointPath& joints;
};

/// Writes the toolpath as five-axis G-code: X Y Z [mm, 4 decimals] of the tip over the bed or of the joints,
/// A B C [deg, 5 decimals] of the rotary joints as in the joint path, and the word of `feederWord` with the
/// amounts of E in `writeGcode`. F is in mm/min, in deg/min if the tool rotates in place; with words of
/// joints, it is in 1/min under G93, which G94 ends. With words of joints, lines that end in `;via` are
/// inserted between waypoints wherever the tip would otherwise leave its straight path by more than
/// `chord_tolerance_mm`.
///
/// @throws InvalidConfig as `writeGcode`; if a joint, as those of an arm, has a name other than the letters
///   x, y, z, a, b, c
/// @throws Unreachable  if the joint path has faults or a joint is outside its limits, or no joints are found
///   between two waypoints; names the waypoint
/// @throws InvalidInput  if the joints are not those of the toolpath, if it holds drops, process values or
///   changes of tools, or as `writeGcode`. Everything is checked before the first piece is written.
void writeFiveAxis(const FiveAxisMotion& motion, const FiveAxisSettings& settings,
                   const ProgramSettings& program, const TextSink& sink);

}  // namespace lamina
