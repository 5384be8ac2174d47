#include "hexoderm/base/message_json.h"

#include "hexoderm/base/enum_names.h"

#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

// Messages within messages and lists within lists: core makes four levels of them.
constexpr int kDeepest = 8;
constexpr std::uint32_t kMaxDecimals = 17;
/// Behind the key of the English.
constexpr const char* kMessageKey = "_message";

constexpr EnumNames<Unit> kUnits = {{"none", "deg", "mm", "mg", "s"}};

nlohmann::ordered_json jsonOf(std::int64_t count) { return count; }
nlohmann::ordered_json jsonOf(const std::string& text) { return text; }
nlohmann::ordered_json jsonOf(const Message& message) { return toJson(message); }
nlohmann::ordered_json jsonOf(const Quantity& quantity) {
  // JSON has no infinity.
  if (!std::isfinite(quantity.value)) return MessageArgument(quantity).english();
  nlohmann::ordered_json json = {{"value", quantity.value}};
  if (quantity.decimals >= 0) json["decimals"] = quantity.decimals;
  if (quantity.unit != Unit::None) json["unit"] = kUnits.of(quantity.unit);
  return json;
}
nlohmann::ordered_json jsonOf(const MessageArgument::List& items) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const MessageArgument& item : items) {
    json.push_back(std::visit([](const auto& held) { return jsonOf(held); }, item.value));
  }
  return json;
}

/// There is more to it than its English.
bool hasArguments(const Message& message) { return !message.empty() && !message.isVerbatim(); }

Message readWhole(const JsonReader& json, int depth);

Quantity readQuantity(const JsonReader& json) {
  Quantity quantity;
  quantity.value = json.at("value").number();
  if (const auto decimals = json.find("decimals")) {
    quantity.decimals = static_cast<int>(decimals->unsignedInteger(0, kMaxDecimals));
  }
  if (const auto unit = json.find("unit")) {
    const std::optional<Unit> known = kUnits.find(unit->string());
    if (!known || *known == Unit::None) unit->fail(message("\"deg\", \"mm\", \"mg\" or \"s\""));
    quantity.unit = *known;
  }
  return quantity;
}

MessageArgument readArgument(const JsonReader& json, int depth) {
  if (depth > kDeepest) json.fail(message("messages within messages to a depth of {}", kDeepest));
  if (json.isString()) return json.string();
  if (json.isObject()) {
    if (json.find("template")) return readWhole(json, depth);
    return readQuantity(json);
  }
  if (json.isArray()) {
    MessageArgument::List items;
    for (const JsonReader& item : json.items()) items.push_back(readArgument(item, depth + 1));
    return items;
  }
  return json.integer();
}

Message readWhole(const JsonReader& json, int depth) {
  std::vector<MessageArgument> arguments;
  for (const JsonReader& item : json.at("arguments").items()) arguments.push_back(readArgument(item, depth + 1));
  const JsonReader text = json.at("template");
  if (!isTemplate(text.string(), arguments.size())) {
    text.fail(message("a text with a {{}} for each of the {} arguments", arguments.size()));
  }
  return {text.string(), std::move(arguments)};
}

}  // namespace

nlohmann::ordered_json toJson(const Message& message) {
  return {{"template", message.englishTemplate()}, {"arguments", jsonOf(message.arguments())}};
}

void writeMessage(JsonWriter& writer, const std::string& key, const Message& message) {
  writer.member(key, message.english());
  if (hasArguments(message)) writer.member(key + kMessageKey, toJson(message));
}

Message readMessage(const JsonReader& json, const std::string& key) {
  const std::string english = json.at(key).string();
  if (const auto whole = json.find(key + kMessageKey)) {
    Message read = readWhole(*whole, 0);
    if (read.english() == english) return read;
  }
  return Message::verbatim(english);
}

}  // namespace hexoderm
