// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lamina/servo/cyclic_sink.hpp"

namespace lamina {

// What goes between this host and the program on the robot: whole numbers of four bytes, the highest first,
// as URScript reads and writes them; joints in millionths of a radian.

constexpr int kServojJoints = 6;
/// A frame of a target: its cycle, then joints and speeds now and ahead. A cycle of -1 ends the program.
constexpr std::size_t kTargetWords = 1 + 4 * kServojJoints;
/// A frame of a report: kind, cycle of the newest target, joints.
constexpr std::size_t kReportWords = 2 + kServojJoints;

using TargetBytes = std::array<char, 4 * kTargetWords>;
using ReportBytes = std::array<char, 4 * kReportWords>;

/// What the program on the robot does.
enum class ServojState : std::uint8_t {
  Waiting,  ///< no target has come yet
  Following,
  Silent,  ///< brakes or stands, as no target came in time
  Ended,   ///< was commanded to end
};

/// What the robot reports each cycle.
struct ServojReport {
  ServojState state = ServojState::Waiting;
  std::int64_t cycle = 0;  ///< of the newest target that it has; 0 before the first
  JointValues position;    ///< [rad]
};

/// @param target  of six joints; its cycle within 1 to 2^31 - 1
TargetBytes targetBytes(const CyclicTarget& target);
/// Ends the program on the robot.
TargetBytes endBytes();
ReportBytes reportBytes(const ServojReport& report);

/// What the frame of a target says.
struct TargetFrame {
  enum class Kind : std::uint8_t { Target, End, Broken };
  Kind kind = Kind::Broken;
  CyclicTarget target;  ///< of `Target`
};
TargetFrame targetOf(const TargetBytes& bytes);
/// Nothing if the bytes are no report.
std::optional<ServojReport> reportOf(const ReportBytes& bytes);

/// Cuts bytes, as they come, into frames of one length.
template <class Bytes>
class FrameCutter {
 public:
  /// @param whole  called with each frame; it ends the cutting by returning false
  template <class Whole>
  void add(std::string_view bytes, Whole whole) {
    for (const char byte : bytes) {
      frame_[filled_++] = byte;
      if (filled_ < frame_.size()) continue;
      filled_ = 0;
      if (!whole(frame_)) return;
    }
  }

 private:
  Bytes frame_{};
  std::size_t filled_ = 0;
};

/// Reads the reports of a robot, and knows the last of them.
class ReportReader {
 public:
  void add(std::string_view bytes);
  /// Nothing before the first.
  const std::optional<ServojReport>& last() const { return last_; }
  std::size_t count() const { return count_; }
  /// Whether bytes came that are no report; nothing is read any more.
  bool isBroken() const { return is_broken_; }

 private:
  FrameCutter<ReportBytes> cutter_;
  std::optional<ServojReport> last_;
  std::size_t count_ = 0;
  bool is_broken_ = false;
};

}  // namespace lamina
