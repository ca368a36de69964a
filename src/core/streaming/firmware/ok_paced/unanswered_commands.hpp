// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace lamina {

/// How many commands of any kind firmware that answers in order still has to answer. An answer that was lost
/// is made up for by that to a question behind it.
class UnansweredCommands {
 public:
  void sent() { ++sent_; }
  /// The command sent last is a question.
  void isQuestion(std::uint64_t question) {
    question_ = question;
    sent_at_question_ = sent_;
  }

  /// One was answered by its ok.
  void onOk() { answered_ = std::min(answered_ + 1, sent_); }
  /// A question was answered; its ok is to come.
  void onAnswer(std::uint64_t question) {
    if (question == question_ && question > 0) answered_ = std::max(answered_, sent_at_question_ - 1);
  }
  /// Whoever had them has forgotten them.
  void forget() { answered_ = sent_; }

  std::size_t count() const { return sent_ - answered_; }

 private:
  std::size_t sent_ = 0;
  std::size_t answered_ = 0;
  std::uint64_t question_ = 0;  ///< the last one
  std::size_t sent_at_question_ = 0;
};

}  // namespace lamina
