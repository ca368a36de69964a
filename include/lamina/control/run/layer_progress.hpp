// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/deposition/path_follower.hpp"

namespace lamina {

/// The position of the nozzle in its toolpath.
struct PrintPosition {
  std::size_t layer = 0;     ///< number of the layer; the number of layers once all are done
  std::size_t path = 0;      ///< number in the layer, travels included
  double along_mm = 0.0;     ///< from the start of the path
  bool is_scanning = false;  ///< on a travel after the layer's last deposition, as in scan passes
};

/// Follows the nozzle along its toolpath (`PathFollower`), never backwards. A layer ends when the nozzle is
/// within the tolerance of its end, so that it has ended when the machine stops there and waits.
class LayerProgress {
 public:
  /// @param toolpath  in the frame of the positions; must outlive this object
  /// @throws InvalidInput as `validate`
  LayerProgress(const Toolpath& toolpath, const FollowingSettings& settings);

  /// Restarts at the beginning of a layer. Until the nozzle is found it is searched for from there to the end
  /// of the second layer above.
  /// @param layer  number; the number of layers for the end of the toolpath
  void resume(std::size_t layer);

  /// The position in the toolpath, after the nozzle was reported at `tip` [mm].
  const PrintPosition& observe(const Point3& tip);
  const PrintPosition& place() const { return place_; }
  /// Whether the nozzle was found on the toolpath since the start, or since `resume`.
  bool isFound() const { return is_found_; }

  /// Whether a layer ends with a travel that may be a scan pass.
  bool hasScan(std::size_t layer) const { return layers_[layer].scan < layers_[layer].paths; }
  /// Whether any layer ends with such a travel.
  bool hasScans() const;

 private:
  struct Span {
    std::size_t first = 0;  ///< number of its first path, counted through all layers
    std::size_t paths = 0;
    /// Number in the layer of the path from which on nothing is deposited; `paths` if there is none.
    std::size_t scan = 0;
    double end_mm = 0.0;  ///< length of the toolpath up to the end of the layer
  };

  double alongPath(const PathPosition& at);
  void locate(const PathPosition& at);

  PathFollower follower_;
  double tolerance_mm_;
  std::vector<Span> layers_;
  std::vector<double> start_mm_;  ///< length of the toolpath up to each path
  PrintPosition place_;
  bool is_found_ = false;
  PathPosition begun_;        ///< from where on the nozzle is searched for
  PathPosition measured_;     ///< motion up to which `measured_mm_` is measured
  double measured_mm_ = 0.0;  ///< distance from the start of the path of `measured_`
};

}  // namespace lamina
