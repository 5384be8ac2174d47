// Any text as a *.session.json: a sound session, which is the same again when written and read, or an Error; the same
// session by the quick reader, or none.

#include "hexoderm/io/session_json.h"
#include "hexoderm/io/session_json_read.h"
#include "hexoderm/util/error.h"

#include "tests/fuzz/fuzz_checks.h"

#include <optional>

namespace {

using namespace hexoderm;

constexpr const char* kFile = "fuzz.session.json";

std::optional<Session> parsed(std::string_view text) {
  try {
    return sessionFromDocument(text, kFile);
  } catch (const Error& error) {
    fuzz::requireSayable(error);
    return std::nullopt;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::optional<Session> session = parsed(fuzz::asText({data, size}));
  const std::optional<Session> scanned = scanSessionJson(fuzz::asText({data, size}), kFile);
  fuzz::require(!scanned || session, "the quick reader to take nothing that the thorough one refuses");
  if (!session) return 0;
  fuzz::require(!scanned || sessionToJson(*scanned) == sessionToJson(*session), "the same session by both readers");
  fuzz::requireSound(*session);
  const std::string text = sessionToJson(*session);
  fuzz::require(sessionToJson(parseSessionJson(text, "again.session.json")) == text,
                "what was written to be the same when read and written again");
  return 0;
}
