#include "hexoderm/device/offence.h"

#include <array>

namespace hexoderm {
namespace {

struct NamedOffence {
  OffenceKind kind;
  std::string_view name;
};

constexpr std::array kNamedOffences = {
    NamedOffence{OffenceKind::BrokenFrame, "broken-frame"},
    NamedOffence{OffenceKind::WrongDialect, "wrong-dialect"},
    NamedOffence{OffenceKind::NoLineFeed, "no-line-feed"},
    NamedOffence{OffenceKind::NotJson, "not-json"},
    NamedOffence{OffenceKind::NotAMessage, "not-a-message"},
    NamedOffence{OffenceKind::UnknownMessage, "unknown-message"},
    NamedOffence{OffenceKind::UnknownField, "unknown-field"},
    NamedOffence{OffenceKind::WrongType, "wrong-type"},
    NamedOffence{OffenceKind::WrongValue, "wrong-value"},
    NamedOffence{OffenceKind::WrongLength, "wrong-length"},
    NamedOffence{OffenceKind::OtherVersion, "other-version"},
    NamedOffence{OffenceKind::NotDescribed, "not-described"},
    NamedOffence{OffenceKind::CellModel, "cell-model"},
    NamedOffence{OffenceKind::CellModelChanged, "cell-model-changed"},
    NamedOffence{OffenceKind::NoCells, "no-cells"},
    NamedOffence{OffenceKind::CellIdZero, "cell-id-zero"},
    NamedOffence{OffenceKind::DuplicateCell, "duplicate-cell"},
    NamedOffence{OffenceKind::UnknownPort, "unknown-port"},
    NamedOffence{OffenceKind::UnknownNeighbour, "unknown-neighbour"},
    NamedOffence{OffenceKind::OneSidedLink, "one-sided-link"},
    NamedOffence{OffenceKind::ContradictoryLink, "contradictory-link"},
    NamedOffence{OffenceKind::UnknownCell, "unknown-cell"},
    NamedOffence{OffenceKind::RepeatedCell, "repeated-cell"},
    NamedOffence{OffenceKind::NoScale, "no-scale"},
    NamedOffence{OffenceKind::NoTime, "no-time"},
    NamedOffence{OffenceKind::TimeBackwards, "time-backwards"},
    NamedOffence{OffenceKind::TimeUnit, "time-unit"},
    NamedOffence{OffenceKind::Sequence, "sequence"},
    NamedOffence{OffenceKind::AccelerationUnit, "acceleration-unit"},
    NamedOffence{OffenceKind::NotGravity, "not-gravity"},
};

constexpr auto kOffenceKinds = [] {
  std::array<OffenceKind, kNamedOffences.size()> kinds{};
  for (std::size_t k = 0; k < kinds.size(); ++k) kinds[k] = kNamedOffences[k].kind;
  return kinds;
}();

constexpr bool offencesAreInOrder() {
  for (std::size_t k = 0; k < kOffenceKinds.size(); ++k) {
    if (static_cast<std::size_t>(kOffenceKinds[k]) != k) return false;
  }
  return true;
}
static_assert(offencesAreInOrder(), "one name for each kind, in the order of the enumeration");

}  // namespace

std::span<const OffenceKind> offenceKinds() { return kOffenceKinds; }

std::string_view offenceName(OffenceKind kind) { return kNamedOffences.at(static_cast<std::size_t>(kind)).name; }

Message inWords(const Offence& offence) {
  return offence.excerpt.empty() ? offence.reason
                                 : message("{}; the message begins: {}", offence.reason, offence.excerpt);
}

}  // namespace hexoderm
