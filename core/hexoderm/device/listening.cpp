#include "hexoderm/device/listening.h"

#include "hexoderm/base/limits.h"
#include "hexoderm/base/median.h"
#include "hexoderm/device/plausibility.h"
#include "hexoderm/skin/skin_graph.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace hexoderm {
namespace {

std::optional<Spread> spreadOf(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(values);
  return Spread{least, median(values), most};
}

const Message* reasonOf(const std::vector<ProtocolViolation>& offences,
                        std::initializer_list<ProtocolViolationKind> kinds) {
  for (const ProtocolViolationKind kind : kinds) {
    const auto found = std::ranges::find(offences, kind, &ProtocolViolation::kind);
    if (found != offences.end()) return &found->reason;
  }
  return nullptr;
}

/// Whether a neighbour is reported at a port 0 that there is not.
bool countsPortsFromZero(const SkinDescription& skin) {
  if (skin.model->findPort(PortNumber(0)) != nullptr) return false;
  return std::ranges::any_of(skin.neighbors, [](const CellReport& cell) {
    return std::ranges::any_of(cell.neighbors, [](const NeighborReport& neighbor) {
      return neighbor.port == PortNumber(0) && neighbor.cell != CellId(0);
    });
  });
}

/// Cells that no link joins to another.
std::size_t loneCells(const SkinGraph& graph) {
  std::vector<bool> is_joined(graph.cells().size(), false);
  for (const GraphLink& link : graph.links()) {
    if (!link.muted()) is_joined[link.source] = is_joined[link.target] = true;
  }
  return static_cast<std::size_t>(std::ranges::count(is_joined, false));
}

}  // namespace

void Listening::onSkin(const SkinDescription& skin) { skin_ = skin; }

void Listening::addReading(Cell& cell, const Eigen::Vector3d& acceleration_g, double time_s) {
  constexpr std::size_t kMaxNorms = 512;
  // A device that starts again begins with an earlier time.
  if (cell.readings > 0 && time_s > cell.last_s) {
    cell.elapsed_s += time_s - cell.last_s;
    ++cell.intervals;
  }
  cell.last_s = time_s;
  cell.sum_g += acceleration_g.cwiseMax(-kMaxAcceleration_g).cwiseMin(kMaxAcceleration_g);
  if (cell.readings++ % cell.stride != 0) return;
  cell.norms_g.push_back(static_cast<float>(std::min(acceleration_g.norm(), kMaxAcceleration_g)));
  if (cell.norms_g.size() < kMaxNorms) return;
  // Every second one from now on, and of those that are there.
  for (std::size_t k = 0; 2 * k < cell.norms_g.size(); ++k) cell.norms_g[k] = cell.norms_g[2 * k];
  cell.norms_g.resize(kMaxNorms / 2);
  cell.stride *= 2;
}

void Listening::add(const SampleFrame& frame, Clock::time_point now) {
  if (last_s_ && frame.time_s > *last_s_) {
    device_s_ += frame.time_s - *last_s_;
    host_s_ += std::chrono::duration<double>(now - last_arrival_).count();
  }
  last_s_ = frame.time_s;
  last_arrival_ = now;
  for (const CellSample& sample : frame.samples) {
    Cell& cell = cells_[sample.cell];
    if (cell.last_g) {
      cell.step_sum_g2 += (sample.acceleration_g - *cell.last_g).squaredNorm();
      ++cell.steps;
    }
    cell.last_g = sample.acceleration_g;
    addReading(cell, sample.acceleration_g, frame.time_s);
  }
  for (const CellMean& mean : frame.means) {
    Cell& cell = cells_[mean.cell];
    cell.variance_sum_g2 += mean.variance_g2.sum();
    ++cell.variances;
    addReading(cell, mean.mean_g, frame.time_s);
    has_means_ = true;
  }
}

ListeningReport Listening::report() const {
  constexpr std::uint64_t kMinForNoise = 10;
  constexpr double kAxes = 3;
  ListeningReport report;
  report.status = status_;
  report.offences = status_.offences;
  report.is_described = skin_.has_value();
  if (!skin_) {
    judge(report);
    return report;
  }
  report.device = skin_->device.english();
  report.cell_model = skin_->model->name;

  const SkinGraph graph(*skin_->model, skin_->neighbors);
  std::vector<double> rates_hz;
  std::vector<double> norms_g;
  std::vector<double> noises_g;
  for (const GraphCell& known : graph.cells()) {
    CellHeard heard{known.id};
    const auto found = cells_.find(known.id);
    if (found == cells_.end()) {
      report.silent_cells.push_back(known.id);
      report.cells.push_back(heard);
      continue;
    }
    const Cell& cell = found->second;
    heard.readings = cell.readings;
    if (cell.intervals > 0) {
      heard.rate_hz = static_cast<double>(cell.intervals) / cell.elapsed_s;
      rates_hz.push_back(*heard.rate_hz);
    }
    heard.mean_u = skin_->model->accelerometer.T_u_a.R * cell.sum_g / static_cast<double>(cell.readings);
    const std::vector<double> norms(cell.norms_g.begin(), cell.norms_g.end());
    heard.norm_g = spreadOf(norms);
    norms_g.insert(norms_g.end(), norms.begin(), norms.end());
    if (cell.steps >= kMinForNoise) {
      heard.noise_g = std::sqrt(cell.step_sum_g2 / (2 * kAxes * static_cast<double>(cell.steps)));
    } else if (cell.variances >= kMinForNoise) {
      heard.noise_g = std::sqrt(cell.variance_sum_g2 / (kAxes * static_cast<double>(cell.variances)));
    }
    if (heard.noise_g) noises_g.push_back(*heard.noise_g);
    report.cells.push_back(heard);
  }
  report.rate_hz = spreadOf(rates_hz);
  report.norm_g = spreadOf(norms_g);
  report.noise_g = spreadOf(noises_g);
  for (const GraphLink& link : graph.links()) {
    if (!link.muted()) {
      ++report.links_agreed;
    } else if (*link.muted_by != FindingCode::OneSidedLink) {
      ++report.links_unusable;
    }
  }
  // Links whose other end is not known are findings alone.
  report.links_one_sided =
      static_cast<std::size_t>(std::ranges::count(graph.findings(), FindingCode::OneSidedLink, &Finding::code));
  judge(report);
  remark(report);
  return report;
}

void Listening::remark(ListeningReport& report) const {
  constexpr double kMin_s = 2;
  constexpr double kSlow = 1.3;
  if (host_s_ >= kMin_s && device_s_ > 0) report.slowness = host_s_ / device_s_;
  // Times in another unit are an offence, which says more.
  const bool is_time_known =
      reasonOf(report.offences, {ProtocolViolationKind::TimeUnit, ProtocolViolationKind::NoTime}) == nullptr;
  if (report.slowness && *report.slowness >= kSlow && is_time_known) {
    report.remarks.push_back(
        message("What is sent arrives {} times slower than the device's clock says: the line is too slow, or the "
                "device waits for it (send fewer samples, or means), or its clock runs too slow; a recording may be "
                "played slowly.",
                Number{*report.slowness, 1}));
  }
}

void Listening::judge(ListeningReport& report) const {
  if (!report.is_described) {
    const Message* why = report.offences.empty() ? nullptr : &report.offences.front().reason;
    report.obstacle = why != nullptr ? message("The device has not described itself: {}", *why)
                                     : message("The device has not described itself.");
    return;
  }
  // A few readings are enough for the verdict here, which the live check still waits with.
  if (report.norm_g) {
    const char* field = has_means_ ? "samples.mean_g" : "samples";
    std::optional<ProtocolViolation> offence = offenceOfNorm(report.norm_g->median, skin_->model->accelerometer, field);
    if (offence && reasonOf(report.offences, {offence->kind}) == nullptr)
      report.offences.push_back(std::move(*offence));
  }
  const SkinGraph graph(*skin_->model, skin_->neighbors);
  const auto isHeard = [this, &graph](std::size_t cell) { return cells_.contains(graph.cells()[cell].id); };
  const bool is_joined = std::ranges::any_of(graph.links(), [&](const GraphLink& link) {
    return !link.muted() && isHeard(link.source) && isHeard(link.target);
  });
  const bool any_heard = report.silent_cells.size() < report.cells.size();
  if (!any_heard) {
    const Message* why =
        reasonOf(report.offences, {ProtocolViolationKind::UnknownCell, ProtocolViolationKind::WrongLength,
                                   ProtocolViolationKind::WrongType, ProtocolViolationKind::WrongValue,
                                   ProtocolViolationKind::UnknownField, ProtocolViolationKind::NoScale,
                                   ProtocolViolationKind::RepeatedCell, ProtocolViolationKind::NoCells});
    report.obstacle = why != nullptr ? message("No readings came: {}", *why) : message("No readings came.");
  } else if (const Message* unit =
                 reasonOf(report.offences, {ProtocolViolationKind::AccelerationUnit, ProtocolViolationKind::NotGravity,
                                            ProtocolViolationKind::TimeUnit, ProtocolViolationKind::NoTime})) {
    report.obstacle = *unit;
  } else if (const Message* late = report.status.late_frames > report.status.frames
                                       ? reasonOf(report.offences, {ProtocolViolationKind::TimeBackwards})
                                       : nullptr) {
    report.obstacle = *late;
  } else if (countsPortsFromZero(*skin_)) {
    report.obstacle = message(
        "A neighbour is at port 0, which cell model {} does not have: are the ports counted from 0? Then the links at "
        "the other ports are wrong, too.",
        skin_->model->name);
  } else if (report.links_agreed == 0) {
    report.obstacle = message("There is no link that both of its cells report; a calibration needs joined cells.");
  } else if (const std::size_t lone = loneCells(graph); 2 * lone > graph.cells().size()) {
    // As after a capture.
    report.obstacle =
        message("{} of {} cells are linked to no other: nothing says how they lie.", lone, graph.cells().size());
  } else if (!is_joined) {
    report.obstacle = message("No two joined cells send readings.");
  } else if (!report.rate_hz) {
    const Message* why = reasonOf(report.offences, {ProtocolViolationKind::TimeBackwards});
    report.obstacle =
        why != nullptr ? *why : message("No cell sent two readings; a pose needs at least 10 of each cell.");
  }
}

}  // namespace hexoderm
