// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// The growth of a cell that one layer is to bring.
struct DepositedGrowth {
  double planned_mm = 0.0;     ///< planned height of the layer there
  double correction = 0.0;     ///< relative change of the amount deposited
  double nozzle_error_mm = 0;  ///< planned less actual height of the nozzle; pressed processes only
};

/// The measurement of a cell by one profile: the mean of some of its points.
struct CellReading {
  double error_mm = 0.0;  ///< planned less measured height along the growth direction
  int points = 1;
  double sigma_mm = 0.02;  ///< standard deviation of one point
};

/// How a reading was used.
enum class ReadingUse : std::uint8_t {
  Used,
  Contested,  ///< too far from the expected value: set aside
  Believed    ///< contested, and confirmed by the third profile in a row: taken over
};

/// The use of a reading, and its squared innovation over the expected variance of the innovation, which is 1
/// in the mean where the model holds.
struct ReadingOutcome {
  ReadingUse use = ReadingUse::Used;
  double surprise = 0.0;
};

/// The gain of a cell as measured.
struct MeasuredGain {
  double gain = 1.0;          ///< measured over commanded growth
  double commanded_mm = 0.0;  ///< growth commanded since the measurement before
};

/// Variance of a reading [mm²], given the correlation of neighbouring points of a profile.
double readingVariance(const CellReading& reading, double correlation);

/// The state of a `CellEstimate`, for storage. Its values are those of floats, so that they read back to the
/// same bits.
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

/// Kalman filter [Kalman1960] of the height of one cell's top, in 24 bytes. The state is the height error
/// [mm], planned less actual: positive is too low. The gain, actual over commanded growth, is learnt beside
/// it, from 0.4 to 2.5.
class CellEstimate {
 public:
  static constexpr double kStartSigma = 0.5;  ///< standard deviation of an unknown cell [mm]
  static constexpr double kLeastGain = 0.4;
  static constexpr double kGreatestGain = 2.5;

  CellEstimate() = default;
  /// A cell of known error, such as one of the bed.
  CellEstimate(double error_mm, double sigma_mm, double gain);

  /// The estimate that was stored.
  explicit CellEstimate(const StoredEstimate& stored);
  StoredEstimate stored() const;

  double error() const { return static_cast<double>(error_mm_); }         ///< [mm]
  double variance() const { return static_cast<double>(variance_mm2_); }  ///< [mm²]
  double gain() const { return static_cast<double>(gain_) / kGainUnits; }
  /// Clamps the gain to its range and rounds it to 1/16384.
  void setGain(double gain);

  /// Predicts the error after a layer of a free process: it changes by the planned less the expected growth.
  /// @param spread  relative standard deviation of growth
  void lay(const DepositedGrowth& growth, double spread);
  /// Predicts the error after a layer of a pressed process: it is that of the nozzle's plane.
  void press(const DepositedGrowth& growth, double spread);
  /// Amends the last `lay`: the layer of height `planned_mm` was deposited with `correction`, not with
  /// `assumed`.
  void relay(double planned_mm, double assumed, double correction);

  /// Takes over a new plan, which is higher by `raised_mm` at this cell and lays `flow` times the volume.
  void replan(double raised_mm, double flow);

  /// Updates the estimate by a reading. A reading within four standard deviations of the expected error is
  /// used. Any other is contested until three profiles in a row agree. A reading that is not finite or has no
  /// points is contested.
  ReadingOutcome see(const CellReading& reading, double correlation);
  /// Takes over the contested height, since neighbours agree with it.
  void believe();
  /// The contested error [mm], if there is one.
  std::optional<double> contested() const;
  /// Whether a reading was used since the last layer was deposited.
  bool isSeen() const { return (flags_ & kSeen) != 0; }
  /// Whether the height derives from a reading or a known surface, and is not a guess.
  bool isKnown() const { return (flags_ & kKnown) != 0; }

  /// The error [mm] that was believed or is contested, for comparison with neighbours.
  std::optional<double> claimed() const;

  /// The gain measured since the last call. None if no growth was commanded or no reading used since, or if a
  /// believed height would mean a gain out of range.
  std::optional<MeasuredGain> takeMeasuredGain();

 private:
  static constexpr double kGainUnits = 16384.0;
  static constexpr std::uint8_t kSeen = 1;
  static constexpr std::uint8_t kBroken = 2;  ///< believed since the gain was measured
  static constexpr std::uint8_t kKnown = 4;

  float error_mm_ = 0.0F;
  float variance_mm2_ = static_cast<float>(kStartSigma * kStartSigma);
  float commanded_mm_ = 0.0F;  ///< growth since the gain was last measured
  float base_mm_ = 0.0F;       ///< error at that time plus the height planned since
  float contested_mm_ = 0.0F;
  std::uint16_t gain_ = static_cast<std::uint16_t>(kGainUnits);
  std::uint8_t contests_ = 0;  ///< profiles in a row that agree on it
  std::uint8_t flags_ = 0;
};
static_assert(sizeof(CellEstimate) == 24, "memory of a map is 24 bytes a cell");

}  // namespace lamina
