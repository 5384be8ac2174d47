// hexoderm-cli listen, and what capture says of devices that do something wrong, in the real programs.

#include "tests/app/cli/cli_program.h"
#include "tests/app/cli/wrong_devices.h"
#include "tests/app/emulator/emulator_program.h"

namespace hexoderm {
namespace {

using Json = nlohmann::json;

class CliListen : public Cli {
 protected:
  /// The bytes of a device on standard input.
  Outcome listen(const std::string& bytes, const std::string& options) const {
    writeFileAtomically(path("device"), bytes);
    return run("listen stdin --for 20 " + options, "cat device | ");
  }
};

const Json* findViolation(const Json& report, ProtocolViolationKind kind) {
  for (const Json& offence : report.at("offences")) {
    if (offence.at("kind") == offenceName(kind)) return &offence;
  }
  return nullptr;
}

bool isPrintable(const std::string& text) {
  return std::ranges::all_of(text, [](unsigned char c) { return c == '\n' || (c >= 0x20 && c != 0x7F); });
}

void expectNothingWrong(const Outcome& outcome) {
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const Json report = Json::parse(outcome.out);
  EXPECT_THAT(report.at("offences"), IsEmpty()) << outcome.out;
  EXPECT_EQ(report.at("ready"), true);
  EXPECT_EQ(report.at("obstacle"), "");
}

TEST_F(CliListen, ADeviceThatIsRightHasNoViolation) {
  const Outcome outcome = listen(Device::right().lines(), "--json");
  expectNothingWrong(outcome);
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report.at("device"), "three cells");
  EXPECT_EQ(report.at("links").at("agreed"), 2);
  EXPECT_EQ(report.at("links").at("one_sided"), 0);
  EXPECT_EQ(report.at("frames"), 300);
  EXPECT_EQ(report.at("lost_samples"), 0);
  EXPECT_NEAR(report.at("rate_hz").at("median").get<double>(), 100, 1e-6);
  EXPECT_NEAR(report.at("norm_g").at("median").get<double>(), 1, 0.01);
  EXPECT_NEAR(report.at("noise_mg").at("median").get<double>(), 4, 0.4);
  ASSERT_EQ(report.at("cells").size(), 3U);
  EXPECT_EQ(report.at("cells").at(1).at("readings"), 300);
}

TEST_F(CliListen, ADeviceIsRightInEveryDialectAndKindOfReading) {
  expectNothingWrong(listen(Device::right().frames(), "--json"));

  Device in_lsb = Device::right();
  in_lsb.eachSamples([](Json& s) {
    s["raw_lsb"] = Json::array();
    for (const Json& value : s["acceleration_g"]) s["raw_lsb"].push_back(std::lround(value.get<double>() * 256));
    s.erase("acceleration_g");
  });
  expectNothingWrong(listen(in_lsb.lines(), "--json"));

  Device of_means = Device::right();
  of_means.eachSamples([](Json& s) {
    s["mean_g"] = s["acceleration_g"];
    s["variance_g2"] = std::vector<double>(9, 1.6e-5);
    s["count"] = {10, 10, 10};
    s.erase("acceleration_g");
  });
  const Outcome outcome = listen(of_means.lines(), "--json");
  expectNothingWrong(outcome);
  EXPECT_NEAR(Json::parse(outcome.out).at("noise_mg").at("median").get<double>(), 4, 0.01);

  Device without_numbers = Device::right();
  without_numbers.hello.erase("rate_hz");
  without_numbers.eachSamples([](Json& s) { s.erase("sequence"); });
  expectNothingWrong(listen(without_numbers.lines(), "--json"));
}

TEST_F(CliListen, SendsCommandsAndSaysHowTheyAreAnswered) {
  const Emulator emulator({"--pty", "--patch", "ring8", "--rate", "100"});
  const std::string asked = " --light 5 --rate 50 --explore";
  const Outcome outcome = run("listen '" + emulator.address + "' --for 1 --json" + asked);
  const Json commands = Json::parse(outcome.out).at("commands");
  ASSERT_EQ(commands.size(), 3U) << outcome.out;
  EXPECT_EQ(commands.at(0).at("command"), "set_led of cell 5");
  for (const Json& command : commands) {
    EXPECT_EQ(command.at("done"), true) << command;
    EXPECT_GE(command.at("after_s"), 0) << command;
  }
  EXPECT_THAT(emulator.type("led 5"), HasSubstr("#ffffff"));
  EXPECT_THAT(run("listen '" + emulator.address + "' --for 1 --light 99").out,
              HasSubstr("Command set_led of cell 99: not done after "));
}

class EveryWrongDevice : public CliListen, public ::testing::WithParamInterface<std::size_t> {};

TEST_P(EveryWrongDevice, IsToldWhatIsWrong) {
  const WrongDevice& wrong = wrongDevices()[GetParam()];
  SCOPED_TRACE(wrong.name);
  Device device = Device::right();
  wrong.spoil(device);
  const Outcome outcome = listen(device.lines(), "--json");
  EXPECT_EQ(outcome.exit_code, wrong.is_ready ? 0 : 1) << outcome.out << outcome.err;
  const Json report = Json::parse(outcome.out);
  const Json* offence = findViolation(report, wrong.kind);
  ASSERT_NE(offence, nullptr) << outcome.out;
  EXPECT_THAT(offence->at("reason").get<std::string>(), HasSubstr(wrong.words));
  EXPECT_GE(offence->at("count").get<int>(), 1);
  EXPECT_LE(offence->at("message_begins").get<std::string>().size(), 83U);
  EXPECT_EQ(report.at("obstacle").get<std::string>().empty(), wrong.is_ready);
  // Said live on standard error, which is no terminal here, each kind once.
  const std::string said = "(" + std::string(offenceName(wrong.kind)) + "): ";
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(said), HasSubstr(wrong.words)));
  EXPECT_EQ(outcome.err.find(said), outcome.err.rfind(said)) << outcome.err;
  EXPECT_TRUE(isPrintable(outcome.err)) << outcome.err;
  EXPECT_TRUE(isPrintable(outcome.out)) << outcome.out;
}

INSTANTIATE_TEST_SUITE_P(All, EveryWrongDevice, ::testing::Range(std::size_t{0}, wrongDevices().size()));

TEST_F(CliListen, TheTableHasEveryKindOfViolation) {
  for (const ProtocolViolationKind kind : offenceKinds()) {
    EXPECT_TRUE(std::ranges::find(wrongDevices(), kind, &WrongDevice::kind) != wrongDevices().end())
        << offenceName(kind);
  }
}

TEST_F(CliListen, TheReportIsReadableAndCountsEveryViolation) {
  Device device = Device::right();
  device.scale(9.80665);
  device.eachSamples([](Json& s) { s["cells"][2] = 4; });
  const Outcome outcome = listen(device.lines(), "");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("three cells: 3 cells of model hex-bma150"), HasSubstr("Links: 2 that both"),
                    HasSubstr("Rate of a cell: 100.0 Hz"), HasSubstr("Norm of the readings: 9.8"),
                    HasSubstr("Noise of a cell: "), HasSubstr("Silent: cell 3"), HasSubstr("x (g)    y (g)    z (g)\n"),
                    HasSubstr("x, y and z are means along the axes of the cell.")));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("unknown-cell (300): samples.cells[2]: the topology has no cell 4"),
                                 HasSubstr("A calibration could not begin. samples.acceleration_g: "),
                                 HasSubstr("are these m/s2?")));
}

TEST_F(CliListen, ALostConnectionIsNoReportAndWrongUsageIsSaid) {
  EXPECT_EQ(run("listen nowhere").exit_code, 2);
  EXPECT_EQ(run("listen sim:x17 --for 0").exit_code, 2);
  // Nobody listens at port 1.
  EXPECT_THAT(errorOf("listen tcp://127.0.0.1:1 --for 0.5", 4), HasSubstr("tcp://127.0.0.1:1"));
  EXPECT_THAT(outputOf("listen stdin --for 5", 1, "true | "), HasSubstr("The device has not described itself."));
}

TEST_F(CliListen, ASimulatedSkinAsInTheHelpIsRightToo) {
  EXPECT_THAT(outputOf("listen --help"), AllOf(HasSubstr("Exit code 0"), HasSubstr("hexoderm-cli listen sim:x17")));
  expectNothingWrong(run("listen sim:x17 --for 1 --json"));
}

TEST_F(CliListen, CtrlCEndsItWithItsReport) {
  const Emulator emulator({"--tcp", "0", "--patch", "ring8"});
  const Outcome outcome = run("listen " + emulator.address + " --for 600 --json",
                              "interrupt() { \"$@\" & sleep 3; kill -s INT $!; wait $!; }; interrupt ");
  expectNothingWrong(outcome);
  EXPECT_GT(Json::parse(outcome.out).at("frames"), 0);
}

// ---- capture

TEST_F(CliListen, CaptureSaysTheFirstViolationOfEachKindAndCounts) {
  Device device = Device::right();
  device.scale(9.80665);
  writeFileAtomically(path("device"), device.lines());
  const Outcome outcome = run("capture --source stdin --json -o a.hexo", "cat device | ");
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("(acceleration-unit): "), HasSubstr("are these m/s2?")));
  const Json report = Json::parse(outcome.out);
  ASSERT_NE(findViolation(report, ProtocolViolationKind::AccelerationUnit), nullptr) << outcome.out;
}

TEST_F(CliListen, CaptureOfADeviceThatNeverDescribesItselfSaysWhy) {
  writeFileAtomically(path("device"), "12.5;0.1;0.2;0.9\n\x1b[31m\n");
  const Outcome outcome = run("capture --source stdin --json -o a.hexo", "cat device | ");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("(not-json): "), HasSubstr("the message begins: 12.5;0.1"),
                                 HasSubstr("ended before a skin described itself. character 5 is not JSON")));
  EXPECT_TRUE(isPrintable(outcome.err));
  const Json report = Json::parse(outcome.out);
  const Json* offence = findViolation(report, ProtocolViolationKind::NotJson);
  ASSERT_NE(offence, nullptr);
  EXPECT_EQ(offence->at("count"), 2);
}

}  // namespace
}  // namespace hexoderm
