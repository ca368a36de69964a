// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

enum class PathClosure : std::uint8_t { Open, Closed };

/// Values of a path's motions, converted to values of the waypoints at which the motions end; a single value
/// if all are equal.
/// @param of_motions  not empty
template <class Value>
AlongPath<Value> perWaypoint(const std::vector<Value>& of_motions, PathClosure ends) {
  const bool is_common = std::all_of(of_motions.begin(), of_motions.end(),
                                     [&](const Value& value) { return value == of_motions.front(); });
  if (is_common) return of_motions.front();
  const bool is_closed = ends == PathClosure::Closed;
  std::vector<Value> each;
  each.reserve(of_motions.size() + 1);
  each.push_back(is_closed ? of_motions.back() : of_motions.front());
  each.insert(each.end(), of_motions.begin(), of_motions.end() - (is_closed ? 1 : 0));
  return AlongPath<Value>(std::move(each));
}

}  // namespace lamina
