// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace lamina {

/// Counts commands that firmware, which answers in order, has not answered yet. The answer to a question
/// replaces lost answers to the commands before it.
class UnansweredCommands {
 public:
  void sent() { ++sent_; }
  /// States that the command sent last is a question.
  void isQuestion(std::uint64_t question) {
    question_ = question;
    sent_at_question_ = sent_;
  }

  /// States that one command was answered by its ok.
  void onOk() { answered_ = std::min(answered_ + 1, sent_); }
  /// States that a question was answered; its ok is still to come.
  void onAnswer(std::uint64_t question) {
    if (question == question_ && question > 0) answered_ = std::max(answered_, sent_at_question_ - 1);
  }
  /// States that the firmware has discarded all unanswered commands.
  void forget() { answered_ = sent_; }

  std::size_t count() const { return sent_ - answered_; }

 private:
  std::size_t sent_ = 0;
  std::size_t answered_ = 0;
  std::uint64_t question_ = 0;  ///< the last one
  std::size_t sent_at_question_ = 0;
};

}  // namespace lamina
