// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Function that appends the text of one layer.
using AppendLayer = std::function<void(std::size_t layer, std::string& text)>;

/// Passes the layers' texts to the sink in order. They are written by all threads, in bounded memory.
void writeLayers(const Toolpath& toolpath, const AppendLayer& append, const TextSink& sink);

}  // namespace lamina
