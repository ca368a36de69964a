// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/cell_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lamina {
namespace {

// Lengths and widths of a cell that it reaches: above crests cells that touch fan out a little.
constexpr float kReach = 0.51F;
constexpr double kLeastRadius = 0.5;  // of a bend at its planned top: a point lies no nearer to its middle

std::vector<float> windowsOf(const LayerCells& cells, double window_layers) {
  std::vector<float> windows;
  windows.reserve(cells.size());
  for (const double height : cells.height_mm) windows.push_back(static_cast<float>(window_layers * height));
  const bool are_same =
      std::all_of(windows.begin(), windows.end(), [&](float window) { return window == windows.front(); });
  if (are_same && !windows.empty()) windows.resize(1);
  windows.shrink_to_fit();
  return windows;
}

/// Change of the tangent along the way at a cell [1/mm].
Eigen::Vector3d bendAt(const LayerCells& cells, const CellRun& run, std::size_t i) {
  const std::size_t end = run.first + run.count;
  const std::size_t before = i > run.first ? i - 1 : (run.is_closed ? end - 1 : i);
  const std::size_t after = i + 1 < end ? i + 1 : (run.is_closed ? run.first : i);
  const double steps = (before != i ? 1.0 : 0.0) + (after != i ? 1.0 : 0.0);
  if (steps == 0.0) return Eigen::Vector3d::Zero();
  return (cells.tangent[after] - cells.tangent[before]) / (steps * run.cellLength());
}

}  // namespace

CellSheet::CellSheet(std::shared_ptr<const LayerCells> cells, double window_layers)
    : laid(cells->size()),
      cells_(std::move(cells)),
      index_(*cells_, window_layers),
      is_plane_(index_.isPlane()),
      window_mm_(windowsOf(*cells_, window_layers)) {
  is_plane_ ? addPlaneStations() : addBentStations();
}

void CellSheet::addPlaneStations() {
  if (cells_->size() == 0) return;
  const Point3 first = index_.placeOf(cells_->middle.front());
  first_top_ = first.z();
  plane_.reserve(cells_->size());
  for (const CellRun& run : cells_->runs) {
    const auto half = static_cast<float>(0.5 * run.cellLength());
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const Eigen::Vector3f place = index_.placeOf(cells_->middle[i]).cast<float>();
      const Eigen::Vector3f tangent = index_.turned(cells_->tangent[i]).cast<float>();
      const double left = bendAt(*cells_, run, i).dot(cells_->growth[i].cross(cells_->tangent[i]));
      const double lift = index_.placeOf(cells_->middle[i]).z() - first_top_;
      plane_.push_back({place.x(), place.y(), tangent.x(), tangent.y(), half,
                        static_cast<float>(cells_->width_mm[i]), static_cast<float>(lift),
                        static_cast<float>(left)});
    }
  }
}

void CellSheet::addBentStations() {
  bent_.reserve(cells_->size());
  for (const CellRun& run : cells_->runs) {
    const auto half = static_cast<float>(0.5 * run.cellLength());
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const Eigen::Vector3d bend = bendAt(*cells_, run, i);
      const Eigen::Vector3d& growth = cells_->growth[i];
      bent_.push_back({cells_->middle[i], cells_->tangent[i].cast<float>(), growth.cast<float>(), half,
                       static_cast<float>(cells_->width_mm[i]), static_cast<float>(bend.dot(growth)),
                       static_cast<float>(bend.dot(growth.cross(cells_->tangent[i])))});
    }
  }
}

/// Along the outside of bends cells gape: in a bend no tighter than the bead by half their length at most.
inline bool CellSheet::Footing::isOn() const { return across <= kReach && along <= 2.0F * kReach + across; }

/// @param place  in the axes of the index
inline CellSheet::Footing CellSheet::onPlane(std::uint32_t cell, const Point3& place) const {
  const PlaneStation& station = plane_[cell];
  const float u = static_cast<float>(place.x()) - station.u;
  const float v = static_cast<float>(place.y()) - station.v;
  Footing on;
  on.along_mm = u * station.tangent_u + v * station.tangent_v;
  on.along = std::abs(on.along_mm) / station.half;
  if (!(on.along <= 3.0F * kReach)) return on;
  on.across_mm =
      v * station.tangent_u - u * station.tangent_v - 0.5F * station.left * on.along_mm * on.along_mm;
  on.across = std::abs(on.across_mm) / station.width;
  on.height_mm = place.z() - first_top_ - static_cast<double>(station.lift);
  if (on.isOn() && std::abs(on.height_mm) <= windowOf(cell)) on.cell = cell;
  return on;
}

inline CellSheet::Footing CellSheet::onBent(std::uint32_t cell, const Point3& point) const {
  const BentStation& station = bent_[cell];
  const Point3 off = point - station.middle;
  Footing on;
  const double along = off.dot(station.tangent.cast<double>());
  on.along_mm = static_cast<float>(along);
  on.along = std::abs(on.along_mm) / station.half;
  if (!(on.along <= 3.0F * kReach)) return on;
  // The bead curves away from its tangent: by its own curvature at its planned top.
  const double half_square = 0.5 * along * along;
  const auto up = static_cast<double>(station.up);
  const double square = off.dot(station.growth.cast<double>());
  on.height_mm = square - up * half_square / std::max(kLeastRadius, 1.0 - up * square);
  if (!(std::abs(on.height_mm) <= windowOf(cell))) return on;
  on.across_mm = off.cast<float>().dot(station.growth.cross(station.tangent)) -
                 station.left * static_cast<float>(half_square);
  on.across = std::abs(on.across_mm) / station.width;
  if (on.isOn()) on.cell = cell;
  return on;
}

/// Of cells in a row, pieces of one bead, the nearer along; of several beads the nearer in widths.
template <class FootingOf>
CellSheet::Footing CellSheet::best(const StationIndex::Cells& near, FootingOf footing) const {
  Footing best;
  Footing of_bead;
  std::uint32_t last = 0;
  for (const std::uint32_t cell : near) {
    if (cell >= laid) break;
    const Footing here = footing(cell);
    if (here.cell == Footing::kNone) continue;
    const bool goes_on = of_bead.cell != Footing::kNone && cell == last + 1;
    last = cell;
    if (goes_on) {
      if (here.along < of_bead.along) of_bead = here;
      continue;
    }
    if (best.cell == Footing::kNone || of_bead.across < best.across) best = of_bead;
    of_bead = here;
  }
  return best.cell == Footing::kNone || of_bead.across < best.across ? of_bead : best;
}

std::optional<CellSight> CellSheet::look(const Point3& point) const {
  const Point3 place = index_.placeOf(point);
  return look(point, place, index_.near(place));
}

inline void CellSheet::fetch(std::uint32_t cell) const {
  if (is_plane_)
    __builtin_prefetch(plane_.data() + cell);
  else
    __builtin_prefetch(bent_.data() + cell);
}

/// Neighbours of a profile lie on different beads, far apart in memory: waiting for each would take longer
/// than all the rest.
std::vector<std::optional<CellSight>> CellSheet::look(const std::vector<Point3>& points) const {
  struct Sought {
    Point3 place;
    std::uint32_t square = StationIndex::kNone;
    StationIndex::Cells near;
  };
  std::vector<Sought> sought;
  sought.reserve(points.size());
  for (const Point3& point : points) {
    const Point3 place = index_.placeOf(point);
    sought.push_back({place, index_.squareOf(place), {}});
    index_.fetch(sought.back().square);
  }
  for (Sought& each : sought) {
    each.near = index_.cellsIn(each.square);
    __builtin_prefetch(each.near.first);
  }
  for (const Sought& each : sought)
    if (each.near.first != each.near.last) fetch(*each.near.first);
  std::vector<std::optional<CellSight>> sights;
  sights.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    sights.push_back(look(points[i], sought[i].place, sought[i].near));
  return sights;
}

std::optional<CellSight> CellSheet::look(const Point3& point, const Point3& place,
                                         const StationIndex::Cells& near) const {
  const Footing on = is_plane_ ? best(near, [&](std::uint32_t cell) { return onPlane(cell, place); })
                               : best(near, [&](std::uint32_t cell) { return onBent(cell, point); });
  if (on.cell == Footing::kNone) return std::nullopt;
  CellSight sight;
  sight.layer = cells_->layer;
  sight.cell = on.cell;
  sight.off_mm = static_cast<double>(on.along_mm);
  sight.across_mm = static_cast<double>(on.across_mm);
  sight.across_share = static_cast<double>(on.across);
  sight.error_mm = -on.height_mm;
  return sight;
}

std::size_t CellSheet::bytes() const {
  return index_.bytes() + sizeof(PlaneStation) * plane_.capacity() + sizeof(BentStation) * bent_.capacity() +
         sizeof(float) * window_mm_.capacity();
}

}  // namespace lamina
