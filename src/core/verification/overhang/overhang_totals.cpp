// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "lamina/verification/overhang/overhang.hpp"

namespace lamina {
namespace {

bool isWall(PathRole role) { return kindOf(role) == RoleKind::Wall; }

}  // namespace

const char* toString(StretchKind kind) { return kind == StretchKind::Bridge ? "bridge" : "overhang"; }

OverhangTotals totals(const OverhangReport& report) {
  OverhangTotals sums;
  for (std::size_t i = 0; i < report.layers.size(); ++i) {
    const LayerOverhang& layer = report.layers[i];
    sums.all.deposited_mm += layer.deposited_mm;
    sums.all.overhang_mm += layer.overhang_mm;
    sums.all.bridge_mm += layer.bridge_mm;
    sums.all.starts_in_air += layer.starts_in_air;
    const double worst = sums.worst_layer ? report.layers[*sums.worst_layer].unsupported() : 0.0;
    if (layer.unsupported() > worst) sums.worst_layer = i;
  }
  for (const UnsupportedStretch& stretch : report.stretches) {
    const bool is_bridge = stretch.kind == StretchKind::Bridge;
    if (isWall(stretch.role)) sums.in_walls_mm += stretch.length_mm;
    ++(is_bridge ? sums.bridges : sums.overhangs);
    double& longest = is_bridge ? sums.longest_bridge_mm : sums.longest_overhang_mm;
    longest = std::max(longest, stretch.length_mm);
  }
  return sums;
}

std::vector<UnsupportedStretch> longest(const OverhangReport& report, StretchKind kind, std::size_t count) {
  std::vector<const UnsupportedStretch*> found;
  for (const UnsupportedStretch& stretch : report.stretches)
    if (stretch.kind == kind) found.push_back(&stretch);
  std::stable_sort(found.begin(), found.end(), [](const UnsupportedStretch* a, const UnsupportedStretch* b) {
    return a->length_mm > b->length_mm;
  });
  found.resize(std::min(count, found.size()));
  std::vector<UnsupportedStretch> chosen;
  std::transform(found.begin(), found.end(), std::back_inserter(chosen),
                 [](const UnsupportedStretch* stretch) { return *stretch; });
  return chosen;
}

}  // namespace lamina
