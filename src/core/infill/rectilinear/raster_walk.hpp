// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "infill/rectilinear/raster.hpp"

namespace lamina {

constexpr std::uint32_t kNoCrossing = 0xFFFFFFFF;

enum class Vertical { Up, Down };

/// The outlines of a raster, to be followed from crossing to crossing. The raster must outlive the object.
class RasterWalk {
 public:
  explicit RasterWalk(const Raster& raster);

  const Raster& raster() const { return raster_; }
  Point2 pointAt(std::uint32_t crossing) const;
  std::int64_t lineOf(std::uint32_t crossing) const { return raster_.crossings[crossing].line; }

  /// The other end of the segment inside that has an end at this crossing.
  std::uint32_t otherEnd(std::uint32_t crossing) const { return raster_.sorted[position_[crossing] ^ 1U]; }
  /// Whether this crossing is the left end of a segment inside.
  bool isLeftEnd(std::uint32_t crossing) const { return position_[crossing] % 2 == 0; }
  /// Number of the segment inside that has an end at this crossing, counted from below and from the left.
  std::size_t insideLine(std::uint32_t crossing) const { return position_[crossing] / 2; }
  std::size_t insideLines() const { return raster_.sorted.size() / 2; }
  std::uint32_t leftEnd(std::size_t inside_line) const { return raster_.sorted[2 * inside_line]; }
  std::uint32_t rightEnd(std::size_t inside_line) const { return raster_.sorted[2 * inside_line + 1]; }

  /// The next crossing along the outline that leads up (or down) from this one: on the neighbouring line, or
  /// on the same line if the outline turns back.
  std::uint32_t next(std::uint32_t crossing, Vertical direction) const;
  /// The part of the outline from this crossing to the next one up (or down), both included.
  Polyline chain(std::uint32_t crossing, Vertical direction) const;

  /// Number of the segment inside on raster line `line` that contains x; nothing if there is none.
  std::optional<std::size_t> insideLineAt(std::int64_t line, double x) const;
  /// Whether raster line `line` is inside all the way from one x to the other.
  bool isInside(std::int64_t line, double from_x, double to_x) const;

 private:
  bool climbs(std::uint32_t crossing) const;
  std::uint32_t following(std::uint32_t crossing) const;
  std::uint32_t preceding(std::uint32_t crossing) const;
  void appendBetween(std::uint32_t from, std::uint32_t to, Polyline& points) const;

  const Raster& raster_;
  std::vector<std::uint32_t> position_;       ///< position of each crossing in the sorted list
  std::vector<std::uint32_t> outline_begin_;  ///< first crossing of each outline, and the end of the last one
};

}  // namespace lamina
