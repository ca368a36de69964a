// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/streaming/session/stream_session.hpp"

namespace lamina::cli {

/// Commands to a job that runs, a line each on the standard input: "feed 90", "pause", "resume".
class LiveInput {
 public:
  /// Follows what has been typed since the last call, up to 4096 characters of it, and says of each line
  /// whether it was taken. Does not wait. A line of more than 4096 characters is not taken.
  void follow(StreamSession& session);

  /// Says what the machine has said last, once.
  void tell(const StreamSession& session);

 private:
  static std::string follow(StreamSession& session, const std::string& line);

  std::string typed_;
  std::string reported_;  ///< the session's message
  bool is_over_ = false;
};

}  // namespace lamina::cli
