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

/// How often a part is printed, one after the other along a belt.
struct CopySettings {
  int count = 1;
  double spacing_mm = 10.0;  ///< the belt goes on by so much between one copy's end and the next one's start
};

/// Adds the keys part.copies and part.spacing_mm.
void describe(SettingsSchema& schema, CopySettings& settings);

/// The toolpath as often as asked for, each copy farther along the endless edge of the build space, the belt,
/// by the same way, so that the belt has passed all of a copy when the next one begins. Between copies the
/// belt goes on first, which takes the copy out of the nozzle's reach, then the nozzle goes across. Layers of
/// one copy follow those of another. One copy is the toolpath as it is.
/// @param travel_feed_mm_s  between copies
/// @throws InvalidConfig if there are to be several and the build space has no endless edge
Toolpath withCopies(Toolpath toolpath, const CopySettings& settings, const BuildSpace& space,
                    const Eigen::Isometry3d& bed_from_part, double travel_feed_mm_s);

/// A part among those that a belt printer prints one after the other.
struct BeltPart {
  std::string name;
  const Toolpath* toolpath = nullptr;                               ///< in the frame of the part
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< at the beginning of the belt
};

/// Where such parts stand, farther along the belt than at its beginning: the belt has passed all of a part,
/// and `spacing_mm` more, when the next one begins.
/// @return for each part, the first at zero [bed frame]
/// @throws InvalidConfig if the build space has no endless edge
std::vector<Point3> placesAlongBelt(const std::vector<BeltPart>& parts, double spacing_mm,
                                    const BuildSpace& space);

/// Their toolpath in the frame of the first, each part marked by its name (`PartMark`); in between the nozzle
/// moves as between copies. Their layers must be parallel.
/// @param places             of the parts
/// @param travel_feed_mm_s  between parts
Toolpath oneAfterAnother(const std::vector<BeltPart>& parts, const std::vector<Point3>& places,
                         const BuildSpace& space, double travel_feed_mm_s);

}  // namespace lamina
