// Any text as a *.session.json: a sound session, which is the same again when written and read, or an Error.

#include "hexoderm/io/session_json.h"
#include "hexoderm/util/error.h"

#include "tests/fuzz/fuzz_checks.h"

#include <optional>

namespace {

using namespace hexoderm;

std::optional<Session> parsed(std::string_view text) {
  try {
    return parseSessionJson(text, "fuzz.session.json");
  } catch (const Error& error) {
    fuzz::requireSayable(error);
    return std::nullopt;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::optional<Session> session = parsed(fuzz::asText({data, size}));
  if (!session) return 0;
  fuzz::requireSound(*session);
  const std::string text = sessionToJson(*session);
  fuzz::require(sessionToJson(parseSessionJson(text, "again.session.json")) == text,
                "what was written to be the same when read and written again");
  return 0;
}
