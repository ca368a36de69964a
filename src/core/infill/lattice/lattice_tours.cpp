// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/lattice/lattice_tours.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <utility>

namespace lamina {
namespace {

using Index = std::uint32_t;

/// Two steps of tours that face each other across a square of the lattice.
struct Flip {
  std::uint64_t distance = 0;  ///< along the Hilbert curve
  Index square = 0;            ///< its low corner
};

class TourBuilder {
 public:
  explicit TourBuilder(const Lattice& lattice)
      : lattice_(lattice),
        columns_(lattice.frame.columns()),
        rows_(lattice.frame.rows()),
        stride_(static_cast<Index>(columns_)),
        sets_(lattice.size()) {
    tours_.neighbours.assign(lattice.size(), {LatticeTours::kNone, LatticeTours::kNone});
  }

  LatticeTours build() {
    makeBlocks(2);
    joinAlongHilbert();
    makeBlocks(1);
    // Each pass can make room for the next; what two passes leave is a handful of cells.
    for (int pass = 0; pass < 2; ++pass) {
      joinFacing();
      takeInPairs();
    }
    joinFacing();
    return std::move(tours_);
  }

 private:
  template <class Visit>
  void forSquares(int step, Visit visit) const {
    for (int row = 0; row + 1 < rows_; row += step)
      for (int column = 0; column + 1 < columns_; column += step)
        visit(static_cast<Index>(lattice_.indexOf({column, row})));
  }

  bool isFree(Index cell) const { return lattice_.isInside(cell) && !tours_.visits(cell); }

  void makeBlocks(int step) {
    forSquares(step, [this](Index low) {
      const Index right = low + 1, up = low + stride_, far = up + 1;
      if (!(isFree(low) && isFree(right) && isFree(up) && isFree(far))) return;
      if (!(lattice_.leadsRight(low) && lattice_.leadsRight(up) && lattice_.leadsUp(low) &&
            lattice_.leadsUp(right)))
        return;
      tours_.neighbours[low] = {right, up};
      tours_.neighbours[right] = {far, low};
      tours_.neighbours[far] = {up, right};
      tours_.neighbours[up] = {low, far};
      for (const Index cell : {right, up, far}) sets_.union_set(low, cell);
    });
  }

  bool areJoined(Index a, Index b) const {
    const auto& neighbours = tours_.neighbours[a];
    return neighbours[0] == b || neighbours[1] == b;
  }

  void replace(Index cell, Index old_neighbour, Index neighbour) {
    auto& neighbours = tours_.neighbours[cell];
    neighbours[neighbours[0] == old_neighbour ? 0 : 1] = neighbour;
  }

  /// Makes one tour of the two whose steps a-b and c-d face each other, by the steps a-c and b-d.
  void flip(Index a, Index b, Index c, Index d) {
    replace(a, b, c);
    replace(b, a, d);
    replace(c, d, a);
    replace(d, c, b);
    sets_.union_set(a, c);
  }

  bool areOfTwoTours(Index a, Index b) { return sets_.find_set(a) != sets_.find_set(b); }

  bool tryFlip(Index low) {
    const Index right = low + 1, up = low + stride_, far = up + 1;
    if (areJoined(low, right) && areJoined(up, far) && lattice_.leadsUp(low) && lattice_.leadsUp(right) &&
        areOfTwoTours(low, up)) {
      flip(low, right, up, far);
      return true;
    }
    if (areJoined(low, up) && areJoined(right, far) && lattice_.leadsRight(low) && lattice_.leadsRight(up) &&
        areOfTwoTours(low, right)) {
      flip(low, up, right, far);
      return true;
    }
    return false;
  }

  std::uint64_t placeOfBlock(Index cell, int level) const {
    const int row = static_cast<int>(cell / stride_);
    const int column = static_cast<int>(cell % stride_);
    return hilbertPlace({column / 2, row / 2}, level);
  }

  void joinAlongHilbert() {
    const int level = hilbertLevel((columns_ + 1) / 2, (rows_ + 1) / 2);
    std::vector<Flip> flips;
    forSquares(1, [&](Index low) {
      if (!tours_.visits(low)) return;
      // The far corner lies in the neighbouring block, whichever side that is on.
      const std::uint64_t a = placeOfBlock(low, level);
      const std::uint64_t b = placeOfBlock(low + stride_ + 1, level);
      flips.push_back({a > b ? a - b : b - a, low});
    });
    std::sort(flips.begin(), flips.end(), [](const Flip& a, const Flip& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.square < b.square;
    });
    for (const Flip& flip : flips) tryFlip(flip.square);
  }

  void joinFacing() {
    forSquares(1, [this](Index low) {
      if (tours_.visits(low) && tours_.visits(low + stride_ + 1)) tryFlip(low);
    });
  }

  /// Leads the tour with the step a-b over the free cells c and d beside it.
  bool tryTakingIn(Index a, Index b, Index c, Index d) {
    if (!(isFree(c) && isFree(d)) || !areJoined(a, b)) return false;
    replace(a, b, c);
    replace(b, a, d);
    tours_.neighbours[c] = {a, d};
    tours_.neighbours[d] = {c, b};
    sets_.union_set(a, c);
    sets_.union_set(a, d);
    return true;
  }

  void takeInPairs() {
    forSquares(1, [this](Index low) {
      const Index right = low + 1, up = low + stride_, far = up + 1;
      if (!(lattice_.leadsRight(low) && lattice_.leadsRight(up) && lattice_.leadsUp(low) &&
            lattice_.leadsUp(right)))
        return;
      tryTakingIn(low, right, up, far) || tryTakingIn(up, far, low, right) ||
          tryTakingIn(low, up, right, far) || tryTakingIn(right, far, low, up);
    });
  }

  const Lattice& lattice_;
  int columns_;
  int rows_;
  Index stride_;
  boost::disjoint_sets_with_storage<> sets_;
  LatticeTours tours_;
};

}  // namespace

LatticeTours makeTours(const Lattice& lattice) { return TourBuilder(lattice).build(); }

}  // namespace lamina
