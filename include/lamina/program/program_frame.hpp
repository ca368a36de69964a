// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Pose of a program's part on the bed, and the coordinates in which the program is written.
struct ProgramFrame {
  ProgramFrame() = default;
  ProgramFrame(const Eigen::Isometry3d& placed)  // NOLINT: a place on the bed is a frame of most programs
      : bed_from_part(placed) {}

  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< [mm]
  /// Maps coordinates of the bed to axis values of the machine: the identity unless the axes are askew to the
  /// bed, as in a belt printer.
  Eigen::Affine3d program_from_bed = Eigen::Affine3d::Identity();
};

/// What a program's header states about layers, nozzle and axes if they are not the usual ones.
struct StatedFrame {
  Eigen::Quaterniond bed_from_layers = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond bed_from_nozzle = nozzleDown();
  Eigen::Affine3d bed_from_program = Eigen::Affine3d::Identity();
};

/// Comment lines that state the frame, with 17 digits: `;LAYER_FRAME:` (bed_from_layers) and `;NOZZLE_FRAME:`
/// (bed_from_nozzle) as w x y z, `;BED_FROM_AXES:` as the rows of a 3 x 4 matrix. Usual values are not
/// stated: level layers, a nozzle that points straight down, axes that are those of the bed.
std::string frameComments(const StatedFrame& frame);

/// Whether a comment, given without its semicolon, is one of those that `frameComments` writes.
bool isFrameComment(std::string_view comment);

/// Reads a comment, without its semicolon, into the frame if it is one that `frameComments` writes.
/// @return whether it is; other comments change nothing
/// @throws InvalidProgram if such a comment states no rotation, or no invertible map
bool readFrameComment(std::string_view comment, StatedFrame& frame);

}  // namespace lamina
