// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "actions/run_outcome.hpp"
#include "print/print_form.hpp"

namespace lamina {

/// Client of the action lamina/Slice that never waits (`ActionRun`).
class SliceClient {
 public:
  /// @param action  name of it
  explicit SliceClient(const std::string& action);
  ~SliceClient();

  std::function<void(const std::string& stage, double fraction)> progressed;
  std::function<void(const RunOutcome& outcome)> ended;  ///< once for each run

  /// Does nothing while a run is under way.
  void run(const SliceRequest& request);
  void cancel();
  bool isRunning() const;
  void poll();

 private:
  class Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace lamina
