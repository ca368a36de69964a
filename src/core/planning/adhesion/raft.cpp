// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/adhesion/raft.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "infill/rectilinear/zigzag.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/tools/tool_beads.hpp"

namespace lamina {
namespace {

constexpr double kRaftJoin = 5.0;     // mm, on each side
constexpr double kRaftDensity = 0.5;  // of base and middle layers

}  // namespace

Regions raftArea(const Regions& standing, const RaftSettings& settings) {
  const Regions whole = unite(outlines(standing));
  return offset(offset(offset(whole, kRaftJoin), -kRaftJoin), settings.margin_mm);
}

std::vector<RaftLayer> makeRaft(const Regions& area, const PlanSettings& settings, double part_mm,
                                double layer_height_mm) {
  const RaftSettings& raft = settings.adhesion.raft;
  const int solid_from = std::max(1, raft.layers - raft.top_layers);
  double bottom_mm = part_mm - raft.gap_mm - raft.base_height_mm - (raft.layers - 1) * layer_height_mm;
  const auto shared_area = std::make_shared<const Regions>(area);
  std::vector<RaftLayer> layers;
  for (int i = 0; i < raft.layers; ++i) {
    const double height = i == 0 ? raft.base_height_mm : layer_height_mm;
    AidRuns group;
    group.bead = beadOf(PathRole::Raft, settings, height).bead;
    group.top_mm = bottom_mm + height;
    group.area = shared_area;
    InfillRequest request;
    request.pitch_mm = planWidth(group.bead);
    request.spacing_mm = i < solid_from ? request.pitch_mm / kRaftDensity : request.pitch_mm;
    request.angle_rad = i % 2 == 0 ? 0.0 : 0.5 * M_PI;
    std::vector<FillPath> runs = rasterRuns(offset(area, -0.5 * request.pitch_mm), request);
    for (FillPath& run : runs) run.role = PathRole::Raft;
    group.runs = std::make_shared<const std::vector<FillPath>>(std::move(runs));
    layers.push_back({{bottom_mm, group.top_mm}, {}});
    layers.back().aids.push_back(std::move(group));
    bottom_mm += height;
  }
  return layers;
}

}  // namespace lamina
