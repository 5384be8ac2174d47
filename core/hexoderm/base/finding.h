#pragma once

#include "hexoderm/base/ids.h"
#include "hexoderm/base/message.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace hexoderm {

/// How much a finding matters.
enum class Severity { Info, Warning, Error };

/// Everything the program can find wrong or worth knowing about a skin, its topology and its poses. The names in files
/// are `codeName(code)`; `findingTable()` documents each of them and is the table in `core/hexoderm/base/README.md`.
enum class FindingCode {
  // topology
  DuplicateCell,
  ReservedCellId,
  UnknownPort,
  UnknownCell,
  SelfLink,
  OneSidedLink,
  ContradictoryLink,
  DuplicateLink,
  ForbiddenPortPair,
  InterfaceLink,
  BodyPartBoundary,
  // links, judged by their geometry and their measurements
  ImplausibleBend,
  ImplausibleTwist,
  ImplausibleYaw,
  LinkNotRigid,
  LinkDoesNotClose,
  LinkSetAside,
  ContradictsModel,
  TornSkin,
  InsideOut,
  // cells, judged by their readings
  NoSamples,
  MissingSamples,
  DeadSensor,
  StuckSensor,
  SaturatedSensor,
  NoisySensor,
  WrongNorm,
  DeadAxis,
  WrongGain,
  InconsistentSensor,
  IdenticalReadings,
  SwappedReadings,
  TurnedSensor,
  TurnedGroup,
  MovedCell,
  SuspiciousSensor,
  SensorsUnlikeModel,
  LeftOut,
  // poses
  SampleOfUnknownCell,
  DuplicateSample,
  DuplicatePose,
  NoPoses,
  TooFewDirections,
  RepeatedPose,
  PartMoved,
  InconsistentPose,
  // the estimate
  NotConverged,
  PoorFit,
};

/// What an operator can do about a finding with the program itself, about the link, the pose or the cell that the
/// finding names. Whether it can be done just now depends on the session and the device.
enum class FindingRemedy {
  MuteLink,       ///< or let it in again, where it is set aside
  DisablePose,    ///< or enable it
  RecapturePose,  ///< the next capture takes its place
  TakePose,
  LightCell,  ///< on the skin itself, to find it
};

/// A kind of finding, for documents and help: what stands behind it, and what helps.
struct FindingDescription {
  FindingCode code;
  std::string_view name;  ///< as written in files, for example "one-sided-link"
  Severity severity;
  Message meaning;     ///< one sentence
  Message why;         ///< why the program thinks so; one sentence or two
  Message what_to_do;  ///< for a person at the skin
  std::vector<FindingRemedy> remedies;
};

/// One entry per code, in the order of the enumeration.
std::span<const FindingDescription> findingTable();
const FindingDescription& descriptionOf(FindingCode code);        ///< the entry of a kind of finding
std::string_view codeName(FindingCode code);                      ///< the code's name in files
std::optional<FindingCode> codeFromName(std::string_view name);   ///< nothing for a name that is none
std::string_view severityName(Severity severity);                 ///< the severity's name in files
std::optional<Severity> severityFromName(std::string_view name);  ///< nothing for a name that is none

/// Something the operator or engineer should know, in words, with the cells, ports and poses it is about.
/// `ports[i]` belongs to `cells[i]` where ports are given.
struct Finding {
  FindingCode code{};
  Severity severity = Severity::Info;
  Message message;
  std::vector<CellId> cells;
  std::vector<PortNumber> ports;
  std::vector<PoseId> poses;
  friend bool operator==(const Finding&, const Finding&) = default;
};

/// A finding with its code's own severity.
Finding makeFinding(FindingCode code, Message message, std::vector<CellId> cells = {},
                    std::vector<PortNumber> ports = {}, std::vector<PoseId> poses = {});

/// Adds a finding unless there is one of the same code about the same cells, ports and poses: what is looked for again
/// after something was taken out is said once.
void addOnce(std::vector<Finding>& findings, Finding finding);

}  // namespace hexoderm
