// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "metrics/face_prism.hpp"

namespace lamina {

/// A span of a line of measurement [mm].
struct LineSpan {
  double from = 0.0;
  double to = 0.0;
};

/// Lengths on lines of measurement, summed.
struct LineSums {
  double face_mm = 0.0;       ///< on the face
  double uncovered_mm = 0.0;  ///< of that, in no band
  double twice_mm = 0.0;      ///< in two bands or more

  void add(const LineSums& other) {
    face_mm += other.face_mm;
    uncovered_mm += other.uncovered_mm;
    twice_mm += other.twice_mm;
  }
};

/// What of `whole` no span covers [mm].
/// @param spans  by their beginning
double uncovered(const std::vector<LineSpan>& spans, const LineSpan& whole);

/// What two spans or more cover [mm].
/// @param spans  by their beginning
double coveredTwice(const std::vector<LineSpan>& spans);

/// What of a band lies at one y of the face frame; empty (from > to) if nothing.
LineSpan spanAt(const Band& band, double y);

/// The parallel lines, along x of a face's frame, on which areas are measured.
struct FaceLines {
  double first_y = 0.0;
  double step_mm = 0.0;
  int count = 0;

  double y(int line) const { return first_y + line * step_mm; }
};

/// Some of them.
struct LineRange {
  int first = 0;
  int last = 0;  ///< not included
};

/// How overlaps are taken.
struct OverlapRule {
  bool cuts_joints = true;    ///< at the bisectors
  bool stays_on_face = true;  ///< otherwise also what sticks out beyond the face's edges counts
};

/// Measures some lines after each other; holds memory to be used again.
class LineMeter {
 public:
  /// @param face   corners of the triangle
  /// @param bands  those that may reach one of the lines
  LineSums measure(const std::array<Point2, 3>& face, const FaceLines& lines, const LineRange& range,
                   const std::vector<const Band*>& bands, const OverlapRule& rule);

 private:
  struct Line {
    std::vector<LineSpan> whole;  // of bands
    std::vector<LineSpan> cut;    // at their joints
  };
  void add(const Band& band, const FaceLines& lines, const LineRange& range, const OverlapRule& rule);

  std::vector<Line> lines_;
};

}  // namespace lamina
