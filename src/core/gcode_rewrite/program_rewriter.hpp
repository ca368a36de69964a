// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "gcode_rewrite/closing_code.hpp"
#include "gcode_rewrite/filament_words.hpp"
#include "gcode_rewrite/point_transform.hpp"
#include "gcode_rewrite/program_tracker.hpp"
#include "gcode_rewrite/survey.hpp"

namespace lamina {

/// What the second pass did.
struct RewriteCounts {
  std::size_t deferred = 0;
  std::size_t homings_annulled = 0;
  std::size_t aids_dropped = 0;
};

/// Second pass over a program: appends each line as it is to be to a text.
class ProgramRewriter {
 public:
  /// @param transform  with its shift; all three must outlive this
  ProgramRewriter(const PointTransform& transform, const Survey& survey, const RewriteSettings& settings);

  void read(std::string_view line, std::size_t number, std::string& out);
  void finish(std::string& out);
  const RewriteCounts& counts() const { return counts_; }
  const Box3& footprint() const { return footprint_; }  ///< as in the report [mm]
  const Extremes& nozzle() const { return nozzle_; }    ///< places it goes to in the part, over the bed [mm]

 private:
  /// One of the chords that follow a motion.
  struct Chord {
    Point3 from = Point3::Zero();
    double length = 0.0;  ///< of all chords [mm]
    double done = 0.0;    ///< of this and those before [mm]
    double pushed = 0.0;  ///< filament of this and those before, as sliced
    double told = 0.0;    ///< sum of E written
  };

  void appendBeginCode(std::string& out);
  void copy(std::string_view line, std::string& out);
  void writeFilament(std::string& out);
  void defer(std::string& out);
  void writeMotion(std::string& out);
  void writeLine(std::string& out);
  void writeChords(const std::vector<Point3>& ends, std::string& out);
  void appendExtrusion(Chord& chord, double pushed, const Point3& end, std::string& out);
  void appendFeed(const Chord& chord, const Point3& end, std::string& out);
  bool isDropped() const;
  void drop(std::string& out);
  void writeInPlace(std::string& out);
  void restoreFilament(std::string& out);
  void restorePlace(std::string& out);
  void leavePart(std::string& out);
  Point3 place(const Point3& point);

  const PointTransform& transform_;
  const Survey& survey_;
  const RewriteSettings& settings_;
  int decimals_;
  ProgramTracker tracker_;
  FilamentWords filament_;
  ClosingCode closing_;
  std::string begin_code_;
  RewriteCounts counts_;
  Extremes nozzle_;
  double last_z_ = 0.0;  ///< of the nozzle, over the bed
  Box3 footprint_;
  double footprint_top_;
  bool is_elsewhere_ = false;        ///< motions were dropped since the nozzle moved last
  bool is_filament_behind_ = false;  ///< deposits were dropped since E was reported last
};

}  // namespace lamina
