// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <optional>
#include <string>
#include <variant>

namespace lamina {

/// What an expression of xacro may be.
using XacroValue = std::variant<double, std::string, YAML::Node>;

/// As it stands in XML: numbers by as many digits as bring them back.
std::string textOf(const XacroValue& value);

/// A number if the text is one as a whole, else the text.
XacroValue valueOfText(const std::string& text);

bool isTrue(const XacroValue& value);

/// What the names in an expression stand for.
struct XacroScope {
  std::function<std::optional<XacroValue>(const std::string& name)> property;
  std::function<YAML::Node(const std::string& path)> load;  ///< of load_yaml
};

/// The value of what stands between `${` and `}`.
/// @throws InvalidConfig if it is not understood
XacroValue evaluated(const std::string& expression, const XacroScope& scope);

}  // namespace lamina
