// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "planning/travel/space_travel.hpp"

namespace lamina {

/// Position of a path in a toolpath: its layer and index.
struct RunPlace {
  std::size_t layer = 0;
  std::size_t path = 0;
};

/// The position as error messages state it: "layer 12 at 2.4 mm, path 3".
std::string placeText(const Toolpath& toolpath, const RunPlace& place);

/// All paths in the order in which they are run.
std::vector<RunPlace> placesOf(const Toolpath& toolpath);

inline Path& pathAt(Toolpath& toolpath, const RunPlace& place) {
  return toolpath.layers[place.layer].paths[place.path];
}
inline const Path& pathAt(const Toolpath& toolpath, const RunPlace& place) {
  return toolpath.layers[place.layer].paths[place.path];
}

/// A run: consecutive beads that meet in one pose and so are deposited without interruption, as a range of
/// indices into the places of a toolpath.
struct RunSpan {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t count() const { return end - begin; }
};

/// Whether a path deposits beads of the part: walls, infill or skins, but not ironing.
bool isOfPart(const Path& path);

/// All runs of beads.
std::vector<RunSpan> beadRunsOf(const Toolpath& toolpath, const std::vector<RunPlace>& places);

/// The runs that have a path of the part.
std::vector<RunSpan> runsOf(const Toolpath& toolpath, const std::vector<RunPlace>& places);

/// The travels that lead to a run and away from it.
struct RunTravels {
  Path* before = nullptr;  ///< null if there is none
  Path* after = nullptr;
  bool is_joined = false;  ///< whether the run meets a path other than a travel, before or after
};
RunTravels travelsOf(Toolpath& toolpath, const std::vector<RunPlace>& places, const RunSpan& run);

/// Direction of the first motion that has a length; zero if none has.
Point3 startTangent(const Path& path);
/// Direction of the last motion that has a length; zero if none has.
Point3 endTangent(const Path& path);

/// Moves the end of a travel to another pose. If the orientation differs, the points above the old end, along
/// the tool axis and then along z, are placed equally far above the new end along its own axis.
/// @param from  the end before
/// @param to    the end afterwards
void shiftEnd(Path& travel, const NozzlePose& from, const NozzlePose& to);
/// Moves the start of a travel, as `shiftEnd` moves the end.
void shiftStart(Path& travel, const NozzlePose& from, const NozzlePose& to);

}  // namespace lamina
