// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/contour/contour_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, ContourSettings& settings) {
  schema.choice("contour.link", settings.link,
                {{"tangential", ContourLink::Tangential}, {"average", ContourLink::Average}},
                "How contours are joined: each link to the nearest point, or both the same way.");
  schema.integer("contour.seed", settings.seed, {0, 2147483647},
                 "Seed of the places where contours are cut.");
}

}  // namespace lamina
