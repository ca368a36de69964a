// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "gcode_rewrite/point_transform.hpp"
#include "gcode_rewrite/program_tracker.hpp"

namespace lamina {

/// E and F of a motion where the map is no isometry, following what the machine was reported before.
class FilamentWords {
 public:
  FilamentWords(const PointTransform& transform, ExtrusionRule rule)
      : transform_(transform),
        rule_(rule),
        scales_feed_(!transform.keepsLengths()),
        scales_extrusion_(transform.map.kind() != MapKind::Isometry && rule != ExtrusionRule::Kept) {}

  bool scalesFeed() const { return scales_feed_; }
  bool scalesExtrusion() const { return scales_extrusion_; }

  /// Value of E for a chord, in the mode of the program.
  /// @param pushed  filament of this chord, as sliced
  double extrusion(const ProgramTracker& tracker, double pushed, const Point3& from, const Point3& to);
  /// Value of E of a line that moves the filament alone.
  double extrusionAlone(const ProgramTracker& tracker, double pushed);
  /// After G92.
  void setFilament(double value) { written_filament_ = value; }

  /// F for a chord; nothing if the machine has that feed already, and the line is not the one that reports
  /// it.
  std::optional<double> feed(const ProgramTracker& tracker, const Point3& from, const Point3& to);
  /// F where the feed is not scaled; likewise.
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

}  // namespace lamina
