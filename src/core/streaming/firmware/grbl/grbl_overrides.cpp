// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_overrides.hpp"

#include <cmath>

#include "streaming/job/decimal.hpp"

namespace lamina {
namespace {

constexpr double kLeast = 10.0;      // %
constexpr double kGreatest = 200.0;  // %

std::string outOfRange(const LiveChange& change, const std::string& expected) {
  return nameOf(change.setting) + " is " + decimal(change.value) + " %; grbl takes " + expected;
}

/// The first of the bytes that lead from one to the other; none where nothing is wanted any more.
std::string stepOf(const std::string& bytes, std::optional<int>& wanted) {
  if (bytes.empty()) wanted.reset();
  return bytes.substr(0, 1);
}

}  // namespace

std::string GrblOverrides::set(const LiveChange& change, double now) {
  const int percent = static_cast<int>(std::lround(change.value));
  const bool is_in_range = change.value >= kLeast && change.value <= kGreatest;
  switch (change.setting) {
    case LiveSetting::Feed:
      if (!is_in_range) return outOfRange(change, "10 to 200 %");
      feed_ = percent;
      break;
    case LiveSetting::Rapid:
      if (percent != 25 && percent != 50 && percent != 100) return outOfRange(change, "25, 50 and 100 %");
      rapid_ = percent;
      break;
    case LiveSetting::Spindle:
    case LiveSetting::Power:
      if (!is_in_range) return outOfRange(change, "10 to 200 %");
      spindle_ = percent;
      break;
    default:
      return notOf("grbl", change.setting);
  }
  asked_s_ = heard_s_ = now;
  return {};
}

void GrblOverrides::hear(const GrblPercents& reported, double now) {
  reported_ = reported;
  heard_s_ = now;
}

std::string GrblOverrides::takeBytes() {
  if (!reported_) return {};
  const GrblPercents from = *reported_;
  reported_.reset();
  std::string bytes;
  if (feed_) bytes += stepOf(grblFeedOverride(from.feed, *feed_), feed_);
  if (rapid_) bytes += stepOf(*rapid_ == from.rapid ? "" : grblRapidOverride(*rapid_), rapid_);
  if (spindle_) bytes += stepOf(grblSpindleOverride(from.spindle, *spindle_), spindle_);
  return bytes;
}

std::string GrblOverrides::giveUp(double now) {
  constexpr double kSilence = 5.0;  // s; grbl reports its overrides each twenty times at least
  constexpr double kMost = 30.0;    // s; the longest way has 28 steps
  if (!isUnderWay() || (now < heard_s_ + kSilence && now < asked_s_ + kMost)) return {};
  std::string wanted;
  if (feed_) wanted += " feed " + std::to_string(*feed_) + " %";
  if (rapid_) wanted += " rapid " + std::to_string(*rapid_) + " %";
  if (spindle_) wanted += " spindle " + std::to_string(*spindle_) + " %";
  feed_.reset();
  rapid_.reset();
  spindle_.reset();
  return "the machine has not reported" + wanted + " (Ov) in time; it may be on the way to it";
}

}  // namespace lamina
