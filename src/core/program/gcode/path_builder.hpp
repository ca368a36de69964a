// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A run of motions of one kind, on its way to become a path.
class PathBuilder {
 public:
  /// Begins with the first motion.
  PathBuilder(const GcodeMotion& motion, bool is_retracted);

  bool deposits() const { return deposits_; }
  /// Whether the motion continues the run.
  bool accepts(const GcodeMotion& motion, bool is_retracted) const;
  void add(const GcodeMotion& motion);
  /// Before the motion added last.
  void addEvents(std::vector<ToolpathEvent> events);
  void setTool(std::uint32_t tool) { tool_ = tool; }

  /// Layer height the comments reported where the run begins, if they did.
  std::optional<double> layerHeight() const { return layer_height_mm_; }
  double lastZ() const { return points_.back().z(); }

  /// @param layer_height_mm  bead height where no comment reported another
  /// @param volume_per_filament  [mm³/mm]
  Path build(double layer_height_mm, double volume_per_filament) const;

 private:
  bool isClosed() const;
  AlongPath<Bead> beads(double layer_height_mm, double volume_per_filament) const;

  bool deposits_;
  bool is_retracted_;
  std::optional<PathRole> role_;
  std::optional<double> layer_height_mm_;
  std::size_t section_;
  std::vector<Point3> points_;
  std::vector<double> filament_mm_;               ///< of each motion
  std::vector<double> feed_mm_s_;                 ///< of each motion
  std::vector<std::optional<double>> height_mm_;  ///< of each motion
  std::uint32_t tool_ = 0;
  std::vector<PathEvent> events_;
};

}  // namespace lamina
