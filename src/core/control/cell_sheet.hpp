// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "control/station_index.hpp"
#include "control/straight_beads.hpp"
#include "lamina/control/cell_atlas.hpp"

namespace lamina {

/// The cells of one layer of an atlas. Most look-ups are decided by a few bytes of each cell, which are
/// stored together, apart from its other values.
class CellSheet {
 public:
  CellSheet(std::shared_ptr<const LayerCells> cells, double window_layers);

  /// The cell that a point lies on, among the first `deposited` cells; nothing if there is none.
  std::optional<CellSight> look(const Point3& point) const;
  /// `look` for many points, with the memory of their cells fetched in advance.
  std::vector<std::optional<CellSight>> look(const std::vector<Point3>& points) const;

  const std::shared_ptr<const LayerCells>& cells() const { return cells_; }
  bool isPlane() const { return is_plane_; }
  std::size_t bytes() const;

  std::size_t deposited = 0;

 private:
  /// A point of a plane layer, in the axes of the index.
  struct PlanePlace {
    float u, v;
    double z;
  };
  /// A cell of a plane layer, in the axes of the index.
  struct alignas(32) PlaneStation {  // two per cache line
    float u, v;
    float tangent_u, tangent_v;
    float half;  ///< half the cell's length
    float width;
    float lift;  ///< height of the top above that of the first cell
    float left;  ///< curvature along the path, positive to the left [1/mm]

    float along(const PlanePlace& place) const;                   ///< [mm]
    float across(const PlanePlace& place, float along_mm) const;  ///< [mm]
  };
  /// A cell of any layer.
  struct BentStation {
    Point3 middle;
    Eigen::Vector3f tangent;
    Eigen::Vector3f growth;
    float half, width;
    float up, left;  ///< curvature along the path [1/mm]; up is negative over a crest

    double along(const Point3& off) const;  ///< of a point, given relative to the cell's middle
    float across(const Point3& off, double along_mm) const;     ///< [mm]
    double heightAt(const Point3& off, double along_mm) const;  ///< [mm] above the planned top
  };
  /// Coordinates of a point in the frame of a cell: `along` in half lengths, `across` in widths. Their
  /// default lies off the cell.
  struct LocalCoordinates {
    float along = std::numeric_limits<float>::infinity();
    float across = std::numeric_limits<float>::infinity();

    bool isOn() const;
    bool isOff() const { return across == std::numeric_limits<float>::infinity(); }
  };
  struct Found {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t cell = kNone;
    LocalCoordinates on;

    bool isCell() const { return cell != kNone; }
  };

  void addPlaneStations();
  void addBentStations();
  double windowOf(std::uint32_t cell) const { return window_mm_[window_mm_.size() == 1 ? 0 : cell]; }
  LocalCoordinates onPlane(std::uint32_t cell, const PlanePlace& place) const;
  LocalCoordinates onBent(std::uint32_t cell, const Point3& point) const;
  double heightOnPlane(const PlaneStation& station, const PlanePlace& place) const;
  template <class CoordinatesOf>
  Found best(const BoxCells::Numbers& near, CoordinatesOf coordinates) const;
  /// @param at  point in the axes of the index
  std::optional<CellSight> lookOnPlane(const Point3& at, const BoxCells::Numbers& near) const;
  CellSight sightOnPlane(std::uint32_t cell, const PlanePlace& place) const;
  std::vector<std::optional<CellSight>> lookAlongBeads(const std::vector<Point3>& points) const;
  std::optional<CellSight> lookOnBent(const Point3& point, const BoxCells::Numbers& near) const;
  void fetch(std::uint32_t cell) const;

  std::shared_ptr<const LayerCells> cells_;
  StationIndex index_;
  bool is_plane_;
  double first_top_ = 0.0;        ///< top of the first cell along the normal, of a plane layer
  std::vector<float> window_mm_;  ///< one for each cell, or one for all
  std::vector<PlaneStation> plane_;
  StraightBeads beads_;
  std::vector<BentStation> bent_;
};

}  // namespace lamina
