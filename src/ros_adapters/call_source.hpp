// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// The entry of a service's connection header that names who asks, "page: anna", for services whose requests
/// have no place for it. Without one the calling node is named.
inline constexpr char kSourceOfCall[] = "lamina_source";

}  // namespace lamina
