// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "metrics/face_prism.hpp"

namespace lamina {

/// An interval on a line of measurement [mm].
struct LineSpan {
  double from = 0.0;
  double to = 0.0;
};

/// Sums of lengths on lines of measurement.
struct LineSums {
  double face_mm = 0.0;       ///< on the face
  double uncovered_mm = 0.0;  ///< part of it that no band covers
  double twice_mm = 0.0;      ///< part that two or more bands cover

  void add(const LineSums& other) {
    face_mm += other.face_mm;
    uncovered_mm += other.uncovered_mm;
    twice_mm += other.twice_mm;
  }
};

/// Length of the part of `whole` that no span covers [mm].
/// @param spans  sorted by their beginning
double uncovered(const std::vector<LineSpan>& spans, const LineSpan& whole);

/// Length that two or more spans cover [mm].
/// @param spans  sorted by their beginning
double coveredTwice(const std::vector<LineSpan>& spans);

/// The interval of a band at one y of the face frame; empty (from > to) if the band does not reach it.
LineSpan spanAt(const Band& band, double y);

/// The parallel lines, along x of a face's frame, on which areas are measured.
struct FaceLines {
  double first_y = 0.0;
  double step_mm = 0.0;
  int count = 0;

  double y(int line) const { return first_y + line * step_mm; }
};

/// A range of the lines.
struct LineRange {
  int first = 0;
  int last = 0;  ///< one past the last
};

/// Rules for measuring overlaps.
struct OverlapRule {
  bool cuts_joints = true;  ///< whether joined bands are cut at the bisectors of their directions
  /// Whether only area on the face counts; otherwise also that beyond the face's edges.
  bool stays_on_face = true;
};

/// Measures lines one after the other; keeps its memory for the next ones.
class LineMeter {
 public:
  /// @param face   corners of the triangle
  /// @param bands  those that may reach one of the lines, or more
  LineSums measure(const std::array<Point2, 3>& face, const FaceLines& lines, const LineRange& range,
                   const std::vector<const Band*>& bands, const OverlapRule& rule);

 private:
  struct Line {
    std::vector<LineSpan> whole;  // intervals of whole bands
    std::vector<LineSpan> cut;    // intervals of bands cut at their joints
  };
  void add(const Band& band, const FaceLines& lines, const LineRange& range, const OverlapRule& rule);

  std::vector<Line> lines_;
};

}  // namespace lamina
