#include "hexoderm/base/sha256.h"

#include "tests/support/testing.h"

namespace hexoderm {
namespace {

TEST(Sha256, AgreesWithTheStandardsExamples) {
  EXPECT_EQ(sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, PiecesCountAsOne) {
  Sha256 sha;
  sha.add("a", 1);
  sha.add("", 0);
  sha.add("bc", 2);
  EXPECT_EQ(hexDigits(sha.finish()), sha256Hex("abc"));
}

}  // namespace
}  // namespace hexoderm
