// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/layer_batches.hpp"

#include <vector>

#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

constexpr std::size_t kWaypointsAtOnce = 1U << 11;  // some 60 kB of text

std::size_t waypointCount(const ToolpathLayer& layer) {
  std::size_t sum = 0;
  for (const Path& path : layer.paths) sum += path.points.size();
  return sum;
}

/// Index one past the layers, from `begin`, that together have some `kWaypointsAtOnce` waypoints.
std::size_t batchEnd(const Toolpath& toolpath, std::size_t begin) {
  std::size_t waypoints = 0;
  std::size_t end = begin;
  while (end < toolpath.layers.size() && waypoints < kWaypointsAtOnce)
    waypoints += waypointCount(toolpath.layers[end++]);
  return end;
}

}  // namespace

void writeLayers(const Toolpath& toolpath, const AppendLayer& append, const TextSink& sink) {
  std::vector<std::string> texts;
  NoProgress nobody;
  for (std::size_t begin = 0; begin < toolpath.layers.size();) {
    const std::size_t end = batchEnd(toolpath, begin);
    if (texts.size() < end - begin) texts.resize(end - begin);
    const auto write = [&](std::size_t i) {
      texts[i].clear();
      append(begin + i, texts[i]);
    };
    parallelFor(end - begin, write, nobody, "write");
    for (std::size_t i = 0; i < end - begin; ++i) sink(texts[i]);
    begin = end;
  }
}

}  // namespace lamina
