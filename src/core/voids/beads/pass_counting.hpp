// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "voids/beads/bead_spans.hpp"

namespace lamina {

/// Reports how many passes lie on each other along a row.
class PassCounter {
 public:
  /// @param reach_mm  parts of a run no farther apart along it are one pass
  PassCounter(const ToolpathLayer& layer, double reach_mm);

  /// A piece of a row on which the number of passes is the same.
  struct Piece : Span {
    int passes = 0;
  };

  /// Pieces with one pass at least, ascending.
  /// @param spans  of one row, in any order
  std::vector<Piece> count(std::vector<BeadSpan> spans) const;

 private:
  struct Place {
    std::uint32_t run;
    double arc;
  };

  int passesAt(std::vector<Place>& places) const;
  void addPieces(const std::vector<BeadSpan>& active, Span range, std::vector<Piece>& pieces) const;

  double reach_mm_;
  std::vector<double> closed_length_;  ///< of each path of the layer; 0 if it is open
};

}  // namespace lamina
