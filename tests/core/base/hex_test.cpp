#include "hexoderm/base/sha256.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

TEST(Hex, TwoDigitsAByteTheHighOneFirst) {
  const std::array<std::uint8_t, 4> bytes = {0x00, 0x1e, 0xa7, 0xff};
  EXPECT_EQ(hexDigits(bytes), "001ea7ff");
  EXPECT_EQ(hexDigits({}), "");
}

}  // namespace
}  // namespace hexoderm
