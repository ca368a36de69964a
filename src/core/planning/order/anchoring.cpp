// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/order/anchoring.hpp"

namespace lamina {

void describe(SettingsSchema& schema, AnchorSettings& anchoring) {
  schema.choice<Anchoring>(
      "anchoring.strategy", anchoring.strategy,
      {{"none", Anchoring::None},
       {"supported_start", Anchoring::SupportedStart},
       {"where_possible", Anchoring::WherePossible}},
      "Where runs of inclined layers begin: as planned, or on bed or material; then what "
      "begins in mid-air is refused, or laid nevertheless.");
}

}  // namespace lamina
