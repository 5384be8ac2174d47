#include "hexoderm/base/message.h"

#include "hexoderm/base/enum_names.h"
#include "hexoderm/base/said_items.h"
#include "hexoderm/base/text.h"
#include "hexoderm/base/units.h"

#include <fmt/args.h>
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>

namespace hexoderm {
namespace {

constexpr std::string_view kVerbatim = "{}";

std::string englishOf(std::int64_t count) { return std::to_string(count); }
std::string englishOf(const std::string& text) { return text; }
std::string englishOf(const Message& message) { return message.english(); }
std::string englishOf(const Quantity& quantity) {
  std::string text =
      quantity.decimals < 0 ? formatExact(quantity.value) : formatFixed(quantity.value, quantity.decimals);
  return text.append(unitSuffix(quantity.unit));
}
std::string englishOf(const MessageArgument::List& items) {
  std::string text;
  const std::size_t said = saidOf(items.size());
  for (std::size_t k = 0; k < said; ++k) {
    if (k > 0) text += k + 1 == items.size() ? " and " : ", ";
    text += items[k].english();
  }
  if (said < items.size()) text += " and " + std::to_string(items.size() - said) + " others";
  return text;
}

}  // namespace

std::string_view unitSuffix(Unit unit) {
  constexpr auto kSuffixes = std::to_array<std::string_view>({"", "°", " mm", " mg", " s"});  // in the order of Unit
  static_assert(kSuffixes.size() == enumeratorCount<Unit>());
  return kSuffixes.at(static_cast<std::size_t>(unit));
}

Message::Message(std::string english, std::vector<MessageArgument> arguments)
    : template_(std::move(english)), arguments_(std::move(arguments)) {}

Message Message::verbatim(std::string text) {
  if (text.empty()) return {};
  return {std::string(kVerbatim), {MessageArgument(std::move(text))}};
}

bool Message::isVerbatim() const {
  return template_ == kVerbatim && arguments_.size() == 1 && std::holds_alternative<std::string>(arguments_[0].value);
}

std::string Message::english() const {
  std::vector<std::string> texts;
  texts.reserve(arguments_.size());
  std::ranges::transform(arguments_, std::back_inserter(texts), &MessageArgument::english);
  return fillTemplate(template_, texts);
}

bool operator==(const Message& a, const Message& b) {
  return a.template_ == b.template_ && a.arguments_ == b.arguments_;
}

std::ostream& operator<<(std::ostream& out, const Message& message) { return out << message.english(); }

MessageArgument::MessageArgument(Number number) : value(Quantity{number.value, number.decimals, Unit::None}) {}
MessageArgument::MessageArgument(Degrees angle)
    : value(Quantity{toDegrees(angle.angle_rad), angle.decimals, Unit::Degrees}) {}
MessageArgument::MessageArgument(Millimetres length)
    : value(Quantity{toMillimetres(length.length_m), length.decimals, Unit::Millimetres}) {}
MessageArgument::MessageArgument(MilliG acceleration)
    : value(Quantity{acceleration.acceleration_g * 1000, acceleration.decimals, Unit::MilliG}) {}
MessageArgument::MessageArgument(Seconds time) : value(Quantity{time.time_s, time.decimals, Unit::Seconds}) {}

std::string MessageArgument::english() const {
  return std::visit([](const auto& held) { return englishOf(held); }, value);
}

std::string fillTemplate(const std::string& text, std::span<const std::string> arguments) {
  if (!isTemplate(text, arguments.size())) {
    throw std::logic_error("the template \"" + text + "\" does not take " + std::to_string(arguments.size()) +
                           " arguments");
  }
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const std::string& argument : arguments) store.push_back(std::cref(argument));
  return fmt::vformat(text, store);
}

Message inRow(std::vector<Message> messages, std::string_view separator) {
  std::erase_if(messages, &Message::empty);
  if (messages.size() == 1) return std::move(messages.front());
  std::string places;
  std::vector<MessageArgument> arguments;
  for (Message& part : messages) {
    if (!places.empty()) places += separator;
    places += "{}";
    arguments.emplace_back(std::move(part));
  }
  return {std::move(places), std::move(arguments)};
}

Message cellsText(const std::vector<CellId>& cells) {
  constexpr std::size_t kNamed = 6;
  if (cells.size() == 1) return message("cell {}", cells.front());
  if (cells.size() <= kNamed) return message("cells {}", cells);
  return message("{} cells", cells.size());
}

Message located(MessageArgument place, Message what) { return {"{}: {}", {std::move(place), std::move(what)}}; }

Message inWords(const LinkEnd& end) { return message("cell {}, port {}", end.cell, end.port); }

}  // namespace hexoderm
