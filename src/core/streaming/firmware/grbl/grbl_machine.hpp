// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"

namespace lamina {

/// The description of a machine by its answers before a job.
struct GrblMachine {
  GrblDialect dialect = GrblDialect::Grbl;
  std::string version;                    ///< "1.1h.20190830"
  std::string options;                    ///< letters of the options it was built with
  int blocks = 0;                         ///< number of blocks of its motion queue; 0 if not reported
  int receive_bytes = 0;                  ///< size of its receive buffer; 0 if not reported
  std::string modes;                      ///< answer to `$G`
  std::optional<bool> reports_in_inches;  ///< nothing if not reported
  bool is_laser = false;                  ///< laser mode is on ($32)

  /// Name and version, as in "grbl 1.1h.20190830".
  std::string name() const;
  /// A reported position [mm]. If the machine does not report its unit, mm are assumed.
  GrblAxes inMillimetres(const GrblAxes& reported) const;
  bool hasOption(char letter) const { return options.find(letter) != std::string::npos; }

  /// Evaluates an answer to `$I`, `$G` or `$$`.
  void learn(const GrblReply& reply);
};

}  // namespace lamina
