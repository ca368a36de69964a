// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "actions/run_outcome.hpp"

namespace lamina {

/// How far a print is.
struct PrintProgress {
  std::string state;      ///< its name in PackML
  int layer = -1;         ///< from 0; -1 before the first
  double fraction = 0.0;  ///< of the program's lines
};

/// Client of the action lamina/StreamProgram that never waits (`ActionRun`).
class StreamClient {
 public:
  /// @param action  name of it
  explicit StreamClient(const std::string& action);
  ~StreamClient();

  std::function<void(const PrintProgress& progress)> progressed;
  std::function<void(const RunOutcome& outcome)> ended;  ///< once for each print

  /// Does nothing while a print is under way.
  void print(const std::string& program);
  /// A safe stop.
  void stop();
  bool isRunning() const;
  void poll();

 private:
  class Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace lamina
