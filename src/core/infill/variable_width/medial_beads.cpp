// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/medial_beads.hpp"

#include "infill/variable_width/axis_loops.hpp"
#include "infill/variable_width/bead_axis.hpp"
#include "infill/variable_width/skeleton_beads.hpp"
#include "infill/variable_width/skeleton_paths.hpp"

namespace lamina {
std::vector<FillPath> medialBeads(const Regions& regions, const MedialBeadSettings& settings) {
  requirePitch(settings);
  std::vector<FillPath> runs;
  for (const Region& region : regions)
    for (const SkeletonPath& skeleton_path : skeletonPathsOf(beadAxis(region, settings)))
      appendTo(runs, skeletonBeads(skeleton_path, settings));
  return runs;
}

std::vector<FillPath> medialLoops(const Regions& regions, const MedialBeadSettings& settings) {
  requirePitch(settings);
  std::vector<FillPath> runs;
  for (const Region& region : regions) appendTo(runs, axisLoops(beadAxis(region, settings), region));
  return runs;
}

}  // namespace lamina
