// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/control/cell_estimate.hpp"
#include "lamina/control/layer_cells.hpp"
#include "lamina/control/loop_settings.hpp"
#include "lamina/control/trailing_trim.hpp"

namespace lamina {

/// A layer under way, trimmed by what a sensor behind the nozzle sees of it (`TrailingTrim`), cell by cell in
/// the order in which they are laid. What the nozzle, and what was handed over ahead of it, has passed stays
/// as it is.
class LayerTrim {
 public:
  static constexpr double kLeastChange = 0.002;  ///< of an amount, that is worth telling

  /// @param laid    as they are predicted, the layer being laid with these amounts
  /// @param amount  one per cell
  LayerTrim(const LayerCells& cells, const std::vector<CellEstimate>& laid, std::vector<double> amount,
            const LoopSettings& settings, const TrimSettings& trim);

  /// The nozzle has laid that many cells.
  /// @return whether amounts of cells to come are others than were told last
  bool advance(std::size_t laid, const std::vector<CellEstimate>& estimates);

  /// Of all cells, trims added, within the limits of the loop.
  const std::vector<double>& amount() const { return amount_; }

 private:
  std::optional<double> relativeError(std::size_t cell, const std::vector<CellEstimate>& estimates) const;

  TrailingTrim trim_;
  std::vector<double> planned_;       ///< amounts without trims
  std::vector<double> amount_;        ///< with them
  std::vector<double> predicted_mm_;  ///< errors by the amounts without trims
  std::vector<double> growth_mm_;     ///< likewise
  std::size_t behind_;                ///< the sensor, in cells
  std::size_t lead_;                  ///< what was handed over, in cells
  double least_;
  double greatest_;
  std::size_t laid_ = 0;
  double told_ = 0.0;  ///< trim
};

/// The trim of such a layer; none if the settings ask for none, or the layer is too short for it.
std::optional<LayerTrim> layerTrim(const LayerCells& cells, const std::vector<CellEstimate>& laid,
                                   const std::vector<double>& amount, const LoopSettings& settings);

}  // namespace lamina
