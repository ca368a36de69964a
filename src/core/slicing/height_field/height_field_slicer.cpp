// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/height_field/height_field_slicer.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/mesh/subdivision.hpp"
#include "lamina/geometry/voxel/height_grid.hpp"
#include "lamina/slicing/height_field/height_field.hpp"
#include "lamina/slicing/height_field/height_field_settings.hpp"
#include "slicing/height_field/layer_alignment.hpp"
#include "slicing/height_field/top_surface.hpp"

namespace lamina {
namespace {

/// Thinnest and thickest of a bent layer where there is material, in layer heights.
struct FactorRange {
  double least = 1.0;
  double greatest = 1.0;
};

/// A bend within its limits, and which part of the asked one it is.
struct LimitedBend {
  HeightField field;
  double share = 1.0;
};

double steepestSlope(const std::vector<double>& factor, const HeightGrid& cells, const TopSurface& top,
                     std::size_t half);

/// Calls visit(half, corners) for each half cell with material.
template <class Visit>
void forMaterial(const HeightGrid& cells, const TopSurface& top, const Visit& visit) {
  for (std::size_t half = 0; half < top.over_half.size(); ++half)
    if (top.over_half[half]) visit(half, cornersOfHalf(cells, half));
}

/// Mean and range of the bend where there is material.
struct BendStatistics {
  double mean = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

BendStatistics statisticsOf(const HeightField& field, const std::vector<double>& log_factor,
                            const TopSurface& top) {
  BendStatistics statistics;
  std::size_t count = 0;
  forMaterial(field.cells, top, [&](std::size_t, const std::array<std::size_t, 3>& corners) {
    for (const std::size_t at : corners) {
      const double value = log_factor[at];
      statistics.mean += value;
      statistics.least = std::min(statistics.least, value);
      statistics.greatest = std::max(statistics.greatest, value);
      ++count;
    }
  });
  statistics.mean /= static_cast<double>(std::max<std::size_t>(count, 1));
  return statistics;
}

FactorRange factorRange(const HeightField& field, const TopSurface& top) {
  const BendStatistics statistics = statisticsOf(field, field.factor, top);
  return {statistics.least, statistics.greatest};
}

/// Tangent of the steepest slope of any layer where there is material: at most so steep.
double steepestSlope(const HeightField& field, const TopSurface& top) {
  double steepest = 0.0;
  for (std::size_t half = 0; half < top.over_half.size(); ++half)
    steepest = std::max(steepest, steepestSlope(field.factor, field.cells, top, half));
  return steepest;
}

/// The same in one half of a cell; 0 where there is no material.
/// @param factor  at the corners of the cells
double steepestSlope(const std::vector<double>& factor, const HeightGrid& cells, const TopSurface& top,
                     std::size_t half) {
  if (!top.over_half[half]) return 0.0;
  const std::array<std::size_t, 3> corners = cornersOfHalf(cells, half);
  std::array<double, 3> factors{};
  double highest = 0.0;  // of the level layers: a quotient of linear functions has its greatest at a corner
  for (std::size_t i = 0; i < 3; ++i) {
    factors[i] = factor[corners[i]];
    highest = std::max(highest, (*top.over_half[half])[i] / factors[i]);
  }
  return highest * slopeOfHalf(factors, cells.cell_mm);
}

/// The bend times the greatest share with which slope and thickness keep within their limits everywhere where
/// there is material. Layers keep their height on average there, as far as the limits allow.
/// @param log_factor  at the corners of the cells
LimitedBend limitedBend(HeightGrid cells, double base_mm, const std::vector<double>& log_factor,
                        const TopSurface& top, const HeightFieldSettings& settings) {
  LimitedBend bend{{cells, base_mm, std::vector<double>(log_factor.size(), 1.0)}, 1.0};
  const BendStatistics asked = statisticsOf(bend.field, log_factor, top);
  const double thin = std::log(settings.min_thickness);
  const double thick = std::log(settings.max_thickness);
  const auto take = [&](double share) {
    double shift = -share * asked.mean;
    shift = std::min(shift, thick - share * asked.greatest);
    shift = std::max(shift, thin - share * asked.least);
    for (std::size_t i = 0; i < log_factor.size(); ++i)
      bend.field.factor[i] = std::exp(share * log_factor[i] + shift);
    bend.share = share;
  };
  const double range = asked.greatest - asked.least;
  const double allowed = std::tan(toRadians(settings.max_slope_deg));
  const double most = range > thick - thin ? (thick - thin) / range : 1.0;
  take(most);
  if (steepestSlope(bend.field, top) <= allowed) return bend;
  double fits = 0.0;
  double exceeds = most;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (fits + exceeds);
    take(middle);
    (steepestSlope(bend.field, top) <= allowed ? fits : exceeds) = middle;
  }
  take(fits);
  return bend;
}

/// Keeps the solution from drifting as a whole; far too weak to bend it.
constexpr double kAnchor = 1e-9;
/// Weight of an even bend where there is no part.
constexpr double kBeside = 1e-6;
constexpr int kMostSolves = 12;
/// Part of the allowed slope to which steeper places are drawn, so that few solves are enough.
constexpr double kDrawn = 0.99;

/// Two neighbouring corners and by how much the solution is to differ between them.
struct Edge {
  std::size_t from = 0;
  std::size_t to = 0;
  double weight = 0.0;
  double difference = 0.0;
};

class Fit {
 public:
  Fit(const TopSurface& top, const HeightGrid& cells, const std::vector<char>& is_followed,
      const HeightFieldSettings& settings)
      : top_(top), cells_(cells), is_followed_(is_followed), settings_(settings) {
    for (int row = 0; row <= cells.rows; ++row)
      for (int column = 0; column < cells.columns; ++column)
        addEdge(cornerOf(cells_, column, row), cornerOf(cells_, column + 1, row), {column, row},
                {column, row - 1});
    for (int row = 0; row < cells.rows; ++row)
      for (int column = 0; column <= cells.columns; ++column)
        addEdge(cornerOf(cells_, column, row), cornerOf(cells_, column, row + 1), {column, row},
                {column - 1, row});
  }

  std::vector<double> solve() && {
    std::vector<double> solution = solved();
    for (int i = 1; i < kMostSolves && drawSteepPlaces(solution); ++i) solution = solved();
    return solution;
  }

 private:
  struct Cell {
    int column = 0;
    int row = 0;
  };

  bool isFollowed(const Cell& at) const {
    return cells_.contains(at.column, at.row) && is_followed_[cells_.cell(at.column, at.row)] != 0;
  }

  bool isPart(const Cell& at) const {
    if (!cells_.contains(at.column, at.row)) return false;
    const std::size_t half = 2 * cells_.cell(at.column, at.row);
    return top_.over_half[half] || top_.over_half[half + 1];
  }

  /// @param one, other  the cells on both sides
  void addEdge(std::size_t from, std::size_t to, const Cell& one, const Cell& other) {
    if (isFollowed(one) || isFollowed(other))
      edges_.push_back({from, to, 1.0, std::log(*top_.prolonged[to] / *top_.prolonged[from])});
    else
      edges_.push_back({from, to, isPart(one) || isPart(other) ? settings_.evenness : kBeside, 0.0});
  }

  std::vector<double> solved() const {
    const auto count = static_cast<Eigen::Index>(top_.at_corner.size());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(count, kAnchor);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(edges_.size() + top_.at_corner.size());
    for (const Edge& edge : edges_) {
      const auto i = static_cast<Eigen::Index>(edge.from);
      const auto j = static_cast<Eigen::Index>(edge.to);
      diagonal[i] += edge.weight;
      diagonal[j] += edge.weight;
      entries.emplace_back(j, i, -edge.weight);  // the lower half of the matrix is enough: from < to
      right[i] -= edge.weight * edge.difference;
      right[j] += edge.weight * edge.difference;
    }
    for (Eigen::Index i = 0; i < count; ++i) entries.emplace_back(i, i, diagonal[i]);
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factorised(matrix);
    const Eigen::VectorXd solution = factorised.solve(right);
    if (factorised.info() != Eigen::Success || !solution.allFinite())
      throw InvalidInput("the height field of " + std::to_string(count) + " corners cannot be solved");
    return {solution.data(), solution.data() + count};
  }

  /// @return whether there are any
  bool drawSteepPlaces(const std::vector<double>& solution) {
    const double allowed = std::tan(toRadians(settings_.max_slope_deg));
    std::vector<double> factor(solution.size());
    for (std::size_t i = 0; i < solution.size(); ++i) factor[i] = std::exp(solution[i]);
    bool is_steep = false;
    for (std::size_t half = 0; half < top_.over_half.size(); ++half) {
      const double slope = steepestSlope(factor, cells_, top_, half);
      if (slope <= allowed * (1.0 + 1e-9)) continue;
      is_steep = true;
      const std::array<std::size_t, 3> corners = cornersOfHalf(cells_, half);
      for (std::size_t i = 0; i < 2; ++i) {
        Edge& edge = edges_[edgeFrom(corners[i], corners[i + 1])];
        edge.weight = 4.0 * std::max(edge.weight, 0.25);
        edge.difference = kDrawn * allowed / slope * (solution[edge.to] - solution[edge.from]);
      }
    }
    return is_steep;
  }

  /// In the order in which the edges were added: those along x first.
  std::size_t edgeFrom(std::size_t from, std::size_t to) const {
    const auto columns = static_cast<std::size_t>(cells_.columns);
    if (to == from + 1) return from - from / (columns + 1);
    return columns * static_cast<std::size_t>(cells_.rows + 1) + from;
  }

  const TopSurface& top_;
  const HeightGrid& cells_;
  const std::vector<char>& is_followed_;
  const HeightFieldSettings& settings_;
  std::vector<Edge> edges_;
};

/// The bend that follows the top best, as log(factor) at the corners of the cells, by least squares: where
/// the top is to be followed, it differs between neighbouring corners as log(height of the top) does, so that
/// the top is level in level layers; elsewhere, with the weight of evenness, it does not differ.
///
/// Between what is followed layers may come out too steep. There the difference of the solution is drawn to
/// what is allowed and the system solved again, up to eleven times, each time with more weight. What then
/// remains too steep is left to `limitedBend`.
/// @param is_followed  each cell
/// @throws InvalidInput if it cannot be solved
std::vector<double> fitHeightField(const TopSurface& top, const HeightGrid& cells,
                                   const std::vector<char>& is_followed,
                                   const HeightFieldSettings& settings) {
  return Fit(top, cells, is_followed, settings).solve();
}

/// Cells no steeper are level.
constexpr double kLevelSlope = 1e-3;

/// What the choice needs to know.
struct Place {
  double lowest = 0.0;  // height above the bed; 0 if there is none
  double slope = 0.0;   // of the layers, where they follow it
  bool has_part = false;
};

Place placeOf(const TopSurface& top, const HeightGrid& cells, std::size_t half) {
  std::array<double, 3> heights{};
  const std::array<std::size_t, 3> corners = cornersOfHalf(cells, half);
  double most = 1.0;  // height of the part over that of the surface
  for (std::size_t i = 0; i < 3; ++i) {
    if (!top.prolonged[corners[i]]) return {};
    heights[i] = *top.prolonged[corners[i]];
    if (top.over_half[half]) most = std::max(most, (*top.over_half[half])[i] / heights[i]);
  }
  return {*std::min_element(heights.begin(), heights.end()), most * slopeOfHalf(heights, cells.cell_mm),
          top.over_half[half].has_value()};
}

Place placeOfCell(const TopSurface& top, const HeightGrid& cells, std::size_t cell) {
  const Place right = placeOf(top, cells, 2 * cell);
  const Place left = placeOf(top, cells, 2 * cell + 1);
  return {std::min(right.lowest, left.lowest), std::max(right.slope, left.slope),
          right.has_part || left.has_part};
}

/// Which cells layers are to follow the top in: those where layers that do so are no steeper than the
/// greatest slope, and that are level or at least min_thickness / max_thickness as high as the highest of
/// them. Lower down layers would have to be thinner than they may.
/// @return for each cell 1 or 0; corners of a followed one have a prolonged height
std::vector<char> followedCells(const TopSurface& top, const HeightGrid& cells,
                                const HeightFieldSettings& settings) {
  const double steepest = std::tan(toRadians(settings.max_slope_deg)) * (1.0 + 1e-9);
  std::vector<Place> places(cells.cellCount());
  double highest = 0.0;
  for (std::size_t cell = 0; cell < places.size(); ++cell) {
    places[cell] = placeOfCell(top, cells, cell);
    if (places[cell].slope > steepest) places[cell].lowest = 0.0;
    if (places[cell].has_part) highest = std::max(highest, places[cell].lowest);
  }
  const double lowest = highest * settings.min_thickness / settings.max_thickness;
  std::vector<char> is_followed(places.size());
  for (std::size_t cell = 0; cell < places.size(); ++cell)
    is_followed[cell] = static_cast<char>(
        places[cell].lowest > 0.0 && (places[cell].lowest >= lowest || places[cell].slope < kLevelSlope));
  return is_followed;
}

constexpr double kMostCells = 4e6;
/// Rings of cells around the part.
constexpr double kMargin = 2.0;

void requireValid(HeightFieldSettings settings) {
  SettingsSchema schema;
  describe(schema, settings);
  schema.validate();
}

HeightGrid gridOver(const Box3& box, double cell_mm) {
  const Point2 size = box.size().head<2>();
  const double count = (size.x() / cell_mm + 5.0) * (size.y() / cell_mm + 5.0);
  if (count > kMostCells)
    throw InvalidConfig("heightfield.cell_mm is " + numberText(cell_mm) + " mm, which makes " +
                        std::to_string(static_cast<long long>(count)) + " cells over a part of " +
                        numberText(size.x()) + " x " + numberText(size.y()) +
                        " mm; must make at most four million");
  const Point2 margin = Point2::Constant(kMargin * cell_mm);
  return heightGrid({box.low.head<2>() - margin, box.high.head<2>() + margin}, cell_mm);
}

bool isPart(const TopSurface& top, std::size_t cell) {
  return top.over_half[2 * cell] || top.over_half[2 * cell + 1];
}

/// Mean slope of the followed surface against layers, times which the layers' number is that of steps.
struct StepCounts {
  double level = 0.0;
  double bent = 0.0;
};

StepCounts stepCounts(const HeightField& field, const std::vector<char>& is_followed, const TopSurface& top) {
  StepCounts sum;
  std::size_t count = 0;
  for (std::size_t half = 0; half < top.over_half.size(); ++half) {
    if (is_followed[half / 2] == 0 || !top.over_half[half]) continue;
    std::array<double, 3> heights{};
    std::array<double, 3> level{};
    const std::array<std::size_t, 3> corners = cornersOfHalf(field.cells, half);
    for (std::size_t i = 0; i < 3; ++i) {
      heights[i] = *top.prolonged[corners[i]];
      level[i] = heights[i] / field.factor[corners[i]];
    }
    sum.level += slopeOfHalf(heights, field.cells.cell_mm);
    sum.bent += slopeOfHalf(level, field.cells.cell_mm);
    ++count;
  }
  const auto most = static_cast<double>(std::max<std::size_t>(count, 1));
  return {sum.level / most, sum.bent / most};
}

double levelTop(const Mesh& mesh, const HeightField& field) {
  double top = field.base_mm;
  for (const Point3& vertex : mesh.vertices) top = std::max(top, field.level(vertex).z());
  return top;
}

/// Low corners of the cells that are followed.
std::vector<SurfacePlace> followedPlaces(const std::vector<char>& is_followed, const TopSurface& top,
                                         const HeightField& field) {
  std::vector<SurfacePlace> places;
  for (std::size_t cell = 0; cell < is_followed.size(); ++cell) {
    const std::size_t corner = field.corner(field.cells.column(cell), field.cells.row(cell));
    if (is_followed[cell] != 0 && isPart(top, cell) && top.at_corner[corner])
      places.push_back({*top.at_corner[corner], field.factor[corner]});
  }
  return places;
}

/// Reports of the bend and what it follows.
HeightFieldReport reportOf(const HeightField& field, const std::vector<char>& is_followed,
                           const TopSurface& top, const SlicingSettings& slicing) {
  HeightFieldReport report;
  report.greatest_slope_deg = toDegrees(std::atan(steepestSlope(field, top)));
  const FactorRange range = factorRange(field, top);
  report.least_thickness_mm = range.least * slicing.layer_height_mm;
  report.greatest_thickness_mm = range.greatest * slicing.layer_height_mm;
  const double area = field.cells.cell_mm * field.cells.cell_mm;
  for (std::size_t cell = 0; cell < is_followed.size(); ++cell) {
    if (!isPart(top, cell)) continue;
    report.upper_mm2 += area;
    if (is_followed[cell] != 0) report.followed_mm2 += area;
  }
  std::vector<SurfacePlace> places = followedPlaces(is_followed, top, field);
  report.bent_error_mm = distanceToTops(places, 1.0, slicing);
  for (SurfacePlace& place : places) place.factor = 1.0;
  report.level_error_mm = distanceToTops(places, 1.0, slicing);
  const StepCounts steps = stepCounts(field, is_followed, top);
  report.level_steps_per_mm = steps.level / slicing.layer_height_mm;
  report.bent_steps_per_mm = steps.bent / slicing.layer_height_mm;
  return report;
}

std::string rounded(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

std::vector<std::string> notesOf(const HeightFieldReport& report, const HeightFieldSettings& settings) {
  if (report.followed_mm2 == 0.0)
    return {"No upper surface is flatter than heightfield.max_slope_deg " +
            rounded(settings.max_slope_deg, "%g") + " deg: the layers are level."};
  std::vector<std::string> notes = {
      "Layers bend up to " + rounded(report.greatest_slope_deg, "%.2f") + " deg and are " +
          rounded(report.least_thickness_mm, "%.3f") + " to " +
          rounded(report.greatest_thickness_mm, "%.3f") + " mm thick.",
      "They follow " + rounded(100.0 * report.followed_mm2 / report.upper_mm2, "%.0f") +
          " % of the upper side. There are " + rounded(report.bent_steps_per_mm, "%.3f") +
          " steps per mm on it, its mean distance from the nearest layer's top is " +
          rounded(report.bent_error_mm, "%.4f") + " mm; with level layers it would be " +
          rounded(report.level_steps_per_mm, "%.3f") + " and " + rounded(report.level_error_mm, "%.4f") +
          " mm."};
  if (report.share < 1.0)
    notes.push_back("The bend is " + rounded(100.0 * report.share, "%.1f") +
                    " % of what the surface asks for, to keep within heightfield.max_slope_deg " +
                    rounded(settings.max_slope_deg, "%g") + " deg and a thickness of " +
                    rounded(settings.min_thickness, "%g") + " to " + rounded(settings.max_thickness, "%g") +
                    " layer heights.");
  return notes;
}

HeightFieldSlices sliceByHeightField(const Mesh& mesh, const SlicingSettings& slicing,
                                     const HeightFieldSettings& settings, Progress& progress) {
  requireValid(settings);
  const Box3 box = boundingBox(mesh);
  if (box.isEmpty() || !(box.size().z() > 0.0))
    throw InvalidMesh("the mesh has " + std::to_string(mesh.triangles.size()) +
                      " triangles and no height; a solid part is needed");
  const HeightGrid cells = gridOver(box, settings.cell_mm);
  Mesh fine = subdivide(mesh, settings.cell_mm).mesh;
  progress.report("bend", 0.2);
  throwIfCancelled(progress, "bend");
  const TopSurface top = topSurface(fine, cells, box.low.z());
  const std::vector<char> is_followed = followedCells(top, cells, settings);
  const std::vector<double> log_factor = fitHeightField(top, cells, is_followed, settings);
  progress.report("bend", 0.8);
  throwIfCancelled(progress, "bend");
  LimitedBend bend = limitedBend(cells, box.low.z(), log_factor, top, settings);
  const FactorRange range = factorRange(bend.field, top);
  const double scale =
      alignedScale(followedPlaces(is_followed, top, bend.field),
                   {settings.min_thickness / range.least, settings.max_thickness / range.greatest}, slicing);
  for (double& factor : bend.field.factor) factor *= scale;

  HeightFieldSlices slices;
  slices.top_mm = box.high.z();
  slices.report = reportOf(bend.field, is_followed, top, slicing);
  slices.report.share = bend.share;
  slices.field = std::move(bend.field);
  const double level_top = levelTop(fine, slices.field);
  const Mesh level = levelled(std::move(fine), slices.field);
  progress.report("bend", 1.0);
  std::vector<double> heights;
  for (const LayerBounds& bounds : stackLayers(box.low.z(), level_top, slicing)) {
    slices.layers.push_back({bounds, {}});
    heights.push_back(bounds.cut());
  }
  std::vector<Section> sections = sliceMesh(level, heights, progress);
  for (std::size_t i = 0; i < sections.size(); ++i) slices.layers[i].section = std::move(sections[i]);
  return slices;
}

}  // namespace lamina
