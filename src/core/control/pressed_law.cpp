// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/pressed_law.hpp"

#include <algorithm>

#include "lamina/control/path_low_pass.hpp"

namespace lamina {

LayerCorrection pressedCorrection(const LayerCells& cells, const SectionKnowledge& known,
                                  const LoopSettings& settings) {
  std::vector<double> wanted = lowPassed(known.deficit, cells, settings.low_pass_mm);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    wanted[i] = (1.0 + settings.gain * wanted[i]) / known.gain[i] - 1.0;
  LoopSettings bounded = settings;
  bounded.least_amount = std::max(settings.least_amount, -kPressedAmount);
  bounded.greatest_amount = std::min(settings.greatest_amount, kPressedAmount);
  return limitedCorrection(cells, wanted, bounded);
}

DropDecision dropDecision(double error_mm, double drop_mm) {
  if (error_mm < -0.5 * drop_mm) return DropDecision::Leave;
  if (error_mm > 0.5 * drop_mm) return DropDecision::LayTwo;
  return DropDecision::Lay;
}

}  // namespace lamina
