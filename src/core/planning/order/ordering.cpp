// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/ordering.hpp"

#include <algorithm>
#include <utility>

#include "planning/order/end_grid.hpp"

namespace lamina {
namespace {

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
      : runs_(runs), order_(order), from_(from) {}

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

  bool tryReversing(std::size_t i, std::size_t j) {
    const double now = onward(before(i), i) + onward(end(j), j + 1);
    const double then = (end(j) - before(i)).norm() + onward(start(i), j + 1);
    if (then > now - kLeastGain) return false;
    const auto first = order_.begin() + static_cast<std::ptrdiff_t>(i);
    const auto last = order_.begin() + static_cast<std::ptrdiff_t>(j) + 1;
    std::reverse(first, last);
    for (auto it = first; it != last; ++it) it->is_reversed = !it->is_reversed;
    return true;
  }

  /// Moves run i behind run j, turned round if that is shorter.
  bool tryMoving(std::size_t i, std::size_t j) {
    if (i == j) return false;
    const double now = onward(before(i), i) + onward(end(i), i + 1) + onward(end(j), j + 1);
    const double closed = onward(before(i), i + 1);
    const double kept = closed + (start(i) - end(j)).norm() + onward(end(i), j + 1);
    const double turned = closed + (end(i) - end(j)).norm() + onward(start(i), j + 1);
    if (std::min(kept, turned) > now - kLeastGain) return false;
    if (turned < kept) order_[i].is_reversed = !order_[i].is_reversed;
    const auto first = order_.begin() + static_cast<std::ptrdiff_t>(i);
    std::rotate(first, first + 1, order_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    return true;
  }

  const std::vector<RunEnds>& runs_;
  std::vector<OrderedRun>& order_;
  Point2 from_;
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
