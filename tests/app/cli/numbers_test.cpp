// Every option of numbers says which it takes, and refuses all others before any work. The options are those of the
// help.

#include "tests/app/cli/cli_program.h"
#include "tests/app/cli/listed_options.h"

namespace hexoderm {
namespace {

class CliNumbers : public Cli {
 protected:
  [[nodiscard]] std::vector<std::string> commands() const { return test::commandsIn(run("--help").out); }
};

TEST_F(CliNumbers, ThatNoOptionTakesAreRefusedWithItsNameAndItsRange) {
  std::size_t tried = 0;
  for (const std::string& command : commands()) {
    for (const test::ListedOption& option : test::optionsIn(run(command + " --help").out)) {
      if (option.type != "FLOAT" && option.type != "UINT" && option.type != "INT") continue;
      const std::string kind = option.type == "FLOAT" ? "a number" : "a whole number";
      const std::string others = option.name == "--up" ? " 0 1" : "";  // of a direction
      for (const std::string value : {"nan", "inf", "-inf", "1e300", "-1e300", "1e400", "''", "many"}) {
        ++tried;
        const std::string found = value == "''" ? "" : value;
        EXPECT_THAT(complaint(command + " " + option.name + " " + value + others, 2),
                    AllOf(HasSubstr(option.name + ": expected " + kind), HasSubstr("found \"" + found + "\""),
                          ContainsRegex("(from|above) -?[0-9.]+ (to|and at most) [0-9.]+")))
            << command;
      }
    }
  }
  EXPECT_GE(tried, 20U * 8U);
}

TEST_F(CliNumbers, OutsideTheRangeAreRefused) {
  for (const auto& [arguments, says] : {
           std::pair<std::string, std::string>{"capture --timeout 0",
                                               "--timeout: expected a number above 0 and at most 1000000, found \"0\""},
           {"simulate --offset-sigma -1", "--offset-sigma: expected a number from 0 to 100000, found \"-1\""},
           {"simulate --poses 1001", "--poses: expected a whole number from 0 to 1000, found \"1001\""},
           {"simulate --poses 2.5", "--poses: expected a whole number from 0 to 1000, found \"2.5\""},
           {"place --gap -0.1", "--gap: expected a number from 0 to 100000, found \"-0.1\""},
           {"place --surface-sigma 0", "--surface-sigma: expected a number from 0.001 to 100000, found \"0\""},
           {"place --normal-sigma 361", "--normal-sigma: expected a number from 0.001 to 360, found \"361\""},
           {"solve -j 0", "--jobs: expected a whole number from 1 to 1024, found \"0\""},
           {"solve --without -1", "--without: expected a whole number from 0 to 4294967295, found \"-1\""},
           {"simulate --seed -1", "--seed: expected a whole number from 0 to 18446744073709551615, found \"-1\""},
           {"simulate --seed 18446744073709551616", "--seed: expected a whole number from 0 to 18446744073709551615"},
           {"links --up 1,0,2e6", "--up: expected a number from -1000000 to 1000000, found \"2e6\""},
       }) {
    EXPECT_THAT(complaint(arguments, 2), HasSubstr(says));
  }
}

TEST_F(CliNumbers, AtTheEndsOfTheRangeAreTaken) {
  EXPECT_EQ(
      run("simulate --poses 2 --samples 1 --offset-sigma 0 --seed 18446744073709551615 -o a.session.json").exit_code,
      0);
  EXPECT_EQ(run("solve a.session.json -j 1024 --class-threshold 1000 -o a.calibration.json").exit_code, 0);
  for (const std::string ends : {"--gap 100000 --surface-sigma 100000 --normal-sigma 360",
                                 "--gap 0 --surface-sigma 0.001 --normal-sigma 0.001"}) {
    // Where the patch is turned any way, a search with such figures takes minutes.
    EXPECT_NE(run("place a.calibration.json --robot demo --link forearm --rotation 0,0,0 " + ends).exit_code, 2)
        << ends;
  }
}

TEST_F(CliNumbers, WithinATextAreRefusedToo) {
  ASSERT_EQ(run("simulate --poses 3 -o a.session.json").exit_code, 0);
  ASSERT_EQ(run("solve a.session.json -o a.calibration.json").exit_code, 0);
  const std::string place = "place a.calibration.json --robot demo --link forearm ";
  for (const auto& [arguments, option, range] : {
           std::tuple<std::string, std::string, std::string>{
               "export a.calibration.json --to urdf -o a.urdf --place l:VALUE,0,0,0,0,0", "--place", "1000000"},
           {"export a.calibration.json --to urdf -o a.urdf --place l:0,0,0,0,VALUE,0", "--place", "1000000"},
           {"simulate --robot demo -o b.session.json --mount forearm:0,VALUE,0", "--mount", "1000000"},
           {"simulate --robot demo -o b.session.json --mount forearm:0,0,0,VALUE,0,0", "--mount", "1000000"},
           {place + "--rotation 0,VALUE,0", "--rotation", "360"},
           {place + "--rotation 0,0,0:VALUE", "--rotation", "360"},
           {place + "--point 1:0,VALUE,0", "--point", "100"},
           {place + "--point 1:0,0,0:VALUE", "--point", "100"},
           {place + "--distance 1:2:VALUE", "--distance", "100"},
           {place + "--distance 1:2:1:VALUE", "--distance", "100"},
       }) {
    for (const std::string value : {"nan", "inf", "1e300", "-1e300", ""}) {
      std::string line = arguments;
      line.replace(line.find("VALUE"), 5, value);
      EXPECT_THAT(complaint(line, 2), AllOf(HasSubstr(option + ":"), HasSubstr("expected a number from "),
                                            HasSubstr(" to " + range + ", found \"" + value + "\"")))
          << line;
    }
  }
  EXPECT_FALSE(exists("a.urdf"));
  EXPECT_FALSE(exists("b.session.json"));
}

}  // namespace
}  // namespace hexoderm
