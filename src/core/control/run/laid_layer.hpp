// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/height_loop.hpp"
#include "lamina/control/run/loop_run.hpp"
#include "lamina/control/run/loop_run_settings.hpp"

namespace lamina {

/// Amounts and shifts of the nozzle with which the layer under way is deposited, one of each per cell. They
/// are those of the layer's last map, except on cells that the machine deposited without it.
///
/// The end of the previous layer carries over: its last amount fades if the loop no longer corrects, and its
/// mean shift changes gradually.
class LaidLayer {
 public:
  /// Sets what carries over to the next layer.
  /// @param last_amount    relative amount by which the layer ends
  /// @param mean_shift_mm  mean shift of the nozzle along the growth direction
  void carryOver(double last_amount, double mean_shift_mm);

  /// States by what of the layer is deposited that has no map in time, once it is decided.
  /// @param coasting  that layer as it was decided when the one before began
  void fallBackOn(const LaidLayer& coasting) { coasting_ = coasting.mapped_; }

  /// Decides the layer that the loop has begun.
  /// @param state  of the loop for this layer
  void decide(const HeightLoop& loop, LoopState state, const LoopRunSettings& settings);
  /// Replaces the whole layer, its map included, by the plan: all amounts and shifts are 0.
  void layAsPlanned(const LayerCells& cells, const LoopSettings& settings);
  /// Replaces the amounts, in the map too.
  /// @param amount  relative, one for each cell
  void trim(const LayerCells& cells, std::vector<double> amount, const LoopSettings& settings);
  /// How cells are deposited that are sent to the machine before their map.
  enum class Without : std::uint8_t {
    Map,    ///< as planned
    OwnMap  ///< by the coasting map, if the layer has one
  };
  /// Lays the first cells without the last map, and the others by it, no faster than the feeder follows. On
  /// the first cells the last amount of the previous layer fades to 0 or to the amounts of the coasting map.
  /// @param cell  number of cells that the machine deposited without the map; 0 if it has all of them
  void layMapFrom(const LayerCells& cells, std::size_t cell, const LoopSettings& settings,
                  Without without = Without::Map);

  /// Whether the map changes nothing of the plan on any cell that is laid by it.
  bool isAsPlanned() const;
  /// Whether part of the layer is laid without its map.
  bool isMapMissed() const { return is_map_missed_; }
  /// Whether the whole layer is laid without its map.
  bool isWhollyMissed() const { return is_wholly_missed_; }

  /// The amounts by which the layer grows.
  const LayerCorrection& correction() const { return laid_; }
  /// Shift of the nozzle along the growth direction by cell [mm]; empty before the first layer.
  const std::vector<double>& shift() const { return shift_mm_; }
  double meanShift() const { return mean_shift_mm_; }  ///< [mm]
  double lastAmount() const { return last_amount_; }   ///< relative amount by which the layer ends
  LoopState state() const { return state_; }           ///< of the loop as it shows in the layer
  /// The last map, as the machine gets it.
  CorrectionMap map(const LayerCells& cells, const std::string& toolpath_id, std::uint64_t sequence) const;

  /// The outcome of each cell.
  std::vector<CellOutcome> outcomes(const LayerCells& cells,
                                    const std::vector<CellEstimate>& estimates) const;

 private:
  LayerCorrection wanted(const HeightLoop& loop, LoopState state, const LoopSettings& settings) const;
  void shiftNozzle(const HeightLoop& loop, LoopState state, const LoopRunSettings& settings);
  void realise(const LayerCells& cells, const LoopSettings& settings);

  /// The layer as it is if all of its last map is applied.
  struct Mapped {
    LayerCorrection correction;
    std::vector<double> shift_mm;
    LoopState state = LoopState::Off;
  };
  Mapped mapped_;
  std::optional<Mapped> coasting_;  ///< the same of the coasting map
  CellCorrections told_;            ///< for the machine, of the last map
  LayerCorrection laid_;
  std::vector<double> shift_mm_;
  LoopState state_ = LoopState::Off;
  bool is_map_missed_ = false;
  bool is_wholly_missed_ = false;
  double first_amount_ = 0.0;  ///< last amount of the previous layer
  double mean_shift_mm_ = 0.0;
  double last_amount_ = 0.0;
};

}  // namespace lamina
