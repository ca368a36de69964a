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

/// State of the program at the beginning of a layer.
struct LayerStart {
  std::size_t index = 0;
  double filament_mm = 0.0;        ///< filament deposited by the layers before, without retractions
  bool is_retracted = false;       ///< whether the path before ends retracted
  bool next_is_retracted = false;  ///< whether the path after the layer's last one begins retracted
  std::uint32_t tool = 0;          ///< tool of the path before
};

/// Writes the layers of a toolpath as G-code. Each layer is written independently, so that layers may be
/// written in any order.
class LayerWriter {
 public:
  /// @param layer_normal  of unit length [part frame]
  LayerWriter(const ProgramFrame& frame, const Point3& layer_normal, const ProgramSettings& settings);

  /// Appends the text of a layer to `text`.
  void write(const ToolpathLayer& layer, const LayerStart& start, std::string& text) const;

 private:
  static constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();

  /// Modal words as last written, in units of their last decimal.
  struct Modal {
    std::int64_t x = kUnknown, y = kUnknown, z = kUnknown, feed = kUnknown;
    std::int64_t height = kUnknown;  ///< height of the beads
    std::int64_t filament = 0;       ///< sum of all E so far
    double filament_mm = 0.0;        ///< that sum before rounding
    Point3 shift = Point3::Zero();   ///< shift of the axes for the tool in use
    bool is_depositing = false;      ///< state of the process; written only if E does not imply it
  };

  void writeDrops(const Path& path, Modal& modal, std::string& text) const;
  void writePath(const Path& path, Modal& modal, std::string& text) const;
  /// Writes a travel during which filament is retracted [mm].
  void writeWipe(const Path& path, double retraction_mm, Modal& modal, std::string& text) const;
  void writeEvents(const Path& path, std::size_t motion, Modal& modal, std::string& text) const;
  static void writeHeight(double height_mm, Modal& modal, std::string& text);
  void writeMotion(const Point3& end, double feed_mm_s, Modal& modal, std::string& text) const;
  /// @param motion  the first motion that the arc replaces
  void writeArc(const Path& path, std::size_t motion, const FittedArc& arc, Modal& modal,
                std::string& text) const;
  void writeRetraction(double length_mm, Modal& modal, std::string& text) const;

  /// Arcs of a path; nothing if the settings ask for none.
  std::optional<PathArcs> arcsOf(const Path& path, const Modal& modal) const;

  /// A point in the coordinates of the program.
  Point3 placeOf(const Point3& point, const Modal& modal) const {
    return linear_ * point + translation_ + modal.shift;
  }

  /// Factor from the nozzle's feed to that of the axes.
  double feedFactor(const Point3& start, const Point3& end) const;

  Eigen::Matrix3d linear_;  ///< program_from_part
  Point3 translation_;
  ProgramFrame frame_;
  bool is_mapped_;  ///< whether axes differ from those of the bed, so that lengths along them may differ
  double rise_mm_;  ///< rise of the part's origin along the layers' normal
  GcodeDialect dialect_;
  double filament_per_volume_;
  ProgramSettings settings_;
};

}  // namespace lamina
