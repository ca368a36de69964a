// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/anchored_starts.hpp"

#include <numeric>

#include "lamina/base/parallel.hpp"
#include "planning/order/support_test.hpp"

namespace lamina {
namespace {

bool laysBeads(const Path& path) { return path.role != PathRole::Travel && path.deposit == Deposit::Bead; }

/// Whether the first path of a layer goes on where the layer before ended.
bool continues(const ToolpathLayer& layer, const ToolpathLayer* before) {
  return before != nullptr && !before->paths.empty() && laysBeads(before->paths.back()) &&
         before->paths.back().lastPoint() == layer.paths.front().firstPoint();
}

std::size_t startsInAir(const ToolpathLayer& layer, bool continues, const SupportTest& support_test) {
  std::size_t count = 0;
  bool is_laying = continues;
  for (const Path& path : layer.paths) {
    const bool is_start = laysBeads(path) && !is_laying;
    if (is_start && !support_test.carries(path.firstPoint().head<2>())) ++count;
    is_laying = laysBeads(path);
  }
  return count;
}

}  // namespace

std::size_t countStartsInAir(const std::vector<Layer>& layers, const std::vector<ToolpathLayer>& toolpath,
                             const BedPlane& bed, double bead_width_mm) {
  std::vector<std::size_t> counts(layers.size(), 0);
  const auto count = [&](std::size_t i) {
    if (toolpath[i].paths.empty()) return;
    const SupportTest support_test(layers[i], i > 0 ? &layers[i - 1] : nullptr, bed,
                                   {bead_width_mm, layers[i].bounds.height()});
    counts[i] =
        startsInAir(toolpath[i], continues(toolpath[i], i > 0 ? &toolpath[i - 1] : nullptr), support_test);
  };
  NoProgress nobody;
  parallelFor(layers.size(), count, nobody, "plan");
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

}  // namespace lamina
