// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/servoj_frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina {
namespace {

constexpr double kScale = 1e6;                // of joints and speeds
constexpr double kWidest = 20.0;              // rad, rad/s: beyond what a joint of these robots does
constexpr std::int32_t kReport = 0x4C530000;  // begins each report, less its kind
constexpr std::int32_t kLastKind = static_cast<std::int32_t>(ServojState::Ended);

template <std::size_t count>
void putWord(std::array<char, count>& bytes, std::size_t word, std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  for (std::size_t i = 0; i < 4; ++i)
    bytes.at(4 * word + i) = static_cast<char>(bits >> (8U * (3U - static_cast<unsigned>(i))) & 0xFFU);
}

template <std::size_t count>
std::int32_t wordOf(const std::array<char, count>& bytes, std::size_t word) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits = bits << 8U | static_cast<unsigned char>(bytes.at(4 * word + i));
  return static_cast<std::int32_t>(bits);
}

template <std::size_t count>
void putJoints(std::array<char, count>& bytes, std::size_t word, const JointValues& values) {
  for (std::size_t j = 0; j < kServojJoints; ++j) {
    const double value = std::clamp(values[static_cast<Eigen::Index>(j)], -kWidest, kWidest);
    putWord(bytes, word + j, static_cast<std::int32_t>(std::lround(kScale * value)));
  }
}

/// Nothing if a value is beyond what joints do.
template <std::size_t count>
std::optional<JointValues> jointsOf(const std::array<char, count>& bytes, std::size_t word) {
  JointValues values(kServojJoints);
  for (std::size_t j = 0; j < kServojJoints; ++j) {
    const double value = wordOf(bytes, word + j) / kScale;
    if (std::abs(value) > kWidest) return std::nullopt;
    values[static_cast<Eigen::Index>(j)] = value;
  }
  return values;
}

std::int32_t cycleWord(std::int64_t cycle) {
  if (cycle <= 0) return 0;
  return static_cast<std::int32_t>(1 + (cycle - 1) % std::numeric_limits<std::int32_t>::max());
}

}  // namespace

TargetBytes targetBytes(const CyclicTarget& target) {
  TargetBytes bytes{};
  putWord(bytes, 0, cycleWord(target.cycle));
  putJoints(bytes, 1, target.now.position);
  putJoints(bytes, 1 + kServojJoints, target.now.velocity);
  putJoints(bytes, 1 + 2 * kServojJoints, target.ahead.position);
  putJoints(bytes, 1 + 3 * kServojJoints, target.ahead.velocity);
  return bytes;
}

TargetBytes endBytes() {
  TargetBytes bytes{};
  putWord(bytes, 0, -1);
  return bytes;
}

ReportBytes reportBytes(const ServojReport& report) {
  ReportBytes bytes{};
  putWord(bytes, 0, kReport + static_cast<std::int32_t>(report.state));
  putWord(bytes, 1, cycleWord(report.cycle));
  putJoints(bytes, 2, report.position);
  return bytes;
}

TargetFrame targetOf(const TargetBytes& bytes) {
  TargetFrame frame;
  const std::int32_t cycle = wordOf(bytes, 0);
  if (cycle == -1) frame.kind = TargetFrame::Kind::End;
  if (cycle <= 0) return frame;
  frame.target.cycle = cycle;
  std::size_t word = 1;
  for (JointValues* const values : {&frame.target.now.position, &frame.target.now.velocity,
                                    &frame.target.ahead.position, &frame.target.ahead.velocity}) {
    const auto read = jointsOf(bytes, word);
    if (!read) return frame;
    *values = *read;
    word += kServojJoints;
  }
  frame.kind = TargetFrame::Kind::Target;
  return frame;
}

std::optional<ServojReport> reportOf(const ReportBytes& bytes) {
  const std::int64_t kind = std::int64_t{wordOf(bytes, 0)} - kReport;
  const std::int32_t cycle = wordOf(bytes, 1);
  const auto position = jointsOf(bytes, 2);
  if (kind < 0 || kind > kLastKind || cycle < 0 || !position) return std::nullopt;
  return ServojReport{static_cast<ServojState>(kind), cycle, *position};
}

void ReportReader::add(std::string_view bytes) {
  if (is_broken_) return;
  cutter_.add(bytes, [this](const ReportBytes& frame) {
    const std::optional<ServojReport> report = reportOf(frame);
    is_broken_ = !report;
    if (!report) return false;
    last_ = report;
    ++count_;
    return true;
  });
}

}  // namespace lamina
