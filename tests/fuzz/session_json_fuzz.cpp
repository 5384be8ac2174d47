// Any text as a *.session.json: a sound session, which is the same again when written and read, or an Error; the same
// session by the quick reader, or none.

#include "hexoderm/io/session_json.h"
#include "hexoderm/io/session_json_read.h"

#include "tests/fuzz/fuzz_checks.h"

#include <optional>

using namespace hexoderm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const char* const file = "fuzz.session.json";
  std::optional<Session> session;
  fuzz::takeOrComplain([&] { session = sessionFromDocument(fuzz::asText({data, size}), file); });
  const std::optional<Session> scanned = scanSessionJson(fuzz::asText({data, size}), file);
  fuzz::require(!scanned || session, "the quick reader to take nothing that the thorough one refuses");
  if (!session) return 0;
  fuzz::require(!scanned || sessionToJson(*scanned) == sessionToJson(*session), "the same session by both readers");
  fuzz::requireSound(*session);
  const std::string text = sessionToJson(*session);
  fuzz::require(sessionToJson(parseSessionJson(text, "again.session.json")) == text,
                "what was written to be the same when read and written again");
  return 0;
}
