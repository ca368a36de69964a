// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/control/height_loop.hpp"
#include "lamina/control/part_learning.hpp"
#include "lamina/control/run/loop_run_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Collects what a part teaches the next one of the same program, machine and material, layer by layer, in
/// eight bytes per cell. Cells that were not seen teach nothing.
class TaughtPart {
 public:
  /// Reads the map of previous parts if the settings name one.
  /// @throws FileError; InvalidInput as `readPartMap`, or naming what differs: program, machine, material,
  ///   layers, or cells of a layer
  TaughtPart(const Toolpath& toolpath, PartIdentity identity, const LoopRunSettings& settings);

  /// Amounts learnt for a layer; empty without a map.
  std::vector<double> amountsOf(std::size_t layer) const;

  /// Begins a layer: takes the height errors of the surface below it.
  void begin(const HeightLoop& loop);
  /// Ends the layer.
  /// @param amount  relative amounts with which it was deposited, one per cell
  void end(const HeightLoop& loop, const std::vector<double>& amount);
  /// States that the rest of the program is another one: nothing is learnt, and the map is used no more.
  void abandon();

  /// The map for the next part; none if machine or material has no name, or a layer is not done.
  std::optional<PartMap> learnt(const Toolpath& toolpath, PartEnd end) const;

 private:
  struct Layer {
    std::vector<float> amount;
    std::vector<float> growth_error_mm;
  };
  LoopRunSettings settings_;
  PartIdentity identity_;
  PartMap before_;
  bool is_abandoned_ = false;
  std::vector<double> error_mm_;  ///< of the layer's cells before it was deposited
  std::vector<Layer> layers_;
};

}  // namespace lamina
