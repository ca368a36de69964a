// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description_files/xacro_expression.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr int kDeepest = 50;  // of parentheses

XacroValue valueOfNode(const YAML::Node& node) {
  if (!node.IsScalar()) return node;
  const std::string& text = node.Scalar();
  if (node.Tag() == "!degrees" || node.Tag() == "!radians") {
    const double number = std::strtod(text.c_str(), nullptr);
    return node.Tag() == "!degrees" ? toRadians(number) : number;
  }
  return valueOfText(text);
}

/// Reads an expression from left to right.
class Expression {
 public:
  Expression(const std::string& text, const XacroScope& scope) : text_(text), scope_(scope) {}

  XacroValue whole() {
    XacroValue value = comparison();
    skipBlanks();
    if (at_ != text_.size()) refuse("is followed by what is not understood");
    return value;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InvalidConfig("expression ${...}, at character " + std::to_string(at_ + 1) + ", " + what);
  }

  void skipBlanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }

  bool take(const std::string& token) {
    skipBlanks();
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }

  double number(const XacroValue& value) const {
    if (const auto* found = std::get_if<double>(&value)) return *found;
    refuse("needs a number here");
  }

  XacroValue comparison() {
    if (++depth_ > kDeepest) refuse("is too deep");
    XacroValue left = sum();
    for (const char* sign : {"==", "!="})
      if (take(sign)) {
        const bool is_same = textOf(left) == textOf(sum());
        left = is_same == (sign[0] == '=') ? 1.0 : 0.0;
      }
    --depth_;
    return left;
  }

  XacroValue sum() {
    XacroValue left = product();
    for (;;) {
      if (take("+")) {
        const XacroValue right = product();
        const bool are_numbers = left.index() == 0 && right.index() == 0;
        left = are_numbers ? XacroValue(std::get<double>(left) + std::get<double>(right))
                           : XacroValue(textOf(left) + textOf(right));
      } else if (take("-")) {
        left = number(left) - number(product());
      } else {
        return left;
      }
    }
  }

  XacroValue product() {
    XacroValue left = sign();
    for (;;) {
      if (take("*"))
        left = number(left) * number(sign());
      else if (take("/"))
        left = number(left) / number(sign());
      else
        return left;
    }
  }

  XacroValue sign() {
    if (take("-")) return -number(sign());
    if (take("+")) return sign();
    // Made anew for each key: a node of a YAML file that is assigned changes the file's.
    std::optional<XacroValue> value(atom());
    while (take("[")) {
      const auto* node = std::get_if<YAML::Node>(&*value);
      const XacroValue key = comparison();
      if (!take("]")) refuse("needs ] here");
      if (node == nullptr || !node->IsMap()) refuse("takes an entry of what has none");
      const YAML::Node entry = YAML::Node(*node)[textOf(key)];
      if (!entry) refuse("takes an entry that is not there");
      value.emplace(valueOfNode(entry));
    }
    return *value;
  }

  XacroValue atom() {
    skipBlanks();
    if (at_ == text_.size()) refuse("ends too early");
    const char letter = text_[at_];
    if (letter == '\'' || letter == '"') {
      const std::size_t end = text_.find(letter, at_ + 1);
      if (end == std::string::npos) refuse("has a text without end");
      const std::string quoted = text_.substr(at_ + 1, end - at_ - 1);
      at_ = end + 1;
      return quoted;
    }
    if (take("(")) {
      XacroValue inner = comparison();
      if (!take(")")) refuse("needs ) here");
      return inner;
    }
    if (std::isdigit(static_cast<unsigned char>(letter)) != 0 || letter == '.') {
      char* end = nullptr;
      const double value = std::strtod(text_.c_str() + at_, &end);
      at_ = static_cast<std::size_t>(end - text_.c_str());
      return value;
    }
    return named();
  }

  XacroValue named() {
    const std::size_t begin = at_;
    const auto belongs = [](char letter) {
      return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '.' ||
             letter == ':';
    };
    while (at_ < text_.size() && belongs(text_[at_])) ++at_;
    std::string name = text_.substr(begin, at_ - begin);
    if (name.empty()) refuse("has a sign that is not understood");
    if (name == "not") return isTrue(sum()) ? 0.0 : 1.0;
    for (const char* prefix : {"math.", "xacro."})
      if (name.rfind(prefix, 0) == 0) name = name.substr(std::string(prefix).size());
    if (take("(")) {
      const XacroValue argument = comparison();
      if (!take(")")) refuse("needs ) here");
      return called(name, argument);
    }
    if (const auto property = scope_.property(name)) return *property;
    if (name == "pi") return M_PI;
    if (name == "True" || name == "true") return 1.0;
    if (name == "False" || name == "false") return 0.0;
    refuse("names a property that is not there");
  }

  XacroValue called(const std::string& function, const XacroValue& argument) const {
    if (function == "load_yaml") return scope_.load(textOf(argument));
    if (function == "radians") return toRadians(number(argument));
    if (function == "degrees") return toDegrees(number(argument));
    if (function == "sin") return std::sin(number(argument));
    if (function == "cos") return std::cos(number(argument));
    if (function == "sqrt") return std::sqrt(number(argument));
    if (function == "abs") return std::abs(number(argument));
    refuse("calls a function that is not understood");
  }

  const std::string& text_;
  const XacroScope& scope_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string textOf(const XacroValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (std::holds_alternative<YAML::Node>(value))
    throw InvalidConfig("a map of a YAML file stands for a text");
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.17g", std::get<double>(value));
  return digits.data();
}

XacroValue valueOfText(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const bool is_number = !text.empty() && *end == '\0' && std::isfinite(number);
  return is_number ? XacroValue(number) : XacroValue(text);
}

bool isTrue(const XacroValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number != 0.0;
  const auto* text = std::get_if<std::string>(&value);
  return text == nullptr || !(text->empty() || *text == "false" || *text == "False");
}

XacroValue evaluated(const std::string& expression, const XacroScope& scope) {
  return Expression(expression, scope).whole();
}

}  // namespace lamina
