#include "tests/fuzz/mutations.h"

#include "hexoderm/base/text.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hexoderm::fuzz {
namespace {

using Random = std::mt19937_64;

std::size_t below(std::size_t limit, Random& random) {
  return limit == 0 ? 0 : static_cast<std::size_t>(random() % limit);
}

template <class Choices>
const auto& oneOf(const Choices& choices, Random& random) {
  return choices[below(std::size(choices), random)];
}

constexpr std::array<std::string_view, 8> kControls = {"\x1b[2J", "\x07",     "\r",           "\n",
                                                       "\x7f",    "\xc2\x9b", "\xe2\x80\xae", "\xff"};
const std::vector<std::string> kNumbers =
    split("-1,0,-0,15,1e400,-1e400,1e308,5e-324,1e-12,1e1000,NaN,4294967296,99999999999999999999,0x7fffffff", ',');

/// Begin and length of a random number in the text; of length 0 if there is none.
std::pair<std::size_t, std::size_t> someNumber(std::string_view text, Random& random) {
  constexpr std::string_view kDigits = "0123456789";
  const std::size_t from = text.find_first_of(kDigits, below(text.size(), random));
  if (from == std::string_view::npos) return {0, 0};
  const std::size_t to = text.find_first_not_of("0123456789.eE+-", from);
  return {from, std::min(to, text.size()) - from};
}

/// Begin and length of a random `"key": value` or element, as far as the next comma or bracket.
std::pair<std::size_t, std::size_t> someMember(std::string_view text, Random& random) {
  const std::size_t from = text.find_first_of("\"<", below(text.size(), random));
  if (from == std::string_view::npos) return {0, 0};
  const std::size_t to = text.find_first_of(",}]>", from);
  return {from, std::min(to, text.size()) - from};
}

void repeatMember(std::string& text, Random& random) {
  const auto [from, size] = someMember(text, random);
  const bool is_element = size > 0 && text[from] == '<';
  text.insert(from, text.substr(from, size) + (is_element ? ">" : ", "));
}

void nestDeeply(std::string& text, Random& random) {
  constexpr std::array<std::string_view, 4> kOpening = {"[", "{\"a\":", "<a>", "[{\"arguments\":["};
  constexpr std::array<std::size_t, 3> kLevels = {9, 101, 3000};
  std::string nested;
  const std::string_view opening = oneOf(kOpening, random);
  for (std::size_t level = oneOf(kLevels, random); level > 0; --level) nested += opening;
  const auto [from, size] = someNumber(text, random);
  text.insert(from, nested);
}

void replaceNumber(std::string& text, Random& random) {
  const auto [from, size] = someNumber(text, random);
  text.replace(from, size, oneOf(kNumbers, random));
}

/// The same length, filled with zeros in front or digits.
void replaceNumberInPlace(std::string& text, Random& random) {
  const auto [from, size] = someNumber(text, random);
  if (size == 0) return;
  std::string number(size, '9');
  if (size > 2 && below(2, random) == 0) number[1] = 'e';
  if (below(3, random) == 0) number[0] = '-';
  text.replace(from, size, number);
}

void insertControl(std::string& text, Random& random) {
  text.insert(below(text.size() + 1, random), oneOf(kControls, random));
}

/// JSON takes control characters as escapes only.
void insertEscapedControl(std::string& text, Random& random) {
  constexpr std::array<std::string_view, 4> kEscapes = {"\\u001b[31m", "\\u0000", "\\n", "\\u009b"};
  const std::size_t quote = text.find('"', below(text.size(), random));
  if (quote != std::string::npos) text.insert(quote + 1, oneOf(kEscapes, random));
}

void overwriteWithControl(std::string& text, Random& random) {
  const std::string_view control = oneOf(kControls, random);
  const std::size_t at = below(text.size(), random);
  text.replace(at, std::min(control.size(), text.size() - at), control.substr(0, text.size() - at));
}

void insertLongWord(std::string& text, Random& random) {
  text.insert(below(text.size() + 1, random), std::string(5000, 'w'));
}

void removePiece(std::string& text, Random& random) { text.erase(below(text.size(), random), 1 + below(40, random)); }

void cutOff(std::string& text, Random& random) { text.resize(below(text.size(), random)); }

void changeByte(std::string& text, Random& random) {
  if (!text.empty()) text[below(text.size(), random)] = static_cast<char>(random() & 0xFFU);
}

void swapMembers(std::string& text, Random& random) {
  auto [a, a_size] = someMember(text, random);
  auto [b, b_size] = someMember(text, random);
  if (a > b) {
    std::swap(a, b);
    std::swap(a_size, b_size);
  }
  if (a + a_size > b) return;
  const std::string first = text.substr(a, a_size);
  const std::string second = text.substr(b, b_size);
  text.replace(b, b_size, first);
  text.replace(a, a_size, second);
}

}  // namespace

std::string mutated(std::string text, Random& random) {
  constexpr std::array kKinds = {
      repeatMember,         nestDeeply,           replaceNumber,        replaceNumberInPlace, insertControl,
      insertEscapedControl, overwriteWithControl, insertLongWord,       removePiece,          cutOff,
      changeByte,           replaceNumberInPlace, overwriteWithControl, changeByte,           swapMembers};
  for (std::size_t changes = 1 + below(3, random); changes > 0; --changes) oneOf(kKinds, random)(text, random);
  return text;
}

}  // namespace hexoderm::fuzz
