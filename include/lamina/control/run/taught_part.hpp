// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/control/height_loop.hpp"
#include "lamina/control/part_learning.hpp"
#include "lamina/control/run/run_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What a part teaches the next one of the same program, machine and material, collected layer by layer:
/// eight bytes a cell. What was not seen of it teaches nothing.
class TaughtPart {
 public:
  /// Reads the map that the settings name, if they name one.
  /// @throws FileError; InvalidInput as `readPartMap`, or naming what differs: program, machine, material,
  ///   layers, or cells of a layer
  TaughtPart(const Toolpath& toolpath, PartIdentity identity, const LoopRunSettings& settings);

  /// Amounts learnt for a layer; empty without a map.
  std::vector<double> amountsOf(std::size_t layer) const;

  /// A layer is about to be laid: errors of what it is laid onto.
  void begin(const HeightLoop& loop);
  /// It is done.
  /// @param amount  that it was laid with, one per cell
  void end(const HeightLoop& loop, const std::vector<double>& amount);
  /// The program is no longer the one that was begun with: nothing is learnt, and the map holds no more.
  void abandon();

  /// The map for the next part; none where machine or material are not named, or a layer is not done.
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
  std::vector<double> error_mm_;  ///< of the layer's cells before it was laid
  std::vector<Layer> layers_;
};

}  // namespace lamina
