// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/web/operator_site.hpp"

namespace lamina {

/// The files of the operator's page.
std::vector<PageFile> pageFiles();

}  // namespace lamina
