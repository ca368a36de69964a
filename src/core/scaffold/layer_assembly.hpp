// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/scaffold/scaffold_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// One deposit of a layer, in the frame of the part's middle [mm].
struct ScaffoldRun {
  Polyline points;
  bool is_closed = false;
  PathRole role = PathRole::Infill;
  /// Section on the way to each point over that of the nominal bead; empty if it is 1 everywhere.
  std::vector<double> section{};
};

/// Height of the top of each layer [mm].
std::vector<double> layerTops(const ScaffoldSettings& settings);

/// The nominal bead of a layer: of a section that fills `fill` of width times height.
Bead scaffoldBead(const ScaffoldSettings& settings, double layer_height_mm, double fill);

/// Puts layers of runs on each other, with travels between them.
class LayerAssembly {
 public:
  /// @param middle  of the part on the bed
  /// @param fill    section of a bead over its width times height
  LayerAssembly(const ScaffoldSettings& settings, const Point2& middle, double fill);

  void add(double top_mm, const std::vector<ScaffoldRun>& runs);
  Toolpath finish(const std::string& part_name);

 private:
  void travelTo(const Point3& start, ToolpathLayer& layer);
  Path path(const ScaffoldRun& run, const ToolpathLayer& layer) const;

  ScaffoldSettings settings_;
  Point2 middle_;
  double fill_;
  Toolpath toolpath_;
};

}  // namespace lamina
