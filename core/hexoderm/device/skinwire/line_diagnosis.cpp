#include "hexoderm/device/skinwire/line_diagnosis.h"

#include "hexoderm/base/spelling_suggestion.h"
#include "hexoderm/base/text.h"
#include "hexoderm/device/protocol_violation_log.h"

#include <google/protobuf/descriptor.h>

#include <skinwire.pb.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

namespace hexoderm::skinwire {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using Json = nlohmann::json;

constexpr std::size_t kMaxOfAValue = 40;

hexoderm::Message valueText(const Json& value) {
  if (value.is_array()) return message("an array of {}", value.size());
  if (value.is_object()) return message("an object");
  return hexoderm::Message::verbatim(
      excerptOf(value.dump(-1, ' ', true, Json::error_handler_t::replace), kMaxOfAValue));
}

const FieldDescriptor* findField(const Descriptor& type, const std::string& key) {
  const FieldDescriptor* field = type.FindFieldByName(key);
  return field != nullptr ? field : type.FindFieldByCamelcaseName(key);
}

std::vector<std::string> fieldNames(const Descriptor& type) {
  std::vector<std::string> names;
  for (int k = 0; k < type.field_count(); ++k) names.push_back(type.field(k)->name());
  return names;
}

/// The number in a text, as the JSON of protobuf allows it.
std::optional<double> numberIn(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

class LineInspector {
 public:
  void inspectLine(const Json& line) {
    const Descriptor& type = *v1::Line::descriptor();
    if (!line.is_object()) {
      return add(ProtocolViolationKind::NotAMessage,
                 message("expected an object with one member, which names the message ({}), found {}", messageNames(),
                         valueText(line)));
    }
    std::size_t messages = 0;
    for (const auto& [key, value] : line.items()) messages += isMessage(type, key) && !value.is_null() ? 1 : 0;
    if (messages > 1)
      add(ProtocolViolationKind::NotAMessage, message("expected one message in a line, found {}", messages));
    for (const auto& [key, value] : line.items()) {
      if (const FieldDescriptor* field = findField(type, key)) {
        inspectField(*field, value, key);
      } else {
        addUnknownMessage(key);
      }
    }
    if (messages == 0 && log_.offences().empty()) {
      add(ProtocolViolationKind::UnknownMessage,
          message("expected a member that names the message ({}), found none", messageNames()));
    }
  }

  [[nodiscard]] std::vector<ProtocolViolation> offences() const { return log_.offences(); }

 private:
  static bool isMessage(const Descriptor& line, const std::string& key) {
    const FieldDescriptor* field = findField(line, key);
    return field != nullptr && field->message_type() != nullptr;
  }

  static std::vector<std::string> messageNames() {
    std::vector<std::string> names = fieldNames(*v1::Line::descriptor());
    std::erase(names, "major");
    return names;
  }

  void add(ProtocolViolationKind kind, hexoderm::Message reason) { log_.add({kind, std::move(reason)}); }
  void add(ProtocolViolationKind kind, const std::string& place, hexoderm::Message what) {
    add(kind, located(place, std::move(what)));
  }

  void addUnknownMessage(const std::string& key) {
    const std::vector<std::string> names = messageNames();
    const std::string found = excerptOf(key, kMaxOfAValue);
    const std::optional<std::string> meant = spellingSuggestion(key, names);
    add(ProtocolViolationKind::UnknownMessage,
        meant ? message("there is no message \"{}\"; did you mean \"{}\"?", found, *meant)
              : message("there is no message \"{}\"; expected one of {}", found, names));
  }

  void inspectMessage(const Descriptor& type, const Json& value, const std::string& place) {
    if (!value.is_object()) {
      return add(ProtocolViolationKind::WrongType, place, message("expected an object, found {}", valueText(value)));
    }
    for (const auto& [key, item] : value.items()) {
      const FieldDescriptor* field = findField(type, key);
      if (field != nullptr) {
        inspectField(*field, item, place + "." + key);
        continue;
      }
      const std::vector<std::string> names = fieldNames(type);
      const std::optional<std::string> meant = spellingSuggestion(key, names);
      add(ProtocolViolationKind::UnknownField, place + "." + excerptOf(key, kMaxOfAValue),
          meant ? message("there is no such field; did you mean {}?", *meant)
                : message("there is no such field; there are {}", names));
    }
  }

  void inspectField(const FieldDescriptor& field, const Json& value, const std::string& place) {
    if (value.is_null()) return;  // absent
    if (!field.is_repeated()) return inspectValue(field, value, place);
    if (!value.is_array()) {
      return add(ProtocolViolationKind::WrongType, place, message("expected an array, found {}", valueText(value)));
    }
    for (std::size_t k = 0; k < value.size(); ++k) inspectValue(field, value[k], place + "[" + std::to_string(k) + "]");
  }

  void inspectValue(const FieldDescriptor& field, const Json& value, const std::string& place) {
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_MESSAGE:
        return inspectMessage(*field.message_type(), value, place);
      case FieldDescriptor::CPPTYPE_BOOL:
        if (!value.is_boolean()) {
          add(ProtocolViolationKind::WrongType, place, message("expected true or false, found {}", valueText(value)));
        }
        return;
      case FieldDescriptor::CPPTYPE_STRING:
        if (!value.is_string()) {
          add(ProtocolViolationKind::WrongType, place,
              field.name() == "cell_model" && value.is_object()
                  ? message("expected a text, found an object; a cell model goes as the text of its JSON")
                  : message("expected a text, found {}", valueText(value)));
        }
        return;
      case FieldDescriptor::CPPTYPE_INT32:
        return inspectWhole(value, place, std::numeric_limits<std::int32_t>::min(),
                            std::numeric_limits<std::int32_t>::max());
      case FieldDescriptor::CPPTYPE_UINT32:
        return inspectWhole(value, place, 0, std::numeric_limits<std::uint32_t>::max());
      case FieldDescriptor::CPPTYPE_UINT64:
        return inspectWhole(value, place, 0, std::numeric_limits<std::int64_t>::max());
      default:
        inspectNumber(value, place);
    }
  }

  void inspectWhole(const Json& value, const std::string& place, std::int64_t least, std::int64_t most) {
    const std::optional<double> number = inspectNumber(value, place);
    if (!number) return;
    const bool is_within = *number >= static_cast<double>(least) && *number <= static_cast<double>(most);
    if (is_within && std::floor(*number) == *number) return;
    add(ProtocolViolationKind::WrongValue, place,
        message("expected a whole number from {} to {}, found {}", least, most, valueText(value)));
  }

  /// The number; nullopt if there is none, which is then an offence.
  std::optional<double> inspectNumber(const Json& value, const std::string& place) {
    if (value.is_number()) return value.get<double>();
    if (value.is_string()) {
      if (const std::optional<double> number = numberIn(value.get_ref<const std::string&>())) return number;
    }
    add(ProtocolViolationKind::WrongType, place, message("expected a number, found {}", valueText(value)));
    return std::nullopt;
  }

  ProtocolViolationLog log_;
};

bool isWordCharacter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// "NaN", "nan", "Infinity" or "inf" around a place where JSON stopped; else empty.
std::string notFiniteWordAt(std::string_view line, std::size_t at) {
  std::size_t begin = std::min(at, line.size());
  while (begin > 0 && isWordCharacter(line[begin - 1])) --begin;
  std::size_t end = std::min(at, line.size());
  while (end < line.size() && isWordCharacter(line[end])) ++end;
  const std::string word(line.substr(begin, end - begin));
  for (const std::string_view known : {"NaN", "nan", "Infinity", "inf", "Inf"}) {
    if (word == known) return word;
  }
  return {};
}

ProtocolViolation notJson(std::string_view line, std::size_t byte) {
  if (lacksLineFeeds(line)) {
    return {ProtocolViolationKind::NoLineFeed, message("expected a line feed (0x0A) after every message")};
  }
  const std::size_t at = byte == 0 ? 0 : byte - 1;
  if (const std::string word = notFiniteWordAt(line, at); !word.empty()) {
    return {
        ProtocolViolationKind::WrongValue,
        message("character {}: expected finite numbers, found {}; leave out a cell that has no reading", at + 1, word)};
  }
  if (at >= line.size() && line.find_first_of("{[") != std::string_view::npos) {
    return {ProtocolViolationKind::NotJson,
            message("the line ends in the middle of its JSON; expected a whole message in one line")};
  }
  return {ProtocolViolationKind::NotJson,
          message("character {} is not JSON any more; expected a line like {}", at + 1,
                  R"({"samples": {"time_us": 10000, "cells": [1], "acceleration_g": [0, 0, 1]}})")};
}

}  // namespace

bool lacksLineFeeds(std::string_view text) {
  constexpr std::string_view kFillings("\r \t;,\0", 6);
  for (std::size_t end = text.find('}'); end != std::string_view::npos; end = text.find('}', end + 1)) {
    const std::size_t next = text.find_first_not_of(kFillings, end + 1);
    if (next == std::string_view::npos || text.substr(next, 2) != "{\"") continue;
    for (const std::string_view name : {"hello", "topology", "samples", "status"}) {
      if (text.substr(next + 2).starts_with(name)) return true;
    }
  }
  return false;
}

std::vector<ProtocolViolation> offencesOfLine(std::string_view line) {
  try {
    LineInspector inspector;
    inspector.inspectLine(Json::parse(line));
    return inspector.offences();
  } catch (const Json::parse_error& error) {
    return {notJson(line, error.byte)};
  } catch (const Json::exception&) {
    return {{ProtocolViolationKind::WrongValue, message("expected finite numbers, found one that is too large")}};
  }
}

}  // namespace hexoderm::skinwire
