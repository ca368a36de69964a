// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "planning/travel/space_travel.hpp"

namespace lamina {

/// Where a path stands in a toolpath.
struct RunPlace {
  std::size_t layer = 0;
  std::size_t path = 0;
};

/// As errors name it: "layer 12 at 2.4 mm, path 3".
std::string placeText(const Toolpath& toolpath, const RunPlace& place);

/// All paths in the order in which they are run.
std::vector<RunPlace> placesOf(const Toolpath& toolpath);

inline Path& pathAt(Toolpath& toolpath, const RunPlace& place) {
  return toolpath.layers[place.layer].paths[place.path];
}
inline const Path& pathAt(const Toolpath& toolpath, const RunPlace& place) {
  return toolpath.layers[place.layer].paths[place.path];
}

/// Beads that are deposited in one go: they meet in one pose. Indices into the places of a toolpath.
struct RunSpan {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t count() const { return end - begin; }
};

/// Whether a path lays beads of the part: walls, infill and skins, but no ironing.
bool isOfPart(const Path& path);

/// All runs of beads.
std::vector<RunSpan> beadRunsOf(const Toolpath& toolpath, const std::vector<RunPlace>& places);

/// Those that hold a path of the part.
std::vector<RunSpan> runsOf(const Toolpath& toolpath, const std::vector<RunPlace>& places);

/// The travels that lead to a run and away from it.
struct RunTravels {
  Path* before = nullptr;  ///< null where there is none
  Path* after = nullptr;
  bool is_joined = false;  ///< to another path than a travel, before or after
};
RunTravels travelsOf(Toolpath& toolpath, const std::vector<RunPlace>& places, const RunSpan& run);

/// Direction of the first motion that has a length; zero if none has.
Point3 startTangent(const Path& path);
/// The same of the last one.
Point3 endTangent(const Path& path);

/// The travel ends elsewhere and, where the nozzle stands another way there, turned as it. What of it stood
/// above its end, along the tool axis and then along z, stands as far above the new one.
/// @param from  the end that it had
void shiftEnd(Path& travel, const NozzlePose& from, const NozzlePose& to);
/// The same of its start.
void shiftStart(Path& travel, const NozzlePose& from, const NozzlePose& to);

}  // namespace lamina
