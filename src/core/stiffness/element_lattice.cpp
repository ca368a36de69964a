// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/element_lattice.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::int64_t kMostNodes = std::numeric_limits<std::int32_t>::max();

/// Runs that overlap or touch become one.
void joinRuns(std::vector<NodeSpan>& runs) {
  std::sort(runs.begin(), runs.end(), [](const NodeSpan& a, const NodeSpan& b) { return a.begin < b.begin; });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    NodeSpan& last = runs[kept];
    if (runs[i].begin > last.end())
      runs[++kept] = runs[i];
    else
      last.count = std::max(last.end(), runs[i].end()) - last.begin;
  }
  if (!runs.empty()) runs.resize(kept + 1);
}

}  // namespace

ElementLattice::ElementLattice(const std::array<int, 3>& count) : count_(count) {}

ElementLattice::ElementLattice(const VoxelGrid& grid, const VoxelRange& range) {
  for (std::size_t axis = 0; axis < 3; ++axis) count_[axis] = range.high[axis] - range.low[axis];
  std::vector<float> densities(static_cast<std::size_t>(count_[0]));
  for (int k = 0; k < count_[2]; ++k)
    for (int j = 0; j < count_[1]; ++j) {
      for (int i = 0; i < count_[0]; ++i)
        densities[std::size_t(i)] =
            grid.isSolid(range.low[0] + i, range.low[1] + j, range.low[2] + k) ? 1.0F : 0.0F;
      addRow(densities);
    }
  numberNodes();
}

ElementLattice ElementLattice::coarsened(const ElementLattice& fine) {
  const auto half = [](int n) { return (n + 1) / 2; };
  ElementLattice coarse({half(fine.count_[0]), half(fine.count_[1]), half(fine.count_[2])});
  std::vector<float> densities(static_cast<std::size_t>(coarse.count_[0]));
  for (int k = 0; k < coarse.count_[2]; ++k)
    for (int j = 0; j < coarse.count_[1]; ++j) {
      std::fill(densities.begin(), densities.end(), 0.0F);
      for (int child = 0; child < 4; ++child) {
        const int fine_j = 2 * j + child % 2;
        const int fine_k = 2 * k + child / 2;
        if (fine_j >= fine.count_[1] || fine_k >= fine.count_[2]) continue;
        const int row = fine.elementRow(fine_j, fine_k);
        for (const ElementRun* run = fine.elementsBegin(row); run != fine.elementsEnd(row); ++run)
          for (std::int32_t i = 0; i < run->count; ++i)
            densities.data()[(run->begin + i) / 2] += 0.125F * fine.density_.data()[run->column + i];
      }
      coarse.addRow(densities);
    }
  coarse.numberNodes();
  return coarse;
}

ElementLattice ElementLattice::withRuns(const std::vector<bool>& is_kept) const {
  ElementLattice made(count_);
  std::vector<float> densities(static_cast<std::size_t>(count_[0]));
  for (int row = 0; row < count_[1] * count_[2]; ++row) {
    std::fill(densities.begin(), densities.end(), 0.0F);
    for (const ElementRun* run = elementsBegin(row); run != elementsEnd(row); ++run)
      if (is_kept[static_cast<std::size_t>(run - elementsBegin(0))])
        std::copy_n(density_.begin() + run->column, run->count, densities.begin() + run->begin);
    made.addRow(densities);
  }
  made.numberNodes();
  return made;
}

void ElementLattice::addRow(const std::vector<float>& densities) {
  const auto size = static_cast<std::int32_t>(densities.size());
  for (std::int32_t i = 0; i < size; ++i) {
    if (densities[std::size_t(i)] == 0.0F) continue;
    ElementRun run;
    run.begin = i;
    run.column = static_cast<std::int32_t>(density_.size());
    while (i < size && densities[std::size_t(i)] > 0.0F && run.count < kLongestRun) {
      density_.push_back(densities[std::size_t(i++)]);
      ++run.count;
    }
    --i;
    density_.push_back(0.0F);
    elements_ += run.count;
    element_runs_.push_back(run);
  }
  if (static_cast<std::int64_t>(density_.size()) > kMostNodes)
    throw InvalidInput("more than " + std::to_string(kMostNodes) + " elements; must be fewer");
  element_row_.push_back(static_cast<std::int32_t>(element_runs_.size()));
}

void ElementLattice::numberNodes() {
  std::int64_t nodes = 0;
  std::vector<NodeSpan> runs;
  for (int k = 0; k <= count_[2]; ++k)
    for (int j = 0; j <= count_[1]; ++j) {
      runs.clear();
      for (int around = 0; around < 4; ++around) {
        const int row_j = j - around % 2;
        const int row_k = k - around / 2;
        if (row_j < 0 || row_k < 0 || row_j >= count_[1] || row_k >= count_[2]) continue;
        const int row = elementRow(row_j, row_k);
        for (const ElementRun* run = elementsBegin(row); run != elementsEnd(row); ++run)
          runs.push_back({run->begin, run->count + 1, 0});
      }
      joinRuns(runs);
      for (NodeSpan& run : runs) {
        run.node = static_cast<std::int32_t>(nodes);
        nodes += run.count;
        node_runs_.push_back(run);
      }
      node_row_.push_back(static_cast<std::int32_t>(node_runs_.size()));
      if (nodes > kMostNodes)
        throw InvalidInput("more than " + std::to_string(kMostNodes) + " nodes; must be fewer");
    }
  nodes_ = static_cast<std::int32_t>(nodes);
  for (int k = 0; k < count_[2]; ++k)
    for (int j = 0; j < count_[1]; ++j) {
      const auto row = std::size_t(elementRow(j, k));
      for (std::int32_t r = element_row_[row]; r < element_row_[row + 1]; ++r)
        for (std::size_t corner = 0; corner < 4; ++corner) {
          ElementRun& run = element_runs_[std::size_t(r)];
          run.node[corner] = nodeAt(run.begin, j + int(corner % 2), k + int(corner / 2));
        }
    }
}

std::int32_t ElementLattice::nodeAt(int i, int j, int k) const {
  if (j < 0 || k < 0 || j > count_[1] || k > count_[2]) return -1;
  const int row = nodeRow(j, k);
  const NodeSpan* after = std::upper_bound(nodesBegin(row), nodesEnd(row), i,
                                           [](int at, const NodeSpan& run) { return at < run.begin; });
  if (after == nodesBegin(row)) return -1;
  const NodeSpan& run = *(after - 1);
  return i < run.end() ? run.node + (i - run.begin) : -1;
}

std::size_t ElementLattice::bytes() const {
  return element_row_.size() * sizeof(element_row_[0]) + element_runs_.size() * sizeof(ElementRun) +
         node_row_.size() * sizeof(node_row_[0]) + node_runs_.size() * sizeof(NodeSpan) +
         density_.size() * sizeof(density_[0]);
}

}  // namespace lamina
