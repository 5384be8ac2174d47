#include "hexoderm/device/open_source.h"

#include "hexoderm/util/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hexoderm {
namespace {

TEST(OpenSkinSource, KnowsEveryKindOfAddress) {
  for (const char* address : {"tcp://localhost:7700", "tcp://[::1]:7700", "udp://192.168.0.7:1", "serial:/dev/ttyUSB0",
                              "serial:/dev/ttyACM0?baud=921600", "stdin"}) {
    EXPECT_EQ(openSkinSource(address)->address(), address);
  }
  EXPECT_EQ(openSkinSource("replay:a.skinrec?speed=2")->address(), "replay:a.skinrec");
  EXPECT_EQ(openSkinSource("replay:what?.skinrec")->address(), "replay:what?.skinrec");
  EXPECT_NO_THROW(openSkinSource("replay:a?speed=max"));
  EXPECT_NO_THROW(openSkinSource("replay:a?speed=step"));
}

TEST(OpenSkinSource, SaysWhatItExpected) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "tcp://HOST:PORT, udp://HOST:PORT, serial:/dev/DEVICE"},
      {"http://localhost", "replay:FILE"},
      {"tcp://localhost", "tcp://HOST:PORT"},
      {"tcp://:7700", "tcp://HOST:PORT"},
      {"tcp://localhost:0", "from 1 to 65535"},
      {"tcp://localhost:65536", "from 1 to 65535"},
      {"tcp://localhost:77x", "from 1 to 65535"},
      {"tcp://::1:7700", "tcp://HOST:PORT"},
      {"tcp://a/b:7700", "tcp://HOST:PORT"},
      {"udp://localhost", "udp://HOST:PORT"},
      {"serial:ttyUSB0", "serial:/dev/DEVICE"},
      {"serial:/dev/ttyUSB0?speed=9600", "baud=N"},
      {"serial:/dev/ttyUSB0?baud=", "baud=N"},
      {"serial:/dev/ttyUSB0?baud=0", "baud=N"},
      {"stdin2", "expected stdin"},
      {"replay:", "replay:FILE"},
      {"replay:a?speed=0", "above 0"},
      {"replay:a?speed=fast", "above 0"},
  };
  for (const auto& [address, expected] : cases) {
    try {
      openSkinSource(address);
      ADD_FAILURE() << address << " was accepted";
    } catch (const InvalidArgument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(expected)) << address;
    }
  }
}

}  // namespace
}  // namespace hexoderm
