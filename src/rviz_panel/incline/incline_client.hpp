// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "actions/run_outcome.hpp"
#include "incline/incline_form.hpp"

namespace lamina {

/// Client of an action lamina/Incline that never waits: `poll` does what there is to do and returns at
/// once, and calls the functions below. All calls come from one thread, that of the panel's window. ROS must
/// have been started.
class InclineClient {
 public:
  /// @param action  name of it
  explicit InclineClient(const std::string& action);
  ~InclineClient();

  std::function<void(const std::string& stage, double fraction)> progressed;
  /// Once for each run; also if there is no node, if it does not answer a cancel, or if it dies meanwhile.
  std::function<void(const RunOutcome& outcome)> ended;

  /// Does nothing while a run is under way.
  void run(const InclineRequest& request);
  void cancel();
  bool isRunning() const;
  void poll();

 private:
  class Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace lamina
