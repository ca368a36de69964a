// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/growth_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

bool isReached(const ArrivalField& field, std::uint32_t node) { return std::isfinite(field.growth_mm[node]); }

/// Groups of nodes that are joined by links among them, each ascending.
class LinkedGroups {
 public:
  LinkedGroups(const CellGraph& cells, std::vector<std::uint32_t> nodes) : nodes_(std::move(nodes)) {
    parent_.resize(nodes_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (std::size_t a = 0; a < nodes_.size(); ++a)
      for (const std::uint32_t linked : cells.links(nodes_[a])) {
        const auto b = std::lower_bound(nodes_.begin(), nodes_.end(), linked);
        if (b != nodes_.end() && *b == linked) join(a, static_cast<std::size_t>(b - nodes_.begin()));
      }
  }

  std::vector<std::vector<std::uint32_t>> groups() {
    std::vector<std::vector<std::uint32_t>> groups;
    std::vector<std::size_t> number(nodes_.size(), nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const std::size_t root = rootOf(i);
      if (number[root] == nodes_.size()) {
        number[root] = groups.size();
        groups.emplace_back();
      }
      groups[number[root]].push_back(nodes_[i]);
    }
    return groups;
  }

 private:
  std::size_t rootOf(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = rootOf(a);
    b = rootOf(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  std::vector<std::uint32_t> nodes_;
  std::vector<std::size_t> parent_;
};

/// Reached nodes in a box of cells, ascending.
std::vector<std::uint32_t> nodesInBox(const CellGraph& cells, const ArrivalField& field,
                                      const std::array<int, 3>& low, int side) {
  std::vector<std::uint32_t> nodes;
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const auto [first, last] = cells.nodesIn({low[0] + x, low[1] + y, low[2] + z});
        for (std::uint32_t node = first; node < last; ++node)
          if (isReached(field, node)) nodes.push_back(node);
      }
  return nodes;
}

}  // namespace

GrowthLattice::GrowthLattice(const CellGraph& cells, const ArrivalField& field, const GrowthGauge& gauge,
                             Progress& progress)
    : cells_(cells) {
  addNodes(field, gauge);
  addBeside(field, gauge, progress);
  addCubes(field, progress);
}

std::size_t GrowthLattice::numberOf(const std::array<int, 3>& cell) const {
  const VoxelFrame& frame = cells_.frame();
  return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(frame.count[1]) +
          static_cast<std::size_t>(cell[1])) *
             static_cast<std::size_t>(frame.count[0]) +
         static_cast<std::size_t>(cell[0]);
}

void GrowthLattice::addNodes(const ArrivalField& field, const GrowthGauge& gauge) {
  samples_.resize(cells_.nodeCount());
  for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
    GrowthSample& sample = samples_[node];
    const std::array<int, 3> cell = cells_.cell(node);
    sample.at = cells_.frame().centre(cell[0], cell[1], cell[2]);
    sample.node = node;
    sample.growth_mm = field.growth_mm[node];
    if (!isReached(field, node)) continue;
    const GrowthAt there = field.near(sample.at, node, cells_.middle(node), gauge);
    sample.growth_mm = there.growth_mm;
    sample.gradient = there.gradient;
    sample.steepness = there.gradient.norm();
  }
}

std::vector<GrowthLattice::Beside> GrowthLattice::besideCell(const std::array<int, 3>& cell,
                                                             const ArrivalField& field) const {
  const auto [first, last] = cells_.nodesIn(cell);
  if (last == first + 1 && isReached(field, first) && cells_.links(first).size() == 26) return {};
  const std::vector<std::uint32_t> nodes =
      nodesInBox(cells_, field, {cell[0] - 1, cell[1] - 1, cell[2] - 1}, 3);
  if (nodes.empty()) return {};
  std::vector<Beside> beside;
  for (std::vector<std::uint32_t>& group : LinkedGroups(cells_, nodes).groups()) {
    const auto isInside = [first = first, last = last](std::uint32_t node) {
      return node >= first && node < last;
    };
    if (std::none_of(group.begin(), group.end(), isInside))
      beside.push_back({static_cast<std::uint32_t>(numberOf(cell)), std::move(group)});
  }
  return beside;
}

/// From the nodes around it, the nearer the more.
GrowthSample GrowthLattice::carriedOn(const Beside& beside, const ArrivalField& field,
                                      const GrowthGauge& gauge) const {
  GrowthSample sample;
  const VoxelFrame& frame = cells_.frame();
  const int number = static_cast<int>(beside.cell);
  sample.at = frame.centre(number % frame.count[0], number / frame.count[0] % frame.count[1],
                           number / frame.count[0] / frame.count[1]);
  sample.gradient = Point3::Zero();
  sample.steepness = 0.0;
  double weights = 0.0;
  for (const std::uint32_t node : beside.of) {
    const GrowthAt there = field.near(sample.at, node, cells_.middle(node), gauge);
    const double weight = 1.0 / (sample.at - cells_.middle(node)).squaredNorm();
    sample.growth_mm += weight * there.growth_mm;
    sample.gradient += weight * there.gradient;
    sample.steepness += weight * there.gradient.norm();
    weights += weight;
  }
  sample.growth_mm /= weights;
  sample.gradient /= weights;
  sample.steepness /= weights;
  return sample;
}

void GrowthLattice::addBeside(const ArrivalField& field, const GrowthGauge& gauge, Progress& progress) {
  const VoxelFrame& frame = cells_.frame();
  std::vector<std::vector<Beside>> slabs(static_cast<std::size_t>(frame.count[2]));
  const auto addSlab = [&](std::size_t k) {
    for (int j = 0; j < frame.count[1]; ++j)
      for (int i = 0; i < frame.count[0]; ++i)
        for (Beside& beside : besideCell({i, j, static_cast<int>(k)}, field))
          slabs[k].push_back(std::move(beside));
  };
  parallelFor(slabs.size(), addSlab, progress, "layers");
  beside_at_.assign(static_cast<std::size_t>(frame.voxelCount()) + 1, 0);
  for (std::vector<Beside>& slab : slabs)
    for (Beside& beside : slab) {
      ++beside_at_[beside.cell + 1];
      samples_.push_back(carriedOn(beside, field, gauge));
      beside_.push_back(std::move(beside));
    }
  for (std::size_t i = 1; i < beside_at_.size(); ++i) beside_at_[i] += beside_at_[i - 1];
}

/// The sample of a piece of the part in a cell, or beside it.
std::uint32_t GrowthLattice::cornerFor(const std::vector<std::uint32_t>& piece,
                                       const std::array<int, 3>& cell, const ArrivalField& field) const {
  const auto [first, last] = cells_.nodesIn(cell);
  for (const std::uint32_t node : piece)
    if (node >= first && node < last) return node;
  const std::size_t number = numberOf(cell);
  for (std::uint32_t i = beside_at_[number]; i < beside_at_[number + 1]; ++i)
    if (std::binary_search(beside_[i].of.begin(), beside_[i].of.end(), piece.front()))
      return cells_.nodeCount() + i;
  for (std::uint32_t node = first; node < last; ++node)
    if (isReached(field, node)) return node;  // joined farther round
  return CellGraph::kNone;
}

void GrowthLattice::appendCubes(const std::array<int, 3>& cell, const ArrivalField& field,
                                std::vector<GrowthCube>& cubes) const {
  std::vector<std::uint32_t> nodes = nodesInBox(cells_, field, cell, 2);
  if (nodes.empty()) return;
  const auto isFull = [this](std::uint32_t node) { return cells_.bits(node) == CellGraph::kFull; };
  if (nodes.size() == 8 && std::all_of(nodes.begin(), nodes.end(), isFull)) {
    GrowthCube cube;
    cube.cell = cell;
    std::copy(nodes.begin(), nodes.end(), cube.sample.begin());
    return cubes.push_back(cube);
  }
  for (const std::vector<std::uint32_t>& piece : LinkedGroups(cells_, std::move(nodes)).groups()) {
    GrowthCube cube;
    cube.cell = cell;
    bool is_whole = true;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const int at = static_cast<int>(corner);
      cube.sample[corner] =
          cornerFor(piece, {cell[0] + at % 2, cell[1] + at / 2 % 2, cell[2] + at / 4}, field);
      is_whole = is_whole && cube.sample[corner] != CellGraph::kNone;
    }
    if (is_whole) cubes.push_back(cube);
  }
}

void GrowthLattice::addCubes(const ArrivalField& field, Progress& progress) {
  const VoxelFrame& frame = cells_.frame();
  std::vector<std::vector<GrowthCube>> slabs(static_cast<std::size_t>(frame.count[2] - 1));
  const auto addSlab = [&](std::size_t k) {
    for (int j = 0; j + 1 < frame.count[1]; ++j)
      for (int i = 0; i + 1 < frame.count[0]; ++i) appendCubes({i, j, static_cast<int>(k)}, field, slabs[k]);
  };
  parallelFor(slabs.size(), addSlab, progress, "layers");
  cubes_at_.assign(static_cast<std::size_t>(frame.voxelCount()) + 1, 0);
  for (const std::vector<GrowthCube>& slab : slabs)
    for (const GrowthCube& cube : slab) {
      ++cubes_at_[numberOf(cube.cell) + 1];
      cubes_.push_back(cube);
    }
  for (std::size_t i = 1; i < cubes_at_.size(); ++i) cubes_at_[i] += cubes_at_[i - 1];
}

std::array<std::uint32_t, 2> GrowthLattice::cubesAt(const std::array<int, 3>& cell) const {
  if (!cells_.frame().contains(cell[0], cell[1], cell[2])) return {0, 0};
  const std::size_t number = numberOf(cell);
  return {cubes_at_[number], cubes_at_[number + 1]};
}

GrowthSample GrowthLattice::within(const GrowthCube& cube, const Point3& point) const {
  const Point3 part = (point - samples_[cube.sample[0]].at) / cells_.frame().voxel_mm;
  GrowthSample sample;
  sample.gradient = Point3::Zero();
  sample.steepness = 0.0;
  sample.at = point;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const GrowthSample& at = samples_[cube.sample[corner]];
    const double weight = (corner % 2 == 1 ? part.x() : 1.0 - part.x()) *
                          (corner / 2 % 2 == 1 ? part.y() : 1.0 - part.y()) *
                          (corner / 4 == 1 ? part.z() : 1.0 - part.z());
    sample.growth_mm += weight * at.growth_mm;
    sample.gradient += weight * at.gradient;
    sample.steepness += weight * at.steepness;
  }
  return sample;
}

}  // namespace lamina
