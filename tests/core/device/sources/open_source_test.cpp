#include "hexoderm/device/sources/open_source.h"

#include "tests/support/testing.h"

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
      {"serial:/dev/ttyUSB0?baud=0", "expected one of the baud rates 1200, 2400, "},
      {"serial:/dev/ttyUSB0?baud=1234", "expected one of the baud rates 1200, 2400, "},
      {"stdin2", "expected stdin"},
      {"replay:", "replay:FILE"},
      {"replay:a?speed=0", "above 0"},
      {"replay:a?speed=fast", "above 0"},
      {"sim:", "is not known; expected x17"},
      {"sim:ring2", "3 to 100000"},
      {"sim:sheet:10", "sheet:ROWSxCOLS"},
      {"sim:sheet:1000x1000", "at most 100000 cells"},
      {"sim:x17?surface=cube:r=1", "cube"},
      {"sim:x17?speed=0", "above 0"},
      {"sim:x17?seed=-1", "seed"},
      {"sim:x17?sped=2", "sim:PATCH"},
      {"sim:robot?sped=2", "sim:robot[?urdf=FILE"},
      {"sim:robot?speed=0", "above 0"},
      {"sim:robot?seed=-1", "seed"},
      {"sim:robot?base=table", "fixed, motors or hand"},
      {"sim:robot?patch=blob", "is not known; expected x17"},
      {"sim:robot?surface=cube:r=1", "cube"},
      {"sim:robot?mount=forearm", "LINK:X,Y,Z"},
      {"sim:robot?mount=forearm:0,0,x", "mount forearm:0,0,x"},
      {"sim:robot?package=x", "NAME=FOLDER"},
      {"sim:robot?urdf=arm.urdf", "a mount for each patch"},
  };
  for (const auto& [address, expected] : cases) {
    const std::string opening = messageOf<InvalidArgument>([&, text = address] { openSkinSource(text); });
    EXPECT_THAT(opening, testing::HasSubstr(expected)) << address;
    EXPECT_EQ(messageOf<InvalidArgument>([&, text = address] { checkSkinAddress(text); }), opening) << address;
  }
}

TEST(OpenSkinSource, TellsFilesFromAddresses) {
  EXPECT_THROW(openSkinSource("sim:robot?urdf=none.urdf&mount=a:0,0,0"), StorageError);
  EXPECT_NO_THROW(checkSkinAddress("sim:robot?urdf=none.urdf&mount=a:0,0,0")) << "opens nothing";
  EXPECT_THROW(openSkinSource("sim:robot?mount=fore_arm:0,0,0"), InvalidArgument);
}

TEST(CheckSkinAddress, TakesWhatCanBeOpenedAndBuildsNoSkinForIt) {
  for (const char* address :
       {"tcp://localhost:7700", "serial:/dev/ttyACM0?baud=921600", "stdin", "replay:a?speed=max", "sim:x17",
        "sim:ring8:closed", "sim:x17?surface=cylinder:r=0.05&seed=2&speed=max", "sim:robot",
        "sim:robot?mount=hand:0,0.02,0.05,0,0,1.57&mount=forearm:0,0,0&base=motors&speed=max"}) {
    EXPECT_NO_THROW(checkSkinAddress(address)) << address;
  }
  // Building one of these takes about a second, a thousand of them would take the test's time and more.
  for (int k = 0; k < 1000; ++k) checkSkinAddress("sim:sheet:316x316");
}

}  // namespace
}  // namespace hexoderm
