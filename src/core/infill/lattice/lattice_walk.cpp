// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/lattice/lattice_walk.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace lamina {
namespace {

using CellIndex = std::uint32_t;
constexpr CellIndex kNone = LatticeTours::kNone;

/// A cell in its place of a walk.
struct Visit {
  CellIndex cell = 0;
  CellIndex next = 0;  ///< visit
  bool is_doubled = false;
};

class WalkBuilder {
 public:
  WalkBuilder(const Lattice& lattice, const LatticeTours& tours)
      : lattice_(lattice),
        tours_(tours),
        stride_(static_cast<CellIndex>(lattice.frame.columns())),
        visit_of_(lattice.size(), kNone) {}

  std::vector<LatticeWalk> build() {
    std::vector<LatticeWalk> walks;
    for (CellIndex cell = 0; cell < lattice_.size(); ++cell)
      if (tours_.visits(cell) && visit_of_[cell] == kNone) add(walkFrom(cell), walks);
    for (CellIndex cell = 0; cell < lattice_.size(); ++cell)
      if (lattice_.isInside(cell) && visit_of_[cell] == kNone) add(walkFromEndNear(cell), walks);
    return walks;
  }

 private:
  static void add(LatticeWalk walk, std::vector<LatticeWalk>& walks) {
    if (walk.cells.size() > 1) walks.push_back(std::move(walk));
  }

  /// Walks the part of the lattice around `root`, breadth first; each tour and cell met hangs on the cell
  /// from which it was met.
  LatticeWalk walkFrom(CellIndex root) {
    visits_.clear();
    queue_.clear();
    has_branch_ = false;
    enter(root);
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const CellIndex cell = queue_[i];
      int children = 0;
      forNeighbours(cell, [&](CellIndex neighbour) {
        if (visit_of_[neighbour] != kNone || !take(cell, neighbour)) return;
        hang(neighbour, cell);
        ++children;
      });
      has_branch_ = has_branch_ || tours_.visits(cell) || children > 1;
    }
    return has_branch_ ? closedWalk() : straightWalk();
  }

  /// A row of single cells is walked from one of its ends, which the cell reached last is.
  LatticeWalk walkFromEndNear(CellIndex cell) {
    std::set<CellIndex> crossed_before = crossed_;
    walkFrom(cell);
    const CellIndex end = queue_.back();
    crossed_ = std::move(crossed_before);
    for (const CellIndex visited : queue_) visit_of_[visited] = kNone;
    return walkFrom(end);
  }

  template <class Use>
  void forNeighbours(CellIndex cell, Use use) const {
    if (lattice_.leadsRight(cell)) use(cell + 1);
    if (lattice_.leadsUp(cell)) use(cell + stride_);
    if (cell % stride_ > 0 && lattice_.leadsRight(cell - 1)) use(cell - 1);
    if (cell >= stride_ && lattice_.leadsUp(cell - stride_)) use(cell - stride_);
    if (lattice_.leadsUpRight(cell)) use(cell + stride_ + 1);
    if (lattice_.leadsUpLeft(cell)) use(cell + stride_ - 1);
    if (cell > stride_ && lattice_.leadsUpRight(cell - stride_ - 1)) use(cell - stride_ - 1);
    if (cell + 1 > stride_ && lattice_.leadsUpLeft(cell - stride_ + 1)) use(cell - stride_ + 1);
  }

  /// Refuses a diagonal step if the other diagonal of its square is walked, which it would cross.
  bool take(CellIndex cell, CellIndex neighbour) {
    const CellIndex low = std::min(cell, neighbour);
    const CellIndex step = std::max(cell, neighbour) - low;
    const bool is_along_row = step == 1 && low % stride_ + 1 < stride_;
    if (is_along_row || step == stride_) return true;
    const CellIndex square = step > stride_ ? low : low - 1;
    return crossed_.insert(square).second;
  }

  CellIndex newVisit(CellIndex cell, CellIndex next, bool is_doubled) {
    visits_.push_back({cell, next, is_doubled});
    return static_cast<CellIndex>(visits_.size() - 1);
  }

  /// Visits the cell, and its whole tour if it has one.
  /// @return the first and the last visit, not yet joined
  std::pair<CellIndex, CellIndex> enter(CellIndex cell) {
    const CellIndex first = newVisit(cell, 0, false);
    visit_of_[cell] = first;
    queue_.push_back(cell);
    CellIndex last = first;
    if (!tours_.visits(cell)) return {first, last};
    CellIndex previous = cell;
    for (CellIndex at = tours_.neighbours[cell][0]; at != cell;) {
      const CellIndex visit = newVisit(at, 0, false);
      visits_[last].next = visit;
      last = visit;
      visit_of_[at] = visit;
      queue_.push_back(at);
      const auto& neighbours = tours_.neighbours[at];
      previous = std::exchange(at, neighbours[0] == previous ? neighbours[1] : neighbours[0]);
    }
    return {first, last};
  }

  /// Inserts a detour from `cell` to `neighbour`, round its tour, and back.
  void hang(CellIndex neighbour, CellIndex cell) {
    const CellIndex visit = visit_of_[cell];
    const CellIndex next = visits_[visit].next;
    const auto [first, last] = enter(neighbour);
    visits_[visit].next = first;
    visits_[first].is_doubled = true;
    const CellIndex back = newVisit(cell, next, true);
    if (tours_.visits(neighbour)) {
      visits_[last].next = newVisit(neighbour, back, false);
    } else {
      visits_[last].next = back;
    }
  }

  /// The visit 0 is the root's; what was met follows it and comes back to it.
  LatticeWalk closedWalk() const {
    LatticeWalk walk;
    walk.is_closed = true;
    for (CellIndex visit = 0; walk.cells.empty() || visit != 0; visit = visits_[visit].next) {
      walk.cells.push_back(visits_[visit].cell);
      walk.is_doubled.push_back(visits_[visit].is_doubled);
    }
    if (walk.cells.size() > 1 && walk.cells.back() == walk.cells.front()) {
      walk.is_doubled.front() = walk.is_doubled.back();
      walk.cells.pop_back();
      walk.is_doubled.pop_back();
    }
    return walk;
  }

  LatticeWalk straightWalk() const {
    LatticeWalk walk;
    walk.cells = queue_;
    walk.is_doubled.assign(queue_.size(), false);
    return walk;
  }

  const Lattice& lattice_;
  const LatticeTours& tours_;
  CellIndex stride_;
  std::set<CellIndex> crossed_;      ///< squares with a diagonal step that is walked, by their low corners
  std::vector<CellIndex> visit_of_;  ///< of each cell the first one, kNone before it
  std::vector<Visit> visits_;
  std::vector<CellIndex> queue_;  ///< cells of this part, in the order met
  bool has_branch_ = false;
};

}  // namespace

std::vector<LatticeWalk> walkLattice(const Lattice& lattice, const LatticeTours& tours) {
  return WalkBuilder(lattice, tours).build();
}

}  // namespace lamina
