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

/// Collects, layer by layer, what the next part of the same program, machine and material learns from this
/// one, in eight bytes per cell. From cells that were not seen, or lie on ground that was not known, nothing
/// is learnt.
class TaughtPart {
 public:
  /// Reads the map of previous parts if the settings name one.
  /// @throws FileError if it cannot be read; InvalidInput as `readPartMap`, or naming what differs: program,
  ///   machine, material, layers, or cells of a layer; InvalidInput of a pressed process
  TaughtPart(const Toolpath& toolpath, PartIdentity identity, const LoopRunSettings& settings);

  /// Amounts learnt for a layer; empty without a map.
  std::vector<double> amountsOf(std::size_t layer) const;

  /// Begins a layer: stores the height errors of the surface below it.
  void begin(const HeightLoop& loop);
  /// Ends the layer.
  /// @param amount  relative amounts with which it was deposited, one per cell
  void end(const HeightLoop& loop, const std::vector<double>& amount);
  /// States that the rest of the program is replaced: nothing is learnt from this part, and its map is no
  /// longer used.
  void abandon();

  /// The map for the next part; none if machine or material has no name, the process is a pressed one (whose
  /// heights say nothing of amounts), the part was abandoned, or a layer with cells is not done.
  std::optional<PartMap> learnt(const Toolpath& toolpath, PartEnd end) const;

 private:
  bool teaches() const;

  struct Layer {
    std::vector<float> amount;
    std::vector<float> growth_error_mm;
  };
  LoopRunSettings settings_;
  PartIdentity identity_;
  PartMap before_;
  bool is_abandoned_ = false;
  /// Height errors of the layer's cells before it was deposited; NaN where they are not known.
  std::vector<double> error_mm_;
  std::vector<Layer> layers_;
};

}  // namespace lamina
