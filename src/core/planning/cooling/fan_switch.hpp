// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/planning/cooling/cooling_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Sends a share of the fan where it differs from the one sent before by 1/255 or more.
class FanSwitch {
 public:
  /// @param settings  must outlive this
  explicit FanSwitch(const FanSettings& settings) : settings_(settings) {}

  bool isOn() const { return steps_ != 0; }

  /// Adds events to the paths of the next layer: at its start, and before and after what lies over nothing.
  /// No fan follows stretches shorter than 2 mm, nor gaps between them.
  /// @param share  of the layer
  void addTo(std::vector<Path>& paths, double share);

 private:
  void addTo(Path& path, double share);
  void change(Path& path, std::size_t motion, double share);

  const FanSettings& settings_;
  std::int64_t steps_ = 0;
};

}  // namespace lamina
