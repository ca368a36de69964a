// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace lamina {

/// The set of members that no other member dominates: none is at least as good in all costs and better in
/// one. Costs are minimised; members with equal costs are all kept.
class FrontArchive {
 public:
  /// Keeps a member if no other dominates it, and drops those that it dominates.
  /// @param costs  as many as those of earlier members, at least one
  void add(std::size_t member, const std::vector<double>& costs);

  const std::vector<std::size_t>& members() const { return members_; }

 private:
  std::vector<std::size_t> members_;
  std::vector<double> costs_;  ///< of one member after the other, as they are read far more often than added
};

}  // namespace lamina
