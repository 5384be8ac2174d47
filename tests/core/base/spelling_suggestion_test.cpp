#include "hexoderm/base/spelling_suggestion.h"

#include "hexoderm/base/text.h"
#include "tests/support/testing.h"

namespace hexoderm {
namespace {

const std::vector<std::string> kFields = {"sequence", "time_us",           "period_us",    "cells",
                                          "raw_lsb",  "acceleration_g",    "mean_g",       "variance_g2",
                                          "count",    "temperature_cells", "temperature_c"};

TEST(SpellingSuggestion, FindsWhatWasMeant) {
  for (const auto& [meant, names] :
       {std::pair("acceleration_g", "acelleration_g acceleration accel"),
        std::pair("time_us", "TIME_US time timestamp time_ms"), std::pair("cells", "cell clels"),
        std::pair("sequence", "seqence"), std::pair("variance_g2", "variance"), std::pair("raw_lsb", "rawLsb")}) {
    for (const std::string& name : split(names, ' ')) EXPECT_EQ(spellingSuggestion(name, kFields), meant) << name;
  }
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
