#pragma once

#include "hexoderm/util/json_reader.h"
#include "hexoderm/util/json_writer.h"
#include "hexoderm/util/message.h"

#include <string>

namespace hexoderm {

/// {"template": "Cell {} reads {}", "arguments": [5, {"value": 44.0, "decimals": 0, "unit": "mg"}]}. A count is a whole
/// number, a verbatim text a string, a list an array, and a message within the message an object like this one.
nlohmann::ordered_json toJson(const Message& message);

/// Puts the English of a message under `key`, and beside it, unless that is all there is to it, the message itself
/// under `key` with "_message" behind it.
void writeMessage(nlohmann::ordered_json& json, const std::string& key, const Message& message);
void writeMessage(JsonWriter& writer, const std::string& key, const Message& message);

/// The reverse. The English counts: if it is alone, or is not what the message says because somebody edited it, it is
/// taken verbatim. Throws FormatError where a message is not what toJson() writes.
Message readMessage(const JsonReader& json, const std::string& key);

}  // namespace hexoderm
