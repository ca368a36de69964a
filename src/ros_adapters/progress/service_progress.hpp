// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/progress.hpp"

namespace lamina {

/// Progress of a service call: it is not shown, and is cancelled when ROS shuts down.
class ServiceProgress final : public Progress {
 public:
  void report(const std::string&, double) override {}
  bool isCancelled() const override;
};

}  // namespace lamina
