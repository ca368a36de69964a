// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/part_learning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/control/cell_estimate.hpp"
#include "lamina/control/path_low_pass.hpp"

namespace lamina {
namespace {

constexpr double kLeastCommanded = 0.1;  // of a layer, below which growth shows no gain

void requireOnePerCell(const DepositedLayer& layer, std::size_t index) {
  const std::size_t cells = layer.cells.size();
  for (const std::size_t count : {layer.amount.size(), layer.growth_error_mm.size()})
    if (count != cells)
      throw InvalidInput("layer " + std::to_string(index) + " has " + std::to_string(count) +
                         " values for its " + std::to_string(cells) + " cells; expected one each");
}

/// What each cell lacks of the amount by which it would have grown as planned. What the loop deposited
/// beyond the map to mend the layers below is no part of that: it would be deposited again on layers that
/// lack nothing.
std::vector<double> missingFrom(const std::vector<double>& amount, const DepositedLayer& layer) {
  std::vector<double> missing(amount.size(), 0.0);
  for (std::size_t i = 0; i < missing.size(); ++i) {
    const double planned_mm = layer.cells.height_mm[i];
    const double commanded_mm = planned_mm * (1.0 + layer.amount[i]);
    if (!std::isfinite(layer.growth_error_mm[i]) || !(commanded_mm > kLeastCommanded * planned_mm)) continue;
    const double gain = (planned_mm - layer.growth_error_mm[i]) / commanded_mm;
    missing[i] =
        1.0 / std::clamp(gain, CellEstimate::kLeastGain, CellEstimate::kGreatestGain) - 1.0 - amount[i];
  }
  return missing;
}

std::string differsIn(const std::string& what, const std::string& is, const std::string& expected) {
  return is == expected ? std::string() : what + " '" + is + "' instead of '" + expected + "'";
}

/// A layer counts half, its neighbours a quarter each; at the ends of the part more of itself.
std::vector<std::vector<double>> smoothAcrossLayers(const std::vector<std::vector<double>>& amount) {
  std::vector<std::vector<double>> smooth = amount;
  for (std::size_t k = 0; k < amount.size(); ++k) {
    const auto& below = k > 0 && amount[k - 1].size() == amount[k].size() ? amount[k - 1] : amount[k];
    const auto& above =
        k + 1 < amount.size() && amount[k + 1].size() == amount[k].size() ? amount[k + 1] : amount[k];
    for (std::size_t i = 0; i < amount[k].size(); ++i)
      smooth[k][i] = 0.5 * amount[k][i] + 0.25 * below[i] + 0.25 * above[i];
  }
  return smooth;
}

}  // namespace

std::string differenceOf(const PartIdentity& map, const PartIdentity& other) {
  const std::string differences[] = {differsIn("program", other.program, map.program),
                                     differsIn("machine", other.machine, map.machine),
                                     differsIn("material", other.material, map.material)};
  for (const std::string& difference : differences)
    if (!difference.empty()) return difference;
  return {};
}

PartMap learntFromPart(const PartMap& before, const PartIdentity& identity,
                       const std::vector<DepositedLayer>& part, PartEnd end, const LoopSettings& settings) {
  const bool is_first = before.parts == 0;
  const std::string difference = is_first ? std::string() : differenceOf(before.identity, identity);
  if (!difference.empty()) throw InvalidInput("the learnt map is of another part: " + difference);
  if (!is_first && before.amount.size() != part.size())
    throw InvalidInput("the part has " + std::to_string(part.size()) + " layers; expected " +
                       std::to_string(before.amount.size()) + ", as the learnt map");
  if (end == PartEnd::Aborted) return before;
  for (std::size_t k = 0; k < part.size(); ++k) {
    requireOnePerCell(part[k], k);
    if (!is_first && before.amount[k].size() != part[k].cells.size())
      throw InvalidInput("layer " + std::to_string(k) + " of the part has " +
                         std::to_string(part[k].cells.size()) + " cells; expected " +
                         std::to_string(before.amount[k].size()) + ", as the learnt map");
  }
  PartMap learnt{identity, before.parts + 1, {}};
  // A mean of all parts so far, until a new one would count less than it should.
  const double share = std::max(settings.part_learning, 1.0 / static_cast<double>(learnt.parts));
  for (std::size_t k = 0; k < part.size(); ++k) {
    const DepositedLayer& layer = part[k];
    std::vector<double> amount = is_first ? std::vector<double>(layer.cells.size(), 0.0) : before.amount[k];
    const std::vector<double> missing =
        lowPassed(missingFrom(amount, layer), layer.cells, settings.low_pass_mm);
    for (std::size_t i = 0; i < amount.size(); ++i) amount[i] += share * missing[i];
    learnt.amount.push_back(std::move(amount));
  }
  learnt.amount = smoothAcrossLayers(learnt.amount);
  for (std::size_t k = 0; k < part.size(); ++k)
    learnt.amount[k] = limitedCorrection(part[k].cells, learnt.amount[k], settings).amount;
  return learnt;
}

}  // namespace lamina
