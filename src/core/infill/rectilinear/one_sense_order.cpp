// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/one_sense_order.hpp"

#include <limits>

namespace lamina {
namespace {

/// Rows one above the other, beside no others but at both ends.
struct RowChain {
  std::vector<std::size_t> rows;   ///< from below
  std::vector<std::size_t> above;  ///< chains whose first row lies beside the last one
  std::size_t waits_for = 0;       ///< chains below that are not deposited yet
};

/// Which rows of the next line lie beside each row.
std::vector<std::vector<std::size_t>> rowsAbove(const std::vector<RasterRow>& rows, double reach_mm) {
  std::vector<std::vector<std::size_t>> above(rows.size());
  std::size_t first = 0;  // of the next line
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RasterRow& row = rows[i];
    while (first < rows.size() && rows[first].line <= row.line) ++first;
    for (std::size_t j = first; j < rows.size() && rows[j].line == row.line + 1; ++j)
      if (rows[j].left_mm <= row.right_mm + reach_mm && row.left_mm <= rows[j].right_mm + reach_mm)
        above[i].push_back(j);
  }
  return above;
}

class ChainOrder {
 public:
  ChainOrder(const std::vector<RasterRow>& rows, const RowSpacing& spacing) : rows_(rows), spacing_(spacing) {
    makeChains(rowsAbove(rows, spacing.reach_mm));
  }

  std::vector<RowVisit> from(Point2 nozzle) {
    std::vector<RowVisit> order;
    order.reserve(rows_.size());
    std::vector<std::size_t> ready;
    for (std::size_t c = 0; c < chains_.size(); ++c)
      if (chains_[c].waits_for == 0) ready.push_back(c);
    while (!ready.empty()) {
      const Entry next = nearest(ready, nozzle);
      const RowChain& chain = chains_[ready[next.place]];
      ready.erase(ready.begin() + static_cast<std::ptrdiff_t>(next.place));
      bool enters_right = next.enters_right;
      for (const std::size_t row : chain.rows) {
        order.push_back({row, enters_right});
        enters_right = !enters_right;
      }
      nozzle = endOf(chain.rows.back(), enters_right);
      for (const std::size_t c : chain.above)
        if (--chains_[c].waits_for == 0) ready.push_back(c);
    }
    return order;
  }

 private:
  struct Entry {
    std::size_t place = 0;  ///< among those that are ready
    bool enters_right = false;
  };

  void makeChains(const std::vector<std::vector<std::size_t>>& above) {
    std::vector<std::size_t> below_count(rows_.size(), 0);
    for (const std::vector<std::size_t>& rows : above)
      for (const std::size_t row : rows) ++below_count[row];
    std::vector<std::size_t> chain_of(rows_.size(), kNone);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (chain_of[i] != kNone) continue;
      RowChain chain;
      for (std::size_t row = i;; row = above[row].front()) {
        chain.rows.push_back(row);
        chain_of[row] = chains_.size();
        if (above[row].size() != 1 || below_count[above[row].front()] != 1) break;
      }
      chains_.push_back(std::move(chain));
    }
    for (RowChain& chain : chains_)
      for (const std::size_t row : above[chain.rows.back()]) {
        chain.above.push_back(chain_of[row]);
        ++chains_[chain_of[row]].waits_for;
      }
  }

  Point2 endOf(std::size_t row, bool is_right) const {
    return {is_right ? rows_[row].right_mm : rows_[row].left_mm,
            static_cast<double>(rows_[row].line) * spacing_.between_lines_mm};
  }

  Entry nearest(const std::vector<std::size_t>& ready, const Point2& nozzle) const {
    Entry best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t place = 0; place < ready.size(); ++place)
      for (const bool is_right : {false, true}) {
        const double distance = (endOf(chains_[ready[place]].rows.front(), is_right) - nozzle).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = {place, is_right};
      }
    return best;
  }

  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  const std::vector<RasterRow>& rows_;
  RowSpacing spacing_;
  std::vector<RowChain> chains_;
};

}  // namespace

std::vector<RowVisit> orderInOneSense(const std::vector<RasterRow>& rows, const RowSpacing& spacing,
                                      const Point2& from) {
  return ChainOrder(rows, spacing).from(from);
}

}  // namespace lamina
