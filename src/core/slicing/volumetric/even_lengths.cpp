// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/even_lengths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace lamina {
namespace {

constexpr std::size_t kSteps = 256;  // in which the way along the field is added up
constexpr double kBandCells = 3.0;
constexpr double kEven = 1e-3;
constexpr int kMostRings = 8;

/// Steepness of a field at nodes, and which nodes' is known.
struct Steepness {
  std::vector<double> length;
  std::vector<char> is_known;
};

/// Neighbours of given nodes have rough gradients too: these nodes take the mean of those farther in.
Steepness steepnessOf(const FieldAlong& field) {
  const std::uint32_t count = field.cells.nodeCount();
  Steepness steepness{std::vector<double>(count, 0.0), std::vector<char>(count, 0)};
  for (std::uint32_t node = 0; node < count; ++node) {
    steepness.length[node] = field.gradient[node].norm();
    const NumberRange links = field.cells.links(node);
    const bool is_inner = field.is_given[node] == 0 &&
                          std::none_of(links.begin(), links.end(),
                                       [&](std::uint32_t near) { return field.is_given[near] != 0; });
    steepness.is_known[node] = static_cast<char>(is_inner && steepness.length[node] > 0.0);
  }
  std::vector<char> is_set = steepness.is_known;
  for (int ring = 0; ring < kMostRings; ++ring) {
    const std::vector<char> before = is_set;
    for (std::uint32_t node = 0; node < count; ++node) {
      if (before[node] != 0) continue;
      double sum = 0.0;
      double near_set = 0.0;
      for (const std::uint32_t near : field.cells.links(node))
        if (before[near] != 0) {
          sum += steepness.length[near];
          near_set += 1.0;
        }
      if (near_set == 0.0) continue;
      steepness.length[node] = sum / near_set;
      is_set[node] = 1;
    }
    if (before == is_set) break;
  }
  return steepness;
}

/// Way along the field [mm] by nodes, from the lowest value; over level surfaces on average.
std::vector<double> waysAlong(const FieldAlong& field, const Steepness& steepness) {
  std::vector<std::uint32_t> order;
  order.reserve(field.cells.nodeCount());
  for (std::uint32_t node = 0; node < field.cells.nodeCount(); ++node)
    if (steepness.length[node] > 0.0) order.push_back(node);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return field.value[a] < field.value[b]; });
  std::vector<double> ways(field.cells.nodeCount(), 0.0);
  double way = 0.0;
  double value = order.empty() ? 0.0 : field.value[order.front()];
  for (std::size_t step = 0; step < kSteps; ++step) {
    const std::size_t first = order.size() * step / kSteps;
    const std::size_t last = order.size() * (step + 1) / kSteps;
    if (first == last) continue;
    double sum = 0.0;
    double whole = 0.0;
    for (std::size_t i = first; i < last; ++i) {
      sum += field.cells.volume(order[i]) * steepness.length[order[i]];
      whole += field.cells.volume(order[i]);
    }
    const double per_mm = sum / whole;
    for (std::size_t i = first; i < last; ++i)
      ways[order[i]] = way + (field.value[order[i]] - value) / per_mm;
    way = ways[order[last - 1]];
    value = field.value[order[last - 1]];
  }
  return ways;
}

/// Bands that overlap by half: each node is in two, and counts in each by how near it is to its middle.
class LevelBands {
 public:
  LevelBands(const FieldAlong& field, const Steepness& steepness)
      : field_(field), steepness_(steepness), place_(waysAlong(field, steepness)) {
    for (double& place : place_) place /= kBandCells * field.cells.frame().voxel_mm;
    for (const int half : {0, 1}) scale_[static_cast<std::size_t>(half)] = scales(half);
  }

  /// By which the field is to be as steep as 1 at a node, by least squares; 0 if that is not known.
  double scaleAt(std::uint32_t node) const {
    double sum = 0.0;
    double weights = 0.0;
    for (const int half : {0, 1}) {
      const double scale = scale_[static_cast<std::size_t>(half)][node];
      if (scale <= 0.0) continue;
      sum += weight(node, half) * scale;
      weights += weight(node, half);
    }
    return weights > 0.0 ? sum / weights : 0.0;
  }

 private:
  /// Bands are two wide; those of one half lie side by side.
  int bandOf(std::uint32_t node, int half) const {
    return static_cast<int>(std::floor(0.5 * (place_[node] + half)));
  }

  double weight(std::uint32_t node, int half) const {
    const double middle = 2.0 * bandOf(node, half) + 1.0 - half;
    return std::max(1e-6, 1.0 - std::abs(place_[node] - middle));
  }

  /// By nodes, of the connected piece of the band of a half in which each is.
  std::vector<double> scales(int half) const {
    std::vector<double> scale(field_.cells.nodeCount(), 0.0);
    std::vector<char> is_seen(field_.cells.nodeCount(), 0);
    std::vector<std::uint32_t> piece;
    for (std::uint32_t start = 0; start < field_.cells.nodeCount(); ++start) {
      if (is_seen[start] != 0 || steepness_.length[start] <= 0.0) continue;
      piece.assign(1, start);
      is_seen[start] = 1;
      double sum = 0.0;
      double squares = 0.0;
      for (std::size_t i = 0; i < piece.size(); ++i) {
        const std::uint32_t node = piece[i];
        if (steepness_.is_known[node] != 0) {
          const double length = steepness_.length[node];
          const double volume = weight(node, half) * field_.cells.volume(node);
          sum += volume * length;
          squares += volume * length * length;
        }
        for (const std::uint32_t near : field_.cells.links(node)) {
          if (is_seen[near] != 0 || steepness_.length[near] <= 0.0) continue;
          if (bandOf(near, half) != bandOf(start, half)) continue;
          is_seen[near] = 1;
          piece.push_back(near);
        }
      }
      for (const std::uint32_t node : piece) scale[node] = squares > 0.0 ? sum / squares : 0.0;
    }
    return scale;
  }

  const FieldAlong& field_;
  const Steepness& steepness_;
  std::vector<double> place_;  // along the field, in thicknesses of half a band
  std::array<std::vector<double>, 2> scale_;
};

}  // namespace

std::vector<double> evenLengths(const FieldAlong& field) {
  const Steepness steepness = steepnessOf(field);
  const LevelBands bands(field, steepness);
  std::vector<double> lengths(field.cells.nodeCount(), 1.0);
  for (std::uint32_t node = 0; node < field.cells.nodeCount(); ++node) {
    const double length = bands.scaleAt(node) * steepness.length[node];
    if (length > 0.0 && std::abs(length - 1.0) > kEven) lengths[node] = length;
  }
  return lengths;
}

}  // namespace lamina
