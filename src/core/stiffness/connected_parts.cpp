// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness/connected_parts.hpp"

#include <algorithm>
#include <numeric>

namespace lamina {
namespace {

/// Which things have become one.
class Union {
 public:
  explicit Union(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  std::int32_t root(std::int32_t of) {
    while (parent_[std::size_t(of)] != of) {
      parent_[std::size_t(of)] = parent_[std::size_t(parent_[std::size_t(of)])];
      of = parent_[std::size_t(of)];
    }
    return of;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<std::int32_t> parent_;
};

/// Joins the runs of two rows that have a face in common.
void joinRows(const ElementLattice& lattice, int row, int other, Union& runs) {
  const ElementRun* const first = lattice.elementsBegin(0);
  const ElementRun* b = lattice.elementsBegin(other);
  for (const ElementRun* a = lattice.elementsBegin(row); a != lattice.elementsEnd(row); ++a) {
    while (b != lattice.elementsEnd(other) && b->begin + b->count <= a->begin) ++b;
    for (const ElementRun* c = b; c != lattice.elementsEnd(other) && c->begin < a->begin + a->count; ++c)
      runs.join(std::int32_t(a - first), std::int32_t(c - first));
  }
}

void joinPieces(const ElementLattice& lattice, int row, Union& runs) {
  const ElementRun* const first = lattice.elementsBegin(0);
  for (const ElementRun* a = lattice.elementsBegin(row); a != lattice.elementsEnd(row); ++a)
    if (a + 1 != lattice.elementsEnd(row) && a->begin + a->count == (a + 1)->begin)
      runs.join(std::int32_t(a - first), std::int32_t(a + 1 - first));
}

bool reaches(const std::array<int, 3>& low, const std::array<int, 3>& high, const HeldNodes& held) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (low[axis] > held.high[axis] || high[axis] < held.low[axis]) return false;
  return true;
}

void include(const std::array<int, 3>& low, const std::array<int, 3>& high,
             const std::vector<HeldNodes>& held, ConnectedPart& part) {
  if (part.elements == 0) {
    part.low = low;
    part.high = high;
    part.reaches.resize(held.size());
  }
  part.elements += high[0] - low[0];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    part.low[axis] = std::min(part.low[axis], low[axis]);
    part.high[axis] = std::max(part.high[axis], high[axis]);
  }
  for (std::size_t i = 0; i < held.size(); ++i)
    if (reaches(low, high, held[i])) part.reaches[i] = true;
}

Union joinedRuns(const ElementLattice& lattice) {
  const std::array<int, 3>& count = lattice.count();
  Union runs(lattice.runCount());
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j) {
      const int row = lattice.elementRow(j, k);
      joinPieces(lattice, row, runs);
      if (j > 0) joinRows(lattice, row, lattice.elementRow(j - 1, k), runs);
      if (k > 0) joinRows(lattice, row, lattice.elementRow(j, k - 1), runs);
    }
  return runs;
}

}  // namespace

bool ConnectedPart::reachesAll() const {
  return std::all_of(reaches.begin(), reaches.end(), [](bool is_reached) { return is_reached; });
}

ConnectedParts connectedParts(const ElementLattice& lattice, const std::vector<HeldNodes>& held) {
  Union runs = joinedRuns(lattice);
  ConnectedParts connected;
  std::vector<std::int32_t> part_of_root(lattice.runCount(), -1);
  const std::array<int, 3>& count = lattice.count();
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j) {
      const int row = lattice.elementRow(j, k);
      for (const ElementRun* run = lattice.elementsBegin(row); run != lattice.elementsEnd(row); ++run) {
        const auto number = static_cast<std::int32_t>(run - lattice.elementsBegin(0));
        std::int32_t& part = part_of_root[std::size_t(runs.root(number))];
        if (part < 0) {
          part = static_cast<std::int32_t>(connected.parts.size());
          connected.parts.emplace_back();
        }
        connected.part_of_run.push_back(part);
        include({run->begin, j, k}, {run->begin + run->count, j + 1, k + 1}, held,
                connected.parts[std::size_t(part)]);
      }
    }
  return connected;
}

}  // namespace lamina
