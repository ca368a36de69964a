// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/wall_strand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh/wall_normals.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "slicing/adapted/curve_places.hpp"
#include "slicing/adapted/mesh_region.hpp"

namespace lamina {
namespace {

constexpr double kSteepestWall = 89.0;  // deg: caps of the part are not taken for walls

std::string inMm(double value) {
  std::string text = std::to_string(value);
  return text.substr(0, text.size() - 3) + " mm";
}

/// The least number of points in between that keep the spacing, evenly spread.
std::vector<Point3> spaced(const Polygon& outline, double z, double step_mm) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point2& from = outline[i];
    const Point2 along = outline[(i + 1) % outline.size()] - from;
    const double pieces = std::max(1.0, std::ceil(along.norm() / step_mm - 1e-9));
    for (double piece = 0.0; piece < pieces; ++piece) {
      const Point2 point = from + piece / pieces * along;
      points.emplace_back(point.x(), point.y(), z);
    }
  }
  return points;
}

WallContour contourOf(const Polygon& outline, double z, double step_mm, const WallNormals& normals) {
  WallContour contour{spaced(outline, z, step_mm), {}};
  contour.axis.reserve(contour.points.size());
  for (const Point3& point : contour.points) {
    const Point3 normal = normals.at(point);
    contour.axis.push_back((Point3::UnitZ() - normal.z() * normal).normalized());
  }
  return contour;
}

/// For each loop of a level the wall it belongs to, given the loops of the walls below; empty if they do
/// not go one to one.
std::vector<std::size_t> wallsOf(const std::vector<Polygon>& loops, const std::vector<Polygon>& below) {
  if (loops.size() != below.size()) return {};
  if (loops.size() == 1) return {0};
  std::vector<std::unique_ptr<CurvePlaces>> places;
  places.reserve(below.size());
  for (const Polygon& loop : below)
    places.push_back(
        std::make_unique<CurvePlaces>(spaced(loop, 0.0, std::numeric_limits<double>::max()), true));
  std::vector<std::size_t> walls;
  std::vector<bool> is_taken(below.size(), false);
  for (const Polygon& loop : loops) {
    std::size_t nearest = below.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t w = 0; w < below.size(); ++w) {
      if ((signedArea(loop) > 0.0) != (signedArea(below[w]) > 0.0)) continue;
      const double distance = places[w]->nearest({loop[0].x(), loop[0].y(), 0.0}).distance_mm;
      if (distance < least) nearest = w;
      least = std::min(least, distance);
    }
    if (nearest == below.size() || is_taken[nearest]) return {};
    is_taken[nearest] = true;
    walls.push_back(nearest);
  }
  return walls;
}

std::string loopsText(std::size_t count) { return std::to_string(count) + (count == 1 ? " loop" : " loops"); }

/// What becomes of the walls from one height to the next, where they are not the same one by one.
std::string changeBetween(std::size_t below, std::size_t above) {
  if (above > below) return "a wall splits or begins";
  return above < below ? "walls merge or end" : "walls change places";
}

/// The loops of each height in the order of the walls they belong to.
std::vector<std::vector<Polygon>> loopsByWall(const Mesh& mesh, std::vector<Section> sections,
                                              const std::vector<double>& heights) {
  std::vector<std::vector<Polygon>> ordered;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    std::vector<Polygon>& loops = sections[k].contours;
    if (!sections[k].open_contours.empty())
      throw InvalidMesh("the contour at z = " + inMm(heights[k]) +
                        " is open; adapted layers need a closed mesh");
    if (loops.empty())
      throw InvalidMesh("there is no contour at z = " + inMm(heights[k]) + "; expected one loop per wall");
    if (k == 0) {
      ordered.push_back(std::move(loops));
      continue;
    }
    const std::vector<std::size_t> walls = wallsOf(loops, ordered.back());
    if (walls.empty())
      throw Unsliceable(changeBetween(ordered.back().size(), loops.size()) +
                            " between z = " + inMm(heights[k - 1]) + " (" + loopsText(ordered.back().size()) +
                            ") and z = " + inMm(heights[k]) + " (" + loopsText(loops.size()) +
                            "); adapted layers need walls that go from the bottom to the top one by one",
                        facesBetween(mesh, heights[k - 1], heights[k]));
    std::vector<Polygon> in_order(loops.size());
    for (std::size_t i = 0; i < loops.size(); ++i) in_order[walls[i]] = std::move(loops[i]);
    ordered.push_back(std::move(in_order));
  }
  return ordered;
}

}  // namespace

std::vector<WallStrand> wallStrands(const Mesh& mesh, const std::vector<double>& heights, double step_mm,
                                    Progress& progress) {
  const std::vector<std::vector<Polygon>> loops =
      loopsByWall(mesh, sliceMesh(mesh, heights, progress), heights);
  const WallNormals normals(mesh, Point3::UnitZ(), kSteepestWall);
  std::vector<WallStrand> strands(loops.front().size());
  for (WallStrand& strand : strands) strand.levels.resize(heights.size());
  parallelFor(
      heights.size(),
      [&](std::size_t k) {
        for (std::size_t w = 0; w < strands.size(); ++w)
          strands[w].levels[k] = contourOf(loops[k][w], heights[k], step_mm, normals);
      },
      progress, "adapt");
  return strands;
}

}  // namespace lamina
