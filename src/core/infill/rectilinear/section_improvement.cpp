// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "infill/least_gain.hpp"
#include "infill/rectilinear/section_order.hpp"

namespace lamina {
namespace {

constexpr std::size_t kWindow = 64;
constexpr int kMostPasses = 8;
constexpr double kRounding = 1e-9;  // mm

/// A tour that is improved move by move. The place before the first visit is the start, the one after the
/// last costs nothing.
class TourImprover {
 public:
  TourImprover(const std::vector<BoustrophedonCell>& sections, const Point2& start, SectionTour tour)
      : sections_(sections), start_(start), tour_(std::move(tour)) {
    ends_.reserve(sections.size());
    for (const BoustrophedonCell& section : sections) {
      Ends& ends = ends_.emplace_back();
      for (std::size_t entry = 0; entry < 4; ++entry) {
        ends.box.include(entryPoint(section, static_cast<SectionEntry>(entry)));
        ends.in[entry] = entryPoint(section, static_cast<SectionEntry>(entry));
        ends.out[entry] = entryPoint(section, exitOf(section, static_cast<SectionEntry>(entry)));
      }
    }
  }

  SectionTour improve() && {
    for (int pass = 0; pass < kMostPasses; ++pass) {
      bool is_better = reenter();
      is_better = turnStretches() || is_better;
      is_better = moveSections() || is_better;
      if (!is_better) break;
    }
    return std::move(tour_);
  }

 private:
  /// Where a section is entered and left, for each entry.
  struct Ends {
    std::array<Point2, 4> in;
    std::array<Point2, 4> out;
    Box2 box;

    bool isFartherThan(double distance_mm, const Point2& point) const {
      const double least = distance_mm + kRounding;
      const Point2 beyond = (box.low - point).cwiseMax(point - box.high).cwiseMax(Point2::Zero());
      return least < 0.0 || beyond.squaredNorm() > least * least;
    }
  };

  const Point2& inPoint(const SectionVisit& visit) const {
    return ends_[visit.section].in[static_cast<std::size_t>(visit.entry)];
  }
  const Point2& outPoint(const SectionVisit& visit) const {
    return ends_[visit.section].out[static_cast<std::size_t>(visit.entry)];
  }
  SectionVisit backwards(const SectionVisit& visit) const {
    return {visit.section, exitOf(sections_[visit.section], visit.entry)};
  }
  /// Where the nozzle stands before visit i.
  const Point2& before(std::size_t i) const { return i == 0 ? start_ : outPoint(tour_[i - 1]); }
  /// From a point on to visit i; nothing after the end.
  double onwards(const Point2& from, std::size_t i) const {
    return i < tour_.size() ? (inPoint(tour_[i]) - from).norm() : 0.0;
  }
  /// Cost of a visit between a point and visit `next`.
  double through(const Point2& from, const SectionVisit& visit, std::size_t next) const {
    return (inPoint(visit) - from).norm() + onwards(outPoint(visit), next);
  }

  bool reenter() {
    bool is_better = false;
    for (std::size_t i = 0; i < tour_.size(); ++i) {
      const SectionVisit best = bestEntry(tour_[i].section, before(i), i + 1);
      if (through(before(i), best, i + 1) >= through(before(i), tour_[i], i + 1) - kLeastGain) continue;
      tour_[i] = best;
      is_better = true;
    }
    return is_better;
  }

  SectionVisit bestEntry(std::size_t section, const Point2& from, std::size_t next) const {
    SectionVisit best{section, SectionEntry::FirstLeft};
    double least = through(from, best, next);
    for (int entry = 1; entry < 4; ++entry) {
      const SectionVisit visit{section, static_cast<SectionEntry>(entry)};
      const double cost = through(from, visit, next);
      if (cost >= least) continue;
      least = cost;
      best = visit;
    }
    return best;
  }

  /// 2-opt: the visits i to j in reverse, each backwards.
  bool turnStretches() {
    bool is_better = false;
    for (std::size_t i = 0; i < tour_.size(); ++i)
      for (std::size_t j = i; j < std::min(tour_.size(), i + kWindow); ++j) {
        const double now = (inPoint(tour_[i]) - before(i)).norm() + onwards(outPoint(tour_[j]), j + 1);
        const double turned = (outPoint(tour_[j]) - before(i)).norm() + onwards(inPoint(tour_[i]), j + 1);
        if (turned >= now - kLeastGain) continue;
        turn(i, j);
        is_better = true;
      }
    return is_better;
  }

  void turn(std::size_t i, std::size_t j) {
    std::reverse(tour_.begin() + static_cast<std::ptrdiff_t>(i),
                 tour_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    for (std::size_t k = i; k <= j; ++k) tour_[k] = backwards(tour_[k]);
  }

  /// Or-opt: one visit to another place, entered wherever is best there.
  bool moveSections() {
    bool is_better = false;
    for (std::size_t i = 0; i < tour_.size(); ++i) is_better |= moveSection(i);
    return is_better;
  }

  bool moveSection(std::size_t i) {
    const Point2 from = before(i);
    const double gain = through(from, tour_[i], i + 1) - onwards(from, i + 1);
    double least = gain - kLeastGain;
    std::size_t place = i;
    SectionVisit moved = tour_[i];
    const std::size_t begin = i > kWindow ? i - kWindow : 0;
    for (std::size_t k = begin; k <= std::min(tour_.size(), i + kWindow); ++k) {
      if (k == i || k == i + 1) continue;
      const double left_out = onwards(before(k), k);
      // However the section is entered there, the way to it is no shorter than that to its box.
      if (ends_[tour_[i].section].isFartherThan(least + left_out, before(k))) continue;
      const SectionVisit best = bestEntry(tour_[i].section, before(k), k);
      const double cost = through(before(k), best, k) - left_out;
      if (cost >= least) continue;
      least = cost;
      place = k;
      moved = best;
    }
    if (place == i) return false;
    tour_.erase(tour_.begin() + static_cast<std::ptrdiff_t>(i));
    tour_.insert(tour_.begin() + static_cast<std::ptrdiff_t>(place > i ? place - 1 : place), moved);
    return true;
  }

  const std::vector<BoustrophedonCell>& sections_;
  Point2 start_;
  SectionTour tour_;
  std::vector<Ends> ends_;
};

}  // namespace

SectionTour improvedTour(const std::vector<BoustrophedonCell>& sections, const Point2& start) {
  return TourImprover(sections, start, tourByEnds(sections, start)).improve();
}

}  // namespace lamina
