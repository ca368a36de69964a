// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How many times a part is printed, one copy after the other along a belt.
struct CopySettings {
  int count = 1;
  double spacing_mm = 10.0;  ///< travel of the belt between the end of one copy and the start of the next
};

/// Adds the keys part.copies and part.spacing_mm.
void describe(SettingsSchema& schema, CopySettings& settings);

/// Repeats a toolpath for several copies of its part along the endless edge of the build space (the belt).
/// The distance from copy to copy is such that the belt has passed all of a copy when the next one begins.
/// Between copies first the belt moves, which takes the copy out of the nozzle's reach, then the nozzle moves
/// across. All layers of a copy precede those of the next. For one copy the toolpath is unchanged.
/// @param travel_feed_mm_s  feed of the travels between copies
/// @throws InvalidConfig if several copies are asked for and the build space has no endless edge
Toolpath withCopies(Toolpath toolpath, const CopySettings& settings, const BuildSpace& space,
                    const Eigen::Isometry3d& bed_from_part, double travel_feed_mm_s);

/// A part among those that a belt printer prints one after the other.
struct BeltPart {
  std::string name;
  const Toolpath* toolpath = nullptr;                               ///< in the frame of the part
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< pose at the beginning of the belt
};

/// Places the parts one after the other along the belt: the belt has passed all of a part, and `spacing_mm`
/// more, when the next one begins.
/// @return translation of each part from its pose at the beginning of the belt [bed frame]; zero for the
///   first that deposits, and for parts that deposit nothing, which take no room
/// @throws InvalidConfig if the build space has no endless edge
std::vector<Point3> placesAlongBelt(const std::vector<BeltPart>& parts, double spacing_mm,
                                    const BuildSpace& space);

/// Joins the toolpaths of the parts into one, in the frame of the first part. Each part is marked by its name
/// (`PartMark`); between parts belt and nozzle move as between copies. The layers of all parts must be
/// parallel. Parts that deposit nothing are left out.
/// @param places            as `placesAlongBelt` returns them
/// @param travel_feed_mm_s  feed of the travels between parts
Toolpath oneAfterAnother(const std::vector<BeltPart>& parts, const std::vector<Point3>& places,
                         const BuildSpace& space, double travel_feed_mm_s);

}  // namespace lamina
