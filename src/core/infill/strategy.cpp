// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/strategy.hpp"

#include <map>

#include "infill/hilbert.hpp"
#include "infill/hilbert_quadtree.hpp"
#include "infill/hybrid.hpp"
#include "infill/zigzag.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

const std::map<std::string, InfillStrategy>& strategies() {
  static const std::map<std::string, InfillStrategy> by_name = {
      {"hilbert", {hilbert, RunOrder::Shortest, LayerLink::Travel, WallContact::Overlapping}},
      {"hilbert_quadtree", {hilbertQuadtree, RunOrder::Shortest, LayerLink::Chained, WallContact::Beside}},
      {"hybrid", {hybrid, RunOrder::AsGiven, LayerLink::Travel, WallContact::Beside}},
      {"zigzag", {zigzag, RunOrder::Shortest, LayerLink::Travel, WallContact::Overlapping}},
  };
  return by_name;
}

}  // namespace

InfillStrategy infillStrategy(const std::string& name) {
  const auto found = strategies().find(name);
  if (found != strategies().end()) return found->second;
  std::string names;
  for (const std::string& known : infillStrategyNames()) names += (names.empty() ? "" : " | ") + known;
  throw InvalidConfig("infill.strategy is '" + name + "'; must be one of " + names);
}

std::vector<std::string> infillStrategyNames() {
  std::vector<std::string> names;
  for (const auto& entry : strategies()) names.push_back(entry.first);
  return names;
}

}  // namespace lamina
