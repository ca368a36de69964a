// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// What of a cell is laid with one layer.
struct LaidGrowth {
  double planned_mm = 0.0;     ///< height of the layer there
  double correction = 0.0;     ///< relative change of the amount
  double nozzle_error_mm = 0;  ///< planned less actual height of the nozzle; pressed processes only
};

/// What one profile says of a cell: the mean of some points.
struct CellReading {
  double error_mm = 0.0;  ///< planned less measured height along the growth direction
  int points = 1;
  double sigma_mm = 0.02;  ///< of one point
};

/// What became of a reading.
enum class ReadingUse : std::uint8_t {
  Used,
  Contested,  ///< too far from what was expected: kept aside
  Believed    ///< contested before, and three profiles agree: a fact
};

/// A reading's use, and the square of its innovation over the variance expected of it: 1 in the mean where
/// the model holds.
struct ReadingOutcome {
  ReadingUse use = ReadingUse::Used;
  double surprise = 0.0;
};

/// Growth measured over growth commanded, and how much was commanded since it was measured last [mm].
struct MeasuredGain {
  double gain = 1.0;
  double commanded_mm = 0.0;
};

/// Variance of the mean of points of one profile whose neighbours correlate [mm²].
double readingVariance(const CellReading& reading, double correlation);

/// All that a `CellEstimate` holds, to be kept. Lengths are floats, so that they come back to the same bits.
struct StoredEstimate {
  double error_mm = 0.0;
  double variance_mm2 = 0.0;
  double commanded_mm = 0.0;
  double base_mm = 0.0;
  double contested_mm = 0.0;
  double gain = 1.0;
  std::uint8_t contests = 0;
  std::uint8_t flags = 0;
};

/// Kalman filter [Kalman1960] of the top of one cell, in 24 bytes. The state is the height error, planned
/// less actual: positive is too low. Growth per commanded growth, the gain, is learnt beside it, within 0.4
/// and 2.5.
class CellEstimate {
 public:
  static constexpr double kStartSigma = 0.5;  ///< of a cell that nothing is known of [mm]
  static constexpr double kLeastGain = 0.4;
  static constexpr double kGreatestGain = 2.5;

  CellEstimate() = default;
  /// A cell whose error is known that well, such as a bed's.
  CellEstimate(double error_mm, double sigma_mm, double gain);

  /// The estimate that was stored.
  explicit CellEstimate(const StoredEstimate& stored);
  StoredEstimate stored() const;

  double error() const { return static_cast<double>(error_mm_); }         ///< [mm]
  double variance() const { return static_cast<double>(variance_mm2_); }  ///< [mm²]
  double gain() const { return static_cast<double>(gain_) / kGainUnits; }
  /// Clamped; kept to 1/16384.
  void setGain(double gain);

  /// A free process: the error grows by what was planned less what the gain expects.
  /// @param spread  relative standard deviation of growth
  void lay(const LaidGrowth& growth, double spread);
  /// A pressed process: the error is that of the nozzle's plane.
  void press(const LaidGrowth& growth, double spread);
  /// What a free process laid last of a planned height was laid by another correction than `lay` was told.
  void relay(double planned_mm, double told, double correction);

  /// The plan has changed: its height by so much at this cell, and the volume of its beads by that factor.
  void replan(double raised_mm, double flow);

  /// A reading that lies within four standard deviations of what is expected is used; else it is contested,
  /// until three profiles in a row agree. A reading that is not finite, or of no points, is contested.
  ReadingOutcome see(const CellReading& reading, double correlation);
  /// Takes a contested height over: neighbours agree with it.
  void believe();
  /// The contested error [mm], if there is one.
  std::optional<double> contested() const;
  /// Whether a reading was used since the last layer was laid.
  bool isSeen() const { return (flags_ & kSeen) != 0; }
  /// Whether the height goes back to something that was seen or is known, and is not a guess.
  bool isKnown() const { return (flags_ & kKnown) != 0; }

  /// The height that was believed, or is contested: what a neighbour may agree with.
  std::optional<double> claimed() const;

  /// The gain since it was last asked for; none if nothing was laid or seen since, or the height was believed
  /// and cannot have grown so.
  std::optional<MeasuredGain> takeMeasuredGain();

 private:
  static constexpr double kGainUnits = 16384.0;
  static constexpr std::uint8_t kSeen = 1;
  static constexpr std::uint8_t kBroken = 2;  ///< believed since the gain was measured
  static constexpr std::uint8_t kKnown = 4;

  float error_mm_ = 0.0F;
  float variance_mm2_ = static_cast<float>(kStartSigma * kStartSigma);
  float commanded_mm_ = 0.0F;  ///< growth since the gain was last measured
  float base_mm_ = 0.0F;       ///< error then, and what was planned since
  float contested_mm_ = 0.0F;
  std::uint16_t gain_ = static_cast<std::uint16_t>(kGainUnits);
  std::uint8_t contests_ = 0;  ///< profiles in a row that agree on it
  std::uint8_t flags_ = 0;
};
static_assert(sizeof(CellEstimate) == 24, "memory of a map is 24 bytes a cell");

}  // namespace lamina
