// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "lamina/program/gcode/gcode_dialect.hpp"
#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "program/gcode/path_arcs.hpp"

namespace lamina {

/// What is known where a layer begins.
struct LayerStart {
  std::size_t index = 0;
  double filament_mm = 0.0;        ///< deposited by the layers before, without retractions
  bool is_retracted = false;       ///< by the path before
  bool next_is_retracted = false;  ///< the path after the layer's last one is a retracted one
  std::uint32_t tool = 0;          ///< of the path before
};

/// Writes the layers of a toolpath as G-code; each layer by itself, so that layers can be written in any
/// order.
class LayerWriter {
 public:
  /// @param layer_normal  of unit length [part frame]
  LayerWriter(const ProgramFrame& frame, const Point3& layer_normal, const ProgramSettings& settings);

  /// Appends the layer to `text`.
  void write(const ToolpathLayer& layer, const LayerStart& start, std::string& text) const;

 private:
  static constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();

  /// Words that hold until they are written again, in units of their last decimal.
  struct Modal {
    std::int64_t x = kUnknown, y = kUnknown, z = kUnknown, feed = kUnknown;
    std::int64_t height = kUnknown;  ///< of the beads
    std::int64_t filament = 0;       ///< sum of all E so far
    double filament_mm = 0.0;        ///< the same before rounding
    Point3 shift = Point3::Zero();   ///< of the axes, for the tool at work
    bool is_depositing = false;      ///< or pulling back: which E does not say where there is none
  };

  void writeDrops(const Path& path, Modal& modal, std::string& text) const;
  void writePath(const Path& path, Modal& modal, std::string& text) const;
  /// A travel on which filament is pulled back [mm].
  void writeWipe(const Path& path, double retraction_mm, Modal& modal, std::string& text) const;
  void writeEvents(const Path& path, std::size_t motion, Modal& modal, std::string& text) const;
  static void writeHeight(double height_mm, Modal& modal, std::string& text);
  void writeMotion(const Point3& end, double feed_mm_s, Modal& modal, std::string& text) const;
  /// @param motion  the first that the arc stands for
  void writeArc(const Path& path, std::size_t motion, const FittedArc& arc, Modal& modal,
                std::string& text) const;
  void writeRetraction(double length_mm, Modal& modal, std::string& text) const;

  /// None if there are to be none.
  std::optional<PathArcs> arcsOf(const Path& path, const Modal& modal) const;

  /// In the program.
  Point3 placeOf(const Point3& point, const Modal& modal) const {
    return linear_ * point + translation_ + modal.shift;
  }

  /// Of the axes over that of the nozzle.
  double feedFactor(const Point3& start, const Point3& end) const;

  Eigen::Matrix3d linear_;  ///< program_from_part
  Point3 translation_;
  ProgramFrame frame_;
  bool is_mapped_;  ///< axes are not the bed's: lengths along them may differ
  double rise_mm_;  ///< of the part along the layers' normal
  GcodeDialect dialect_;
  double filament_per_volume_;
  ProgramSettings settings_;
};

}  // namespace lamina
