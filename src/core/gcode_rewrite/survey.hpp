// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "gcode_rewrite/point_transform.hpp"
#include "gcode_rewrite/program_tracker.hpp"
#include "lamina/program/program_frame.hpp"

namespace lamina {

/// A bounding box, and the lines of the program that reach its sides.
struct Extremes {
  Box3 box;
  std::array<std::size_t, 3> low_line{};
  std::array<std::size_t, 3> high_line{};

  void include(const Point3& point, std::size_t line);
};

/// Totals of the part of a program. Boxes are after the map and before the shift [mm].
struct SurveyTotals {
  Extremes part;    ///< both ends of depositing motions, without build aids
  Extremes aids;    ///< both ends of motions that deposit skirt, brim, raft, support or priming tower
  Extremes nozzle;  ///< ends of all motions except those of dropped build aids
  std::size_t layers = 0;
  std::size_t first_layer = 0;  ///< value of `layers` at the first deposition of the part
  /// Lowest end of a deposition of the part in its first layer, after the map and before the shift [mm].
  double first_layer_low_mm = std::numeric_limits<double>::infinity();
  std::size_t motions = 0;
  std::size_t depositions = 0;
  std::size_t arcs = 0;
  std::size_t last_deposition = 0;          ///< line number
  std::size_t motion_after_deposition = 0;  ///< line of the first later motion; 0 if there is none
  std::size_t pushing = 0;                  ///< number of motions with E that deposit
  std::size_t not_pushing = 0;              ///< number of motions with E that do not deposit
};

struct Survey {
  SurveyTotals totals;
  std::size_t end_line = 0;  ///< first line of the end code; 0 if the part continues to the end of the file
  std::size_t lines = 0;
  std::string slicer;
  std::optional<double> layer_height_mm;  ///< as comments state it
  StatedFrame frame;                      ///< as comments state it
};

/// The first pass over a program: finds where its part ends and how far the part extends, and refuses what
/// cannot be transformed.
class Surveyor {
 public:
  Surveyor(const PointTransform& transform, const RewriteSettings& settings);

  /// @throws InvalidProgram naming the line, as `ProgramTracker::read`
  void read(std::string_view line, std::size_t number);

  /// @throws InvalidProgram if no comment opens a layer, nothing is deposited, motions after the last
  ///   deposition may belong to the part or to the end code, or E looks relative although nothing states so
  Survey finish();

 private:
  void readFrame(std::size_t number);
  void readMark(std::size_t number);
  void addMotion(std::size_t number);
  void addPoints(const std::vector<Point3>& ends, std::size_t number);
  void addToFirstLayer(const Point3& mapped);

  const PointTransform& transform_;
  BuildAids build_aids_;
  double chord_tolerance_mm_;
  ProgramTracker tracker_;
  Survey survey_;
  SurveyTotals live_;  ///< totals as if the part had not ended
  std::optional<std::string>
      refusal_;  ///< refusal of the first line that cannot be transformed after the part may have ended
};

}  // namespace lamina
