#pragma once

#include "hexoderm/base/json_reader.h"
#include "hexoderm/base/json_writer.h"
#include "hexoderm/base/message.h"

#include <string>

namespace hexoderm {

/// {"template": "Cell {} reads {}", "arguments": [5, {"value": 44.0, "decimals": 0, "unit": "mg"}]}. A count is a whole
/// number, a verbatim text a string, a list an array, and a message within the message an object like this one.
nlohmann::ordered_json toJson(const Message& message);

/// Puts the English of a message under `key`, and beside it, unless that is all there is to it, the message itself
/// under `key` with "_message" behind it.
void writeMessage(JsonWriter& writer, const std::string& key, const Message& message);

/// The reverse. The English counts: if it is alone, or is not what the message says because somebody edited it, it is
/// taken verbatim. Throws FormatError where a message is not what toJson() writes.
Message readMessage(const JsonReader& json, const std::string& key);

/// A message as a member of an object (json_fields.h), with the second key beside it. One that is not required is
/// absent where it says nothing.
template <class Said>
struct MessageField {
  std::string key;
  Said& message;
  bool is_required = true;

  void takeFrom(const JsonReader& json) {
    if (is_required || json.find(key)) message = readMessage(json, key);
  }
  void write(JsonWriter& out) const {
    if (is_required || !message.empty()) writeMessage(out, key, message);
  }
};
template <class Said>
MessageField<Said> requiredMessage(const std::string& key, Said& message) {
  return {key, message};
}
template <class Said>
MessageField<Said> optionalMessage(const std::string& key, Said& message) {
  return {key, message, false};
}

}  // namespace hexoderm
