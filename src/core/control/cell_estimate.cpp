// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/cell_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double kGate = 16.0;  // four standard deviations, squared
constexpr double kAgreement = 4.0;
constexpr std::uint8_t kProfilesBelieved = 3;

}  // namespace

double readingVariance(const CellReading& reading, double correlation) {
  const double points = std::max(1, reading.points);
  return reading.sigma_mm * reading.sigma_mm * (1.0 + (points - 1.0) * correlation) / points;
}

CellEstimate::CellEstimate(double error_mm, double sigma_mm, double gain)
    : error_mm_(static_cast<float>(error_mm)),
      variance_mm2_(static_cast<float>(sigma_mm * sigma_mm)),
      base_mm_(static_cast<float>(error_mm)),
      flags_(kKnown) {
  setGain(gain);
}

CellEstimate::CellEstimate(const StoredEstimate& stored)
    : error_mm_(static_cast<float>(stored.error_mm)),
      variance_mm2_(static_cast<float>(stored.variance_mm2)),
      commanded_mm_(static_cast<float>(stored.commanded_mm)),
      base_mm_(static_cast<float>(stored.base_mm)),
      contested_mm_(static_cast<float>(stored.contested_mm)),
      contests_(stored.contests),
      flags_(stored.flags) {
  setGain(stored.gain);
}

StoredEstimate CellEstimate::stored() const {
  return {static_cast<double>(error_mm_),
          static_cast<double>(variance_mm2_),
          static_cast<double>(commanded_mm_),
          static_cast<double>(base_mm_),
          static_cast<double>(contested_mm_),
          gain(),
          contests_,
          flags_};
}

void CellEstimate::setGain(double gain) {
  gain_ = static_cast<std::uint16_t>(std::lround(std::clamp(gain, kLeastGain, kGreatestGain) * kGainUnits));
}

void CellEstimate::lay(const DepositedGrowth& growth, double spread) {
  const double commanded = growth.planned_mm * (1.0 + growth.correction);
  const double expected = gain() * commanded;
  error_mm_ = static_cast<float>(error() + growth.planned_mm - expected);
  variance_mm2_ = static_cast<float>(variance() + spread * expected * spread * expected);
  commanded_mm_ += static_cast<float>(commanded);
  base_mm_ += static_cast<float>(growth.planned_mm);
  contested_mm_ += static_cast<float>(growth.planned_mm - expected);  // what is contested grows as well
  flags_ = static_cast<std::uint8_t>(flags_ & ~kSeen);
}

void CellEstimate::press(const DepositedGrowth& growth, double spread) {
  error_mm_ = static_cast<float>(growth.nozzle_error_mm);
  const double sigma = spread * growth.planned_mm;
  variance_mm2_ = static_cast<float>(sigma * sigma);
  contests_ = 0;
  flags_ = static_cast<std::uint8_t>(flags_ & ~kSeen);
}

/// A height that was seen since needs no expectation; what was commanded is as it is.
void CellEstimate::relay(double planned_mm, double assumed, double correction) {
  const double more = planned_mm * (correction - assumed);
  commanded_mm_ += static_cast<float>(more);
  if (isSeen()) return;
  error_mm_ -= static_cast<float>(gain() * more);
  contested_mm_ -= static_cast<float>(gain() * more);
}

/// The spread before the readings is gone; that of the growth was most of it.
void CellEstimate::forget(const PredictedError& predicted) {
  contests_ = 0;
  if (!isSeen()) return;
  const double sigma = predicted.is_known ? predicted.sigma_mm : kStartSigma;
  error_mm_ = static_cast<float>(predicted.error_mm);
  variance_mm2_ = std::max(variance_mm2_, static_cast<float>(sigma * sigma));
  const int lost = predicted.is_known ? kSeen | kBroken : kSeen | kBroken | kKnown;
  flags_ = static_cast<std::uint8_t>(flags_ & ~lost);
}

void CellEstimate::replan(double raised_mm, double flow) {
  error_mm_ += static_cast<float>(raised_mm);
  base_mm_ += static_cast<float>(raised_mm);
  contested_mm_ += static_cast<float>(raised_mm);
  commanded_mm_ /= static_cast<float>(flow);
  setGain(gain() * flow);
}

ReadingOutcome CellEstimate::see(const CellReading& reading, double correlation) {
  const bool has_sigma = std::isfinite(reading.sigma_mm) && reading.sigma_mm > 0.0;
  if (!std::isfinite(reading.error_mm) || !has_sigma || reading.points < 1)
    return {ReadingUse::Contested, 0.0};
  const double noise = readingVariance(reading, correlation);
  const double innovation = reading.error_mm - error();
  const double surprise = innovation * innovation / (variance() + noise);
  const double point = reading.sigma_mm * reading.sigma_mm;
  if (innovation * innovation > kGate * (variance() + point)) {
    const bool agrees = contests_ > 0 && std::abs(reading.error_mm - static_cast<double>(contested_mm_)) <=
                                             kAgreement * reading.sigma_mm;
    contests_ = agrees ? static_cast<std::uint8_t>(contests_ + 1) : std::uint8_t{1};
    contested_mm_ = static_cast<float>(reading.error_mm);
    if (contests_ < kProfilesBelieved) return {ReadingUse::Contested, surprise};
    believe();
    return {ReadingUse::Believed, surprise};
  }
  const double share = variance() / (variance() + noise);
  error_mm_ = static_cast<float>(error() + share * innovation);
  variance_mm2_ = static_cast<float>((1.0 - share) * variance());
  contests_ = 0;
  becomeKnown();
  flags_ |= kSeen;
  return {ReadingUse::Used, surprise};
}

void CellEstimate::believe() {
  if (contests_ == 0) return;
  error_mm_ = contested_mm_;
  variance_mm2_ = static_cast<float>(kStartSigma * kStartSigma);
  contests_ = 0;
  becomeKnown();
  flags_ |= kSeen | kBroken;
}

/// From a ground that nobody knew no growth can be told: what is measured of it begins here.
void CellEstimate::becomeKnown() {
  if (isKnown()) return;
  commanded_mm_ = 0.0F;
  base_mm_ = error_mm_;
  flags_ |= kKnown;
}

std::optional<double> CellEstimate::contested() const {
  return contests_ > 0 ? std::optional<double>(static_cast<double>(contested_mm_)) : std::nullopt;
}

std::optional<double> CellEstimate::claimed() const {
  return (flags_ & kBroken) != 0 ? std::optional<double>(error()) : contested();
}

std::optional<MeasuredGain> CellEstimate::takeMeasuredGain() {
  if (!isSeen()) return std::nullopt;
  const double commanded = static_cast<double>(commanded_mm_);
  const double gain = (static_cast<double>(base_mm_) - error()) / commanded;
  const bool is_plausible = gain >= kLeastGain && gain <= kGreatestGain;
  const bool is_growth = commanded > 0.0 && ((flags_ & kBroken) == 0 || is_plausible);
  commanded_mm_ = 0.0F;
  base_mm_ = error_mm_;
  flags_ = static_cast<std::uint8_t>(flags_ & ~kBroken);
  if (!is_growth) return std::nullopt;
  return MeasuredGain{gain, commanded};
}

}  // namespace lamina
