// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

#include "lamina/base/text_search.hpp"
#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// Whether the answer to `M115` states that the firmware acts on `M108` while it waits: it was built with
/// EMERGENCY_PARSER.
inline bool saysThatItHearsAtOnce(const FirmwareReply& reply) {
  return contains(reply.text, "Cap:EMERGENCY_PARSER:1");
}

/// A wait of the machine for a person, as in M0 and M600. The machine reports it repeatedly.
class PersonWait {
 public:
  enum class News { None, Begun, Ended };

  /// @param hears_at_once  whether the machine is known to hear `M108` while it waits
  explicit PersonWait(bool hears_at_once) : hears_at_once_(hears_at_once) {}

  News hear(const FirmwareReply& reply) {
    hears_at_once_ = hears_at_once_ || saysThatItHearsAtOnce(reply);
    const bool was_under_way = is_under_way_;
    if (reply.kind == ReplyKind::Ok) is_under_way_ = false;
    if (reply.kind == ReplyKind::Busy) is_under_way_ = contains(reply.text, "paused for");
    if (was_under_way == is_under_way_) return News::None;
    return is_under_way_ ? News::Begun : News::Ended;
  }

  /// Message on what the machine waits for and what ends the wait.
  std::string advice(const std::string& said) const {
    return "the machine waits for a person: \"" + said + "\"; " +
           (hears_at_once_ ? "resume makes it go on (M108)"
                           : "press its button, since it hears no command meanwhile (its firmware was built "
                             "without EMERGENCY_PARSER)");
  }
  /// Marks the wait as ended; a machine that still waits reports so again.
  /// @return whether to send `M108`: the machine was waiting and acts on it
  bool release() { return std::exchange(is_under_way_, false) && hears_at_once_; }

 private:
  bool hears_at_once_;
  bool is_under_way_ = false;
};

}  // namespace lamina
