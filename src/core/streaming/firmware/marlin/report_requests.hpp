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
  /// @param requests  the last one first
  void begin(std::vector<std::string> requests) {
    requests_ = std::move(requests);
    attempts_ = 0;
  }

  bool isDone() const { return requests_.empty(); }
  /// The request to be asked for, unless all are done.
  const std::string& next() const { return requests_.back(); }
  /// States that it was not answered.
  /// @return whether to ask for it once more
  bool mayRepeat() {
    constexpr int kAttempts = 3;
    return ++attempts_ < kAttempts;
  }
  /// States that it was answered, or will not be.
  void advance() {
    requests_.pop_back();
    attempts_ = 0;
  }

 private:
  std::vector<std::string> requests_;
  int attempts_ = 0;
};

}  // namespace lamina
