// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/divided_area.hpp"

#include <optional>
#include <utility>

#include "geometry/polygon/crossed_outlines.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {

DividedArea divided(const Regions& area, const Regions& by) {
  if (area.empty() || by.empty()) return {{}, area};
  const CrossedOutlines crossed(area, by);
  std::optional<Regions> common = crossed.common();
  std::optional<Regions> rest = crossed.rest();
  return {common ? std::move(*common) : intersection(area, by),
          rest ? std::move(*rest) : difference(area, by)};
}

}  // namespace lamina
