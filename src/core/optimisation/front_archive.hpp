// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// Members that no other dominates: none is nowhere worse, and somewhere better. Costs are to be minimised;
/// members of equal costs are all kept.
class FrontArchive {
 public:
  /// Keeps a member if no other dominates it, and drops those that it dominates.
  /// @param costs  as many as of the members before, at least one
  void add(std::size_t member, const std::vector<double>& costs);

  const std::vector<std::size_t>& members() const { return members_; }

 private:
  std::vector<std::size_t> members_;
  std::vector<double> costs_;  ///< of one member after the other: they are read far more often than kept
};

}  // namespace lamina
