// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/edit_distance.hpp"

#include <algorithm>
#include <vector>

namespace lamina {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

namespace {

/// Whether a name holds the given words between its dots and underscores: "slicing.layer_height_mm" those of
/// "layer_height".
bool holdsWords(std::string_view name, std::string_view given) {
  const auto isEdge = [name](std::size_t at) {
    return at >= name.size() || name[at] == '.' || name[at] == '_';
  };
  for (std::size_t at = name.find(given); at != std::string_view::npos; at = name.find(given, at + 1))
    if ((at == 0 || isEdge(at - 1)) && isEdge(at + given.size())) return true;
  return false;
}

}  // namespace

std::string suggestionFor(const std::vector<std::string>& names, std::string_view given) {
  const auto nearest =
      std::min_element(names.begin(), names.end(), [given](const std::string& a, const std::string& b) {
        const bool a_holds = holdsWords(a, given);
        return a_holds == holdsWords(b, given) ? editDistance(a, given) < editDistance(b, given) : a_holds;
      });
  if (nearest == names.end()) return "";
  const bool is_like = holdsWords(*nearest, given) ||
                       2 * editDistance(*nearest, given) <= std::max(nearest->size(), given.size());
  return is_like && !given.empty() ? "; did you mean '" + *nearest + "'?" : "";
}

}  // namespace lamina
