// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report_watch.hpp"
#include "lamina/base/number_text.hpp"
#include "stamps.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr double kLongestLook = 0.1;  // s between two looks that count: some periods of the driver

}  // namespace

ReportWatch::ReportWatch(const TrackingLimits& limits, double connection_s, const ros::Time& begin)
    : limits_(limits), connection_s_(connection_s), looked_at_(begin) {}

void ReportWatch::hear(const ros::Time& stamp, const ros::Time& now) {
  if (!stamp_.isZero() && stamp > stamp_) gap_s_ = std::max(gap_s_, secondsBetween(stamp_, stamp));
  stamp_ = std::max(stamp_, stamp);
  looked_at_ = std::max(looked_at_, now);
  unheard_s_ = 0.0;
}

void ReportWatch::restart(const ros::Time& now) {
  stamp_ = ros::Time();
  looked_at_ = std::max(looked_at_, now);
  unheard_s_ = 0.0;
}

std::optional<std::string> ReportWatch::look(const ros::Time& now) {
  const double since_s = std::max(0.0, (now - looked_at_).toSec());
  looked_at_ = std::max(looked_at_, now);
  unheard_s_ += std::min(since_s, kLongestLook);
  const bool is_by_stamps = limits_.silence_by == SilenceBy::Stamps;
  if (is_by_stamps && gap_s_ > limits_.silence_s)
    return "two reports of the controller are " + numberText(gap_s_) +
           " s apart by their stamps; expected at most " + numberText(limits_.silence_s) + " s";
  const double longest_s = is_by_stamps ? std::max(connection_s_, limits_.silence_s) : limits_.silence_s;
  if (unheard_s_ <= longest_s) return std::nullopt;
  return "the controller has been silent for " + numberText(unheard_s_) + " s; expected a report every " +
         numberText(longest_s) + " s at least";
}

}  // namespace lamina
