// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/offset_watch.hpp"

#include <cmath>

namespace lamina {
namespace {

constexpr double kLeastSpeed = 1.0;      // mm/s
constexpr double kGreatestSigma = 0.01;  // s
constexpr std::size_t kSlopeReach = 4;   // cells either side, over which heights have a slope
constexpr std::size_t kLeastCells = 8;
constexpr double kPlaceInCell = 1.0 / 6.0;  // variance of the difference of two places in a cell, in cells

/// What both senses say of a cell.
struct BothSenses {
  bool is_seen = false;
  double error_mm = 0.0;          ///< mean of both
  double difference_mm = 0.0;     ///< along the path less against it
  double twice_speed_mm_s = 0.0;  ///< speeds added
  double variance_mm2 = 0.0;      ///< of the difference
};

/// Means of the readings in one sense.
struct SenseMean {
  double error_mm = 0.0;
  double speed_mm_s = 0.0;
  double variance_mm2 = 0.0;  ///< of the mean error
};

SenseMean meanOf(float readings, float error_mm, float speed_mm_s, float variance_mm2) {
  const auto count = static_cast<double>(readings);
  return {static_cast<double>(error_mm) / count, static_cast<double>(speed_mm_s) / count,
          static_cast<double>(variance_mm2) / (count * count)};
}

/// A straight line through weighted points.
struct WeightedLine {
  double weight = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  std::size_t points = 0;

  void add(double at, double value, double of_weight) {
    weight += of_weight;
    x += of_weight * at;
    y += of_weight * value;
    xx += of_weight * at * at;
    xy += of_weight * at * value;
    ++points;
  }
  /// Of the places about their mean.
  double information() const { return weight > 0.0 ? xx - x * x / weight : 0.0; }
  double slope() const { return (xy - x * y / weight) / information(); }
};

/// Slope of the heights around a cell, and its variance; none at the ends of what is seen.
struct HeightSlope {
  double slope = 0.0;
  double variance = 0.0;
};

std::optional<HeightSlope> slopeAt(const std::vector<BothSenses>& cells, const CellRun& run, std::size_t i) {
  if (i < run.first + kSlopeReach || i + kSlopeReach >= run.first + run.count) return std::nullopt;
  HeightSlope slope;
  double squares = 0.0;
  for (std::size_t k = 1; k <= kSlopeReach; ++k) {
    const BothSenses& before = cells[i - k];
    const BothSenses& behind = cells[i + k];
    if (!before.is_seen || !behind.is_seen) return std::nullopt;
    const auto way = static_cast<double>(k) * run.cellLength();
    slope.slope += way * (behind.error_mm - before.error_mm);
    slope.variance += way * way * 0.25 * (before.variance_mm2 + behind.variance_mm2);
    squares += 2.0 * way * way;
  }
  slope.slope /= squares;
  slope.variance /= squares * squares;
  return slope;
}

}  // namespace

void OffsetWatch::begin(std::size_t cells) {
  cells_ = cells;
  seen_.clear();
  is_seen_ = {false, false};
}

void OffsetWatch::see(std::size_t cell, double speed_mm_s, const CellReading& reading) {
  if (cell >= cells_ || !(std::abs(speed_mm_s) >= kLeastSpeed) || !std::isfinite(speed_mm_s)) return;
  if (!std::isfinite(reading.error_mm)) return;
  if (seen_.empty()) seen_.resize(cells_);
  const std::size_t sense = speed_mm_s < 0.0 ? 1 : 0;
  is_seen_[sense] = true;
  Seen& seen = seen_[cell][sense];
  seen.readings += 1.0F;
  seen.error_mm += static_cast<float>(reading.error_mm);
  seen.speed_mm_s += static_cast<float>(std::abs(speed_mm_s));
  seen.variance_mm2 += static_cast<float>(readingVariance(reading, 0.0));
}

std::optional<OffsetLeft> OffsetWatch::offset(const LayerCells& cells) const {
  if (seen_.size() != cells.size() || !is_seen_[0] || !is_seen_[1]) return std::nullopt;
  std::vector<BothSenses> both(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto& [there, back] = seen_[i];
    if (there.readings == 0.0F || back.readings == 0.0F) continue;
    const SenseMean along = meanOf(there.readings, there.error_mm, there.speed_mm_s, there.variance_mm2);
    const SenseMean against = meanOf(back.readings, back.error_mm, back.speed_mm_s, back.variance_mm2);
    both[i] = {true, 0.5 * (along.error_mm + against.error_mm), along.error_mm - against.error_mm,
               along.speed_mm_s + against.speed_mm_s, along.variance_mm2 + against.variance_mm2};
  }
  WeightedLine line;
  for (const CellRun& run : cells.runs) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const auto slope = both[i].is_seen ? slopeAt(both, run, i) : std::nullopt;
      // A slope that is noise would draw the offset towards nothing.
      if (!slope || slope->slope * slope->slope < 9.0 * slope->variance) continue;
      const double place = slope->slope * run.cellLength();
      const double variance = both[i].variance_mm2 + kPlaceInCell * place * place;
      line.add(both[i].twice_speed_mm_s * slope->slope, -both[i].difference_mm, 1.0 / variance);
    }
  }
  if (line.points < kLeastCells || !(line.information() > 0.0)) return std::nullopt;
  const OffsetLeft left{line.slope(), 1.0 / std::sqrt(line.information())};
  return left.sigma_s <= kGreatestSigma ? std::optional<OffsetLeft>(left) : std::nullopt;
}

}  // namespace lamina
