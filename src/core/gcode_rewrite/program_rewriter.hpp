// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "closing_code.hpp"
#include "point_transform.hpp"
#include "program_tracker.hpp"
#include "survey.hpp"

namespace lamina {

/// Computes E and F of motions under a map that changes lengths, from what was written before.
class FilamentWords {
 public:
  FilamentWords(const PointTransform& transform, ExtrusionRule rule)
      : transform_(transform),
        rule_(rule),
        scales_feed_(!transform.keepsLengths()),
        scales_extrusion_(transform.map.kind() != MapKind::Isometry && rule != ExtrusionRule::Kept) {}

  bool scalesFeed() const { return scales_feed_; }
  bool scalesExtrusion() const { return scales_extrusion_; }

  /// Value of E for a chord, absolute or relative as in the program.
  /// @param pushed  filament of the chord, as sliced
  double extrusion(const ProgramTracker& tracker, double pushed, const Point3& from, const Point3& to);
  /// Value of E for a line that moves only the filament.
  double extrusionAlone(const ProgramTracker& tracker, double pushed);
  /// States that G92 has set the value of E.
  void setFilament(double value) { written_filament_ = value; }

  /// Value of F for a chord; nothing if the machine already has this feed and the line does not state F.
  std::optional<double> feed(const ProgramTracker& tracker, const Point3& from, const Point3& to);
  /// Value of F where the feed is not scaled; nothing as in `feed`.
  std::optional<double> feedAlone(const ProgramTracker& tracker);

 private:
  double push(const ProgramTracker& tracker, double pushed);
  std::optional<double> newFeed(const ProgramTracker& tracker, double feed);

  const PointTransform& transform_;
  ExtrusionRule rule_;
  bool scales_feed_;
  bool scales_extrusion_;
  double written_filament_ = 0.0;
  double written_feed_ = 0.0;
};

/// Number of changes that the second pass made.
struct RewriteCounts {
  std::size_t deferred = 0;
  std::size_t homings_annulled = 0;
  std::size_t aids_dropped = 0;
};

/// The second pass over a program: appends each line, rewritten, to a text.
class ProgramRewriter {
 public:
  /// @param transform  including its shift; all three arguments must outlive the object
  ProgramRewriter(const PointTransform& transform, const Survey& survey, const RewriteSettings& settings);

  void read(std::string_view line, std::size_t number, std::string& out);
  void finish(std::string& out);
  const RewriteCounts& counts() const { return counts_; }
  const Box3& footprint() const { return footprint_; }  ///< as in the report [mm]
  /// Positions in the part that the nozzle moves to, over the bed [mm].
  const Extremes& nozzle() const { return nozzle_; }

 private:
  /// One of the chords that replace a motion.
  struct Chord {
    Point3 from = Point3::Zero();
    double length = 0.0;   ///< length of all chords of the motion [mm]
    double done = 0.0;     ///< length up to the end of this chord [mm]
    double pushed = 0.0;   ///< filament up to the end of this chord, as sliced
    double written = 0.0;  ///< sum of E written so far
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
  double last_z_ = 0.0;  ///< last height of the nozzle over the bed
  Box3 footprint_;
  double footprint_top_;
  bool is_elsewhere_ = false;        ///< whether motions were dropped since the last motion of the nozzle
  bool is_filament_behind_ = false;  ///< whether depositing motions were dropped since E was written last
};

}  // namespace lamina
