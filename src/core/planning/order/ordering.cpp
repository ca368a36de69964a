// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/ordering.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "infill/least_gain.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {
namespace {

constexpr double kLeastCell = 1e-6;  // mm

/// The ends of runs, from which the nearest are taken one after the other.
class EndGrid {
 public:
  explicit EndGrid(const std::vector<RunEnds>& runs);

  /// The run with an end nearest to the point, entered at that end; of equally near ones the first. It is not
  /// given again. Call at most once per run.
  OrderedRun takeNearest(const Point2& point);

 private:
  PointGrid ends_;  ///< 2 * run, plus 1 for its last point
};

Box2 boxOfEnds(const std::vector<RunEnds>& runs) {
  Box2 box;
  for (const RunEnds& run : runs) {
    box.include(run.first);
    box.include(run.last);
  }
  return box;
}

/// About one run a cell, also where all ends lie on a line.
double cellFor(const Point2& size, std::size_t runs) {
  const auto cells = static_cast<double>(std::max<std::size_t>(1, runs));
  return std::max({std::sqrt(size.x() * size.y() / cells), size.maxCoeff() / cells, kLeastCell});
}

EndGrid::EndGrid(const std::vector<RunEnds>& runs)
    : ends_(boxOfEnds(runs), cellFor(boxOfEnds(runs).size(), runs.size())) {
  for (const RunEnds& run : runs) {
    ends_.insert(run.first);
    ends_.insert(run.last);
  }
}

OrderedRun EndGrid::takeNearest(const Point2& point) {
  const std::uint32_t end = *ends_.nearest(point);
  ends_.remove(end);
  ends_.remove(end ^ 1U);
  return {end / 2, end % 2 == 1};
}

constexpr int kMostPasses = 4;
/// How far apart in the order two places may lie that an improvement joins.
constexpr std::size_t kWindow = 32;

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
  Improver(const std::vector<RunEnds>& runs, std::vector<OrderedRun>& order, const Point2& from,
           const std::optional<Point2>& to)
      : runs_(runs), order_(order), from_(from), to_(to), links_(order.size() + 1) {
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

  /// Distance from a point to the start of run i, or to what follows the last run.
  double onward(const Point2& point, std::size_t i) const {
    if (i < order_.size()) return (start(i) - point).norm();
    return to_ ? (*to_ - point).norm() : 0.0;
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
  std::optional<Point2> to_;
  std::vector<double> links_;  ///< length of the travel to each run, and to what follows the last
};

}  // namespace

std::vector<OrderedRun> orderRuns(const std::vector<RunEnds>& runs, const Point2& from) {
  return orderRuns(runs, from, std::nullopt);
}

std::vector<OrderedRun> orderRuns(const std::vector<RunEnds>& runs, const Point2& from,
                                  const std::optional<Point2>& to) {
  std::vector<OrderedRun> order = nearestNeighbours(runs, from);
  Improver(runs, order, from, to).improve();
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
