// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "control/run/laid_layer.hpp"
#include "lamina/control/correction_map.hpp"
#include "lamina/control/height_loop.hpp"
#include "lamina/control/run/loop_run_settings.hpp"

namespace lamina {

/// The coasting maps of the layer under way and of the next one. A machine deposits a layer by its coasting
/// map if the layer's own map does not come in time.
class CoastingMaps {
 public:
  /// Gives the next layer its coasting map and, for a feeder with a dead time, the amounts expected at the
  /// start of that layer. The map uses the growth learnt so far, not the error, as measurements of the layer
  /// under way may come too late.
  /// @param next  the loop at the beginning of the next layer, as if the layer under way had not been
  ///   measured
  /// @param laid  the layer under way
  const CorrectionMap& give(const HeightLoop& next, const LaidLayer& laid, const std::string& toolpath_id,
                            const LoopRunSettings& settings);
  /// Begins a layer. The layer falls back on its coasting map if it has one.
  void begin(std::size_t layer, LaidLayer& laid);

  /// The map of the layer under way with what is expected of the next one.
  CorrectionMap withAhead(CorrectionMap map) const;

  /// States that the machine has begun the layer under way by its coasting map.
  void use() { is_used_ = true; }
  bool isUsed() const { return is_used_; }

  /// The coasting map of a layer; null if it has none, or is done.
  const CorrectionMap* of(std::size_t layer) const;

 private:
  std::optional<LaidLayer> next_;              ///< as it is if its coasting map is applied
  std::map<std::size_t, CorrectionMap> maps_;  ///< by layer
  ExpectedBeginning ahead_;                    ///< of the next layer
  bool is_used_ = false;
};

}  // namespace lamina
