#include "hexoderm/base/spelling_suggestion.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

const std::vector<std::string> kFields = {"sequence", "time_us",           "period_us",    "cells",
                                          "raw_lsb",  "acceleration_g",    "mean_g",       "variance_g2",
                                          "count",    "temperature_cells", "temperature_c"};

TEST(SpellingSuggestion, FindsWhatWasMeant) {
  const std::vector<std::pair<std::string, std::string>> cases = {{"acelleration_g", "acceleration_g"},
                                                                  {"acceleration", "acceleration_g"},
                                                                  {"accel", "acceleration_g"},
                                                                  {"TIME_US", "time_us"},
                                                                  {"time", "time_us"},
                                                                  {"timestamp", "time_us"},
                                                                  {"time_ms", "time_us"},
                                                                  {"cell", "cells"},
                                                                  {"clels", "cells"},
                                                                  {"seqence", "sequence"},
                                                                  {"variance", "variance_g2"},
                                                                  {"rawLsb", "raw_lsb"}};
  for (const auto& [name, meant] : cases) EXPECT_EQ(spellingSuggestion(name, kFields), meant) << name;
}

TEST(SpellingSuggestion, FindsNothingWhereNothingIsNear) {
  for (const char* name : {"", "x", "foo", "led", "gyro", "\x1b[31m", "humidity"}) {
    EXPECT_EQ(spellingSuggestion(name, kFields), std::nullopt) << name;
  }
  EXPECT_EQ(spellingSuggestion("anything", {}), std::nullopt);
  EXPECT_EQ(spellingSuggestion(std::string(1'000'000, 'q'), kFields), std::nullopt);
}

}  // namespace
}  // namespace hexoderm
