// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/deposition/path_follower.hpp"

namespace lamina {

/// Where the nozzle is in the layers of its toolpath.
struct PrintPlace {
  std::size_t layer = 0;     ///< as many as there are at the end
  std::size_t path = 0;      ///< of the layer, travels counted too
  double along_mm = 0.0;     ///< from the start of the path
  bool is_scanning = false;  ///< on a travel after all that the layer deposits, as scan passes are
};

/// Follows the nozzle from layer to layer (`PathFollower`): it never goes back. A layer is over when no more
/// than the tolerance of it is left, so that a machine that waits at its end has ended it.
class LayerProgress {
 public:
  /// @param toolpath  in the frame of the positions; must outlive this
  /// @throws InvalidInput as `validate`
  LayerProgress(const Toolpath& toolpath, const FollowingSettings& settings);

  /// Goes on at the beginning of a layer: the nozzle is looked for from there on, up to the end of the second
  /// layer above, until it is found.
  /// @param layer  as many as there are for the end
  void resume(std::size_t layer);

  /// The place after a report of the nozzle at `tip` [mm].
  const PrintPlace& observe(const Point3& tip);
  const PrintPlace& place() const { return place_; }
  /// Whether the nozzle was seen on the toolpath since its beginning, or since that of the layer it went on
  /// at.
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
