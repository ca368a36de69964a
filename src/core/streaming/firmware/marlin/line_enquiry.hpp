// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"
#include "streaming/job/answer_timer.hpp"

namespace lamina {

/// Finds out how many lines of an unfinished job the firmware has accepted, without changing anything in the
/// firmware.
///
/// First it empties the firmware's line buffer, which may hold the beginning of a line of the earlier
/// session. Backspaces erase what they reach; an end of line makes the rest a line without checksum, which is
/// refused, or completes a line that lacked only its end. Then it asks for the firmware's name; the answer
/// follows the oks of all lines that were still queued. Finally it sends a line with a wrong number; the
/// firmware replies by requesting the line that it lacks.
class LineEnquiry {
 public:
  LineEnquiry(const StreamOrder& order, std::shared_ptr<const MarlinFirmware> firmware);

  void start(double now);
  void hear(const FirmwareReply& reply, double now);
  void elapse(double now);
  double nextDeadline() const;
  std::string takeOutput() { return std::exchange(output_, {}); }

  /// Number of the last line accepted; nothing until it is known.
  const std::optional<std::uint64_t>& taken() const { return taken_; }
  /// Why the number cannot be known, or the job must not be resumed from it; Ok otherwise.
  const Failure& failure() const { return failure_; }

 private:
  enum class Step {
    Emptying,   ///< the line buffer; until nothing is heard any more
    Naming,     ///< until the name was heard, and its ok
    Quieting,   ///< until nothing is heard any more
    Counting,   ///< until the firmware requests a line
    Confirming  ///< until nothing is heard any more
  };

  void enter(Step step, double now);
  void ask(double now);
  void onCounted(std::uint64_t wanted, double now);
  void conclude();
  bool isOver() const { return taken_ || failure_.code != ErrorCode::Ok; }
  bool waitsForQuiet() const {
    return step_ == Step::Emptying || step_ == Step::Quieting || step_ == Step::Confirming;
  }
  void fail(ErrorCode code, const std::string& why);

  StreamSettings settings_;
  std::shared_ptr<const MarlinFirmware> firmware_;
  UnfinishedLines unfinished_;
  std::uint64_t base_;
  std::uint64_t lines_total_;
  std::uint64_t wrong_number_;
  AnswerTimer timer_;
  Step step_ = Step::Emptying;
  double quiet_at_ = 0.0;
  bool is_named_ = false;
  std::optional<std::uint64_t> wanted_;  ///< line that the firmware requested last
  std::optional<std::uint64_t> taken_;
  Failure failure_;
  std::string output_;
};

}  // namespace lamina
