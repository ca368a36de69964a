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

// Frames that this host and the program on the robot exchange: integers of four bytes, most significant byte
// first, as URScript reads and writes them; angles in millionths of a radian.
constexpr int kServojJoints = 6;
/// Number of integers of a target frame: number of the cycle, then positions and velocities for this
/// cycle, then those for the time `CyclicSink::ahead` later. Cycle 2^31 - 1 is followed by cycle 1; cycle -1
/// ends the program.
constexpr std::size_t kTargetWords = 1 + 4 * kServojJoints;
/// Number of integers of a report frame: state, cycle of the newest target, positions.
constexpr std::size_t kReportWords = 2 + kServojJoints;

using TargetBytes = std::array<char, 4 * kTargetWords>;
using ReportBytes = std::array<char, 4 * kReportWords>;

/// State of the program on the robot.
enum class ServojState : std::uint8_t {
  Waiting,  ///< no target has arrived yet
  Following,
  Silent,  ///< brakes or rests, since no target arrived in time
  Ended,   ///< brakes or rests, since it was commanded to end
};

/// The report that the robot sends each cycle.
struct ServojReport {
  ServojState state = ServojState::Waiting;
  std::int64_t cycle = 0;  ///< number of the newest target; 0 before the first
  JointValues position;    ///< [rad]
};

/// The frame of a target.
/// @param target  target of six joints, its cycle at least 1
TargetBytes targetBytes(const CyclicTarget& target);
/// The frame that ends the program on the robot.
TargetBytes endBytes();
/// The frame of a report.
ReportBytes reportBytes(const ServojReport& report);

/// Contents of a target frame.
struct TargetFrame {
  enum class Kind : std::uint8_t { Target, End, Broken };
  Kind kind = Kind::Broken;
  CyclicTarget target;  ///< only if `kind` is `Target`
};
/// Decodes a target frame.
TargetFrame targetOf(const TargetBytes& bytes);
/// Decodes a report frame; nothing if the bytes are no report.
std::optional<ServojReport> reportOf(const ReportBytes& bytes);

/// Cuts a stream of bytes into frames of one length.
template <class Bytes>
class FrameCutter {
 public:
  /// @param bytes  in pieces of any length
  /// @param whole  called with each complete frame; if it returns false, the rest of `bytes` is ignored
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

/// Decodes the reports of a robot from a stream of bytes, and keeps the last of them.
class ReportReader {
 public:
  void add(std::string_view bytes);
  /// The last report; nothing before the first.
  const std::optional<ServojReport>& last() const { return last_; }
  std::size_t count() const { return count_; }  ///< number of reports so far
  /// Whether a frame that is no report has arrived; all bytes after it are ignored.
  bool isBroken() const { return is_broken_; }

 private:
  FrameCutter<ReportBytes> cutter_;
  std::optional<ServojReport> last_;
  std::size_t count_ = 0;
  bool is_broken_ = false;
};

}  // namespace lamina
