// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"

namespace lamina {

/// The position of a machine from its reports, most of which do not state the work offset.
class GrblPlace {
 public:
  /// Evaluates a report while the machine is being prepared.
  void learn(const GrblReport& report);
  /// Evaluates a report of a machine that may move.
  /// @return whether the machine is at another position than in the report before
  bool follow(const GrblReport& report);

  /// The position in work coordinates, in the unit of the reports; nothing if it is not known.
  const std::optional<GrblAxes>& work() const { return work_; }
  void forgetWork() { work_.reset(); }

 private:
  std::optional<GrblAxes> work_offset_;
  std::optional<GrblAxes> place_;  ///< position in the coordinates of the reports
  std::optional<GrblAxes> work_;
};

}  // namespace lamina
