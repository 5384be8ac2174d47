#pragma once

#include "hexoderm/base/ids.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace hexoderm {

/// A number with a fixed count of decimals; without one, the shortest text that reads back as the same double.
struct Number {
  static constexpr int kExact = -1;  ///< as many decimals as tell the double
  double value = 0;
  int decimals = kExact;
};
/// An angle, said in degrees: "0.4°".
struct Degrees {
  double angle_rad = 0;
  int decimals = 1;
};
/// A length, said in millimetres: "1.2 mm".
struct Millimetres {
  double length_m = 0;
  int decimals = 1;
};
/// An acceleration, said in thousandths of gravity: "44 mg".
struct MilliG {
  double acceleration_g = 0;
  int decimals = 0;
};
/// A time: "0.50 s".
struct Seconds {
  double time_s = 0;
  int decimals = 1;
};

/// The unit in which people read a figure.
enum class Unit { None, Degrees, Millimetres, MilliG, Seconds };

/// The text that follows a figure, its blank included: " mm", "°".
std::string_view unitSuffix(Unit unit);

/// A figure in the unit in which people read it.
struct Quantity {
  double value = 0;
  int decimals = Number::kExact;
  Unit unit = Unit::None;
  friend bool operator==(const Quantity&, const Quantity&) = default;
};

struct MessageArgument;

/// Something to say to a person, as a value: an English template and the arguments of its placeholders ({}, in the
/// syntax of libfmt). Files and the command line show `english()`; the window looks the template up in its translations
/// and writes the arguments as the locale has it. Messages are made by message() below, which is also what the
/// translation tools look for. Compared by template and arguments.
class Message {
 public:
  /// Says nothing; `english()` is empty.
  Message() = default;
  /// `english` must be a template with as many placeholders as arguments, see isTemplate().
  Message(std::string english, std::vector<MessageArgument> arguments);
  /// A text that is never translated: a name, or the words of a library or an operator.
  static Message verbatim(std::string text);

  /// The template, with its placeholders.
  [[nodiscard]] const std::string& englishTemplate() const { return template_; }
  /// One for each placeholder.
  [[nodiscard]] const std::vector<MessageArgument>& arguments() const { return arguments_; }
  [[nodiscard]] bool empty() const { return template_.empty(); }  ///< it says nothing
  [[nodiscard]] bool isVerbatim() const;                          ///< it is never translated
  /// The template with its arguments, numbers with a decimal point. Throws std::logic_error if they don't match.
  [[nodiscard]] std::string english() const;

  friend bool operator==(const Message& a, const Message& b);                  ///< the same template and arguments
  friend std::ostream& operator<<(std::ostream& out, const Message& message);  ///< writes english()

 private:
  std::string template_;
  std::vector<MessageArgument> arguments_;
};

/// One argument: an ID or a count, a figure, a verbatim text, a list ("1, 2 and 3"), or a message of its own.
struct MessageArgument {
  using List = std::vector<MessageArgument>;  ///< items of a list

  /// A count.
  template <std::integral Count>
  requires(!std::same_as<Count, bool> && !std::same_as<Count, char>) MessageArgument(Count count)
      : value(static_cast<std::int64_t>(count)) {}
  /// An ID.
  template <class Tag>
  MessageArgument(StrongId<Tag> id) : value(static_cast<std::int64_t>(id.value())) {}
  MessageArgument(Quantity quantity) : value(quantity) {}               ///< a figure
  MessageArgument(Number number);                                       ///< a number
  MessageArgument(Degrees angle);                                       ///< an angle
  MessageArgument(Millimetres length);                                  ///< a length
  MessageArgument(MilliG acceleration);                                 ///< an acceleration
  MessageArgument(Seconds time);                                        ///< a time
  MessageArgument(std::string text) : value(std::move(text)) {}         ///< a text as it is
  MessageArgument(std::string_view text) : value(std::string(text)) {}  ///< a text as it is
  MessageArgument(const char* text) : value(std::string(text)) {}       ///< a text as it is
  MessageArgument(Message message) : value(std::move(message)) {}       ///< a message within the message
  MessageArgument(List items) : value(std::move(items)) {}              ///< a list
  /// A list.
  template <class Item>
  requires(!std::same_as<Item, MessageArgument>) MessageArgument(const std::vector<Item>& items)
      : value(List(items.begin(), items.end())) {}

  [[nodiscard]] std::string english() const;  ///< the argument as it stands in a message
  /// The same argument.
  friend bool operator==(const MessageArgument& a, const MessageArgument& b) { return a.value == b.value; }

  std::variant<std::int64_t, Quantity, std::string, List, Message> value;
};

/// Whether a text has only placeholders {} in order, or only {0}, {1}, ... by number, of which `arguments` are given.
/// Braces that stand for themselves are doubled.
constexpr bool isTemplate(std::string_view text, std::size_t arguments) {
  std::size_t in_order = 0;
  bool by_number = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '{' && text[k] != '}') continue;
    if (k + 1 < text.size() && text[k + 1] == text[k]) {
      ++k;
      continue;
    }
    if (text[k] == '}') return false;
    std::size_t number = 0;
    std::size_t digits = 0;
    for (++k; k < text.size() && text[k] >= '0' && text[k] <= '9' && digits < 4; ++k, ++digits) {
      number = 10 * number + static_cast<std::size_t>(text[k] - '0');
    }
    if (k >= text.size() || text[k] != '}') return false;
    if (digits == 0) {
      ++in_order;
    } else {
      by_number = true;
      if (number >= arguments) return false;
    }
  }
  return by_number ? in_order == 0 : in_order == arguments;
}

/// The template filled with texts. Throws std::logic_error unless isTemplate().
std::string fillTemplate(const std::string& text, std::span<const std::string> arguments);

/// A literal template; one whose placeholders are not as many as the arguments does not compile.
template <class... Arguments>
struct LiteralTemplate {
  /// A literal with as many placeholders as arguments, which the compiler checks.
  consteval LiteralTemplate(const char* english_text) : english(english_text) {  // NOLINT(*-explicit-*)
    if (!isTemplate(english_text, sizeof...(Arguments))) throw "each argument needs one placeholder";
  }
  const char* english;
};

/// message("Cell {} reads {}", cell, MilliG{a}). The template stands here as a literal, because the translations are
/// collected from the sources by this call.
template <class... Arguments>
Message message(std::type_identity_t<LiteralTemplate<Arguments...>> english, Arguments&&... arguments) {
  std::vector<MessageArgument> values;
  values.reserve(sizeof...(Arguments));
  (values.emplace_back(std::forward<Arguments>(arguments)), ...);
  return {english.english, std::move(values)};
}

/// Messages in a row, separated: sentences by a blank, for example. Those that say nothing are left out.
Message inRow(std::vector<Message> messages, std::string_view separator = " ");

/// "cell 7", "cells 7, 9", "12 cells": few are named, many are counted.
Message cellsText(const std::vector<CellId>& cells);

/// "PLACE: what is wrong there", of a file, a key, an address.
Message located(MessageArgument place, Message what);

/// "cell 5, port 2".
Message inWords(const LinkEnd& end);

}  // namespace hexoderm
