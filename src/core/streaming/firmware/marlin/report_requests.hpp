// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lamina {

/// Requests for reports, each asked for a few times if it is not answered.
class ReportRequests {
 public:
  /// @param requests  in reverse order: the last one is sent first
  void begin(std::vector<std::string> requests) {
    requests_ = std::move(requests);
    attempts_ = 0;
  }

  bool isDone() const { return requests_.empty(); }
  /// The request to be sent next; not to be called when all are done.
  const std::string& next() const { return requests_.back(); }
  /// States that the request was not answered.
  /// @return whether to repeat it
  bool mayRepeat() {
    constexpr int kAttempts = 3;
    return ++attempts_ < kAttempts;
  }
  /// States that the request was answered, or is given up.
  void advance() {
    requests_.pop_back();
    attempts_ = 0;
  }

 private:
  std::vector<std::string> requests_;
  int attempts_ = 0;
};

}  // namespace lamina
