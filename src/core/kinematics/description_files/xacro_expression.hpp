// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <optional>
#include <string>
#include <variant>

namespace lamina {

/// Value of a xacro expression: a number, a text, or a tree from YAML.
using XacroValue = std::variant<double, std::string, YAML::Node>;

/// The value as text in XML; numbers have as many digits as reading back the same number needs.
std::string textOf(const XacroValue& value);

/// A number if the whole text is one, otherwise the text.
XacroValue valueOfText(const std::string& text);

bool isTrue(const XacroValue& value);

/// Values of the names that an expression may use.
struct XacroScope {
  std::function<std::optional<XacroValue>(const std::string& name)> property;
  std::function<YAML::Node(const std::string& path)> load;  ///< loads the file of a load_yaml
};

/// The value of an expression, given as the text between `${` and `}`.
/// @throws InvalidConfig if it cannot be parsed or evaluated
XacroValue evaluated(const std::string& expression, const XacroScope& scope);

}  // namespace lamina
