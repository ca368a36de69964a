// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/fractional_factorial.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// A product of signs of variables: bit i for variable i.
struct Word {
  std::uint32_t variables = 0;
  bool is_negative = false;
};

constexpr std::size_t kMostVariables = 26;
constexpr std::size_t kMostBaseVariables = 19;
constexpr std::size_t kMostGenerators = 16;

int lengthOf(const Word& word) {
  int length = 0;
  for (std::uint32_t rest = word.variables; rest != 0; rest &= rest - 1) ++length;
  return length;
}

std::string textOf(const Word& word) {
  std::string text = word.is_negative ? "-" : "";
  for (std::size_t i = 0; i < kMostVariables; ++i)
    if (word.variables >> i & 1U) text += static_cast<char>('a' + i);
  return text;
}

InvalidConfig generatorFault(const std::string& generator, const std::string& what) {
  return InvalidConfig("generator '" + generator + "': " + what);
}

std::uint32_t bitOf(char letter, std::size_t count, const std::string& generator) {
  if (letter < 'a' || letter >= static_cast<char>('a' + count))
    throw generatorFault(generator, std::string("'") + letter + "' is no variable; expected a to " +
                                        static_cast<char>('a' + count - 1));
  return 1U << (letter - 'a');
}

std::vector<std::string> generatorsIn(const std::string& text) {
  std::vector<std::string> generators;
  bool is_open = false;
  for (const char character : text) {
    const bool separates = character == ',' || character == ' ';
    if (!separates && !is_open) generators.emplace_back();
    if (!separates) generators.back() += character;
    is_open = !separates;
  }
  return generators;
}

/// What each generated variable is the product of.
std::map<std::size_t, Word> generatedBy(const std::string& text, std::size_t count) {
  std::map<std::size_t, Word> generated;
  std::uint32_t generated_bits = 0;
  for (const std::string& generator : generatorsIn(text)) {
    if (generator.size() < 3 || generator[1] != '=')
      throw generatorFault(generator, "expected a letter, '=' and letters, as in d=abc");
    const std::uint32_t bit = bitOf(generator[0], count, generator);
    Word word;
    word.is_negative = generator[2] == '-';
    for (const char letter : generator.substr(word.is_negative ? 3 : 2)) {
      const std::uint32_t factor = bitOf(letter, count, generator);
      if (word.variables & factor)
        throw generatorFault(generator, std::string("'") + letter + "' stands twice");
      word.variables |= factor;
    }
    if (generated_bits & bit)
      throw generatorFault(generator, std::string("variable ") + generator[0] + " has a generator already");
    generated_bits |= bit;
    generated[static_cast<std::size_t>(generator[0] - 'a')] = word;
  }
  for (const auto& [variable, word] : generated)
    if (word.variables & generated_bits)
      throw generatorFault(std::string(1, static_cast<char>('a' + variable)) + "=" + textOf(word),
                           "refers to a variable that has a generator itself");
  return generated;
}

/// All products of the generators: words that are the same sign in every point.
std::vector<Word> definingRelation(const std::map<std::size_t, Word>& generated) {
  std::vector<Word> relation;
  for (const auto& [variable, word] : generated) {
    const Word defining = {word.variables | 1U << variable, word.is_negative};
    const std::size_t count = relation.size();
    relation.push_back(defining);
    for (std::size_t i = 0; i < count; ++i)
      relation.push_back(
          {relation[i].variables ^ defining.variables, relation[i].is_negative != defining.is_negative});
  }
  std::sort(relation.begin(), relation.end(), [](const Word& a, const Word& b) {
    return lengthOf(a) != lengthOf(b) ? lengthOf(a) < lengthOf(b) : textOf(a) < textOf(b);
  });
  return relation;
}

void requireTwoLevels(const Variable& variable) {
  const std::size_t count = variable.kind == VariableKind::Levels        ? variable.levels.size()
                            : variable.kind == VariableKind::Categorical ? variable.choices.size()
                                                                         : 2;
  if (count != 2)
    throw InvalidConfig("variable " + variable.name + " has " + std::to_string(count) +
                        " levels; a fractional factorial design needs 2 of each variable: take a full one");
}

bool isHigh(std::uint32_t signs, const Word& word) {
  const int lows = lengthOf({word.variables & ~signs, false});
  return (lows % 2 == 0) != word.is_negative;
}

}  // namespace

FractionalFactorial fractionalFactorial(const DesignSpace& space, const std::string& generators) {
  if (space.size() > kMostVariables)
    throw InvalidConfig("fractional factorial design of " + std::to_string(space.size()) +
                        " variables; expected at most " + std::to_string(kMostVariables));
  for (const Variable& variable : space) requireTwoLevels(variable);
  const std::map<std::size_t, Word> generated = generatedBy(generators, space.size());
  const std::size_t base_count = space.size() - generated.size();
  if (base_count > kMostBaseVariables || generated.size() > kMostGenerators)
    throw InvalidConfig("fractional factorial design: " + std::to_string(base_count) +
                        " variables without and " + std::to_string(generated.size()) +
                        " with a generator; expected at most " + std::to_string(kMostBaseVariables) +
                        " and " + std::to_string(kMostGenerators));
  FractionalFactorial design;
  for (const Word& word : definingRelation(generated)) design.defining_words.push_back(textOf(word));
  for (const Word& word : definingRelation(generated)) {
    if (lengthOf(word) < 3)
      throw InvalidConfig("generators '" + generators + "': " + textOf(word) +
                          " is the same in every point; its variables could not be distinguished");
    if (design.resolution == 0) design.resolution = lengthOf(word);
  }
  for (std::uint32_t run = 0; run < 1U << base_count; ++run) {
    std::uint32_t signs = 0;
    std::size_t base = 0;
    for (std::size_t i = 0; i < space.size(); ++i)
      if (generated.count(i) == 0) signs |= (run >> (base_count - 1 - base++) & 1U) << i;
    DesignPoint point;
    for (std::size_t i = 0; i < space.size(); ++i) {
      const auto found = generated.find(i);
      const bool is_high = found == generated.end() ? (signs >> i & 1U) != 0 : isHigh(signs, found->second);
      point.push_back(is_high ? highOf(space[i]) : lowOf(space[i]));
    }
    design.points.push_back(std::move(point));
  }
  return design;
}

}  // namespace lamina
