// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "lamina/infill/strategy.hpp"
#include "lamina/voids/drops/drop_layer.hpp"
#include "support/fill_requests.hpp"

namespace lamina::test {

/// `side` by `side` drops of a square lattice of pitch 1, the middle one at the origin if `side` is odd.
inline std::vector<Point2> squareLattice(int side) {
  std::vector<Point2> drops;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) drops.emplace_back(x - side / 2, y - side / 2);
  return drops;
}

/// Place of a hexagonal lattice of pitch 1, (0, 0) at the origin: i steps along x, j rows up.
inline Point2 hexSite(int i, int j) { return {i + 0.5 * j, 0.5 * std::sqrt(3.0) * j}; }

/// The drops of a hexagonal lattice within a square of that half side.
inline std::vector<Point2> hexLattice(double half) {
  std::vector<Point2> drops;
  for (int j = -40; j <= 40; ++j)
    for (int i = -60; i <= 60; ++i)
      if (hexSite(i, j).cwiseAbs().maxCoeff() <= half) drops.push_back(hexSite(i, j));
  return drops;
}

/// The drops without those at the places.
inline std::vector<Point2> without(std::vector<Point2> drops, const std::vector<Point2>& places) {
  const auto is_removed = [&](const Point2& drop) {
    return std::any_of(places.begin(), places.end(),
                       [&](const Point2& place) { return (place - drop).norm() < 1e-6; });
  };
  drops.erase(std::remove_if(drops.begin(), drops.end(), is_removed), drops.end());
  return drops;
}

/// A layer of drops of diameter 1 within a border through these corners. The corners have drops of their own,
/// as the layer's contour.
inline DropLayer layerWithin(const Polygon& border, const std::vector<Point2>& infill) {
  DropLayer layer;
  layer.diameter_mm = 1.0;
  layer.drops = border;
  layer.drops.insert(layer.drops.end(), infill.begin(), infill.end());
  layer.chains = {{DropRole::Contour, 0, border.size()},
                  {DropRole::Infill, border.size(), layer.drops.size()}};
  return layer;
}

/// The layer that a strategy fills with drops.
inline DropLayer filledLayer(const std::string& strategy, const Regions& regions, double diameter,
                             double angle = 0.0) {
  DropLayer layer;
  layer.diameter_mm = diameter;
  layer.is_dense = strategy == "drops_dense";
  for (const FillPath& path : infillStrategy(strategy).fill(regions, requestOf(diameter, angle))) {
    const std::size_t begin = layer.drops.size();
    layer.drops.insert(layer.drops.end(), path.points.begin(), path.points.end());
    layer.chains.push_back(
        {path.role == PathRole::Infill ? DropRole::Infill : DropRole::Contour, begin, layer.drops.size()});
  }
  return layer;
}

}  // namespace lamina::test
