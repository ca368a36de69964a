// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/program/corrected_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// Places from one end of a stretch to the other between which the correction is linear, and changes by no
/// more than a split.
std::vector<double> linearNodes(const PathCorrection& correction, const DepositedStretch& stretch,
                                double split_change) {
  const double step = correction.spacing_mm;
  std::vector<double> coarse{stretch.from_mm};
  const double first = std::max(0.0, std::floor(stretch.from_mm / step - 0.5));
  for (auto i = static_cast<std::size_t>(std::min(first, 1e15)); i < correction.stations.size(); ++i) {
    const double station = (static_cast<double>(i) + 0.5) * step;
    if (station >= stretch.to_mm) break;
    if (station > stretch.from_mm) coarse.push_back(station);
  }
  coarse.push_back(stretch.to_mm);
  std::vector<double> nodes{coarse.front()};
  for (std::size_t i = 1; i < coarse.size(); ++i) {
    const double change =
        std::abs(correctionAt(correction, coarse[i]).amount - correctionAt(correction, coarse[i - 1]).amount);
    const double parts = std::max(1.0, std::ceil(change / split_change - 1e-9));
    for (double k = 1.0; k <= parts; k += 1.0)
      nodes.push_back(coarse[i - 1] + (coarse[i] - coarse[i - 1]) * k / parts);
  }
  return nodes;
}

}  // namespace

void CorrectionsByPath::add(const CorrectionMap& map) {
  validate(map);
  const std::size_t layer = map.layer;
  if (!maps_.try_emplace(layer, map).second)
    throw InvalidInput("two correction maps are of layer " + std::to_string(layer) +
                       "; expected one a layer");
}

void CorrectionsByPath::replace(const CorrectionMap& map) {
  validate(map);
  maps_[map.layer] = map;
}

const PathCorrection* CorrectionsByPath::find(std::size_t layer, std::size_t path) const {
  const auto map = maps_.find(layer);
  if (map == maps_.end()) return nullptr;
  const std::vector<PathCorrection>& paths = map->second.paths;
  const auto found =
      std::lower_bound(paths.begin(), paths.end(), path,
                       [](const PathCorrection& each, std::size_t sought) { return each.path < sought; });
  return found == paths.end() || found->path != path ? nullptr : &*found;
}

std::vector<CorrectedPiece> correctedPieces(const PathCorrection& correction, const DepositedStretch& stretch,
                                            double split_change) {
  const double length = stretch.to_mm - stretch.from_mm;
  if (!(length > 0.0)) {
    const PointCorrection here = correctionAt(correction, stretch.to_mm);
    return {{1.0, here, here.dz_mm}};
  }
  const std::vector<double> nodes = linearNodes(correction, stretch, split_change);
  std::vector<CorrectedPiece> pieces;
  PointCorrection sum;
  double begin = nodes.front();
  PointCorrection last = correctionAt(correction, begin);
  double first_amount = last.amount;
  const auto close = [&](double end) {
    const double of_piece = end - begin;
    pieces.push_back({of_piece / length,
                      {sum.amount / of_piece, sum.speed / of_piece, sum.dz_mm / of_piece},
                      correctionAt(correction, end).dz_mm});
    sum = {};
    begin = end;
  };
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const PointCorrection next = correctionAt(correction, nodes[i]);
    const bool changes = std::abs(next.amount - first_amount) > split_change * (1.0 + 1e-9);
    if (changes && nodes[i - 1] > begin) {
      close(nodes[i - 1]);
      first_amount = last.amount;
    }
    const double half = 0.5 * (nodes[i] - nodes[i - 1]);
    sum.amount += half * (last.amount + next.amount);
    sum.speed += half * (last.speed + next.speed);
    sum.dz_mm += half * (last.dz_mm + next.dz_mm);
    last = next;
  }
  close(nodes.back());
  return pieces;
}

}  // namespace lamina
