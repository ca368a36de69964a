// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/coasting_maps.hpp"

#include <utility>
#include <vector>

#include "lamina/control/feeder_lead.hpp"

namespace lamina {
namespace {

/// By what is predicted of the layer under way: what it will show of itself is not known yet.
ExpectedBeginning expectedOf(const HeightLoop& next, LaidLayer laid, const LoopRunSettings& settings) {
  if (!(settings.loop.dead_time_s > 0.0)) return {};
  laid.decide(next, laid.state(), settings);
  std::vector<double> amounts;
  amounts.reserve(next.cells().size());
  for (const PathCorrection& path : laid.map(next.cells(), {}, 1).paths)
    for (const PointCorrection& place : path.stations) amounts.push_back(place.amount);
  amounts.resize(next.cells().size(), 0.0);
  return expectedBeginning(next.cells(), amounts, settings.loop.dead_time_s);
}

}  // namespace

const CorrectionMap& CoastingMaps::give(const HeightLoop& next, const LaidLayer& laid,
                                        const std::string& toolpath_id, const LoopRunSettings& settings) {
  ahead_ = expectedOf(next, laid, settings);
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
  ahead_ = {};
  is_used_ = false;
}

CorrectionMap CoastingMaps::withAhead(CorrectionMap map) const {
  map.ahead = ahead_;
  return map;
}

const CorrectionMap* CoastingMaps::of(std::size_t layer) const {
  const auto found = maps_.find(layer);
  return found == maps_.end() ? nullptr : &found->second;
}

}  // namespace lamina
