// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/section_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {
namespace {

constexpr std::array<SectionEntry, 4> kEntries = {SectionEntry::FirstLeft, SectionEntry::FirstRight,
                                                  SectionEntry::LastLeft, SectionEntry::LastRight};

const std::array<Point2, 2>& lineAt(const BoustrophedonCell& section, SectionEntry entry) {
  return static_cast<int>(entry) < 2 ? section.first : section.last;
}

Point2 midpointAt(const BoustrophedonCell& section, SectionEntry entry) {
  const std::array<Point2, 2>& line = lineAt(section, entry);
  return 0.5 * (line[0] + line[1]);
}

/// The sense of [Flores2018, figure 50]: a section begins at the left of its first line, or is the reverse of
/// that.
SectionEntry documentedEntry(const BoustrophedonCell& section, bool is_from_last) {
  return is_from_last ? exitOf(section, SectionEntry::FirstLeft) : SectionEntry::FirstLeft;
}

/// The ends of all sections, those of a section after each other in the order of the entries.
PointGrid gridOfEnds(const std::vector<BoustrophedonCell>& sections) {
  if (sections.empty()) return PointGrid({Point2::Zero(), Point2::Zero()}, 1.0);
  Box2 box;
  for (const BoustrophedonCell& section : sections)
    for (const SectionEntry entry : kEntries) box.include(entryPoint(section, entry));
  const double across = std::max(1.0, (box.high - box.low).maxCoeff());
  PointGrid grid(box, across / std::sqrt(static_cast<double>(sections.size() + 1)));
  for (const BoustrophedonCell& section : sections)
    for (const SectionEntry entry : kEntries) grid.insert(entryPoint(section, entry));
  return grid;
}

}  // namespace

Point2 entryPoint(const BoustrophedonCell& section, SectionEntry entry) {
  return lineAt(section, entry)[static_cast<std::size_t>(entry) % 2];
}

SectionEntry exitOf(const BoustrophedonCell& section, SectionEntry entry) {
  const int changes_side = static_cast<int>(section.lines % 2);
  return static_cast<SectionEntry>((static_cast<int>(entry) ^ 2) ^ changes_side);
}

double travelLength(const std::vector<BoustrophedonCell>& sections, const SectionTour& tour) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < tour.size(); ++i) {
    const BoustrophedonCell& from = sections[tour[i].section];
    const BoustrophedonCell& to = sections[tour[i + 1].section];
    sum += (entryPoint(to, tour[i + 1].entry) - entryPoint(from, exitOf(from, tour[i].entry))).norm();
  }
  return sum;
}

SectionTour tourAsGiven(const std::vector<BoustrophedonCell>& sections) {
  SectionTour tour;
  for (std::size_t i = 0; i < sections.size(); ++i) tour.push_back({i, SectionEntry::FirstLeft});
  return tour;
}

SectionTour tourByMidpoints(const std::vector<BoustrophedonCell>& sections) {
  SectionTour tour;
  std::vector<bool> is_done(sections.size(), false);
  SectionVisit next{0, SectionEntry::FirstLeft};
  while (tour.size() < sections.size()) {
    tour.push_back(next);
    is_done[next.section] = true;
    const BoustrophedonCell& section = sections[next.section];
    const Point2 from = midpointAt(section, exitOf(section, next.entry));
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sections.size(); ++i) {
      for (const bool is_from_last : {false, true}) {
        const SectionEntry entry = documentedEntry(sections[i], is_from_last);
        const double distance = (midpointAt(sections[i], entry) - from).norm();
        if (is_done[i] || distance >= nearest) continue;
        nearest = distance;
        next = {i, entry};
      }
    }
  }
  return tour;
}

SectionTour tourByEnds(const std::vector<BoustrophedonCell>& sections, const Point2& start) {
  SectionTour tour;
  tour.reserve(sections.size());
  PointGrid ends = gridOfEnds(sections);
  Point2 from = start;
  while (const std::optional<std::uint32_t> nearest = ends.nearest(from)) {
    const SectionVisit next{*nearest / kEntries.size(), kEntries[*nearest % kEntries.size()]};
    tour.push_back(next);
    const std::size_t first = next.section * kEntries.size();
    for (std::size_t i = 0; i < kEntries.size(); ++i) ends.remove(static_cast<std::uint32_t>(first + i));
    const BoustrophedonCell& section = sections[next.section];
    from = entryPoint(section, exitOf(section, next.entry));
  }
  return tour;
}

SectionTour tourOf(const std::vector<BoustrophedonCell>& sections, const Point2& start, SectionOrder order) {
  if (order == SectionOrder::Midpoints) return tourByMidpoints(sections);
  return order == SectionOrder::Ends ? tourByEnds(sections, start) : improvedTour(sections, start);
}

SectionTravels sectionTravels(const std::vector<BoustrophedonCell>& sections, const Point2& start) {
  return {travelLength(sections, tourAsGiven(sections)), travelLength(sections, tourByMidpoints(sections)),
          travelLength(sections, tourByEnds(sections, start)),
          travelLength(sections, improvedTour(sections, start))};
}

}  // namespace lamina
