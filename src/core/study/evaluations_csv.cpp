// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/evaluations_csv.hpp"

#include <charconv>
#include <cmath>

#include "lamina/base/text.hpp"

namespace lamina {
namespace {

/// A cell as RFC 4180 wants it; line ends become spaces, so that each row stays one line.
std::string cell(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  if (text.find_first_of(",\"#") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string number(double value) {
  if (!std::isfinite(value)) return {};
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

std::string evaluationsCsv(const DesignSpace& space, const std::vector<std::string>& response_names,
                           const std::vector<Evaluation>& evaluations) {
  std::vector<std::string> head;
  for (const Variable& variable : space) head.push_back(cell(variable.name));
  for (const std::string& name : response_names) head.push_back(cell(name));
  std::string csv = listed(head, ",") + ",error\n";
  for (const Evaluation& evaluation : evaluations) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < space.size(); ++i)
      cells.push_back(cell(textOf(space[i], evaluation.point.at(i))));
    for (std::size_t i = 0; i < response_names.size(); ++i)
      cells.push_back(isEvaluated(evaluation) ? number(evaluation.responses.at(i)) : std::string());
    csv += listed(cells, ",") + "," + cell(evaluation.error) + "\n";
  }
  return csv;
}

}  // namespace lamina
