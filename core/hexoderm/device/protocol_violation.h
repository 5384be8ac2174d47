#pragma once

#include "hexoderm/base/message.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace hexoderm {

/// What a device can do wrong, as its maker would look for it. The table in core/hexoderm/device/skinwire/README.md
/// explains each.
enum class ProtocolViolationKind {
  // what came is no message
  BrokenFrame,
  WrongDialect,
  NoLineFeed,
  NotJson,
  NotAMessage,
  UnknownMessage,
  UnknownField,
  WrongType,
  WrongValue,
  WrongLength,
  OtherVersion,
  // the description
  NotDescribed,
  CellModel,
  CellModelChanged,
  NoCells,
  CellIdZero,
  DuplicateCell,
  UnknownPort,
  UnknownNeighbour,
  OneSidedLink,
  ContradictoryLink,
  // samples
  UnknownCell,
  RepeatedCell,
  NoScale,
  NoTime,
  TimeBackwards,
  TimeUnit,
  Sequence,
  AccelerationUnit,
  NotGravity,
};

/// All kinds, in the order of the enumeration.
std::span<const ProtocolViolationKind> offenceKinds();
/// The name in JSON and in documents: "unknown-field".
std::string_view offenceName(ProtocolViolationKind kind);

/// Something that a device does wrong: the first time in words, the others counted.
struct ProtocolViolation {
  ProtocolViolationKind kind{};
  Message reason;           ///< the place, what is wrong there, and what is expected
  std::string excerpt{};    ///< the beginning of the message, as of excerptOf(); empty where there is no single message
  std::uint64_t count = 1;  ///< messages; samples, cells and links where it is about them
  friend bool operator==(const ProtocolViolation&, const ProtocolViolation&) = default;
};

/// "time_us: is missing ...; the message begins: {"samples"...".
Message inWords(const ProtocolViolation& offence);

}  // namespace hexoderm
