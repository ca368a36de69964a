// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/streaming/session/stream_session.hpp"

namespace lamina::cli {

/// Commands to a running job, one per line of standard input: "feed 90", "pause", "resume".
class LiveInput {
 public:
  /// Carries out the lines typed since the last call, up to 4096 characters, and reports for each line
  /// whether it was accepted. Does not wait. A line of more than 4096 characters is refused.
  void follow(StreamSession& session);

  /// Reports the machine's last message, once.
  void tell(const StreamSession& session);

 private:
  static std::string follow(StreamSession& session, const std::string& line);

  std::string typed_;
  std::string reported_;  ///< the session's message
  bool is_over_ = false;
};

}  // namespace lamina::cli
