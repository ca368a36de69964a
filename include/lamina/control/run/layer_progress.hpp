// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/deposition/path_follower.hpp"

namespace lamina {

/// The position of the nozzle in its toolpath.
struct PrintPlace {
  std::size_t layer = 0;     ///< number; that of layers once all are done
  std::size_t path = 0;      ///< number in the layer, travels included
  double along_mm = 0.0;     ///< from the start of the path
  bool is_scanning = false;  ///< on a travel after the layer's last deposition, as scan passes are
};

/// Follows the nozzle along its toolpath (`PathFollower`), never backwards. A layer ends when at most the
/// tolerance is left of it, so that a machine that waits at its end has ended it.
class LayerProgress {
 public:
  /// @param toolpath  in the frame of the positions; must outlive this
  /// @throws InvalidInput as `validate`
  LayerProgress(const Toolpath& toolpath, const FollowingSettings& settings);

  /// Restarts at the beginning of a layer. Until the nozzle is found it is searched for from there to the end
  /// of the second layer above.
  /// @param layer  number; that of layers for the end
  void resume(std::size_t layer);

  /// The place after a report of the nozzle at `tip` [mm].
  const PrintPlace& observe(const Point3& tip);
  const PrintPlace& place() const { return place_; }
  /// Whether the nozzle was found on the toolpath since the start, or since `resume`.
  bool isFound() const { return is_found_; }

  /// Whether a layer ends with a travel that may be a scan pass.
  bool hasScan(std::size_t layer) const { return layers_[layer].scan < layers_[layer].paths; }
  /// Whether any layer does.
  bool hasScans() const;

 private:
  struct Span {
    std::size_t first = 0;  ///< path, through all layers
    std::size_t paths = 0;
    std::size_t scan = 0;  ///< path of the layer from which on nothing is deposited; `paths` if there is none
    double end_mm = 0.0;   ///< length of the toolpath up to its end
  };

  double alongPath(const PathPlace& at);
  void locate(const PathPlace& at);

  PathFollower follower_;
  double tolerance_mm_;
  std::vector<Span> layers_;
  std::vector<double> start_mm_;  ///< length of the toolpath up to each path
  PrintPlace place_;
  bool is_found_ = false;
  PathPlace begun_;           ///< where it is looked for from
  PathPlace measured_;        ///< motion up to which `measured_mm_` is
  double measured_mm_ = 0.0;  ///< from the start of its path
};

}  // namespace lamina
