// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/job/plate/plate_settings.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The toolpath of a part, and its position on the plate.
struct PlateToolpath {
  std::string name;
  const Toolpath* toolpath = nullptr;  ///< [frame of the part's layers]
  Point3 at = Point3::Zero();  ///< position of the part's origin [bed frame, turned as the layers are]
};

/// The toolpaths of all parts, layer by layer [bed frame, turned as the layers are]. Layers of the same
/// height become one layer; others are sorted by the height of their tops. Within a layer the tool in use
/// comes first, then the others by number, and with each tool the nozzle continues at the nearest part.
/// Travels between the layers of a part are made anew. Before another part begins, the last path ends with
/// the `PartMark` of that part, so that the retraction before the travel to it counts as its own.
Toolpath mergedByLayer(const std::vector<PlateToolpath>& parts, const TravelSettings& travel);

/// The parts one after the other, in the order of these indices; in between the nozzle rises above all parts.
Toolpath partAfterPart(const std::vector<PlateToolpath>& parts, const std::vector<std::size_t>& order,
                       const TravelSettings& travel);

/// Adds before the first layer what lies round all parts: a prime line along an edge of the bed, and a skirt,
/// loops around the first layers of all parts.
/// @param bed  where the nozzle may be
/// @throws InvalidConfig if the prime line has no room
void addRoundParts(Toolpath& plate, const std::vector<PlateToolpath>& parts, const PlanSettings& settings,
                   const Box2& bed);

/// A part as it is reported to hosts.
struct LabelledPart {
  std::string name;
  Polygon outline;  ///< [bed frame]
};

/// Adds the commands by which a host or firmware can leave out a part, at the part marks: a list of the parts
/// at the start, and the end of the last part at the end.
void addLabels(Toolpath& plate, const std::vector<LabelledPart>& parts, ObjectLabels labels);

}  // namespace lamina
