// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "gcode_rewrite/gcode_block.hpp"
#include "gcode_rewrite/point_transform.hpp"
#include "gcode_rewrite/section_marks.hpp"
#include "gcode_rewrite/survey.hpp"
#include "lamina/gcode_rewrite/rewrite_settings.hpp"

namespace lamina {

/// The points of a program as the listings of [Garcia2024] take them: of every line that begins with G0 or G1
/// after the first layer is opened, to the end of the file, from (0, 0, 0) on.
class ListingTracker {
 public:
  /// @return whether the line has a point
  /// @throws InvalidProgram naming the line: what the listing would leave untransformed or write wrongly
  ///   (G2, G3, G20, G91, words out of order)
  bool read(std::string_view line, std::size_t number);

  bool hasPart() const { return has_part_; }
  const Point3& point() const { return point_; }  ///< [mm, as sliced]
  const GcodeBlock& command() const { return command_; }
  const SectionMarks& marks() const { return marks_; }
  SectionMark mark() const { return mark_; }

 private:
  void requireTransformable() const;
  [[noreturn]] void refuse(const std::string& what) const;

  GcodeBlock command_;
  SectionMarks marks_;
  SectionMark mark_ = SectionMark::None;
  bool has_part_ = false;
  bool is_relative_ = false;
  bool is_in_inches_ = false;
  Point3 point_ = Point3::Zero();
};

/// First pass of the listing: the height comes from all points.
class ListingSurveyor {
 public:
  explicit ListingSurveyor(const PointTransform& transform) : transform_(transform) {}
  void read(std::string_view line, std::size_t number);
  /// @throws InvalidProgram if no comment opens a layer, or there is no motion after it
  Survey finish();

 private:
  const PointTransform& transform_;
  ListingTracker tracker_;
  Survey survey_;
};

/// Second pass of the listing, byte for byte: lines stripped, empty ones dropped, coordinates between what
/// stands before the first and after the last of them.
class ListingRewriter {
 public:
  ListingRewriter(const PointTransform& transform, int decimals)
      : transform_(transform), decimals_(decimals) {}
  void read(std::string_view line, std::size_t number, std::string& out);
  std::size_t homingsAnnulled() const { return homings_annulled_; }

 private:
  const PointTransform& transform_;
  int decimals_;
  ListingTracker tracker_;
  std::size_t homings_annulled_ = 0;
};

}  // namespace lamina
