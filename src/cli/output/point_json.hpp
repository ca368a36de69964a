// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "lamina/geometry/vector.hpp"

namespace lamina::cli {

/// Its three coordinates, in a list.
inline nlohmann::ordered_json pointToJson(const Point3& point) { return {point.x(), point.y(), point.z()}; }

}  // namespace lamina::cli
