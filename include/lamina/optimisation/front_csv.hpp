// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// A point of a front, as read from a file.
struct FrontRow {
  std::vector<std::string> values;  ///< of the variables, as in a configuration
  std::vector<double> responses;    ///< not a number where the cell is empty
  std::size_t line = 0;             ///< its number in the file, from 1
};

/// A front, as read from a file.
struct FrontTable {
  std::string source;  ///< name of the file, for errors
  std::vector<std::string> variables;
  std::vector<std::string> responses;
  std::vector<FrontRow> rows;
};

/// The front as a table (.csv): a line `# variables N`, a header, and a row for each point with its N
/// variables and then its responses. Cells are empty for responses that are not finite, and for those of
/// points that could not be tried.
std::string frontCsv(const DesignSpace& space, const std::vector<std::string>& response_names,
                     const std::vector<Evaluation>& front);

/// Reads a table that `frontCsv` wrote, or that was written by hand in that form.
/// @throws FileError; InvalidInput naming file and line if the number of variables is missing or greater than
///   the number of columns, there is no row, or a response is no number
FrontTable readFrontCsv(const std::string& path);

}  // namespace lamina
