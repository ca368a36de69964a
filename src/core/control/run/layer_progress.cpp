// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/layer_progress.hpp"

#include <algorithm>

#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

bool deposits(const Path& path) { return path.role != PathRole::Travel; }

/// The path of a layer from which on it only travels; as many as it has where there is none, or no deposit.
std::size_t scanOf(const ToolpathLayer& layer) {
  std::size_t scan = layer.paths.size();
  while (scan > 0 && !deposits(layer.paths[scan - 1])) --scan;
  return scan == 0 ? layer.paths.size() : scan;
}

}  // namespace

LayerProgress::LayerProgress(const Toolpath& toolpath, const FollowingSettings& settings)
    : follower_(toolpath, settings), tolerance_mm_(settings.tolerance_mm) {
  double way_mm = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers) {
    Span span{start_mm_.size(), layer.paths.size(), scanOf(layer), 0.0};
    for (const Path& path : layer.paths) {
      start_mm_.push_back(way_mm);
      way_mm += length(path);
    }
    span.end_mm = way_mm;
    layers_.push_back(span);
  }
  begun_ = follower_.place();
}

bool LayerProgress::hasScans() const {
  return std::any_of(layers_.begin(), layers_.end(),
                     [](const Span& layer) { return layer.scan < layer.paths; });
}

void LayerProgress::resume(std::size_t layer) {
  constexpr std::size_t kLayersAhead = 2;
  place_ = {std::min(layer, layers_.size()), 0, 0.0, false};
  measured_ = {};
  measured_mm_ = 0.0;
  is_found_ = false;
  if (place_.layer == layers_.size()) {
    follower_.begin(start_mm_.size(), 0.0);
    return;
  }
  const double begin_mm = place_.layer == 0 ? 0.0 : layers_[place_.layer - 1].end_mm;
  const Span& last = layers_[std::min(place_.layer + kLayersAhead, layers_.size() - 1)];
  follower_.begin(layers_[place_.layer].first, last.end_mm - begin_mm);
  begun_ = follower_.place();
}

const PrintPosition& LayerProgress::observe(const Point3& tip) {
  const PathPosition at = follower_.observe(tip);
  is_found_ = is_found_ || !(at == begun_);
  locate(at);
  return place_;
}

/// Sums on from where it was last asked for: paths may have a hundred thousand motions.
double LayerProgress::alongPath(const PathPosition& at) {
  const Path& path = *follower_.paths()[at.path];
  if (measured_.path != at.path || measured_.motion > at.motion) {
    measured_ = {at.path, 0, 0.0};
    measured_mm_ = 0.0;
  }
  for (; measured_.motion < at.motion; ++measured_.motion)
    measured_mm_ += motionLength(path, measured_.motion);
  return measured_mm_ + at.fraction * motionLength(path, at.motion);
}

void LayerProgress::locate(const PathPosition& at) {
  const bool is_at_end = at.path >= start_mm_.size();
  const double along = is_at_end ? 0.0 : alongPath(at);
  const double way = is_at_end ? 0.0 : start_mm_[at.path] + along;
  while (place_.layer < layers_.size()) {
    const Span& layer = layers_[place_.layer];
    const bool is_behind = is_at_end || at.path >= layer.first + layer.paths;
    if (!is_behind && layer.end_mm - way > tolerance_mm_) break;
    place_ = {place_.layer + 1, 0, 0.0, false};
  }
  if (is_at_end || place_.layer >= layers_.size()) return;
  const Span& layer = layers_[place_.layer];
  if (at.path < layer.first) return;  // within the tolerance of the layer's beginning
  place_.path = at.path - layer.first;
  place_.along_mm = along;
  place_.is_scanning = place_.path >= layer.scan;
}

}  // namespace lamina
