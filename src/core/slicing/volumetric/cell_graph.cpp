// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/cell_graph.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/voxel/voxelised_mesh.hpp"

namespace lamina {
namespace {

constexpr std::uint64_t kLowX = 0x1111111111111111;
constexpr std::uint64_t kLowY = 0x000F000F000F000F;
constexpr std::uint64_t kLowZ = 0x000000000000FFFF;
constexpr double kStepBits = 1.0;                 // along a line that is looked along
constexpr std::int64_t kMostCells = 400'000'000;  // of the box around the part

/// Bits of a cell's side, and how far it is to the opposite one.
struct CellSide {
  std::uint64_t low;
  int shift;
};
constexpr std::array<CellSide, 3> kSides = {{{kLowX, 1}, {kLowY, 4}, {kLowZ, 16}}};

std::uint64_t grownOnce(std::uint64_t bits) {
  std::uint64_t grown = bits;
  for (const CellSide& side : kSides) {
    const std::uint64_t high = side.low << (3 * side.shift);
    grown |= (bits & ~high) << side.shift | (bits & ~side.low) >> side.shift;
  }
  return grown;
}

std::uint64_t pieceWith(std::uint64_t seed, std::uint64_t bits) {
  for (;;) {
    const std::uint64_t grown = grownOnce(seed) & bits;
    if (grown == seed) return seed;
    seed = grown;
  }
}

/// Whether bits of a cell touch those of the next one along an axis.
bool touch(std::uint64_t low, std::uint64_t high, std::size_t axis) {
  const CellSide& side = kSides[axis];
  return (low >> (3 * side.shift) & high & side.low) != 0;
}

Point3 middleOf(std::uint64_t bits) {
  if (bits == CellGraph::kFull) return Point3::Constant(0.5);
  Point3 sum = Point3::Zero();
  int count = 0;
  for (int bit = 0; bit < 64; ++bit) {
    if ((bits >> bit & 1U) == 0) continue;
    sum += Eigen::Vector3i(bit % 4, bit / 4 % 4, bit / 16).cast<double>();
    ++count;
  }
  return (sum / count + Point3::Constant(0.5)) / CellGraph::kBits;
}

struct CellPiece {
  std::uint32_t cell;
  std::uint64_t bits;
};

/// The bits of a cell; cell (1, 1, 1) begins with the grid.
std::uint64_t bitsOfCell(const VoxelGrid& grid, const std::array<int, 3>& cell, int lowest_row) {
  const VoxelFrame& frame = grid.frame();
  const int x = CellGraph::kBits * (cell[0] - 1);
  const int y = CellGraph::kBits * (cell[1] - 1);
  const int z = CellGraph::kBits * (cell[2] - 1);
  if (x < 0 || y < 0 || z < 0 || x >= frame.count[0]) return 0;
  std::uint64_t bits = 0;
  for (int k = std::max(0, lowest_row - z); k < CellGraph::kBits && z + k < frame.count[2]; ++k)
    for (int j = 0; j < CellGraph::kBits && y + j < frame.count[1]; ++j) {
      const std::uint64_t word = grid.word(x / VoxelGrid::kWord, y + j, z + k);
      bits |= (word >> (x % VoxelGrid::kWord) & 0xFU) << (4 * j + 16 * k);
    }
  return bits;
}

void requireFew(double cells, double cell_mm) {
  if (cells <= static_cast<double>(kMostCells)) return;
  char count[40];
  std::snprintf(count, sizeof count, "%.0f", cells);
  throw InvalidInput("cells of " + numberText(cell_mm) + " mm fill the part's box by " + count +
                     "; expected at most " + std::to_string(kMostCells) + ": larger ones");
}

}  // namespace

CellGraph::CellGraph(const Mesh& mesh, double cell_mm, double floor_mm, Progress& progress) {
  // Before the part is divided into them, which takes minutes for so many.
  if (!mesh.vertices.empty()) requireFew((boundingBox(mesh).size() / cell_mm).prod(), cell_mm);
  const VoxelGrid grid = voxelisedMesh(mesh, cell_mm / kBits, progress);
  const VoxelFrame& fine = grid.frame();
  frame_.voxel_mm = cell_mm;
  frame_.corner = fine.corner - Point3::Constant(cell_mm);
  for (std::size_t axis = 0; axis < 3; ++axis)
    frame_.count[axis] = (fine.count[axis] + kBits - 1) / kBits + 2;
  requireFew(static_cast<double>(frame_.voxelCount()), cell_mm);
  const double below = (floor_mm - fine.corner.z()) / fine.voxel_mm - 0.5;
  addNodes(grid, std::max(0, static_cast<int>(std::ceil(below))), progress);
  link(progress);
}

std::array<int, 3> CellGraph::placeOf(std::uint32_t cell) const {
  const auto x = static_cast<std::uint32_t>(frame_.count[0]);
  const auto y = static_cast<std::uint32_t>(frame_.count[1]);
  return {static_cast<int>(cell % x), static_cast<int>(cell / x % y), static_cast<int>(cell / x / y)};
}

Point3 CellGraph::corner(std::uint32_t node) const {
  const std::array<int, 3> at = cell(node);
  return frame_.corner + frame_.voxel_mm * Point3(at[0], at[1], at[2]);
}

double CellGraph::volume(std::uint32_t node) const {
  int count = 0;
  for (std::uint64_t rest = bits_[node]; rest != 0; rest &= rest - 1) ++count;
  const double side = bitSide();
  return count * side * side * side;
}

void CellGraph::addNodes(const VoxelGrid& grid, int lowest_row, Progress& progress) {
  std::vector<std::vector<CellPiece>> slabs(static_cast<std::size_t>(frame_.count[2]));
  const auto addSlab = [&](std::size_t k) {
    const auto row = static_cast<std::size_t>(frame_.count[0]);
    for (int j = 0; j < frame_.count[1]; ++j)
      for (int i = 0; i < frame_.count[0]; ++i) {
        std::uint64_t rest = bitsOfCell(grid, {i, j, static_cast<int>(k)}, lowest_row);
        const std::size_t number =
            (k * static_cast<std::size_t>(frame_.count[1]) + static_cast<std::size_t>(j)) * row +
            static_cast<std::size_t>(i);
        while (rest != 0) {
          const std::uint64_t piece = pieceWith(rest & (~rest + 1), rest);
          slabs[k].push_back({static_cast<std::uint32_t>(number), piece});
          rest &= ~piece;
        }
      }
  };
  parallelFor(slabs.size(), addSlab, progress, "field");
  first_.assign(static_cast<std::size_t>(frame_.voxelCount()) + 1, 0);
  for (const std::vector<CellPiece>& slab : slabs)
    for (const CellPiece& piece : slab) {
      ++first_[piece.cell + 1];
      bits_.push_back(piece.bits);
      cell_.push_back(piece.cell);
    }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  middle_.resize(bits_.size());
  for (std::uint32_t node = 0; node < nodeCount(); ++node)
    middle_[node] = corner(node) + frame_.voxel_mm * middleOf(bits_[node]);
}

std::array<std::uint32_t, 2> CellGraph::nodesIn(const std::array<int, 3>& cell) const {
  if (!frame_.contains(cell[0], cell[1], cell[2])) return {0, 0};
  const auto number = (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(frame_.count[1]) +
                       static_cast<std::size_t>(cell[1])) *
                          static_cast<std::size_t>(frame_.count[0]) +
                      static_cast<std::size_t>(cell[0]);
  return {first_[number], first_[number + 1]};
}

/// By nodes that touch one another, one axis after the other.
/// @param offset  of b's cell from a's, -1 to 1 along each axis
bool CellGraph::isJoined(std::uint32_t a, std::uint32_t b, std::array<int, 3> offset) const {
  const int steps = std::abs(offset[0]) + std::abs(offset[1]) + std::abs(offset[2]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (offset[axis] == 0) continue;
    const auto touches = [&](std::uint32_t next) {
      return offset[axis] > 0 ? touch(bits_[a], bits_[next], axis) : touch(bits_[next], bits_[a], axis);
    };
    if (steps == 1) return touches(b);
    std::array<int, 3> between = cell(a);
    between[axis] += offset[axis];
    std::array<int, 3> rest = offset;
    rest[axis] = 0;
    const auto [first, last] = nodesIn(between);
    for (std::uint32_t next = first; next < last; ++next)
      if (touches(next) && isJoined(next, b, rest)) return true;
  }
  return false;
}

void CellGraph::appendLinks(std::uint32_t node, std::vector<std::uint32_t>& links) const {
  const std::array<int, 3> at = cell(node);
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        if (x == 0 && y == 0 && z == 0) continue;
        const auto [first, last] = nodesIn({at[0] + x, at[1] + y, at[2] + z});
        for (std::uint32_t other = first; other < last; ++other)
          if (isJoined(node, other, {x, y, z})) links.push_back(other);
      }
}

void CellGraph::link(Progress& progress) {
  constexpr std::uint32_t kBlock = 4096;
  const std::size_t blocks = (nodeCount() + kBlock - 1) / kBlock;
  std::vector<std::vector<std::uint32_t>> links(blocks);
  link_start_.assign(nodeCount() + std::size_t{1}, 0);
  const auto linkBlock = [&](std::size_t block) {
    const auto begin = static_cast<std::uint32_t>(block * kBlock);
    const std::uint32_t end = std::min(nodeCount(), begin + kBlock);
    for (std::uint32_t node = begin; node < end; ++node) {
      const std::size_t before = links[block].size();
      appendLinks(node, links[block]);
      link_start_[node + 1] = static_cast<std::uint32_t>(links[block].size() - before);
    }
  };
  parallelFor(blocks, linkBlock, progress, "field");
  for (std::size_t i = 1; i < link_start_.size(); ++i) link_start_[i] += link_start_[i - 1];
  links_.reserve(link_start_.back());
  for (std::vector<std::uint32_t>& block : links) {
    links_.insert(links_.end(), block.begin(), block.end());
    block = {};
  }
}

bool CellGraph::areLinked(std::uint32_t a, std::uint32_t b) const {
  const NumberRange of_a = links(a);
  return std::find(of_a.begin(), of_a.end(), b) != of_a.end();
}

std::uint32_t CellGraph::nodeOfBit(int i, int j, int k) const {
  if (i < 0 || j < 0 || k < 0) return kNone;
  const auto [first, last] = nodesIn({i / kBits, j / kBits, k / kBits});
  const int bit = i % kBits + kBits * (j % kBits) + kBits * kBits * (k % kBits);
  for (std::uint32_t node = first; node < last; ++node)
    if ((bits_[node] >> bit & 1U) != 0) return node;
  return kNone;
}

std::uint32_t CellGraph::nodeAt(const Point3& point) const {
  const Point3 at = (point - frame_.corner) / bitSide();
  if (at.minCoeff() < 0.0 || at.maxCoeff() > 1e9) return kNone;
  return nodeOfBit(static_cast<int>(at.x()), static_cast<int>(at.y()), static_cast<int>(at.z()));
}

/// The node at a point that may be reached from another without leaving the part; none if there is not.
std::uint32_t CellGraph::stepTo(std::uint32_t from, const Point3& point) const {
  const std::uint32_t there = nodeAt(point);
  if (there == from || (there != kNone && areLinked(from, there))) return there;
  const Point3 low = (point - frame_.corner) / bitSide() - Point3::Constant(0.5);
  const int i = static_cast<int>(std::floor(low.x()));
  const int j = static_cast<int>(std::floor(low.y()));
  const int k = static_cast<int>(std::floor(low.z()));
  for (int near = 0; near < 8; ++near) {
    const std::uint32_t node = nodeOfBit(i + near % 2, j + near / 2 % 2, k + near / 4);
    if (node == from || (node != kNone && areLinked(from, node))) return node;
  }
  return kNone;
}

bool CellGraph::isClear(const NodePlace& from, const Point3& to) const {
  const Point3 way = to - from.at;
  const int steps = static_cast<int>(std::ceil(way.norm() / (kStepBits * bitSide())));
  std::uint32_t at = from.node;
  for (int step = 1; step < steps; ++step) {
    at = stepTo(at, from.at + way * (static_cast<double>(step) / steps));
    if (at == kNone) return false;
  }
  return true;
}

}  // namespace lamina
