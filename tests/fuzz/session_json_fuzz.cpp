// Any text as a *.session.json: a sound session, which is the same again when written and read, or an Error.

#include "hexoderm/io/session_json.h"

#include "tests/fuzz/fuzz_checks.h"

#include <optional>

using namespace hexoderm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const char* const file = "fuzz.session.json";
  std::optional<Session> session;
  fuzz::takeOrComplain([&] { session = parseSessionJson(fuzz::asText({data, size}), file); });
  if (!session) return 0;
  fuzz::requireSound(*session);
  const std::string text = sessionToJson(*session);
  fuzz::require(sessionToJson(parseSessionJson(text, "again.session.json")) == text,
                "what was written to be the same when read and written again");
  return 0;
}
