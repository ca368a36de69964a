// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/grown_deposit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>

#include "deposition/bead_section.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kStation = 0.5;        // mm
constexpr double kJoined = 1e-3;        // mm: above the rounding of programs
constexpr double kRemembered = 10.0;    // time constants of the feeder
constexpr double kBridged = 0.5;        // layers: of the depth of a gap under a bead that it does not fill
constexpr double kMiddle = 0.25;        // of a bead's width, which the nozzle is over
constexpr double kLeastPlanned = 1e-3;  // mm: a nozzle that rubs on the bed plans no layer
constexpr double kLeastRise = 0.05;     // mm: to a second layer, whatever the first one seems to be

double lengthOf(const GrownPiece& piece) { return (piece.end - piece.start).norm(); }

void requirePiece(const GrownPiece& piece) {
  if (!piece.start.allFinite() || !piece.end.allFinite())
    throw InvalidInput("a piece of a bead is not finite; expected finite coordinates");
  if (!(piece.volume_mm3 >= 0.0 && std::isfinite(piece.volume_mm3)))
    throw InvalidInput("deposited volume is " + numberText(piece.volume_mm3) + " mm3; must be 0 or more");
}

/// Height of a stadium twice as wide as high.
double usualHeight(double section_mm2) { return std::sqrt(section_mm2 / (1.0 + 0.25 * M_PI)); }

bool isClosed(const std::vector<GrownPiece>& bead) {
  return bead.size() > 2 && (bead.back().end - bead.front().start).norm() < kStation;
}

/// The ground that a piece covers.
struct Stripe {
  Point2 start = Point2::Zero();
  Point2 along = Point2::Zero();  ///< of unit length, unless the piece is steep
  double length_mm = 0.0;
  double half_width_mm = 0.0;
};

Stripe stripeOf(const GrownPiece& piece, double across_mm, double width_mm) {
  const double length = lengthOf(piece);
  const Point2 along = (piece.end - piece.start).head<2>() / length;
  return {piece.start.head<2>() + across_mm * Point2(-along.y(), along.x()), along, length, 0.5 * width_mm};
}

/// Calls `see(cell, at_mm, distance_mm)` for the cells whose middle is no farther off than half the width.
template <class See>
void forCellsBeside(const HeightGrid& grid, const Stripe& stripe, See see) {
  const Point2 end = stripe.start + stripe.length_mm * stripe.along;
  const Point2 reach(stripe.half_width_mm, stripe.half_width_mm);
  const Point2 low = (stripe.start.cwiseMin(end) - reach - grid.origin) / grid.cell_mm;
  const Point2 high = (stripe.start.cwiseMax(end) + reach - grid.origin) / grid.cell_mm;
  const auto column_from = static_cast<int>(std::floor(std::max(0.0, low.x())));
  const auto row_from = static_cast<int>(std::floor(std::max(0.0, low.y())));
  for (int row = row_from; row <= high.y() && row < grid.rows; ++row) {
    for (int column = column_from; column <= high.x() && column < grid.columns; ++column) {
      const Point2 from_start = grid.centre(column, row) - stripe.start;
      const double at = from_start.dot(stripe.along);
      const double distance = (from_start - std::clamp(at, 0.0, stripe.length_mm) * stripe.along).norm();
      if (distance <= stripe.half_width_mm) see(grid.cell(column, row), at, distance);
    }
  }
}

}  // namespace

void describe(SettingsSchema& schema, GrownDepositSettings& settings) {
  schema.number("deposit.bead_width_mm", settings.bead_width_mm, {0.0, 1000.0},
                "Width over which a bead grows as plant.* says; 0 for that of the first bead.");
  schema.integer("deposit.layers", settings.layers, {1, 1000000}, "Layers over which plant.wear wears.");
}

GrownDeposit::GrownDeposit(HeightMap ground, PlantSettings plant, const GrownDepositSettings& settings)
    : surface_(std::move(ground)),
      plant_(std::move(plant)),
      settings_(settings),
      highest_(heightRange(surface_).high),
      lowest_(heightRange(surface_).low),
      is_ground_level_(highest_ == lowest_),
      deposited_in_(surface_.grid().cellCount(), 0) {
  if (settings_.bead_width_mm > 0.0) width_mm_ = settings_.bead_width_mm;
}

void GrownDeposit::lay(const GrownPiece& piece) {
  requirePiece(piece);
  if (piece.volume_mm3 == 0.0 || lengthOf(piece) == 0.0) return;
  if (!bead_.empty() && (bead_.back().end - piece.start).norm() > kJoined) endBead();
  bead_.push_back(piece);
}

void GrownDeposit::endBead() {
  if (bead_.empty()) return;
  const double z = bead_.front().start.z();
  const bool is_first = planned_mm_ == 0.0;
  const double rise_mm = is_planned_guessed_ ? kLeastRise : 0.5 * planned_mm_;
  const Stations stations = stationsOfBead();
  double volume = 0.0;
  for (const GrownPiece& piece : bead_) volume += piece.volume_mm3;
  const double section = volume / stations.length_mm;
  if (is_first || z > layer_z_mm_ + rise_mm) beginLayer(section);
  if (!width_mm_) width_mm_ = section / planned_mm_;
  const std::vector<double> sections = arrivedSections(stations);
  if (plant_.settings().pressed)
    press(stations, sections, *width_mm_);
  else
    grow(stations, sections, *width_mm_);
  bead_.clear();
  ++beads_;
}

void GrownDeposit::beginLayer(double section_mm2) {
  const Point3& at = bead_.front().start;
  const double start_s = bead_.front().start_s;
  if (planned_mm_ == 0.0) {
    plan(at, section_mm2);
  } else {
    if (is_planned_guessed_) {
      // What was taken for the height of the first layer gave the width of its beads.
      *width_mm_ *= planned_mm_ / (at.z() - layer_z_mm_);
      planned_mm_ = at.z() - layer_z_mm_;
      is_planned_guessed_ = false;
    }
    ++layer_;
    layer_s_ = start_s - layer_start_s_;
  }
  layer_z_mm_ = at.z();
  layer_start_s_ = start_s;
  beads_ = 0;
}

/// Over ground that slopes, how far the first nozzle is from it says nothing of the layers.
void GrownDeposit::plan(const Point3& at, double section_mm2) {
  if (is_ground_level_) {
    const double ground = surface_.nearest(at.head<2>());
    planned_mm_ = std::max(kLeastPlanned, at.z() - (std::isfinite(ground) ? ground : lowest_));
    return;
  }
  is_planned_guessed_ = !width_mm_;
  planned_mm_ = std::max(kLeastPlanned, width_mm_ ? section_mm2 / *width_mm_ : usualHeight(section_mm2));
}

GrownDeposit::Stations GrownDeposit::stationsOfBead() const {
  Stations stations;
  for (const GrownPiece& piece : bead_) stations.length_mm += lengthOf(piece);
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(stations.length_mm / kStation)));
  std::size_t p = 0;
  double begun_mm = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double along = (static_cast<double>(i) + 0.5) * stations.length_mm / static_cast<double>(count);
    while (p + 1 < bead_.size() && along > begun_mm + lengthOf(bead_[p])) begun_mm += lengthOf(bead_[p++]);
    const GrownPiece& piece = bead_[p];
    const double length = lengthOf(piece);
    const double part = std::clamp((along - begun_mm) / length, 0.0, 1.0);
    stations.place.emplace_back(piece.start + part * (piece.end - piece.start));
    stations.time_s.push_back(piece.start_s + part * (piece.end_s - piece.start_s));
    stations.section_mm2.push_back(piece.volume_mm3 / length);
  }
  return stations;
}

/// Between beads the feeder keeps its last command.
std::vector<double> GrownDeposit::arrivedSections(const Stations& stations) {
  const PlantSettings& plant = plant_.settings();
  if (plant.dead_time_s == 0.0 && plant.lag_s == 0.0) return stations.section_mm2;
  if (!commanded_.value.empty()) {
    commanded_.time_s.push_back(stations.time_s.front());
    commanded_.value.push_back(commanded_.value.back());
  }
  commanded_.time_s.insert(commanded_.time_s.end(), stations.time_s.begin(), stations.time_s.end());
  commanded_.value.insert(commanded_.value.end(), stations.section_mm2.begin(), stations.section_mm2.end());
  std::vector<double> arrived = delayed(commanded_, stations.time_s, plant);
  const double forgotten_s = stations.time_s.back() - plant.dead_time_s - kRemembered * plant.lag_s;
  const auto kept = std::lower_bound(commanded_.time_s.begin(), commanded_.time_s.end(), forgotten_s);
  const auto dropped = std::max<std::ptrdiff_t>(0, kept - commanded_.time_s.begin() - 1);
  commanded_.time_s.erase(commanded_.time_s.begin(), commanded_.time_s.begin() + dropped);
  commanded_.value.erase(commanded_.value.begin(), commanded_.value.begin() + dropped);
  return arrived;
}

/// Each cell once, with its nearest station. Beside the ends of an open bead nothing is deposited.
std::vector<GrownDeposit::CoveredCell> GrownDeposit::coveredCells(const Stations& stations,
                                                                  double width_mm) const {
  const std::vector<double>& offset = plant_.settings().nozzle_offset_mm;
  const double across_mm = offset.size() == 3 ? offset[1] : 0.0;
  const double per_station = stations.length_mm / static_cast<double>(stations.place.size());
  const bool is_closed = isClosed(bead_);
  std::vector<CoveredCell> covered;
  std::unordered_map<std::size_t, std::size_t> known;  // cell to its place in `covered`
  double begun_mm = 0.0;
  for (const GrownPiece& piece : bead_) {
    const double length = lengthOf(piece);
    const bool begins = !is_closed && &piece == &bead_.front();
    const bool ends = !is_closed && &piece == &bead_.back();
    forCellsBeside(surface_.grid(), stripeOf(piece, across_mm, width_mm),
                   [&](std::size_t cell, double at_mm, double distance_mm) {
                     if ((begins && at_mm < 0.0) || (ends && at_mm > length)) return;
                     const double along = begun_mm + std::clamp(at_mm, 0.0, length);
                     const auto station =
                         std::min(stations.place.size() - 1, static_cast<std::size_t>(along / per_station));
                     const auto [place, is_new] = known.try_emplace(cell, covered.size());
                     if (is_new) covered.push_back({cell, station, distance_mm});
                     CoveredCell& nearest = covered[place->second];
                     if (distance_mm < nearest.distance_mm) nearest = {cell, station, distance_mm};
                   });
    begun_mm += length;
  }
  return covered;
}

/// What a bead stands on at each station: the mean of the cells that are no deeper than half a layer under
/// the highest one, or of all cells where nothing was deposited yet: a gap under it would be bridged, but it
/// fits a bed that slopes. What its own layer has deposited before is no ground, unless there is nothing
/// else.
std::vector<double> GrownDeposit::groundUnder(const std::vector<CoveredCell>& covered,
                                              std::size_t stations) const {
  std::vector<double> highest(stations, -std::numeric_limits<double>::infinity());
  std::vector<bool> has_ground(stations, false);
  std::vector<bool> is_bare(stations, true);
  for (const CoveredCell& each : covered) {
    if (!isOfLayer(each.cell)) has_ground[each.station] = true;
    if (isDeposited(each.cell)) is_bare[each.station] = false;
  }
  const auto counts = [&](const CoveredCell& each) {
    return !has_ground[each.station] || !isOfLayer(each.cell);
  };
  for (const CoveredCell& each : covered)
    if (counts(each)) highest[each.station] = std::max(highest[each.station], surface_.at(each.cell));
  std::vector<double> sum(stations, 0.0);
  std::vector<double> cells(stations, 0.0);
  for (const CoveredCell& each : covered) {
    const double height = surface_.at(each.cell);
    const bool is_gap = !is_bare[each.station] && height < highest[each.station] - kBridged * planned_mm_;
    if (!counts(each) || is_gap) continue;
    sum[each.station] += height;
    cells[each.station] += 1.0;
  }
  for (std::size_t i = 0; i < stations; ++i)
    if (cells[i] > 0.0) sum[i] /= cells[i];
  return sum;
}

/// Over a bare bed that slopes a bead has its foot where the bed comes near its planned underside, and what
/// is beyond hangs on, as over the bead below. One that the bed does not reach falls on to it.
void GrownDeposit::hangOnFeet(const std::vector<CoveredCell>& covered, const Stations& stations,
                              std::vector<double>& ground) const {
  if (is_ground_level_) return;
  const std::size_t count = stations.place.size();
  std::vector<double> highest(count, -std::numeric_limits<double>::infinity());
  std::vector<bool> is_bare(count, true);
  for (const CoveredCell& each : covered) {
    highest[each.station] = std::max(highest[each.station], surface_.at(each.cell));
    if (isDeposited(each.cell)) is_bare[each.station] = false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double underside = stations.place[i].z() - planned_mm_;
    const bool is_reached = underside - highest[i] <= kBridged * planned_mm_;
    if (is_bare[i]) ground[i] = std::max(ground[i], is_reached ? underside : highest[i]);
  }
}

/// The bead as planned, without its correction and what it stands on.
PlantBead GrownDeposit::beadOf(const Stations& stations) const {
  const std::size_t count = stations.place.size();
  PlantBead bead;
  bead.layer = layer_;
  bead.layers = static_cast<std::size_t>(settings_.layers);
  bead.path = beads_;
  bead.length_mm = stations.length_mm;
  bead.is_closed = isClosed(bead_);
  bead.layer_s = layer_s_;
  bead.planned_mm.assign(count, planned_mm_);
  bead.along_mm.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    bead.along_mm.push_back((static_cast<double>(i) + 0.5) * stations.length_mm / static_cast<double>(count));
  return bead;
}

void GrownDeposit::raise(std::size_t cell, double height_mm) {
  surface_.set(cell, height_mm);
  deposited_in_[cell] = static_cast<std::uint32_t>(layer_ + 1);
  highest_ = std::max(highest_, height_mm);
}

void GrownDeposit::grow(const Stations& stations, const std::vector<double>& sections, double width_mm) {
  const std::size_t count = stations.place.size();
  const std::vector<CoveredCell> covered = coveredCells(stations, width_mm);
  std::vector<double> ground = groundUnder(covered, count);
  hangOnFeet(covered, stations, ground);
  PlantBead bead = beadOf(stations);
  bead.correction.reserve(count);
  bead.nozzle_far_mm.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    bead.correction.push_back(sections[i] / (width_mm * planned_mm_) - 1.0);
    bead.nozzle_far_mm.push_back(stations.place[i].z() - planned_mm_ - ground[i]);
  }
  const std::vector<double> after = plant_.afterBead(bead, ground);
  for (const CoveredCell& each : covered) {
    const double onto = isOfLayer(each.cell) ? surface_.at(each.cell) : ground[each.station];
    const double least = isDeposited(each.cell) ? lowest_ : surface_.at(each.cell);
    raise(each.cell, std::max(least, onto + after[each.station] - ground[each.station]));
  }
}

/// Too little material lies on the ground, lower than the nozzle; where the nozzle is at the ground, nothing
/// comes out.
void GrownDeposit::press(const Stations& stations, const std::vector<double>& sections, double width_mm) {
  const std::size_t count = stations.place.size();
  // Narrower than a cell is across corners, it might hold no cell's middle, and there would be no ground.
  const double middle_mm = std::max(kMiddle * width_mm, std::sqrt(2.0) * surface_.grid().cell_mm);
  const std::vector<double> ground = groundUnder(coveredCells(stations, middle_mm), count);
  const PlantBead bead = beadOf(stations);
  const double settled_mm = plant_.settling(bead) * planned_mm_;
  std::vector<BeadSection> pressed(count);
  double widest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double room_mm = stations.place[i].z() + plant_.nozzleAbove() - ground[i];
    const double along = bead.along_mm[i];
    const double arrived = plant_.gainAt(bead, along) + plant_.randomAt(bead, along);
    const double area = sections[i] * std::max(0.0, arrived);
    if (!(room_mm > 0.0) || area == 0.0) continue;
    pressed[i] = {widthOnFlatGround(area, room_mm), std::min(room_mm, discDiameter(area)),
                  surface_.grid().cell_mm};
    widest = std::max(widest, pressed[i].width_mm);
  }
  for (const CoveredCell& each : coveredCells(stations, widest)) {
    const BeadSection& section = pressed[each.station];
    if (each.distance_mm > 0.5 * section.width_mm) continue;
    const double height = ground[each.station] + topAbove(section, each.distance_mm) - settled_mm;
    if (height > surface_.at(each.cell)) raise(each.cell, height);
  }
}

}  // namespace lamina
