// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Chooses where the closed loops of one layer start and end.
///
/// Aligned: the vertex nearest to `anchor`, which is the same point for all layers. Rear: the vertex farthest
/// towards +y, of several the one farthest towards +x. Random: anywhere along the loop, by seed and layer.
/// Nearest: the vertex nearest to the position from which the nozzle comes. Corner: an inward corner, which
/// hides the seam in its shadow, else an outward one, of several the one farthest back, else the vertex
/// farthest back. Corners turn by at least 30 deg within 0.5 mm on either side; inward is to the right along
/// the loop, as outlines run anticlockwise and holes clockwise. Back is +y, slightly turned towards +x: of
/// equal corners on a level back edge, all layers choose the same.
///
/// If areas for seams are given, a loop that passes through them starts within them: at the vertex that the
/// rule chooses among those in the areas, or, without such a vertex, in the middle of the longest stretch
/// within.
class Seam {
 public:
  /// @param here  areas for seams, outlives this; null for none
  Seam(const SeamSettings& settings, const Point2& anchor, std::uint64_t layer,
       const Regions* here = nullptr);

  /// The loop, rotated to start at its seam. With Nearest it is unchanged, as the position of the nozzle is
  /// not known yet.
  Polygon placed(Polygon loop);

  /// The loop, starting at its seam for a nozzle that comes from `nozzle`. Only Nearest changes it.
  Polygon approached(Polygon loop, const Point2& nozzle) const;

 private:
  Polygon withVertexHere(Polygon loop) const;
  std::vector<std::size_t> candidates(const Polygon& loop) const;

  SeamPlacement placement_;
  Point2 anchor_;
  Random random_;
  std::vector<Polygon> here_;  ///< borders of the areas for seams; empty for none
};

}  // namespace lamina
