#include "hexoderm/device/sources/wire_address.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"

#include <algorithm>
#include <array>
#include <vector>

namespace hexoderm {
namespace {

/// Those that Linux has a name for and Boost.Asio knows, from 1,200 on.
constexpr std::array<unsigned, 19> kBaudRates = {
    1200,    2400,    4800,    9600,      19'200,    38'400,    57'600,    115'200,   230'400,  460'800,
    500'000, 576'000, 921'600, 1'000'000, 1'152'000, 2'000'000, 3'000'000, 3'500'000, 4'000'000};

[[noreturn]] void fail(std::string_view address, const Message& expected) {
  throw InvalidArgument(message("source \"{}\": expected {}", address, expected));
}

WireAddress parseNetwork(std::string_view address, std::string_view rest, WireAddress::Kind kind) {
  const Message expected =
      message("{}, the port from 1 to 65535 (for example {})",
              kind == WireAddress::Kind::Tcp ? "tcp://HOST:PORT" : "udp://HOST:PORT", "tcp://localhost:7700");
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string_view::npos) fail(address, expected);
  std::string_view host = rest.substr(0, colon);
  const bool in_brackets = host.starts_with('[') && host.ends_with(']');
  if (in_brackets) host = host.substr(1, host.size() - 2);
  if (host.empty() || host.find_first_of("/ []") != std::string_view::npos ||
      (!in_brackets && host.find(':') != std::string_view::npos)) {
    fail(address, expected);
  }
  WireAddress parsed;
  parsed.kind = kind;
  parsed.host = host;
  unsigned port = 0;
  try {
    port = parseUnsigned(rest.substr(colon + 1), "port");
  } catch (const InvalidArgument&) {
    fail(address, expected);
  }
  if (port < 1 || port > UINT16_MAX) fail(address, expected);
  parsed.port = static_cast<std::uint16_t>(port);
  return parsed;
}

WireAddress parseSerial(std::string_view address, std::string_view rest) {
  const Message expected =
      message("{} or {} (for example {})", "serial:/dev/DEVICE", "serial:/dev/DEVICE?baud=N", "serial:/dev/ttyUSB0");
  const std::size_t query = rest.find('?');
  WireAddress parsed;
  parsed.kind = WireAddress::Kind::Serial;
  parsed.host = rest.substr(0, query);
  if (!parsed.host.starts_with('/')) fail(address, expected);
  if (query != std::string_view::npos) {
    constexpr std::string_view kBaud = "baud=";
    const std::string_view option = rest.substr(query + 1);
    if (!option.starts_with(kBaud)) fail(address, expected);
    try {
      parsed.baud = parseUnsigned(option.substr(kBaud.size()), "baud");
    } catch (const InvalidArgument&) {
      fail(address, expected);
    }
    if (std::ranges::find(kBaudRates, parsed.baud) == kBaudRates.end()) {
      fail(address,
           message("one of the baud rates {}", std::vector<std::uint64_t>(kBaudRates.begin(), kBaudRates.end())));
    }
  }
  return parsed;
}

}  // namespace

WireAddress parseWireAddress(std::string_view address) {
  constexpr std::string_view kTcp = "tcp://";
  constexpr std::string_view kUdp = "udp://";
  constexpr std::string_view kSerial = "serial:";
  if (address.starts_with(kTcp)) return parseNetwork(address, address.substr(kTcp.size()), WireAddress::Kind::Tcp);
  if (address.starts_with(kUdp)) return parseNetwork(address, address.substr(kUdp.size()), WireAddress::Kind::Udp);
  if (address.starts_with(kSerial)) return parseSerial(address, address.substr(kSerial.size()));
  fail(address, message("tcp://HOST:PORT, udp://HOST:PORT or serial:/dev/DEVICE"));
}

}  // namespace hexoderm
