// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// The lines of a journal of evaluations: each one JSON object, without the end of the line.
class JournalLines {
 public:
  JournalLines(const DesignSpace& space, const std::vector<std::string>& response_names,
               const std::string& fingerprint);

  const std::string& header() const { return header_; }

  /// @throws InvalidInput telling in what it differs from this header
  void requireHeader(const std::string& line) const;

  /// Reads back to the same values, those that are not finite too.
  std::string lineOf(const Evaluation& evaluation) const;

  /// @throws InvalidInput telling what is wrong with it
  Evaluation evaluationOf(const std::string& line) const;

 private:
  const DesignSpace& space_;
  const std::vector<std::string>& response_names_;
  std::string header_;
};

}  // namespace lamina
