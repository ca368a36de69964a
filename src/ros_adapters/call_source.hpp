// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Key in a service's connection header by which a caller states its name, as "page: anna", for services
/// whose requests have no field for it. Without this key the caller is named by its node.
inline constexpr char kSourceOfCall[] = "lamina_source";

}  // namespace lamina
