// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "streaming/firmware/ok_paced/ok_paced_firmware.hpp"

namespace lamina {

/// The numbered questions of a job. Once the last one is answered, everything sent before it was answered
/// too, or never will be.
class PacedQuestions {
 public:
  /// Begins to count questions and oks, while at most one line is unanswered.
  void begin() {
    asked_ = 0;
    oks_ = 0;
    is_line_answered_ = false;
    answer_.reset();
  }
  /// Adds a question.
  /// @return its number
  std::uint64_t ask() {
    answer_.reset();
    ++asked_;
    return ++last_;
  }
  std::uint64_t last() const { return last_; }

  /// Counts an ok that came before the answer to the last question.
  void hearOk() { ++oks_; }
  /// Evaluates an answer.
  /// @return whether it belongs to the last question
  bool hear(const SyncAnswer& answer) {
    // Each earlier question has at most one ok; one ok more is that of the line.
    const std::uint64_t first = last_ - asked_ + 1;
    if (answer.question >= first && oks_ > answer.question - first) is_line_answered_ = true;
    return answer.question == last_;
  }
  /// Keeps the answer to the last question, whose ok is still to come.
  void keep(const SyncAnswer& answer) { answer_ = answer; }
  /// The answer kept; nothing once another question was added.
  const std::optional<SyncAnswer>& answer() const { return answer_; }
  /// Whether the ok of the line was among those counted.
  bool isLineAnswered() const { return is_line_answered_; }

 private:
  std::uint64_t last_ = 0;
  std::uint64_t asked_ = 0;
  std::uint64_t oks_ = 0;
  bool is_line_answered_ = false;
  std::optional<SyncAnswer> answer_;
};

}  // namespace lamina
