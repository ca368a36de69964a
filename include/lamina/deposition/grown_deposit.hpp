// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/deposition/growth_plant.hpp"
#include "lamina/geometry/voxel/height_map.hpp"

namespace lamina {

/// Properties of a process that grows otherwise than commanded, which motions do not show to a machine.
struct GrownDepositSettings {
  double bead_width_mm = 0.0;  ///< over which a bead grows; 0 for that of the first bead
  int layers = 100;            ///< of the job, over which the gain wears
};

/// Adds the keys deposit.bead_width_mm and deposit.layers.
void describe(SettingsSchema& schema, GrownDepositSettings& settings);

/// A straight piece of a bead as a machine ran it.
struct GrownPiece {
  Point3 start = Point3::Zero();  ///< nozzle tip [mm, bed]
  Point3 end = Point3::Zero();
  double volume_mm3 = 0.0;  ///< commanded
  double start_s = 0.0;     ///< machine time
  double end_s = 0.0;
};

/// Lays beads into a map of heights as a `GrowthPlant` lets them grow: upwards by volume over width, whatever
/// stands below, and not up to the nozzle. Layers and beads are recognised by the motions alone: a bead
/// ends where the next motion does not go on from it, a layer where the nozzle is half of the first layer
/// higher. All layers count as planned as high as the first one, which stands for what is commanded without
/// correction.
///
/// A bead has the same height all across its width: where it reaches beyond what it stands on, it bridges the
/// gap below. Where a bead crosses an earlier one of its own layer, the earlier one grows further.
///
/// A bead is deposited only once it has ended, because its ends and the levelling depend on all of it. The
/// feeder's dead time and lag act on the cross-section commanded by machine time; it is kept between beads.
/// The same motions give the same heights. Cost is proportional to the cells that beads cover.
class GrownDeposit {
 public:
  /// @param ground  known in all its cells
  GrownDeposit(HeightMap ground, PlantSettings plant, const GrownDepositSettings& settings);

  /// A piece without volume or length lays nothing.
  /// @throws InvalidInput if a piece is not finite, or its volume negative
  void lay(const GrownPiece& piece);
  /// The bead under way is deposited as far as it came.
  void endBead();

  const HeightMap& surface() const { return surface_; }
  /// Largest height of the surface [mm].
  double highest() const { return highest_; }

 private:
  /// Where the stations of a bead lie, and what they are given.
  struct Stations {
    double length_mm = 0.0;
    std::vector<Point3> place;
    std::vector<double> time_s;
    std::vector<double> section_mm2;  ///< commanded
  };
  /// A cell of the map under a bead.
  struct CoveredCell {
    std::size_t cell = 0;
    std::size_t station = 0;
    double distance_mm = 0.0;
  };

  void beginLayer(double z_mm, double start_s);
  Stations stationsOfBead() const;
  std::vector<double> arrivedSections(const Stations& stations);
  std::vector<CoveredCell> coveredCells(const Stations& stations, double width_mm) const;
  std::vector<double> groundUnder(const std::vector<CoveredCell>& covered, std::size_t stations) const;
  bool isOfLayer(std::size_t cell) const { return deposited_in_[cell] == layer_ + 1; }
  void grow(const Stations& stations, const std::vector<double>& sections, double width_mm);

  HeightMap surface_;
  GrowthPlant plant_;
  GrownDepositSettings settings_;
  double highest_;
  std::vector<std::uint32_t> deposited_in_;  ///< layer of each cell, from 1; 0 where nothing was deposited
  std::vector<GrownPiece> bead_;
  std::size_t layer_ = 0;
  std::size_t beads_ = 0;           ///< of the layer
  double planned_mm_ = 0.0;         ///< height of a layer; 0 before the first bead
  double layer_z_mm_ = 0.0;         ///< nozzle at the layer's first bead
  double layer_start_s_ = 0.0;      ///< of the layer
  double layer_s_ = 0.0;            ///< from the layer below to this one; 0 for the first
  std::optional<double> width_mm_;  ///< of beads, once known
  TimedValues commanded_;           ///< cross-section, as far back as the feeder remembers [mm2]
};

}  // namespace lamina
