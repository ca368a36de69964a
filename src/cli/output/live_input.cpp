// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "live_input.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <sstream>

#include "lamina/base/error.hpp"

namespace lamina::cli {
namespace {

constexpr std::size_t kMostAtOnce = 4096;  // characters

}  // namespace

void LiveInput::follow(StreamSession& session) {
  // One buffer at a time: what is sent without end must not keep the caller from its other work.
  std::array<char, kMostAtOnce> bytes{};
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (!is_over_ && ::poll(&input, 1, 0) > 0) {
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    is_over_ = count <= 0;
    if (count > 0) typed_.append(bytes.data(), static_cast<std::size_t>(count));
  }
  for (std::size_t end = typed_.find('\n'); end != std::string::npos; end = typed_.find('\n')) {
    const std::string line = typed_.substr(0, end);
    typed_.erase(0, end + 1);
    if (!line.empty()) std::fprintf(stderr, "%s: %s\n", line.c_str(), follow(session, line).c_str());
  }
  if (typed_.size() < kMostAtOnce) return;
  std::fprintf(stderr, "%zu characters without the end of a line: not taken; expected such as feed 90\n",
               typed_.size());
  typed_.clear();
}

void LiveInput::tell(const StreamSession& session) {
  const std::string message = session.status().message;
  if (message == reported_) return;
  reported_ = message;
  if (!message.empty()) std::fprintf(stderr, "machine: %s\n", message.c_str());
}

std::string LiveInput::follow(StreamSession& session, const std::string& line) {
  std::istringstream words(line);
  std::string name;
  double value = 0.0;
  words >> name;
  if (name == "pause" || name == "resume") {
    name == "pause" ? session.pause() : session.resume();
    return "asked for";
  }
  if (!(words >> value)) return "no number; expected such as feed 90";
  try {
    const std::string refusal = session.change(liveChange(name, value));
    return refusal.empty() ? "taken" : refusal;
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace lamina::cli
