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

/// Settings of a process whose growth differs from the commanded one: those that the motions do not state.
struct GrownDepositSettings {
  double bead_width_mm = 0.0;  ///< width over which a bead grows; 0: that of the first bead
  int layers = 100;            ///< number of layers of the job, over which the gain wears
};

/// Adds the keys deposit.bead_width_mm and deposit.layers.
void describe(SettingsSchema& schema, GrownDepositSettings& settings);

/// A straight piece of a bead as a machine executed it.
struct GrownPiece {
  Point3 start = Point3::Zero();  ///< nozzle tip [mm, bed]
  Point3 end = Point3::Zero();
  double volume_mm3 = 0.0;  ///< commanded
  double start_s = 0.0;     ///< machine time at the start
  double end_s = 0.0;       ///< machine time at the end
};

/// Deposits beads into a height map with the growth of a `GrowthPlant`: upwards by volume over width from the
/// surface below, and not up to the nozzle. Layers and beads are recognised by the motions alone. A bead ends
/// where the next motion does not continue it; a layer ends where the nozzle is higher by half of the first
/// layer. The planned height of all layers is taken to be that of the first bead above the ground at its
/// start, and the cross-section of planned height and width counts as commanded without correction. Over
/// sloping ground, such as the bed under a leaning tool axis, the height is the first bead's cross-section
/// over the stated width. Without a stated width the height is the rise to the second layer; until then beads
/// are taken to be twice as wide as high. Over sloping ground a first bead begins at its planned underside if
/// the bed under the bead comes within half a layer of this underside at any point, since the foot holds the
/// bead. Otherwise the bead falls onto the highest point of the bed under it. If the mean of the bed under
/// the bead is higher, the bead stands on the mean. Pressed beads stand on the bed under their middle.
///
/// In a pressed process (`PlantSettings::pressed`) the nozzle forms the top: the section of a bead is a
/// stadium between the ground under its middle and the nozzle, with the width that the volume requires, and
/// settles afterwards. Stand-off, levelling, an offset along the bead and detached pieces have no effect on
/// it.
///
/// A bead has one height across its width: where it reaches beyond its support, it bridges the gap. Where a
/// bead crosses an earlier one of its own layer, the earlier one grows further.
///
/// A bead is deposited only when it has ended, because its ends and the levelling depend on the whole bead.
/// The feeder's dead time and lag act on the cross-section as commanded over machine time; between beads the
/// last command holds. The same motions give the same heights. The cost is proportional to the number of
/// cells that beads cover.
class GrownDeposit {
 public:
  /// @param ground  initial heights, known in all cells
  GrownDeposit(HeightMap ground, PlantSettings plant, const GrownDepositSettings& settings);

  /// Adds a piece. A piece without volume or length deposits nothing.
  /// @throws InvalidInput if a piece is not finite, or its volume is negative
  void lay(const GrownPiece& piece);
  /// Ends the bead under way and deposits it.
  void endBead();

  const HeightMap& surface() const { return surface_; }
  /// Greatest height of the surface [mm].
  double highest() const { return highest_; }
  /// Whether something was deposited on a cell of the surface.
  bool isDeposited(std::size_t cell) const { return deposited_in_[cell] > 0; }

 private:
  /// Positions along a bead, and the commanded values there.
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

  void beginLayer(double section_mm2);
  void plan(const Point3& at, double section_mm2);
  Stations stationsOfBead() const;
  std::vector<double> arrivedSections(const Stations& stations);
  std::vector<CoveredCell> coveredCells(const Stations& stations, double width_mm) const;
  std::vector<double> groundUnder(const std::vector<CoveredCell>& covered, std::size_t stations) const;
  void hangOnFeet(const std::vector<CoveredCell>& covered, const Stations& stations,
                  std::vector<double>& ground) const;
  bool isOfLayer(std::size_t cell) const { return deposited_in_[cell] == layer_ + 1; }
  PlantBead beadOf(const Stations& stations) const;
  void grow(const Stations& stations, const std::vector<double>& sections, double width_mm);
  void press(const Stations& stations, const std::vector<double>& sections, double width_mm);
  void raise(std::size_t cell, double height_mm);

  HeightMap surface_;
  GrowthPlant plant_;
  GrownDepositSettings settings_;
  double highest_;
  double lowest_;                            ///< height of the lowest ground [mm]
  bool is_ground_level_;                     ///< before anything was deposited
  std::vector<std::uint32_t> deposited_in_;  ///< layer of each cell, from 1; 0 where nothing was deposited
  std::vector<GrownPiece> bead_;
  std::size_t layer_ = 0;
  std::size_t beads_ = 0;            ///< number of beads of the layer so far
  double planned_mm_ = 0.0;          ///< height of a layer; 0 before the first bead
  bool is_planned_guessed_ = false;  ///< whether the second layer will determine it
  double layer_z_mm_ = 0.0;          ///< height of the nozzle at the layer's first bead
  double layer_start_s_ = 0.0;       ///< time at which the layer began
  double layer_s_ = 0.0;  ///< time from the start of the layer below to that of this one; 0 for the first
  std::optional<double> width_mm_;  ///< width of beads, once known
  TimedValues commanded_;           ///< cross-section, as far back as the feeder remembers [mm2]
};

}  // namespace lamina
