// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness/lattice_transfer.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>

#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

/// A row of values by their place along x, of which only those of nodes mean something.
using Row = std::vector<float>;
using Rows = tbb::enumerable_thread_specific<Row>;

void addScaled(const float* from, std::int32_t count, float weight, float* to) {
  for (std::int32_t i = 0; i < count; ++i) to[i] += weight * from[i];
}

/// Adds a row of nodes, times `weight`.
void spread(const ElementLattice& lattice, int row, float weight, const std::vector<float>& values, Row& to) {
  for (const NodeSpan* run = lattice.nodesBegin(row); run != lattice.nodesEnd(row); ++run)
    addScaled(values.data() + run->node, run->count, weight, to.data() + run->begin);
}

/// Between which coarse rows a fine row lies: one of them twice if it lies on it.
struct Between {
  int low;
  int high;
};
Between between(int fine) { return {fine / 2, (fine + 1) / 2}; }

/// Calls body(j, k) for each row of nodes, at the same time.
template <class Body>
void forNodeRows(const ElementLattice& lattice, const Body& body) {
  const int rows = lattice.count()[1] + 1;
  parallelFor(std::size_t(lattice.count()[2]) + 1, [&](std::size_t layer) {
    const int k = static_cast<int>(layer);
    for (int j = 0; j < rows; ++j)
      if (lattice.nodesBegin(lattice.nodeRow(j, k)) != lattice.nodesEnd(lattice.nodeRow(j, k))) body(j, k);
  });
}

void interpolateRow(const ElementLattice& lattice, int row, const Row& coarse, std::vector<float>& fine) {
  for (const NodeSpan* run = lattice.nodesBegin(row); run != lattice.nodesEnd(row); ++run) {
    float* to = fine.data() + run->node;
    for (std::int32_t i = 0; i < run->count; ++i) {
      const Between x = between(run->begin + i);
      to[i] += 0.5F * (coarse[std::size_t(x.low)] + coarse[std::size_t(x.high)]);
    }
  }
}

/// Fine rows around a coarse one and what they weigh.
struct Share {
  int row;
  float weight;
};
std::array<Share, 3> sharesOf(int coarse) {
  return {Share{2 * coarse - 1, 0.5F}, Share{2 * coarse, 1.0F}, Share{2 * coarse + 1, 0.5F}};
}

}  // namespace

void addInterpolated(const ElementLattice& coarse_lattice, const NodeField<float>& coarse,
                     const ElementLattice& fine_lattice, NodeField<float>& fine) {
  Rows rows([&] { return Row(std::size_t(coarse_lattice.count()[0] + 1)); });
  forNodeRows(fine_lattice, [&](int j, int k) {
    Row& row = rows.local();
    const Between y = between(j);
    const Between z = between(k);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::fill(row.begin(), row.end(), 0.0F);
      for (const int coarse_k : {z.low, z.high})
        for (const int coarse_j : {y.low, y.high})
          spread(coarse_lattice, coarse_lattice.nodeRow(coarse_j, coarse_k), 0.25F, coarse.along[axis], row);
      interpolateRow(fine_lattice, fine_lattice.nodeRow(j, k), row, fine.along[axis]);
    }
  });
}

void gatherForces(const ElementLattice& fine_lattice, const NodeField<float>& fine,
                  const ElementLattice& coarse_lattice, NodeField<float>& coarse) {
  const std::array<int, 3>& count = fine_lattice.count();
  // One place more at either end, so that every coarse node finds both neighbours.
  Rows rows([&] { return Row(std::size_t(2 * coarse_lattice.count()[0] + 3)); });
  forNodeRows(coarse_lattice, [&](int j, int k) {
    Row& row = rows.local();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::fill(row.begin(), row.end(), 0.0F);
      for (const Share& z : sharesOf(k))
        for (const Share& y : sharesOf(j)) {
          if (y.row < 0 || z.row < 0 || y.row > count[1] || z.row > count[2]) continue;
          const int from = fine_lattice.nodeRow(y.row, z.row);
          // Place 1 of the row is node 0.
          for (const NodeSpan* run = fine_lattice.nodesBegin(from); run != fine_lattice.nodesEnd(from); ++run)
            addScaled(fine.along[axis].data() + run->node, run->count, y.weight * z.weight,
                      row.data() + run->begin + 1);
        }
      const int to = coarse_lattice.nodeRow(j, k);
      for (const NodeSpan* run = coarse_lattice.nodesBegin(to); run != coarse_lattice.nodesEnd(to); ++run) {
        float* force = coarse.along[axis].data() + run->node;
        const float* at = row.data() + std::ptrdiff_t{2} * run->begin + 1;
        for (std::int32_t i = 0; i < run->count; ++i, at += 2) force[i] = at[0] + 0.5F * (at[-1] + at[1]);
      }
    }
  });
}

GivenNodes givenOnCoarse(const ElementLattice& fine_lattice, const GivenNodes& given,
                         const ElementLattice& coarse_lattice) {
  GivenNodes coarse;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t next = 0;
    const auto& nodes = given[axis];
    for (int k = 0; k <= fine_lattice.count()[2]; ++k)
      for (int j = 0; j <= fine_lattice.count()[1]; ++j) {
        const int row = fine_lattice.nodeRow(j, k);
        for (const NodeSpan* run = fine_lattice.nodesBegin(row); run != fine_lattice.nodesEnd(row); ++run)
          for (; next < nodes.size() && nodes[next] < run->node + run->count; ++next) {
            const Between x = between(run->begin + nodes[next] - run->node);
            const Between y = between(j);
            const Between z = between(k);
            for (const int c : {z.low, z.high})
              for (const int b : {y.low, y.high})
                for (const int a : {x.low, x.high}) coarse[axis].push_back(coarse_lattice.nodeAt(a, b, c));
          }
      }
    std::sort(coarse[axis].begin(), coarse[axis].end());
    coarse[axis].erase(std::unique(coarse[axis].begin(), coarse[axis].end()), coarse[axis].end());
  }
  return coarse;
}

}  // namespace lamina
