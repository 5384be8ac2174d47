#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace hexoderm::fuzz {

/// An input with one to three changes of the kinds that people and attackers make of documents: keys and elements that
/// are there twice, deep nesting, numbers out of every range, control characters and bytes that are no text, words of
/// any length, pieces that are missing, or swapped with others. Half of the kinds keep the length, so that frames and
/// lengths around the change stay right.
std::string mutated(std::string text, std::mt19937_64& random);

}  // namespace hexoderm::fuzz
