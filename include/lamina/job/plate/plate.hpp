// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A part of a plate as it is requested, and the number of its copies.
struct PlatePart {
  std::string file;  ///< path of a mesh file, or the name of a parametric part
  std::string name;  ///< name in programs and messages; empty for that of the file
  /// Position of the middle of its bounding box [bed frame]; nothing to have the part arranged.
  std::optional<Point2> at_mm;
  Point3 turn_deg = Point3::Zero();  ///< rotations about the fixed axes x, y, z, in this order
  double scale = 1.0;                ///< factor on its size, above 0
  int copies = 1;
  std::vector<SettingText> settings;  ///< settings of its own (`requirePartSetting`)
};

/// Parts that share a bed, and settings of the plate that its file states.
struct Plate {
  std::vector<PlatePart> parts;
  std::vector<SettingText> settings;  ///< plate.*
};

/// Reads a plate from a YAML file. Paths of parts are relative to its folder unless they are absolute or name
/// a parametric part.
/// @throws InvalidConfig naming file, line and key; FileError
Plate readPlateFile(const std::string& path);

/// Reads a plate from YAML text, as `readPlateFile`.
/// @param source_name  names the text in errors
/// @param folder       folder to which paths of parts are relative
Plate readPlate(const std::string& yaml, const std::string& source_name, const std::string& folder);

/// A plate with one part from each file.
Plate plateOf(const std::vector<std::string>& files);

/// Checks that a part of a plate may have a setting of its own: settings of the deposition in its layers.
/// Settings of motion, machine, cooling and program belong to the plate.
/// @throws InvalidConfig otherwise, naming the settings that a part may have
void requirePartSetting(const SettingText& setting, const std::string& part);

/// The rotation about the fixed axes x, y, z, in this order.
Eigen::Quaterniond rotationOfDegrees(const Point3& turn_deg);

/// The transform part_from_file that scales and rotates a mesh and puts its bottom at z = 0 and the middle of
/// its bounding box over the origin.
Eigen::Affine3d standing(const Mesh& mesh, const Eigen::Quaterniond& turn, double scale);

/// The mesh with all vertices transformed.
Mesh transformed(Mesh mesh, const Eigen::Affine3d& by);

}  // namespace lamina
