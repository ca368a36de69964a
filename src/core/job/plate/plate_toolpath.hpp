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

/// The toolpath of a part, and where on the plate it stands.
struct PlateToolpath {
  std::string name;
  const Toolpath* toolpath = nullptr;  ///< [frame of the part's layers]
  Point3 at = Point3::Zero();          ///< of the part's origin [bed, turned as the layers are]
};

/// The parts layer by layer, in the frame of the bed, turned as their layers are: layers of one height are
/// one layer, others follow each other by the height of their tops. Within a layer the tool at work comes
/// first, then the others by their numbers, and with each the nozzle goes on to the nearest part. The travels
/// that led from layer to layer of a part are made anew. Where another part begins, the path before ends with
/// its `PartMark`, so that the retraction on the way there is of the part to come.
Toolpath mergedByLayer(const std::vector<PlateToolpath>& parts, const TravelSettings& travel);

/// One part after the other, in that order of indices; in between the nozzle rises above all parts.
Toolpath partAfterPart(const std::vector<PlateToolpath>& parts, const std::vector<std::size_t>& order,
                       const TravelSettings& travel);

/// Lays loops round all that lies in the first layer of any part, before it.
void addSkirt(Toolpath& plate, const std::vector<PlateToolpath>& parts, const PlanSettings& settings);

/// A part as it is reported to hosts.
struct LabelledPart {
  std::string name;
  Polygon outline;  ///< [bed frame]
};

/// Adds the commands by which a host or firmware leaves out a part, where the marks are: which parts there
/// are before all, and the end after all.
void addLabels(Toolpath& plate, const std::vector<LabelledPart>& parts, ObjectLabels labels);

}  // namespace lamina
