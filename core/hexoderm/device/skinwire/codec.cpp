#include "hexoderm/device/skinwire/codec.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/device/skinwire/crc32c.h"
#include "hexoderm/device/skinwire/line_diagnosis.h"
#include "hexoderm/device/skinwire/little_endian.h"

#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/stubs/common.h>
#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/util/json_util.h>

#include <skinwire.pb.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

namespace hexoderm::skinwire {
namespace {

constexpr std::size_t kHead = 2;  // major, type
constexpr std::size_t kTail = 4;  // CRC

/// What protobuf thinks of a message is in what it returns: it is not to say it on standard error as well.
using NoWordsOfProtobuf = google::protobuf::LogSilencer;

// ---- plain types to protobuf

template <class Repeated, class Values>
void assign(Repeated* to, const Values& from) {
  to->Assign(from.begin(), from.end());
}

void fill(const Hello& from, v1::Line& line) {
  v1::Hello& to = *line.mutable_hello();
  to.set_minor(from.minor);
  to.set_device(from.device);
  to.set_cell_model(from.cell_model);
  to.set_can_light_cells(from.can_light_cells);
  to.set_can_turn(from.can_turn);
  to.set_rate_hz(from.rate_hz);
  to.set_stream(from.stream);
}

void fill(const Topology& from, v1::Line& line) {
  v1::Topology& to = *line.mutable_topology();
  to.set_id(from.id);
  to.set_part(from.part);
  to.set_parts(from.parts);
  for (const CellReport& cell : from.cells) {
    v1::Cell& entry = *to.add_cells();
    entry.set_id(cell.id.value());
    entry.set_body_part(cell.body_part);
    for (const NeighborReport& neighbor : cell.neighbors) {
      v1::Port& port = *entry.add_ports();
      port.set_port(neighbor.port.value());
      port.set_cell(neighbor.cell.value());
      if (neighbor.cell_port) port.set_cell_port(neighbor.cell_port->value());
    }
  }
}

void fill(const Samples& from, v1::Line& line) {
  v1::Samples& to = *line.mutable_samples();
  if (from.sequence) to.set_sequence(*from.sequence);
  to.set_time_us(from.time_us);
  to.set_period_us(from.period_us);
  assign(to.mutable_cells(), from.cells);
  assign(to.mutable_raw_lsb(), from.raw_lsb);
  assign(to.mutable_acceleration_g(), from.acceleration_g);
  assign(to.mutable_mean_g(), from.mean_g);
  assign(to.mutable_variance_g2(), from.variance_g2);
  assign(to.mutable_count(), from.count);
  assign(to.mutable_temperature_cells(), from.temperature_cells);
  assign(to.mutable_temperature_c(), from.temperature_c);
}

void fill(const Status& from, v1::Line& line) {
  v1::Status& to = *line.mutable_status();
  to.set_text(from.text);
  to.set_exploring(from.exploring);
  to.set_samples_sent(from.samples_sent);
  to.set_samples_dropped(from.samples_dropped);
}

void fill(const Command& from, v1::Line& line) {
  v1::Command& to = *line.mutable_command();
  to.set_number(from.number);
  if (const auto* rate = std::get_if<SetRate>(&from.request)) {
    to.mutable_set_rate()->set_rate_hz(rate->rate_hz);
  } else if (const auto* led = std::get_if<SetLed>(&from.request)) {
    v1::SetLed& entry = *to.mutable_set_led();
    entry.set_cell(led->cell);
    entry.set_red(led->red);
    entry.set_green(led->green);
    entry.set_blue(led->blue);
  } else if (const auto* turn = std::get_if<TurnTo>(&from.request)) {
    v1::TurnTo& entry = *to.mutable_turn_to();
    entry.set_cell(turn->cell);
    for (const double value : turn->up_u) entry.add_up(value);
  } else if (std::holds_alternative<ExploreAgain>(from.request)) {
    to.mutable_explore_again();
  } else if (const auto* describe = std::get_if<Describe>(&from.request)) {
    v1::Describe& entry = *to.mutable_describe();
    if (describe->known_topology) entry.set_known_topology(*describe->known_topology);
  }
}

void fill(const Ack& from, v1::Line& line) {
  v1::Ack& to = *line.mutable_ack();
  to.set_command(from.command);
  to.set_done(from.done);
  to.set_text(from.text);
  to.set_working(from.working);
}

void fill(const Joints& from, v1::Line& line) {
  v1::Joints& to = *line.mutable_joints();
  to.set_time_us(from.time_us);
  for (const std::string& name : from.names) to.add_names(name);
  assign(to.mutable_position(), from.position);
}

// ---- protobuf to plain types; nullopt where a plain type can't hold it

std::optional<Message> plain(const v1::Hello& from) {
  return Hello{from.minor(),    from.device(),  from.cell_model(), from.can_light_cells(),
               from.can_turn(), from.rate_hz(), from.stream()};
}

std::optional<Message> plain(const v1::Topology& from) {
  Topology to{from.id(), from.part(), from.parts() == 0 ? 1 : from.parts(), {}};
  to.cells.reserve(static_cast<std::size_t>(from.cells_size()));
  for (const v1::Cell& entry : from.cells()) {
    CellReport& cell = to.cells.emplace_back(CellReport{CellId(entry.id()), entry.body_part(), {}});
    cell.neighbors.reserve(static_cast<std::size_t>(entry.ports_size()));
    for (const v1::Port& port : entry.ports()) {
      NeighborReport neighbor{PortNumber(port.port()), CellId(port.cell()), std::nullopt};
      if (port.has_cell_port()) neighbor.cell_port = PortNumber(port.cell_port());
      cell.neighbors.push_back(neighbor);
    }
  }
  return to;
}

std::optional<Message> plain(const v1::Samples& from) {
  Samples to;
  if (from.has_sequence()) to.sequence = from.sequence();
  to.time_us = from.time_us();
  to.period_us = from.period_us();
  to.cells.assign(from.cells().begin(), from.cells().end());
  to.raw_lsb.assign(from.raw_lsb().begin(), from.raw_lsb().end());
  to.acceleration_g.assign(from.acceleration_g().begin(), from.acceleration_g().end());
  to.mean_g.assign(from.mean_g().begin(), from.mean_g().end());
  to.variance_g2.assign(from.variance_g2().begin(), from.variance_g2().end());
  to.count.assign(from.count().begin(), from.count().end());
  to.temperature_cells.assign(from.temperature_cells().begin(), from.temperature_cells().end());
  to.temperature_c.assign(from.temperature_c().begin(), from.temperature_c().end());
  return to;
}

std::optional<Message> plain(const v1::Status& from) {
  return Status{from.text(), from.exploring(), from.samples_sent(), from.samples_dropped()};
}

std::optional<Message> plain(const v1::Command& from) {
  Command to{from.number(), {}};
  switch (from.request_case()) {
    case v1::Command::kSetRate:
      to.request = SetRate{from.set_rate().rate_hz()};
      break;
    case v1::Command::kSetLed: {
      const v1::SetLed& led = from.set_led();
      if (led.red() > UINT8_MAX || led.green() > UINT8_MAX || led.blue() > UINT8_MAX) return std::nullopt;
      to.request = SetLed{led.cell(), static_cast<std::uint8_t>(led.red()), static_cast<std::uint8_t>(led.green()),
                          static_cast<std::uint8_t>(led.blue())};
      break;
    }
    case v1::Command::kTurnTo: {
      const v1::TurnTo& turn = from.turn_to();
      if (turn.up_size() != 3) return std::nullopt;
      to.request = TurnTo{turn.cell(), {turn.up(0), turn.up(1), turn.up(2)}};
      break;
    }
    case v1::Command::kExploreAgain:
      to.request = ExploreAgain{};
      break;
    case v1::Command::kDescribe: {
      Describe describe;
      if (from.describe().has_known_topology()) describe.known_topology = from.describe().known_topology();
      to.request = describe;
      break;
    }
    case v1::Command::REQUEST_NOT_SET:
      break;
  }
  return to;
}

std::optional<Message> plain(const v1::Ack& from) {
  return Ack{from.command(), from.done(), from.text(), from.working()};
}

std::optional<Message> plain(const v1::Joints& from) {
  return Joints{
      from.time_us(), {from.names().begin(), from.names().end()}, {from.position().begin(), from.position().end()}};
}

// ---- bodies

std::string_view asText(ByteView bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

Decoded failed(DecodeOutcome outcome, ProtocolViolation offence, std::uint32_t major = kMajor) {
  Decoded decoded;
  decoded.outcome = outcome;
  decoded.major = major;
  decoded.offences.push_back(std::move(offence));
  return decoded;
}

Decoded otherMajor(std::uint32_t major) {
  return failed(DecodeOutcome::OtherMajor,
                {ProtocolViolationKind::OtherVersion,
                 message("the device speaks SkinWire {}, this program SkinWire {}", major, std::uint32_t{kMajor})},
                major);
}

Decoded checked(std::optional<Message> message) {
  if (!message) {
    return failed(DecodeOutcome::Broken,
                  {ProtocolViolationKind::WrongValue, hexoderm::message("a number is out of range")});
  }
  if (ValidationError why = complaint(*message); !why.empty()) {
    return failed(DecodeOutcome::Broken, {why.kind, std::move(why.reason)});
  }
  Decoded decoded;
  decoded.outcome = DecodeOutcome::Understood;
  decoded.major = kMajor;
  decoded.message = std::move(*message);
  return decoded;
}

Decoded messageIn(const v1::Line& line) {
  switch (line.message_case()) {
    case v1::Line::kHello:
      return checked(plain(line.hello()));
    case v1::Line::kTopology:
      return checked(plain(line.topology()));
    case v1::Line::kSamples:
      return checked(plain(line.samples()));
    case v1::Line::kStatus:
      return checked(plain(line.status()));
    case v1::Line::kCommand:
      return checked(plain(line.command()));
    case v1::Line::kAck:
      return checked(plain(line.ack()));
    case v1::Line::kJoints:
      return checked(plain(line.joints()));
    case v1::Line::MESSAGE_NOT_SET:
      break;
  }
  Decoded unknown;
  unknown.outcome = DecodeOutcome::UnknownType;
  unknown.major = kMajor;
  return unknown;
}

/// The payload of a body is the field of Line whose number is its type and one more.
Decoded parsePayload(std::uint8_t type, ByteView payload) {
  // Kept for each type, so that the arrays of samples need not grow again for every one of a thousand messages a
  // second.
  thread_local std::array<v1::Line, 8> lines;
  v1::Line& line = lines[type % lines.size()];
  const google::protobuf::FieldDescriptor* field = line.GetDescriptor()->FindFieldByNumber(type + 1);
  if (field == nullptr || field->message_type() == nullptr) {
    return failed(DecodeOutcome::UnknownType,
                  {ProtocolViolationKind::UnknownMessage,
                   message("there is no message of type {}; expected 1 to 7", std::uint32_t{type})});
  }
  const NoWordsOfProtobuf quiet;
  google::protobuf::Message& proto = *line.GetReflection()->MutableMessage(&line, field);
  const std::string& name = field->message_type()->name();
  if (!proto.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) {
    return failed(DecodeOutcome::Broken,
                  {ProtocolViolationKind::WrongType,
                   message("the payload is not the protobuf message {} that its type says", name)});
  }
  Decoded decoded = messageIn(line);
  const auto& unknown = proto.GetReflection()->GetUnknownFields(proto);
  if (!unknown.empty()) {
    decoded.offences.insert(decoded.offences.begin(),
                            {ProtocolViolationKind::UnknownField,
                             message("{} has no field with the number {}", name, unknown.field(0).number())});
  }
  return decoded;
}

/// Throws for a message that can't be sent.
v1::Line lineOf(const Message& message) {
  if (const ValidationError why = complaint(message); !why.empty()) {
    throw InvalidArgument(hexoderm::message("a message can't be sent: {}", why.reason));
  }
  v1::Line line;
  std::visit([&](const auto& m) { fill(m, line); }, message);
  return line;
}

/// The checksum of Ethernet and zip, which is taken for CRC-32C most often.
std::uint32_t crc32(ByteView bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

/// Why the CRC of a body is wrong, as far as that can be told.
Decoded wrongCrc(ByteView body) {
  const ByteView content = body.first(body.size() - kTail);
  const std::uint32_t found = littleEndian(body.last(kTail));
  if (body[0] == '{') {
    return brokenPiece(ProtocolViolationKind::WrongDialect,
                       message("this looks like a line of JSON; lines go over TCP and standard input, here bodies of "
                               "bytes with a CRC are expected"),
                       body);
  }
  if (littleEndian(body) == body.size() - sizeof(std::uint32_t)) {
    return brokenPiece(ProtocolViolationKind::WrongDialect,
                       message("a length stands before the body; here the body is expected alone"), body);
  }
  if (found == boost::endian::endian_reverse(crc32c(content))) {
    return brokenPiece(ProtocolViolationKind::BrokenFrame, message("the CRC is big-endian, expected little-endian"),
                       body);
  }
  if (found == crc32(content) || found == boost::endian::endian_reverse(crc32(content))) {
    return brokenPiece(ProtocolViolationKind::BrokenFrame,
                       message("the CRC is CRC-32, expected CRC-32C (polynomial 0x1EDC6F41)"), body);
  }
  return brokenPiece(ProtocolViolationKind::BrokenFrame, message("the CRC is wrong"), body);
}

/// ProtocolViolations of a line with where they were found.
Decoded withViolationsOf(std::string_view line, Decoded decoded) {
  std::vector<ProtocolViolation> found = offencesOfLine(line);
  found.insert(found.end(), decoded.offences.begin(), decoded.offences.end());
  for (ProtocolViolation& offence : found) offence.excerpt = excerptOf(line);
  decoded.offences = std::move(found);
  return decoded;
}

/// The major version that an unreadable line claims; nullopt if it has none.
std::optional<std::uint32_t> majorOfLine(std::string_view line) {
  const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const auto major = json.find("major");
  if (major == json.end() || !major->is_number_unsigned()) return std::nullopt;
  const auto value = major->get<std::uint64_t>();
  return value <= UINT32_MAX ? std::optional(static_cast<std::uint32_t>(value)) : std::nullopt;
}

}  // namespace

Decoded brokenPiece(ProtocolViolationKind kind, hexoderm::Message reason, ByteView beginning) {
  Decoded broken;
  broken.offences.push_back({kind, std::move(reason), excerptOf(asText(beginning))});
  return broken;
}

Bytes encodeBody(const Message& message) {
  const NoWordsOfProtobuf quiet;
  const v1::Line line = lineOf(message);
  const auto type = static_cast<std::uint8_t>(message.index() + 1);
  const google::protobuf::Message& proto =
      line.GetReflection()->GetMessage(line, line.GetDescriptor()->FindFieldByNumber(type + 1));
  const std::size_t payload = proto.ByteSizeLong();
  if (payload > kMaxBody - kHead - kTail) {
    throw InvalidArgument("a message of " + std::to_string(payload) + " bytes can't be sent, the limit is " +
                          std::to_string(kMaxBody - kHead - kTail) + "; expected it to be sent in parts");
  }
  Bytes body;
  body.reserve(kHead + payload + kTail);
  body.resize(kHead + payload);
  body[0] = kMajor;
  body[1] = type;
  proto.SerializeWithCachedSizesToArray(body.data() + kHead);
  const std::uint32_t crc = crc32c(body);
  appendLittleEndian(crc, body);
  return body;
}

Decoded decodeBody(ByteView body) {
  if (body.size() < kHead + kTail || body.size() > kMaxBody) {
    return brokenPiece(ProtocolViolationKind::BrokenFrame,
                       message("expected 6 to {} bytes, found {}", kMaxBody, body.size()), body);
  }
  const ByteView content = body.first(body.size() - kTail);
  if (littleEndian(body.last(kTail)) != crc32c(content)) return wrongCrc(body);
  if (body[0] != kMajor) return otherMajor(body[0]);
  Decoded decoded = parsePayload(body[1], content.subspan(kHead));
  for (ProtocolViolation& offence : decoded.offences) offence.excerpt = excerptOf(asText(body));
  return decoded;
}

std::string encodeLine(const Message& message) {
  const NoWordsOfProtobuf quiet;
  const v1::Line line = lineOf(message);
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  std::string text;
  if (!google::protobuf::util::MessageToJsonString(line, &text, options).ok() || text.size() > kMaxBody) {
    throw InvalidArgument("a message can't be sent as a line of at most " + std::to_string(kMaxBody) + " bytes");
  }
  return text;
}

Decoded decodeLine(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.size() > kMaxBody) {
    return brokenPiece(ProtocolViolationKind::WrongLength, message("expected a line of at most {} bytes", kMaxBody),
                       ByteView(reinterpret_cast<const std::uint8_t*>(line.data()), line.size()));
  }
  const NoWordsOfProtobuf quiet;
  const google::protobuf::StringPiece text(line.data(), static_cast<std::ptrdiff_t>(line.size()));
  google::protobuf::util::JsonParseOptions options;
  v1::Line proto;
  if (google::protobuf::util::JsonStringToMessage(text, &proto, options).ok()) {
    if (proto.major() > kMajor) return otherMajor(proto.major());
    Decoded decoded = messageIn(proto);
    return decoded.outcome == DecodeOutcome::Understood ? decoded : withViolationsOf(line, std::move(decoded));
  }
  // A second time, leaving out what is not known: a device that is newer, or whose maker misspelt it.
  proto.Clear();
  options.ignore_unknown_fields = true;
  const auto status = google::protobuf::util::JsonStringToMessage(text, &proto, options);
  const std::optional<std::uint32_t> major = status.ok() ? proto.major() : majorOfLine(line);
  if (major && *major > kMajor) return otherMajor(*major);
  if (status.ok()) return withViolationsOf(line, messageIn(proto));
  Decoded broken = withViolationsOf(line, {});
  if (broken.offences.empty()) {
    // The library's message may quote the whole line.
    constexpr std::size_t kMax = 160;
    broken.offences.push_back({ProtocolViolationKind::NotAMessage,
                               message("this is no message: {}", excerptOf(status.ToString(), kMax)), excerptOf(line)});
  }
  broken.major = kMajor;
  return broken;
}

}  // namespace hexoderm::skinwire
