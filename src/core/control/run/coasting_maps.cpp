// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/coasting_maps.hpp"

namespace lamina {

const CorrectionMap& CoastingMaps::give(const HeightLoop& next, const LaidLayer& laid,
                                        const std::string& toolpath_id, const LoopRunSettings& settings) {
  next_ = laid;
  next_->decide(next, LoopState::Coasting, settings);
  CorrectionMap& map = maps_[next.cells().layer];
  map = next_->map(next.cells(), toolpath_id, 0);
  return map;
}

void CoastingMaps::begin(std::size_t layer, LaidLayer& laid) {
  maps_.erase(maps_.begin(), maps_.lower_bound(layer));
  if (next_ && maps_.count(layer) > 0) laid.fallBackOn(*next_);
  next_.reset();
  is_used_ = false;
}

const CorrectionMap* CoastingMaps::of(std::size_t layer) const {
  const auto found = maps_.find(layer);
  return found == maps_.end() ? nullptr : &found->second;
}

}  // namespace lamina
