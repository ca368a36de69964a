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
// Beyond these shares of half its length, and of its width, a cell is not reached, whatever the rounding.
constexpr float kBeyondAlong = 1.5301F;
constexpr float kBeyondAcross = 0.5101F;
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
    : deposited(cells->size()),
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
  beads_ = StraightBeads(*cells_, index_);
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

inline float CellSheet::PlaneStation::along(const PlanePlace& place) const {
  return (place.u - u) * tangent_u + (place.v - v) * tangent_v;
}

inline float CellSheet::PlaneStation::across(const PlanePlace& place, float along_mm) const {
  return (place.v - v) * tangent_u - (place.u - u) * tangent_v - 0.5F * left * along_mm * along_mm;
}

inline double CellSheet::BentStation::along(const Point3& off) const {
  return off.dot(tangent.cast<double>());
}

inline float CellSheet::BentStation::across(const Point3& off, double along_mm) const {
  return off.cast<float>().dot(growth.cross(tangent)) - left * static_cast<float>(0.5 * along_mm * along_mm);
}

/// The bead curves away from its tangent: by its own curvature at its planned top.
inline double CellSheet::BentStation::heightAt(const Point3& off, double along_mm) const {
  const auto bend = static_cast<double>(up);
  const double square = off.dot(growth.cast<double>());
  return square - bend * (0.5 * along_mm * along_mm) / std::max(kLeastRadius, 1.0 - bend * square);
}

/// Along the outside of bends cells gape: in a bend no tighter than the bead by half their length at most.
inline bool CellSheet::LocalCoordinates::isOn() const {
  return across <= kReach && along <= 2.0F * kReach + across;
}

/// Most cells are ruled out before anything is divided.
inline CellSheet::LocalCoordinates CellSheet::onPlane(std::uint32_t cell, const PlanePlace& place) const {
  const PlaneStation& station = plane_[cell];
  const float along_mm = station.along(place);
  if (std::abs(along_mm) > kBeyondAlong * station.half) return {};
  const float across_mm = station.across(place, along_mm);
  if (std::abs(across_mm) > kBeyondAcross * station.width) return {};
  const LocalCoordinates on = {std::abs(along_mm) / station.half, std::abs(across_mm) / station.width};
  if (!on.isOn() || !(std::abs(heightOnPlane(station, place)) <= windowOf(cell))) return {};
  return on;
}

inline double CellSheet::heightOnPlane(const PlaneStation& station, const PlanePlace& place) const {
  return place.z - first_top_ - static_cast<double>(station.lift);
}

inline CellSheet::LocalCoordinates CellSheet::onBent(std::uint32_t cell, const Point3& point) const {
  const BentStation& station = bent_[cell];
  const Point3 off = point - station.middle;
  const double along = station.along(off);
  const float along_mm = std::abs(static_cast<float>(along));
  if (along_mm > kBeyondAlong * station.half) return {};
  const float across_mm = std::abs(station.across(off, along));
  if (across_mm > kBeyondAcross * station.width) return {};
  const LocalCoordinates on = {along_mm / station.half, across_mm / station.width};
  if (!on.isOn() || !(std::abs(station.heightAt(off, along)) <= windowOf(cell))) return {};
  return on;
}

/// Of cells in a row, pieces of one bead, the nearer along; of several beads the nearer in widths.
template <class CoordinatesOf>
CellSheet::Found CellSheet::best(const BoxCells::Numbers& near, CoordinatesOf coordinates) const {
  Found best;
  Found of_bead;
  std::uint32_t last = 0;
  for (const std::uint32_t cell : near) {
    if (cell >= deposited) break;
    const LocalCoordinates here = coordinates(cell);
    if (here.isOff()) continue;
    const bool goes_on = of_bead.isCell() && cell == last + 1;
    last = cell;
    if (goes_on) {
      if (here.along < of_bead.on.along) of_bead = {cell, here};
      continue;
    }
    if (!best.isCell() || of_bead.on.across < best.on.across) best = of_bead;
    of_bead = {cell, here};
  }
  return !best.isCell() || of_bead.on.across < best.on.across ? of_bead : best;
}

inline std::optional<CellSight> CellSheet::lookOnPlane(const Point3& at,
                                                       const BoxCells::Numbers& near) const {
  const PlanePlace place = {static_cast<float>(at.x()), static_cast<float>(at.y()), at.z()};
  const Found found = best(near, [&](std::uint32_t cell) { return onPlane(cell, place); });
  return found.isCell() ? std::optional<CellSight>(sightOnPlane(found.cell, place)) : std::nullopt;
}

inline CellSight CellSheet::sightOnPlane(std::uint32_t cell, const PlanePlace& place) const {
  const PlaneStation& station = plane_[cell];
  const float along_mm = station.along(place);
  const float across_mm = station.across(place, along_mm);
  return {cells_->layer,
          cell,
          static_cast<double>(along_mm),
          static_cast<double>(across_mm),
          static_cast<double>(std::abs(across_mm) / station.width),
          -heightOnPlane(station, place)};
}

inline std::optional<CellSight> CellSheet::lookOnBent(const Point3& point,
                                                      const BoxCells::Numbers& near) const {
  const Found found = best(near, [&](std::uint32_t cell) { return onBent(cell, point); });
  if (!found.isCell()) return std::nullopt;
  const BentStation& station = bent_[found.cell];
  const Point3 off = point - station.middle;
  const double along_mm = station.along(off);
  return CellSight{cells_->layer,
                   found.cell,
                   static_cast<double>(static_cast<float>(along_mm)),
                   static_cast<double>(station.across(off, along_mm)),
                   static_cast<double>(found.on.across),
                   -station.heightAt(off, along_mm)};
}

std::optional<CellSight> CellSheet::look(const Point3& point) const {
  const Point3 place = index_.placeOf(point);
  return is_plane_ ? lookOnPlane(place, index_.stations().near(place))
                   : lookOnBent(point, index_.stations().near(place));
}

inline void CellSheet::fetch(std::uint32_t cell) const {
  if (is_plane_)
    __builtin_prefetch(plane_.data() + cell);
  else
    __builtin_prefetch(bent_.data() + cell);
}

/// Of most points a division tells the cell, and that cell is all that is fetched.
std::vector<std::optional<CellSight>> CellSheet::lookAlongBeads(const std::vector<Point3>& points) const {
  struct Sought {
    Point3 place;
    std::uint32_t square = BoxCells::kNone;
    std::uint32_t cell = StraightBeads::kNone;
  };
  std::vector<Sought> sought(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    sought[i].place = index_.placeOf(points[i]);
    sought[i].square = index_.stations().cellAt(sought[i].place);
    beads_.fetch(sought[i].square);
  }
  for (Sought& each : sought) {
    each.cell = beads_.cellAt(each.square, each.place);
    if (each.cell < deposited) __builtin_prefetch(plane_.data() + each.cell);
  }
  std::vector<std::optional<CellSight>> sights(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Sought& each = sought[i];
    if (each.cell == StraightBeads::kNone) continue;
    const PlanePlace place = {static_cast<float>(each.place.x()), static_cast<float>(each.place.y()),
                              each.place.z()};
    // Another cell may reach a point that lies on one not deposited yet, or out of its window.
    const bool is_on =
        each.cell < deposited && std::abs(heightOnPlane(plane_[each.cell], place)) <= windowOf(each.cell);
    if (is_on)
      sights[i] = sightOnPlane(each.cell, place);
    else
      sights[i] = lookOnPlane(each.place, index_.stations().in(each.square));
  }
  return sights;
}

/// Neighbours of a profile lie on different beads, far apart in memory: waiting for each would take longer
/// than all the rest.
std::vector<std::optional<CellSight>> CellSheet::look(const std::vector<Point3>& points) const {
  if (beads_.bytes() > 0) return lookAlongBeads(points);
  struct Sought {
    Point3 place;
    std::uint32_t square = BoxCells::kNone;
    BoxCells::Numbers near;
  };
  std::vector<Sought> sought;
  sought.reserve(points.size());
  for (const Point3& point : points) {
    const Point3 place = index_.placeOf(point);
    sought.push_back({place, index_.stations().cellAt(place), {}});
    index_.stations().fetch(sought.back().square);
  }
  for (Sought& each : sought) {
    each.near = index_.stations().in(each.square);
    __builtin_prefetch(each.near.first);
  }
  for (const Sought& each : sought)
    for (const std::uint32_t cell : each.near) fetch(cell);
  std::vector<std::optional<CellSight>> sights;
  sights.reserve(points.size());
  if (is_plane_)
    for (const Sought& each : sought) sights.push_back(lookOnPlane(each.place, each.near));
  else
    for (std::size_t i = 0; i < points.size(); ++i) sights.push_back(lookOnBent(points[i], sought[i].near));
  return sights;
}

std::size_t CellSheet::bytes() const {
  return index_.stations().bytes() + beads_.bytes() + sizeof(PlaneStation) * plane_.capacity() +
         sizeof(BentStation) * bent_.capacity() + sizeof(float) * window_mm_.capacity();
}

}  // namespace lamina
