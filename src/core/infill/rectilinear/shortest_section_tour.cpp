// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <string>

#include "infill/rectilinear/section_order.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostSections = 12;

/// The best way to have visited a set of sections, the last of them by a given entry.
struct Stage {
  double length = std::numeric_limits<double>::infinity();
  std::size_t previous = 0;  ///< visit number before the last
};

/// Visit number 4 * section + entry.
SectionVisit visitOf(std::size_t number) { return {number / 4, static_cast<SectionEntry>(number % 4)}; }

class SubsetTours {
 public:
  SubsetTours(const std::vector<BoustrophedonCell>& sections, const Point2& start)
      : sections_(sections), start_(start), visits_(4 * sections.size()) {
    stages_.resize((std::size_t{1} << sections.size()) * visits_);
  }

  SectionTour shortest() {
    for (std::size_t v = 0; v < visits_; ++v)
      stage(std::size_t{1} << (v / 4), v) = {(inPoint(v) - start_).norm(), v};
    const std::size_t all = (std::size_t{1} << sections_.size()) - 1;
    for (std::size_t set = 1; set <= all; ++set)
      for (std::size_t last = 0; last < visits_; ++last)
        if (((set >> (last / 4)) & 1U) != 0) extend(set, last);
    return traced(all);
  }

 private:
  Stage& stage(std::size_t set, std::size_t last) { return stages_[set * visits_ + last]; }
  Point2 inPoint(std::size_t number) const {
    return entryPoint(sections_[number / 4], visitOf(number).entry);
  }
  Point2 outPoint(std::size_t number) const {
    const BoustrophedonCell& section = sections_[number / 4];
    return entryPoint(section, exitOf(section, visitOf(number).entry));
  }

  void extend(std::size_t set, std::size_t last) {
    for (std::size_t next = 0; next < visits_; ++next) {
      if (((set >> (next / 4)) & 1U) != 0) continue;
      const double length = stage(set, last).length + (inPoint(next) - outPoint(last)).norm();
      Stage& longer = stage(set | std::size_t{1} << (next / 4), next);
      if (length < longer.length) longer = {length, last};
    }
  }

  SectionTour traced(std::size_t set) {
    std::size_t last = 0;
    for (std::size_t v = 1; v < visits_; ++v)
      if (stage(set, v).length < stage(set, last).length) last = v;
    SectionTour tour;
    while (set != 0) {
      tour.push_back(visitOf(last));
      const std::size_t previous = stage(set, last).previous;
      set &= ~(std::size_t{1} << (last / 4));
      last = previous;
    }
    std::reverse(tour.begin(), tour.end());
    return tour;
  }

  const std::vector<BoustrophedonCell>& sections_;
  Point2 start_;
  std::size_t visits_;
  std::vector<Stage> stages_;  ///< by set and last visit
};

}  // namespace

SectionTour shortestTour(const std::vector<BoustrophedonCell>& sections, const Point2& start) {
  if (sections.size() > kMostSections)
    throw InvalidInput("the shortest tour is asked for " + std::to_string(sections.size()) +
                       " sections; must be at most " + std::to_string(kMostSections));
  if (sections.empty()) return {};
  return SubsetTours(sections, start).shortest();
}

}  // namespace lamina
