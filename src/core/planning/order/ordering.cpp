// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/ordering.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace lamina {
namespace {

/// The ends of runs in square cells, about one run a cell, from which the nearest are taken one after the
/// other.
class EndGrid {
 public:
  /// `runs` must outlive the grid.
  explicit EndGrid(const std::vector<RunEnds>& runs);

  /// The run with an end nearest to the point, entered at that end; of equally near ones the first. It is not
  /// given again. Call at most once per run.
  OrderedRun takeNearest(const Point2& point);

 private:
  struct Candidate {
    double squared_distance;
    std::uint32_t end;
  };

  std::int64_t column(double x) const;
  std::int64_t row(double y) const;
  void searchCell(std::int64_t x, std::int64_t y, const Point2& point, Candidate& best);
  void searchLoop(std::int64_t radius, const Point2& point, Candidate& best);
  const Point2& pointOf(std::uint32_t end) const;

  const std::vector<RunEnds>& runs_;
  Point2 low_;
  double cell_ = 1.0;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
  std::vector<std::uint32_t> begin_;  ///< of each cell in ends_
  std::vector<std::uint32_t> count_;  ///< of each cell's ends that are left
  std::vector<std::uint32_t> ends_;   ///< 2 * run, plus 1 for its last point
  std::vector<bool> is_taken_;
};

EndGrid::EndGrid(const std::vector<RunEnds>& runs) : runs_(runs), is_taken_(runs.size(), false) {
  Box2 box;
  for (const RunEnds& run : runs) {
    box.include(run.first);
    box.include(run.last);
  }
  low_ = box.isEmpty() ? Point2(Point2::Zero()) : box.low;
  const Point2 size = box.size();
  const auto runs_wanted = static_cast<double>(std::max<std::size_t>(1, runs.size()));
  // Square cells, also where all ends lie on a line.
  cell_ = std::max({std::sqrt(size.x() * size.y() / runs_wanted), size.maxCoeff() / runs_wanted, 1e-6});
  columns_ = static_cast<std::int64_t>(size.x() / cell_) + 1;
  rows_ = static_cast<std::int64_t>(size.y() / cell_) + 1;
  const auto cellOf = [this](std::uint32_t end) {
    return static_cast<std::size_t>(row(pointOf(end).y()) * columns_ + column(pointOf(end).x()));
  };
  const auto end_count = static_cast<std::uint32_t>(2 * runs.size());
  count_.assign(static_cast<std::size_t>(columns_ * rows_), 0);
  for (std::uint32_t end = 0; end < end_count; ++end) ++count_[cellOf(end)];
  begin_.assign(count_.size(), 0);
  std::partial_sum(count_.begin(), count_.end() - 1, begin_.begin() + 1);
  std::vector<std::uint32_t> next = begin_;
  ends_.resize(end_count);
  for (std::uint32_t end = 0; end < end_count; ++end) ends_[next[cellOf(end)]++] = end;
}

const Point2& EndGrid::pointOf(std::uint32_t end) const {
  return end % 2 == 0 ? runs_[end / 2].first : runs_[end / 2].last;
}

std::int64_t EndGrid::column(double x) const {
  return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((x - low_.x()) / cell_)), 0,
                                  columns_ - 1);
}

std::int64_t EndGrid::row(double y) const {
  return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((y - low_.y()) / cell_)), 0,
                                  rows_ - 1);
}

void EndGrid::searchCell(std::int64_t x, std::int64_t y, const Point2& point, Candidate& best) {
  const auto cell = static_cast<std::size_t>(y * columns_ + x);
  for (std::uint32_t i = begin_[cell]; i < begin_[cell] + count_[cell];) {
    const std::uint32_t end = ends_[i];
    if (is_taken_[end / 2]) {
      ends_[i] = ends_[begin_[cell] + --count_[cell]];
      continue;
    }
    const double distance = (pointOf(end) - point).squaredNorm();
    if (distance < best.squared_distance || (distance == best.squared_distance && end < best.end))
      best = {distance, end};
    ++i;
  }
}

void EndGrid::searchLoop(std::int64_t radius, const Point2& point, Candidate& best) {
  const std::int64_t x = column(point.x());
  const std::int64_t y = row(point.y());
  const std::int64_t left = std::max<std::int64_t>(0, x - radius);
  const std::int64_t right = std::min(columns_ - 1, x + radius);
  for (const std::int64_t outermost : {y - radius, y + radius}) {
    if (outermost < 0 || outermost >= rows_) continue;
    for (std::int64_t column = left; column <= right; ++column) searchCell(column, outermost, point, best);
  }
  const std::int64_t bottom = std::max<std::int64_t>(0, y - radius + 1);
  const std::int64_t top = std::min(rows_ - 1, y + radius - 1);
  for (const std::int64_t outermost : {x - radius, x + radius}) {
    if (outermost < 0 || outermost >= columns_) continue;
    for (std::int64_t row = bottom; row <= top; ++row) searchCell(outermost, row, point, best);
  }
}

OrderedRun EndGrid::takeNearest(const Point2& point) {
  Candidate best{std::numeric_limits<double>::infinity(), 0};
  const std::int64_t last_loop = std::max(columns_, rows_);
  for (std::int64_t radius = 0; radius <= last_loop; ++radius) {
    // Seen from a point in the middle cell, all of this loop is at least this far away; from one outside the
    // grid even farther.
    const double least = static_cast<double>(radius - 1) * cell_;
    if (radius > 0 && least > 0.0 && least * least > best.squared_distance) break;
    searchLoop(radius, point, best);
  }
  is_taken_[best.end / 2] = true;
  return {best.end / 2, best.end % 2 == 1};
}

constexpr int kMostPasses = 4;
/// How far apart in the order two places may lie that an improvement joins.
constexpr std::size_t kWindow = 32;
/// Gains below this are rounding, and could be undone and redone for ever [mm].
constexpr double kLeastGain = 1e-9;

const Point2& startOf(const std::vector<RunEnds>& runs, const OrderedRun& ordered) {
  return ordered.is_reversed ? runs[ordered.run].last : runs[ordered.run].first;
}

const Point2& endOf(const std::vector<RunEnds>& runs, const OrderedRun& ordered) {
  return ordered.is_reversed ? runs[ordered.run].first : runs[ordered.run].last;
}

std::vector<OrderedRun> nearestNeighbours(const std::vector<RunEnds>& runs, const Point2& from) {
  EndGrid grid(runs);
  std::vector<OrderedRun> order;
  order.reserve(runs.size());
  Point2 nozzle = from;
  while (order.size() < runs.size()) {
    order.push_back(grid.takeNearest(nozzle));
    nozzle = endOf(runs, order.back());
  }
  return order;
}

class Improver {
 public:
  Improver(const std::vector<RunEnds>& runs, std::vector<OrderedRun>& order, const Point2& from)
      : runs_(runs), order_(order), from_(from), links_(order.size() + 1) {
    findLinks(0, order.size());
  }

  void improve() {
    for (int pass = 0; pass < kMostPasses; ++pass)
      if (!improveOnce()) return;
  }

 private:
  bool improveOnce() {
    bool is_better = false;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const std::size_t end = std::min(order_.size(), i + kWindow);
      for (std::size_t j = i; j < end; ++j) is_better |= tryReversing(i, j) || tryMoving(i, j);
    }
    return is_better;
  }

  const Point2& before(std::size_t i) const { return i == 0 ? from_ : endOf(runs_, order_[i - 1]); }
  const Point2& start(std::size_t i) const { return startOf(runs_, order_[i]); }
  const Point2& end(std::size_t i) const { return endOf(runs_, order_[i]); }

  /// Distance from a point to the start of run i; nothing follows the last run.
  double onward(const Point2& point, std::size_t i) const {
    return i < order_.size() ? (start(i) - point).norm() : 0.0;
  }

  /// Of the travels to runs that have changed their places, and to the one behind them.
  void findLinks(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i <= last; ++i) links_[i] = onward(before(i), i);
  }

  // Sums are given up as soon as they are too long: this is what most pairs come to.

  bool tryReversing(std::size_t i, std::size_t j) {
    const double most = links_[i] + links_[j + 1] - kLeastGain;
    const double first_way = (end(j) - before(i)).norm();
    if (first_way > most || first_way + onward(start(i), j + 1) > most) return false;
    const auto first = order_.begin() + static_cast<std::ptrdiff_t>(i);
    const auto last = order_.begin() + static_cast<std::ptrdiff_t>(j) + 1;
    std::reverse(first, last);
    for (auto it = first; it != last; ++it) it->is_reversed = !it->is_reversed;
    findLinks(i, j + 1);
    return true;
  }

  /// Moves run i behind run j, turned round if that is shorter.
  bool tryMoving(std::size_t i, std::size_t j) {
    if (i == j) return false;
    const double most = links_[i] + links_[i + 1] + links_[j + 1] - kLeastGain;
    const double closed = onward(before(i), i + 1);
    if (closed > most) return false;
    double kept = closed + (start(i) - end(j)).norm();
    double turned = closed + (end(i) - end(j)).norm();
    if (std::min(kept, turned) > most) return false;
    kept += onward(end(i), j + 1);
    turned += onward(start(i), j + 1);
    if (std::min(kept, turned) > most) return false;
    if (turned < kept) order_[i].is_reversed = !order_[i].is_reversed;
    const auto first = order_.begin() + static_cast<std::ptrdiff_t>(i);
    std::rotate(first, first + 1, order_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    findLinks(i, j + 1);
    return true;
  }

  const std::vector<RunEnds>& runs_;
  std::vector<OrderedRun>& order_;
  Point2 from_;
  std::vector<double> links_;  ///< length of the travel to each run; 0 behind the last
};

}  // namespace

std::vector<OrderedRun> orderRuns(const std::vector<RunEnds>& runs, const Point2& from) {
  std::vector<OrderedRun> order = nearestNeighbours(runs, from);
  Improver(runs, order, from).improve();
  return order;
}

double travelLength(const std::vector<RunEnds>& runs, const std::vector<OrderedRun>& order,
                    const Point2& from) {
  double sum = 0.0;
  Point2 nozzle = from;
  for (const OrderedRun& ordered : order) {
    sum += (startOf(runs, ordered) - nozzle).norm();
    nozzle = endOf(runs, ordered);
  }
  return sum;
}

}  // namespace lamina
