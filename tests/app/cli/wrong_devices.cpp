#include "tests/app/cli/wrong_devices.h"

#include "hexoderm/device/skinwire/framing.h"
#include "hexoderm/skin/cell_model.h"

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <random>
#include <regex>
#include <stdexcept>

namespace hexoderm {
namespace {

using Json = Device::Json;
using Kind = ProtocolViolationKind;

constexpr int kMessages = 300;
constexpr int kStep_us = 10'000;
constexpr double kNoise_g = 0.004;

/// The built-in model's JSON text with one text replaced.
std::string modelWith(const std::string& from, const std::string& to) {
  std::string text = cellModelToJson(builtInCellModel("hex-bma150"));
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the built-in model has no " + from);
  return text.replace(at, from.size(), to);
}

std::string substituted(const std::string& text, const std::string& from, const std::string& to) {
  return std::regex_replace(text, std::regex(from), to);
}

void rename(Json& object, const std::string& from, const std::string& to) {
  object[to] = object.at(from);
  object.erase(from);
}

std::function<void(Device&)> eachSamples(std::function<void(Json&)> change) {
  return [change = std::move(change)](Device& device) { device.eachSamples(change); };
}

std::function<void(Device&)> eachTime(std::function<Json(std::uint64_t)> change) {
  return eachSamples([change = std::move(change)](Json& samples) {
    samples["time_us"] = change(samples["time_us"].get<std::uint64_t>());
  });
}

std::function<void(Device&)> asSent(std::function<std::string(std::string)> as_sent) {
  return [as_sent = std::move(as_sent)](Device& device) { device.as_sent = as_sent; };
}

/// Bytes in place of lines, spoilt.
std::function<void(Device&)> asBytes(std::function<std::string(std::string)> spoil) {
  return [spoil = std::move(spoil)](Device& device) {
    device.as_sent = [frames = device.frames(), spoil](const std::string&) { return spoil(frames); };
  };
}

/// {"type": "samples", "time_us": ...}, as many protocols have it.
void withTypes(Device& device) {
  for (Json line : device.samples) {
    line["type"] = "samples";
    device.more.push_back(line);
  }
  device.samples.clear();
}

Json& cell(Device& device, std::size_t k) { return device.topology["cells"][k]; }

/// The first frame, of which the last four bytes are another checksum.
std::string withZipCrc(std::string frames) {
  const std::size_t length = static_cast<std::uint8_t>(frames[0]) + 256U * static_cast<std::uint8_t>(frames[1]);
  std::string body = frames.substr(4, length);
  boost::crc_32_type crc;
  crc.process_bytes(body.data(), length - 4);
  for (std::size_t k = 0; k < 4; ++k) body[length - 4 + k] = static_cast<char>(crc.checksum() >> (8 * k));
  return frames.substr(0, 4) + body;
}

std::string withBigEndianLength(std::string frames) {
  std::reverse(frames.begin(), frames.begin() + 4);
  return frames;
}

std::string inUtf16(const std::string& text) {
  std::string wide = "\xFF\xFE";
  for (const char c : text) wide += {c, '\0'};
  return wide;
}

}  // namespace

Device Device::right() {
  Device device;
  device.hello = {{"device", "three cells"}, {"cell_model", "hex-bma150"}, {"rate_hz", 100}};
  const auto port = [](int number, int cell, int cell_port) {
    return Json{{"port", number}, {"cell", cell}, {"cell_port", cell_port}};
  };
  device.topology = {{"id", 1},
                     {"cells", Json::array({{{"id", 1}, {"ports", Json::array({port(1, 2, 3)})}},
                                            {{"id", 2}, {"ports", Json::array({port(3, 1, 1), port(1, 3, 3)})}},
                                            {{"id", 3}, {"ports", Json::array({port(3, 2, 1)})}}})}};
  std::mt19937 random(1);  // the same noise in every run
  const auto noise_g = [&random] {
    return kNoise_g * std::sqrt(12.0) * (static_cast<double>(random()) / 4294967296.0 - 0.5);
  };
  for (int k = 0; k < kMessages; ++k) {
    Json readings = Json::array();
    for (int c = 0; c < 3; ++c) {
      for (const double value_g : {0.6, 0.0, 0.8}) readings.push_back(value_g + noise_g());
    }
    device.samples.push_back({{"sequence", 3 * k},
                              {"time_us", 5'000'000 + kStep_us * k},
                              {"cells", {1, 2, 3}},
                              {"acceleration_g", readings}});
  }
  return device;
}

void Device::eachSamples(const std::function<void(Json&)>& change) { std::ranges::for_each(samples, change); }

void Device::scale(double factor) {
  eachSamples([factor](Json& message) {
    for (Json& value : message["acceleration_g"]) value = value.get<double>() * factor;
  });
}

std::string Device::lines() const {
  std::string text;
  const auto add = [&text](const Json& line) { text += line.dump() + "\n"; };
  if (!hello.is_null()) add({{"hello", hello}});
  if (!topology.is_null()) add({{"topology", topology}});
  for (const Json& message : samples) add({{"samples", message}});
  for (const Json& line : more) add(line);
  return as_sent ? as_sent(text) : text;
}

std::string Device::frames() const {
  std::string bytes;
  const std::string text = lines();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const skinwire::Decoded decoded = skinwire::decodeLine(text.substr(begin, end - begin));
    const skinwire::Bytes frame = skinwire::encodeFrame(skinwire::Framing::Length, decoded.message);
    bytes.append(frame.begin(), frame.end());
    begin = end + 1;
  }
  return bytes;
}

const std::vector<WrongDevice>& wrongDevices() {
  // clang-format off
  static const std::vector<WrongDevice> devices = {
      // what came is no message
      {"not JSON", asSent([](auto) { return "12.5;0.1;0.2;0.9\n12.6;0.1;0.2;0.9\n"; }), Kind::NotJson, "character 5 is not JSON any more"},
      {"text of Python", asSent([](auto t) { return substituted(substituted(t, "\"", "'"), "100\\}", "100, 'can_turn': True}"); }), Kind::NotJson, "character 2 is not JSON any more"},
      {"JSON in several lines", asSent([](auto t) { return substituted(t, "\\{", "{\n"); }), Kind::NotJson, "ends in the middle of its JSON"},
      {"lines in a list", asSent([](auto t) { return "[" + substituted(t.substr(0, t.size() - 1), "\n", ",") + "]\n"; }), Kind::NotAMessage, "found an array of 302"},
      {"carriage returns", asSent([](auto t) { return substituted(t, "\n", "\r"); }), Kind::NoLineFeed, "expected a line feed (0x0A)"},
      {"UTF-16", asSent([](auto t) { return inUtf16(t); }), Kind::WrongDialect, "text in UTF-16"},
      {"terminal's codes", asSent([](auto) { return "\x1b]0;boot\x07\x1b[31mready\n"; }), Kind::NotJson, "character 1 is not JSON any more"},
      {"another CRC", asBytes(withZipCrc), Kind::BrokenFrame, "the CRC is CRC-32, expected CRC-32C"},
      {"a big-endian length", asBytes(withBigEndianLength), Kind::BrokenFrame, "is big-endian, expected little-endian"},
      {"a body without its length", asBytes([](auto b) { return b.substr(4); }), Kind::WrongDialect, "neither a line of JSON nor a frame"},
      {"a misspelt message", asSent([](auto t) { return substituted(t, "\"samples\"", "\"sample\""); }), Kind::UnknownMessage, "did you mean \"samples\"?"},
      {"a type beside the fields", withTypes, Kind::UnknownMessage, "there is no message \"acceleration_g\"; expected one of hello, topology"},
      {"two messages in a line", asSent([](auto t) { return substituted(t, "\\}\\}\n\\{\"topology\"", "},\"topology\""); }), Kind::NotAMessage, "expected one message in a line, found 2"},
      {"another major version", [](Device& d) { d.more.push_back(Json::object({{"major", 2}})); d.samples.clear(); }, Kind::OtherVersion, "speaks SkinWire 2"},
      // fields
      {"misspelt readings", eachSamples([](Json& s) { rename(s, "acceleration_g", "acelleration_g"); }), Kind::UnknownField, "samples.acelleration_g: there is no such field; did you mean acceleration_g?"},
      {"misspelt readings, missing", eachSamples([](Json& s) { rename(s, "acceleration_g", "accel"); }), Kind::WrongLength, "expected exactly one of raw_lsb, acceleration_g and mean_g"},
      {"misspelt time", eachSamples([](Json& s) { rename(s, "time_us", "timestamp"); }), Kind::UnknownField, "did you mean time_us?"},
      {"misspelt cell model", [](Device& d) { rename(d.hello, "cell_model", "model"); }, Kind::UnknownField, "hello.model: there is no such field; did you mean cell_model?"},
      {"misspelt port", [](Device& d) { rename(cell(d, 0)["ports"][0], "cell_port", "cellport"); }, Kind::UnknownField, "topology.cells[0].ports[0].cellport: there is no such field; did you mean cell_port?", true},
      {"texts with units", eachSamples([](Json& s) { s["acceleration_g"][1] = "0.1 g"; }), Kind::WrongType, "samples.acceleration_g[1]: expected a number, found \"0.1 g\""},
      {"axes by name", eachSamples([](Json& s) { s["acceleration_g"] = Json::array({{{"x", 0}, {"y", 0}, {"z", 1}}}); }), Kind::WrongType, "samples.acceleration_g[0]: expected a number, found an object"},
      {"readings in an object", eachSamples([](Json& s) { s["acceleration_g"] = {{"1", {0, 0, 1}}}; }), Kind::WrongType, "samples.acceleration_g: expected an array, found an object"},
      {"a cell model that is no text", [](Device& d) { d.hello["cell_model"] = Json::parse(modelWith("", "")); }, Kind::WrongType, "a cell model goes as the text of its JSON"},
      {"negative cells", eachSamples([](Json& s) { s["cells"][2] = -1; }), Kind::WrongValue, "samples.cells[2]: expected a whole number from 0 to 4294967295, found -1"},
      {"NaN", asSent([](auto t) { return substituted(t, "\\[0\\.[0-9]+,", "[NaN,"); }), Kind::WrongValue, "expected finite numbers, found NaN"},
      {"seconds as fractions", eachTime([](auto us) { return static_cast<double>(us) * 1e-6 + 1e-9; }), Kind::WrongValue, "samples.time_us: expected a whole number"},
      {"several ticks without a period", eachSamples([](Json& s) { s["cells"] = {1}; }), Kind::WrongValue, "samples.period_us: expected at least 1"},
      {"a reading short", eachSamples([](Json& s) { s["acceleration_g"].erase(8); }), Kind::WrongLength, "samples.acceleration_g: expected a multiple of 3 numbers for each of 3 cells, found 8"},
      {"two kinds of readings", eachSamples([](Json& s) { s["raw_lsb"] = {0, 0, 256, 0, 0, 256, 0, 0, 256}; }), Kind::WrongLength, "expected exactly one"},
      {"readings without cells", eachSamples([](Json& s) { s.erase("cells"); }), Kind::WrongLength, "samples.cells: expected the IDs"},
      {"means without variances", eachSamples([](Json& s) { rename(s, "acceleration_g", "mean_g"); }), Kind::WrongLength, "samples.variance_g2: expected 9 numbers, found 0"},
      // the description
      {"no hello", [](Device& d) { d.hello = nullptr; }, Kind::NotDescribed, "no hello came"},
      {"no topology", [](Device& d) { d.topology = nullptr; }, Kind::NotDescribed, "no whole topology came"},
      {"half of a topology", [](Device& d) { d.topology["parts"] = 2; }, Kind::NotDescribed, "no whole topology came"},
      {"a part too many", [](Device& d) { d.topology["part"] = 1; }, Kind::WrongValue, "topology.part: expected less than parts (1), found 1"},
      {"an unknown cell model", [](Device& d) { d.hello["cell_model"] = "hex-bma\x1b[31m"; }, Kind::CellModel, "hello.cell_model: there is no built-in cell model"},
      {"a cell model with a misspelt key", [](Device& d) { d.hello["cell_model"] = modelWith("\"lsb_g\"", "\"lsb\""); }, Kind::CellModel, "accelerometer.lsb: there is no such key; did you mean lsb_g?"},
      {"a cell model without a key", [](Device& d) { d.hello["cell_model"] = modelWith("\"side_m\": 0.01502,", ""); }, Kind::CellModel, "side_m: is missing"},
      {"another cell model", [](Device& d) { d.more.push_back(Json::object({{"hello", d.hello}})); d.more[0]["hello"]["cell_model"] = modelWith("hex-bma150", "other"); }, Kind::CellModelChanged, "changed its cell model from hex-bma150 to other", true},
      {"no cells", [](Device& d) { d.topology["cells"] = Json::array(); }, Kind::NoCells, "expected at least one cell"},
      {"cell ID 0", [](Device& d) { cell(d, 2)["id"] = 0; }, Kind::CellIdZero, "A cell carries the ID 0", true},
      {"a cell twice in the topology", [](Device& d) { d.topology["cells"].push_back(cell(d, 2)); }, Kind::DuplicateCell, "Cell 3 is listed more than once", true},
      {"ports from 0", [](Device& d) { cell(d, 0)["ports"][0]["port"] = 0; cell(d, 1)["ports"][0]["cell_port"] = 0; }, Kind::UnknownPort, "the model's ports are 1, 2, 3 and 4"},
      {"a neighbour that is not there", [](Device& d) { cell(d, 2)["ports"][0]["cell"] = 7; }, Kind::UnknownNeighbour, "Cell 3 reports cell 7 at port 3", true},
      {"one-sided links", [](Device& d) { cell(d, 0)["ports"].clear(); cell(d, 2)["ports"].clear(); }, Kind::OneSidedLink, "both cells of a link have to list it"},
      {"links that contradict each other", [](Device& d) { cell(d, 2)["ports"][0]["cell_port"] = 2; }, Kind::ContradictoryLink, "Neither link is used", true},
      {"a cell that is its own neighbour", [](Device& d) { cell(d, 2)["ports"][0]["cell"] = 3; }, Kind::ContradictoryLink, "reports itself", true},
      // samples
      {"samples of unknown cells", eachSamples([](Json& s) { s["cells"] = {11, 12, 13}; }), Kind::UnknownCell, "samples.cells[0]: the topology has no cell 11"},
      {"cells counted from 0", eachSamples([](Json& s) { s["cells"] = {0, 1, 2}; }), Kind::UnknownCell, "samples.cells[0]: the topology has no cell 0", true},
      {"a cell twice in a message", eachSamples([](Json& s) { s["cells"] = {1, 1, 2}; }), Kind::RepeatedCell, "a cell is twice in one message"},
      {"LSB without a scale", [](Device& d) { d.hello["cell_model"] = modelWith("\"lsb_g\": 0.00390625", "\"lsb_g\": 0"); d.eachSamples([](Json& s) { s.erase("acceleration_g"); s["raw_lsb"] = {0, 0, 256, 0, 0, 256, 0, 0, 256}; }); }, Kind::NoScale, "lsb_g is above 0"},
      {"no time", eachSamples([](Json& s) { s.erase("time_us"); }), Kind::NoTime, "samples.time_us: is missing, or 0 again"},
      {"time backwards", [](Device& d) { std::ranges::reverse(d.samples); d.eachSamples([](Json& s) { s.erase("sequence"); }); }, Kind::TimeBackwards, "samples.time_us: went back from 7990000 to 7980000"},
      {"whole seconds", eachTime([](auto us) { return us / 1'000'000; }), Kind::TimeBackwards, "samples.time_us: is 5 again"},
      {"milliseconds", eachTime([](auto us) { return us / 1000; }), Kind::TimeUnit, "are these milliseconds?"},
      {"milliseconds, no rate", [](Device& d) { d.hello.erase("rate_hz"); eachTime([](auto us) { return us / 1000; })(d); }, Kind::TimeUnit, "are these milliseconds?"},
      {"nanoseconds", eachTime([](auto us) { return us * 1000; }), Kind::TimeUnit, "are these nanoseconds?"},
      {"another rate than the one it states", [](Device& d) { d.hello["rate_hz"] = 350; }, Kind::WrongValue, "hello.rate_hz: says 350 Hz, but a cell's samples come 100.0 times a second", true},
      {"a sequence of messages", eachSamples([](Json& s) { s["sequence"] = s["sequence"].get<int>() / 3; }), Kind::Sequence, "samples.sequence: expected 3, found 1", true},
      {"m/s2", [](Device& d) { d.scale(9.80665); }, Kind::AccelerationUnit, "are these m/s2?"},
      {"mg", [](Device& d) { d.scale(1000); }, Kind::AccelerationUnit, "are these mg?"},
      {"LSB as g", [](Device& d) { d.scale(256); }, Kind::AccelerationUnit, "are these LSB"},
      {"zeros", [](Device& d) { d.scale(0); }, Kind::NotGravity, "0.00 g in the median, expected 1 g"},
      {"a wrong scale", [](Device& d) { d.scale(4); }, Kind::NotGravity, "4.00 g in the median, expected 1 g"},
  };
  // clang-format on
  return devices;
}

}  // namespace hexoderm
