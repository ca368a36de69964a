// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// The deposition of a layer at one cell: planned height and differences from the plan.
struct DepositedGrowth {
  double planned_mm = 0.0;     ///< planned height of the layer there
  double correction = 0.0;     ///< relative change of the amount deposited
  double nozzle_error_mm = 0;  ///< planned less actual height of the nozzle; used by pressed processes only
};

/// A measurement of a cell by one profile: the mean over those points of the profile that lie on the cell.
struct CellReading {
  double error_mm = 0.0;  ///< planned less measured height along the growth direction
  int points = 1;
  double sigma_mm = 0.02;  ///< standard deviation of one point, not of the mean
};

/// How a reading was used.
enum class ReadingUse : std::uint8_t {
  Used,
  Contested,  ///< too far from the expected value: not used, but compared with the readings that follow
  Believed    ///< contested, but the third in a row to agree: its value replaces the estimate
};

/// How a reading was used, and its squared innovation (reading less expected value) divided by the expected
/// variance of the innovation. The mean of this quotient is 1 where the model holds.
struct ReadingOutcome {
  ReadingUse use = ReadingUse::Used;
  double surprise = 0.0;
};

/// The error of a cell as it was predicted before any reading.
struct PredictedError {
  double error_mm = 0.0;
  double sigma_mm = 0.0;  ///< standard deviation of the layer's growth
  bool is_known = true;   ///< whether the prediction derives from a reading or a known surface
};

/// The gain of a cell, measured over one or more layers.
struct MeasuredGain {
  double gain = 1.0;          ///< measured over commanded growth
  double commanded_mm = 0.0;  ///< growth commanded since the measurement before
};

/// Variance of a reading [mm²], given the correlation of neighbouring points of a profile.
double readingVariance(const CellReading& reading, double correlation);

/// The state of a `CellEstimate`, for storage. `CellEstimate` holds floats, so storing and restoring it
/// changes no bit.
struct StoredEstimate {
  double error_mm = 0.0;
  double variance_mm2 = 0.0;
  double commanded_mm = 0.0;  ///< growth commanded since the gain was last measured
  double base_mm = 0.0;
  double contested_mm = 0.0;
  double gain = 1.0;
  std::uint8_t contests = 0;
  std::uint8_t flags = 0;
};

/// Kalman filter [Kalman1960] of the height of one cell's top, in 24 bytes. The state is the height error
/// [mm], planned less actual: positive if too low. The gain, actual over commanded growth, is learnt
/// separately, within 0.4 to 2.5.
class CellEstimate {
 public:
  static constexpr double kStartSigma = 0.5;  ///< standard deviation of an unknown cell [mm]
  static constexpr double kLeastGain = 0.4;
  static constexpr double kGreatestGain = 2.5;

  CellEstimate() = default;
  /// A cell of known error, for instance one of the bed.
  CellEstimate(double error_mm, double sigma_mm, double gain);

  /// Restores a stored estimate.
  explicit CellEstimate(const StoredEstimate& stored);
  StoredEstimate stored() const;

  double error() const { return static_cast<double>(error_mm_); }         ///< [mm]
  double variance() const { return static_cast<double>(variance_mm2_); }  ///< [mm²]
  double gain() const { return static_cast<double>(gain_) / kGainUnits; }
  /// Clamps the gain to its range and rounds it to 1/16384.
  void setGain(double gain);

  /// Predicts the error after a layer of a free process: the error grows by the planned less the expected
  /// growth.
  /// @param spread  relative standard deviation of growth
  void lay(const DepositedGrowth& growth, double spread);
  /// Predicts the error after a layer of a pressed process: the error becomes that of the nozzle's height.
  /// @param spread  relative standard deviation of growth
  void press(const DepositedGrowth& growth, double spread);
  /// Corrects the last `lay`: the layer of height `planned_mm` was deposited with `correction`, not with
  /// `assumed`, the correction that was given to `lay`. The expected error is corrected only if the cell was
  /// not seen since.
  void relay(double planned_mm, double assumed, double correction);

  /// Takes back the readings since the last layer was deposited, if any was used or believed.
  void forget(const PredictedError& predicted);
  /// Growth commanded since the gain was last measured, or since the height is known [mm].
  double commanded() const { return static_cast<double>(commanded_mm_); }

  /// Refers the estimate to a new plan that is higher by `raised_mm` at this cell and deposits `flow` times
  /// the volume.
  void replan(double raised_mm, double flow);

  /// Updates the estimate by a reading. A reading that lies off the expected error by at most four standard
  /// deviations (of the estimate and one point together) is used. Any other is contested, until three in a
  /// row agree; the third is believed. A reading that is not finite, has no points or no positive sigma is
  /// contested, and does not count towards the three.
  /// @param correlation  correlation of neighbouring points of a profile
  ReadingOutcome see(const CellReading& reading, double correlation);
  /// Replaces the estimate by the contested error; to be called if neighbouring cells agree with that error.
  /// Without a contested error it has no effect.
  void believe();
  /// The error of the last contested reading [mm]; none if a reading was used or believed since.
  std::optional<double> contested() const;
  /// Whether a reading was used or believed since the last layer was deposited.
  bool isSeen() const { return (flags_ & kSeen) != 0; }
  /// Whether the height derives from a reading or a known surface; otherwise it is a guess.
  bool isKnown() const { return (flags_ & kKnown) != 0; }

  /// The error [mm] that unexpected readings gave, for comparison with neighbouring cells. This is the
  /// estimate if a reading was believed since the gain was last measured, otherwise the contested error; none
  /// if there is neither.
  std::optional<double> claimed() const;

  /// The gain since the last measurement of the gain, which may be several layers ago; the next measurement
  /// starts here. None if the cell was not seen since the last layer was deposited, if no growth was
  /// commanded since its height is known, or if a believed height would mean a gain out of range.
  std::optional<MeasuredGain> takeMeasuredGain();

 private:
  void becomeKnown();

  static constexpr double kGainUnits = 16384.0;
  static constexpr std::uint8_t kSeen = 1;
  static constexpr std::uint8_t kBroken = 2;  ///< a reading was believed since the gain was measured
  static constexpr std::uint8_t kKnown = 4;

  float error_mm_ = 0.0F;
  float variance_mm2_ = static_cast<float>(kStartSigma * kStartSigma);
  float commanded_mm_ = 0.0F;  ///< growth commanded since the gain was last measured
  float base_mm_ = 0.0F;       ///< error at that time, plus the height planned since
  float contested_mm_ = 0.0F;
  std::uint16_t gain_ = static_cast<std::uint16_t>(kGainUnits);
  std::uint8_t contests_ = 0;  ///< number of contested readings in a row that agree
  std::uint8_t flags_ = 0;
};
static_assert(sizeof(CellEstimate) == 24, "memory of a map is 24 bytes a cell");

}  // namespace lamina
