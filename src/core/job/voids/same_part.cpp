// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/voids/same_part.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "job/modes/wall_contours.hpp"
#include "job/voids/part_placing.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

// In widths of its widest bead: by how much what a layer lays may be wider or narrower than its section.
constexpr double kMostBeads = 3.0;
/// Sections are compared on so many layers.
constexpr std::size_t kComparedSections = 16;

/// The layers that were compared, and what the first one of another part has.
struct Comparison {
  std::size_t compared = 0;
  std::size_t other = 0;
  std::string first;            ///< empty as long as there is none
  bool has_neighbours = false;  ///< whether two differ of which one was compared right after the other
  bool is_last_other = false;

  void add(const std::string& difference) {
    ++compared;
    const bool is_other = !difference.empty();
    if (is_other && other++ == 0) first = difference;
    has_neighbours |= is_other && is_last_other;
    is_last_other = is_other;
  }
  bool areMost() const { return 2 * other > compared; }
};

double widestBead(const ToolpathLayer& layer) {
  double widest_mm = 0.0;
  for (const Path& path : layer.paths)
    if (isPartOfPart(path))
      for (const Bead& bead : path.bead.values()) widest_mm = std::max(widest_mm, bead.width_mm);
  return widest_mm;
}

std::vector<Polyline> beadLines(const ToolpathLayer& layer) {
  std::vector<Polyline> lines;
  for (const Path& path : layer.paths) {
    if (!isPartOfPart(path) || path.points.empty()) continue;
    Polyline& line = lines.emplace_back();
    line.reserve(path.points.size() + 1);
    for (const Point3& point : path.points) line.emplace_back(point.head<2>());
    if (path.is_closed) line.push_back(line.front());
  }
  return lines;
}

double lengthWithin(const std::vector<Polyline>& lines, const Regions& regions) {
  double sum = 0.0;
  for (const Polyline& piece : clipped(lines, regions)) sum += length(piece);
  return sum;
}

double lengthOf(const std::vector<Polyline>& lines) {
  double sum = 0.0;
  for (const Polyline& line : lines) sum += length(line);
  return sum;
}

bool laysDrops(const ToolpathLayer& layer) {
  return std::any_of(layer.paths.begin(), layer.paths.end(),
                     [](const Path& path) { return path.deposit == Deposit::Drops; });
}

/// What the outlines of holes enclose, without the islands in them. What is narrower than twice the reach is
/// left out first: two walls side by side, where a program calls both the outer one, enclose no hole.
Regions holesOf(const Regions& walls, double reach_mm) {
  const Regions regions = offset(offset(walls, -reach_mm), reach_mm);
  std::vector<Polygon> holes;
  for (const Region& region : regions)
    for (Polygon hole : region.holes) {
      std::reverse(hole.begin(), hole.end());
      holes.push_back(std::move(hole));
    }
  return difference(unite(holes), regions);
}

/// How a layer differs from its section; empty if it does not.
std::string differenceOf(const ToolpathLayer& layer, const Regions& walls, const Regions& section) {
  const double width = widestBead(layer);
  const double reach = 0.5 * kMostBeads * width;
  const std::vector<Polyline> lines = beadLines(layer);
  char text[160];
  const double beyond = lengthOf(lines) - lengthWithin(lines, offset(section, reach));
  if (beyond > width) {
    std::snprintf(text, sizeof text, "%.4g mm of beads lie %.4g mm or more outside the part", beyond, reach);
    return text;
  }
  for (const Region& hole : offset(intersection(section, holesOf(walls, reach)), -reach)) {
    if (lengthWithin(lines, {hole}) > width) continue;
    const Box2 box = boundingBox({hole.outer});
    std::snprintf(text, sizeof text,
                  "nothing is deposited in a hole of %.4g x %.4g mm, where the part has material",
                  box.size().x() + 2.0 * reach, box.size().y() + 2.0 * reach);
    return text;
  }
  return {};
}

[[noreturn]] void refuse(const Toolpath& program, const std::string& part, const Comparison& comparison,
                         const std::string& what) {
  throw InvalidInput("'" + program.part_name + "' is no program of the part '" + part +
                     "': " + std::to_string(comparison.other) + " of " + std::to_string(comparison.compared) +
                     " layers are of another " + what + " (" + comparison.first + ")");
}

std::string differenceOfSize(const Box2& deposited, const Box2& cut, double bead_mm) {
  const Point2 size = cut.isEmpty() ? Point2(Point2::Zero()) : Point2(cut.size());
  if ((deposited.size() - size).cwiseAbs().maxCoeff() <= kMostBeads * bead_mm) return {};
  char text[160];
  std::snprintf(text, sizeof text, "%.4g x %.4g mm are deposited, and the part has %.4g x %.4g mm",
                deposited.size().x(), deposited.size().y(), size.x(), size.y());
  return text;
}

std::string inLayer(std::size_t layer, const std::string& difference) {
  return difference.empty() ? difference : "in layer " + std::to_string(layer) + " " + difference;
}

}  // namespace

void requireSameSize(const Toolpath& program, const std::vector<Regions>& sections, const std::string& part) {
  Comparison comparison;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Box2 deposited = depositedBox(program.layers[i]);
    if (deposited.isEmpty()) continue;
    const Box2 cut = boundingBox(outlines(sections[i]));
    comparison.add(inLayer(i, differenceOfSize(deposited, cut, widestBead(program.layers[i]))));
  }
  if (comparison.areMost())
    refuse(program, part, comparison, "size; expected the part that it lays, at its scale");
}

std::string requireSameSections(const Toolpath& program, const std::vector<Regions>& sections,
                                const std::string& part) {
  Comparison comparison;
  const std::size_t step = 1 + sections.size() / (kComparedSections + 1);
  for (std::size_t i = 0; i < sections.size(); i += step) {
    const ToolpathLayer& layer = program.layers[i];
    if (depositedBox(layer).isEmpty() || laysDrops(layer)) continue;
    comparison.add(inLayer(i, differenceOf(layer, wallContour(layer), sections[i])));
  }
  // A step of the part that a program was cut just beside makes one layer differ, and not the next.
  if (comparison.areMost() || comparison.has_neighbours)
    refuse(program, part, comparison, "section; expected the part that it lays, where it lays it");
  return comparison.first;
}

}  // namespace lamina
