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
  int blocks = 0;                         ///< of its motion queue; 0 if it does not say
  int receive_bytes = 0;                  ///< of its receive buffer; 0 if it does not say
  std::string modes;                      ///< answer to `$G`
  std::optional<bool> reports_in_inches;  ///< nothing if it does not say
  bool is_laser = false;                  ///< laser mode is on ($32)

  /// Name and version, as in "grbl 1.1h.20190830".
  std::string name() const;
  /// A reported position [mm]; of a machine that does not say its unit, as if it were that.
  GrblAxes inMillimetres(const GrblAxes& reported) const;
  bool hasOption(char letter) const { return options.find(letter) != std::string::npos; }

  /// Takes an answer to `$I`, `$G` or `$$`.
  void learn(const GrblReply& reply);
};

}  // namespace lamina
