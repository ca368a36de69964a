// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/evaluations_csv.hpp"

#include <cmath>

#include "lamina/base/csv_table.hpp"
#include "lamina/base/exact_text.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

std::string number(double value) { return std::isfinite(value) ? exactText(value) : std::string(); }

}  // namespace

std::string evaluationsCsv(const DesignSpace& space, const std::vector<std::string>& response_names,
                           const std::vector<Evaluation>& evaluations) {
  std::vector<std::string> head;
  for (const Variable& variable : space) head.push_back(csvCell(variable.name));
  for (const std::string& name : response_names) head.push_back(csvCell(name));
  std::string csv = listed(head, ",") + ",error\n";
  for (const Evaluation& evaluation : evaluations) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < space.size(); ++i)
      cells.push_back(csvCell(textOf(space[i], evaluation.point.at(i))));
    for (std::size_t i = 0; i < response_names.size(); ++i)
      cells.push_back(isEvaluated(evaluation) ? number(evaluation.responses.at(i)) : std::string());
    csv += listed(cells, ",") + "," + csvCell(evaluation.error) + "\n";
  }
  return csv;
}

}  // namespace lamina
