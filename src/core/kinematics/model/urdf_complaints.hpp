// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <console_bridge/console.h>

#include <mutex>
#include <string>

namespace lamina {

/// While it lives, it keeps what the parser of URDF complains of, which would go to the terminal; the
/// parser's results report no reasons. One at a time: others wait.
class UrdfComplaints : public console_bridge::OutputHandler {
 public:
  UrdfComplaints();
  ~UrdfComplaints() override;
  UrdfComplaints(const UrdfComplaints&) = delete;
  UrdfComplaints& operator=(const UrdfComplaints&) = delete;

  /// The first error, which later ones follow from; empty if there was none.
  const std::string& first() const { return first_; }

  void log(const std::string& text, console_bridge::LogLevel level, const char* file, int line) override;

 private:
  std::unique_lock<std::mutex> alone_;
  console_bridge::OutputHandler* usual_;
  std::string first_;
};

}  // namespace lamina
