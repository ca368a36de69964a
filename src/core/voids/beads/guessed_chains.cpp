// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "lamina/voids/drops/drop_layer.hpp"

namespace lamina {
namespace {

constexpr double kStep = 2.0;       // diameters: drops farther apart are of two chains
constexpr double kReturn = 1.6;     // diameters: a chain that comes so near to its start is closed
constexpr double kLeastHole = 1.2;  // diameters: two rows of a raster that meet at both ends are no hole

struct Loop {
  DropChain chain;
  Polygon outline;
};

/// A chain is closed as soon as it returns, at a greater distance than a step along it.
std::vector<DropChain> splitByDistance(const std::vector<Point2>& drops, double diameter,
                                       std::vector<Loop>& loops) {
  std::vector<DropChain> chains;
  DropChain open;
  for (std::size_t i = 0; i < drops.size(); ++i) {
    if (i > open.begin && (drops[i] - drops[i - 1]).norm() > kStep * diameter) {
      open.end = i;
      chains.push_back(open);
      open.begin = i;
    }
    const bool returns = i >= open.begin + 5 && (drops[i] - drops[open.begin]).norm() < kReturn * diameter &&
                         (i + 1 == drops.size() ||
                          (drops[i + 1] - drops[open.begin]).norm() > (drops[i] - drops[open.begin]).norm());
    if (!returns) continue;
    open.end = i + 1;
    loops.push_back({open,
                     {drops.begin() + static_cast<std::ptrdiff_t>(open.begin),
                      drops.begin() + static_cast<std::ptrdiff_t>(open.end)}});
    open.begin = i + 1;
  }
  open.end = drops.size();
  if (open.end > open.begin) chains.push_back(open);
  return chains;
}

bool isInAnother(const std::vector<Loop>& loops, std::size_t i) {
  for (std::size_t j = 0; j < loops.size(); ++j)
    if (j != i && encloses(loops[j].outline, loops[i].outline.front())) return true;
  return false;
}

bool isRoundNothing(const Loop& loop, const std::vector<Point2>& drops, double diameter) {
  if (2.0 * std::abs(signedArea(loop.outline)) < kLeastHole * diameter * perimeter(loop.outline))
    return false;
  for (std::size_t i = 0; i < drops.size(); ++i)
    if ((i < loop.chain.begin || i >= loop.chain.end) && encloses(loop.outline, drops[i])) return false;
  return true;
}

}  // namespace

std::vector<DropChain> guessChains(const std::vector<Point2>& drops, double diameter_mm) {
  std::vector<Loop> loops;
  std::vector<DropChain> chains = splitByDistance(drops, diameter_mm, loops);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!isInAnother(loops, i) || isRoundNothing(loops[i], drops, diameter_mm))
      loops[i].chain.role = DropRole::Contour;
    chains.push_back(loops[i].chain);
  }
  std::sort(chains.begin(), chains.end(),
            [](const DropChain& a, const DropChain& b) { return a.begin < b.begin; });
  return chains;
}

}  // namespace lamina
