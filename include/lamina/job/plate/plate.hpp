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

/// A part of a plate, as asked for.
struct PlatePart {
  std::string file;                  ///< path of a mesh file, or the name of a parametric part
  std::string name;                  ///< in programs and messages; empty takes that of the file
  std::optional<Point2> at_mm;       ///< of the middle of its box [bed frame]; without, it is arranged
  Point3 turn_deg = Point3::Zero();  ///< about the fixed axes x, y, z, in this order
  double scale = 1.0;
  int copies = 1;
  std::vector<SettingText> settings;  ///< of its own (`requirePartSetting`)
};

/// Parts that share a bed, and settings that the file of the plate gives besides.
struct Plate {
  std::vector<PlatePart> parts;
  std::vector<SettingText> settings;  ///< plate.*
};

/// Reads a plate from YAML. Files of parts are relative to its folder unless they are absolute or name a
/// parametric part.
/// @throws InvalidConfig naming file, line and key; FileError
Plate readPlateFile(const std::string& path);

/// The same from text.
/// @param folder  of relative files
Plate readPlate(const std::string& yaml, const std::string& source_name, const std::string& folder);

/// A plate of files, one part of each.
Plate plateOf(const std::vector<std::string>& files);

/// Settings that a part of a plate may have for itself: what is deposited in its own layers. Motion, machine,
/// cooling and program are those of the plate.
/// @throws InvalidConfig naming those it may have
void requirePartSetting(const SettingText& setting, const std::string& part);

/// How a part is turned: about the fixed axes x, y, z, in this order.
Eigen::Quaterniond turnOf(const Point3& turn_deg);

/// part_from_file of a mesh that is scaled and turned, its bottom at z = 0 and the middle of its box over the
/// origin.
Eigen::Affine3d standing(const Mesh& mesh, const Eigen::Quaterniond& turn, double scale);

Mesh transformed(Mesh mesh, const Eigen::Affine3d& by);

}  // namespace lamina
