// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"

namespace lamina {

/// The position of a machine by its reports, most of which lack the offset of the work.
class GrblPlace {
 public:
  /// Takes a report while the machine is prepared.
  void learn(const GrblReport& report);
  /// Takes a report of a machine that may move.
  /// @return whether it stands elsewhere than at the report before
  bool follow(const GrblReport& report);

  /// The position in the coordinates of the work, in the unit of the reports; nothing if it is not known.
  const std::optional<GrblAxes>& work() const { return work_; }
  void forgetWork() { work_.reset(); }

 private:
  std::optional<GrblAxes> work_offset_;
  std::optional<GrblAxes> place_;  ///< in the coordinates that were reported
  std::optional<GrblAxes> work_;
};

}  // namespace lamina
