#include "hexoderm/solve/faults/own_attitudes.h"

#include "hexoderm/base/lane_numbers.h"
#include "hexoderm/base/parallel.h"
#include "hexoderm/base/units.h"
#include "hexoderm/base/vector_instructions.h"
#include "hexoderm/solve/global/attitude_kernel.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace hexoderm {
namespace {

/// One pose's force and swing, by least squares over the cells that read it.
class AngularAccelerationFit {
 public:
  void add(const Eigen::Vector3d& f_o, const Eigen::Vector3d& t_o, const Eigen::Matrix3d& R_o_a, double variance_g2) {
    count_ += 1;
    axes_ += R_o_a;
    turned_axes_ += skew(t_o) * R_o_a;
    variances_ += variance_g2;
    force_ += f_o;
    squares_ += f_o.squaredNorm();
    place_ += t_o;
    places_ += t_o * t_o.transpose();
    turning_ += t_o.cross(f_o);
  }

  void operator+=(const AngularAccelerationFit& other) {
    count_ += other.count_;
    squares_ += other.squares_;
    variances_ += other.variances_;
    force_ += other.force_;
    place_ += other.place_;
    places_ += other.places_;
    turning_ += other.turning_;
    axes_ += other.axes_;
    turned_axes_ += other.turned_axes_;
  }

  /// Returns by how much that changes what a usual cell reads, g. Leaves `force` as it was where the cells agree on
  /// nothing. `shared_g2`: variance of an offset that all sensors share, which on a curved patch reads like a swing.
  double find(PatchForce& force, double shared_g2) const {
    constexpr double kMinAgreed = 0.5;  // g, as a sum
    constexpr int kRounds = 4;
    if (count_ == 0 || force_.norm() <= kMinAgreed) return 0;
    const Eigen::Vector3d mean = force_ / count_;
    const Eigen::Vector3d middle = place_ / count_;
    // f(t) = mean + swing x (t - middle), the swing with a usual tremor as its prior, and an error of every f whose
    // variance is what is left.
    const Eigen::Matrix3d about_middle = places_ - count_ * middle * middle.transpose();
    const Eigen::Matrix3d levers = about_middle.trace() * Eigen::Matrix3d::Identity() - about_middle;
    const Eigen::Vector3d turning = turning_ - middle.cross(force_);
    const double squares = squares_ - count_ * mean.squaredNorm();
    const PatchForce before = force;
    double left = squares;
    for (int round = 0; round < kRounds; ++round) {
      const double variance = std::max(kMinVariance, left / (3 * count_));
      Eigen::Matrix3d information = levers;
      information.diagonal().array() += variance * std::pow(kStandardGravity / kTremorAcceleration_rad_s2, 2);
      force.swing_o = information.ldlt().solve(turning);
      // With few poses own attitudes and sensors fit what they read too well.
      const Eigen::Matrix3d inverse = information.inverse();
      const Eigen::Matrix3d by_shared = inverse * (turned_axes_ - skew(middle) * axes_);
      force.swing_covariance_o =
          std::max(variance, variances_ / count_) * inverse + shared_g2 * by_shared * by_shared.transpose();
      left = squares + force.swing_o.dot(levers * force.swing_o - 2 * turning);
    }
    force.at_origin_o = mean.normalized() - force.swing_o.cross(middle);
    const Eigen::Vector3d turned = force.swing_o - before.swing_o;
    return (force.at_origin_o - before.at_origin_o + turned.cross(middle)).norm() +
           turned.norm() * std::sqrt(about_middle.trace() / count_);
  }

 private:
  static constexpr double kMinVariance = 1e-12;  // g^2: without noise too the algebra is finite
  double count_ = 0;
  double squares_ = 0;
  double variances_ = 0;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Zero();         // sum of R_o_a
  Eigen::Matrix3d turned_axes_ = Eigen::Matrix3d::Zero();  // of [t]x R_o_a
  Eigen::Matrix3d places_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d turning_ = Eigen::Vector3d::Zero();
};

/// Anderson's acceleration of x = g(x): the next x is what the last few, each with its g, say together.
class Acceleration {
 public:
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& g) {
    constexpr std::size_t kMemory = 5;
    const Eigen::VectorXd off = g - x;
    if (last_off_.size() == off.size()) {
      g_changes_.push_back(g - last_g_);
      off_changes_.push_back(off - last_off_);
      if (g_changes_.size() > kMemory) {
        g_changes_.erase(g_changes_.begin());
        off_changes_.erase(off_changes_.begin());
      }
    }
    last_g_ = g;
    last_off_ = off;
    if (g_changes_.empty()) return g;
    const auto count = static_cast<Eigen::Index>(g_changes_.size());
    Eigen::MatrixXd changes(off.size(), count);
    for (Eigen::Index k = 0; k < count; ++k) changes.col(k) = off_changes_[static_cast<std::size_t>(k)];
    const Eigen::VectorXd shares = changes.colPivHouseholderQr().solve(off);
    Eigen::VectorXd next = g;
    for (Eigen::Index k = 0; k < count; ++k) next -= shares[k] * g_changes_[static_cast<std::size_t>(k)];
    return next;
  }

 private:
  Eigen::VectorXd last_g_;
  Eigen::VectorXd last_off_;
  std::vector<Eigen::VectorXd> g_changes_;
  std::vector<Eigen::VectorXd> off_changes_;
};

constexpr double kLever_m = 0.1;

/// All forces in one column, swings as what they change over the lever.
Eigen::VectorXd packed(std::span<const PatchForce> forces) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(6 * forces.size()));
  for (std::size_t k = 0; k < forces.size(); ++k) {
    all.segment<6>(static_cast<Eigen::Index>(6 * k)) << forces[k].at_origin_o, kLever_m * forces[k].swing_o;
  }
  return all;
}
void unpack(const Eigen::VectorXd& all, std::span<PatchForce> forces) {
  for (std::size_t k = 0; k < forces.size(); ++k) {
    forces[k].at_origin_o = all.segment<3>(static_cast<Eigen::Index>(6 * k));
    forces[k].swing_o = all.segment<3>(static_cast<Eigen::Index>(6 * k + 3)) / kLever_m;
  }
}

/// The readings of kLanes cells side by side in each batch, and the attitudes that were found last, as the kernel takes
/// them.
class OwnAttitudeBatches {
 public:
  OwnAttitudeBatches(const AccelerometerPrior& prior, std::size_t poses, std::size_t cells)
      : kernel_(attitudeKernelOptions(prior)),
        poses_(poses),
        batches_((cells + kLanes - 1) / kLanes),
        y_g_(3 * kLanes * poses * batches_, 0),
        precision_(kLanes * poses * batches_, 0),
        R_(9 * kLanes * batches_, 0) {}

  [[nodiscard]] std::size_t count() const { return batches_; }

  void put(std::size_t cell, std::span<const CellReading> readings, const Eigen::Matrix3d& R_start) {
    for (const CellReading& reading : readings) {
      precision_[kLanes * (poses_ * (cell / kLanes) + reading.pose) + cell % kLanes] = 1 / reading.variance_g2;
      vectorOfLane(&y_g_[3 * kLanes * (poses_ * (cell / kLanes) + reading.pose)], cell % kLanes) = reading.y_g;
    }
    start(cell, R_start);
  }
  /// Where the next search begins.
  void start(std::size_t cell, const Eigen::Matrix3d& R) {
    matrixOfLane(&R_[9 * kLanes * (cell / kLanes)], cell % kLanes) = R;
  }
  [[nodiscard]] Eigen::Matrix3d startOf(std::size_t cell) const {
    return matrixOfLane(&R_[9 * kLanes * (cell / kLanes)], cell % kLanes);
  }

  /// One batch at a time.
  class Search {
   public:
    Search(OwnAttitudeBatches& batches, int most_steps)
        : batches_(batches), most_steps_(most_steps), f_o_(3 * kLanes * batches.poses_, 0) {}

    /// `placements` of all cells.
    void run(std::size_t batch, std::span<const PatchForce> forces, std::span<const SE3> placements) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const std::size_t cell = std::min(kLanes * batch + lane, placements.size() - 1);
        for (std::size_t pose = 0; pose < forces.size(); ++pose) {
          vectorOfLane(&f_o_[3 * kLanes * pose], lane) =
              forces[pose].at_origin_o + forces[pose].swing_o.cross(placements[cell].t);
        }
      }
      const std::size_t first = kLanes * batch;  // cell
      const OwnAttitudeKernelInput in{static_cast<int>(batches_.poses_),
                                      f_o_.data(),
                                      batches_.y_g_.data() + 3 * batches_.poses_ * first,
                                      batches_.precision_.data() + batches_.poses_ * first,
                                      batches_.R_.data() + 9 * first,
                                      most_steps_};
      (hasVectorInstructions() ? findAttitudesByFour : findAttitudesByTwo)(batches_.kernel_, in, out_);
    }

    /// Nothing for a cell that needs a more careful look.
    [[nodiscard]] std::optional<OwnAttitude> found(std::size_t lane) const {
      if (out_.usual[lane] == 0) return std::nullopt;
      return OwnAttitude{matrixOfLane(out_.R, lane), symmetricOfLane(out_.information, lane),
                         vectorOfLane(out_.offset_g, lane), matrixOfLane(out_.gain, lane)};
    }

   private:
    const OwnAttitudeBatches& batches_;
    int most_steps_;
    std::vector<double> f_o_;
    OwnAttitudeKernelOutput out_{};
  };

 private:
  AttitudeKernelOptions kernel_;
  std::size_t poses_;
  std::size_t batches_;
  std::vector<double> y_g_;
  std::vector<double> precision_;
  std::vector<double> R_;
};

/// A lot whose scale makes 1 g of what the cells read in the mean, as far as the cell model allows.
SensorLot lotByNorms(const SkinLinks& skin, std::span<const std::size_t> cells) {
  const double allowed = 5 * skin.model().accelerometer.scale_shared_sigma;
  double norms_g = 0;
  double count = 0;
  for (const std::size_t cell : cells) {
    for (const std::size_t pose : skin.table().usablePoses(cell)) {
      norms_g += skin.table().at(cell, pose).mean_g.norm();
      ++count;
    }
  }
  return {Eigen::Vector3d::Zero(), norms_g > 0 ? std::clamp(norms_g / count, 1 - allowed, 1 + allowed) : 1};
}

class Finder {
 public:
  Finder(const SkinLinks& skin, std::span<const std::size_t> cells, std::vector<PatchForce> forces,
         std::span<const SE3> placements, const SensorLot& lot, const Accelerometer& sensor, double shared_g2)
      : R_u_a_(sensor.T_u_a.R),
        shared_g2_(shared_g2),
        prior_(sensor),
        forces_(std::move(forces)),
        placements_(placements),
        own_(cells.size()),
        batches_(prior_, forces_.size(), cells.size()) {
    for (std::size_t place = 0; place < cells.size(); ++place) {
      OwnCell& own = own_[place];
      own.R_o_u = placements[place].R;
      for (std::size_t k = 0; k < forces_.size(); ++k) {
        const GravityTable::Entry& entry = skin.table().at(cells[place], forces_[k].pose);
        if (!entry.usable) continue;
        own.readings.push_back(lot.without({k, R_u_a_.transpose() * entry.mean_g, entry.variance_g2}));
      }
      own.f_o.resize(own.readings.size());
      own.known = !own.readings.empty();
      batches_.put(place, own.readings, own.R_o_u * R_u_a_);
    }
  }

  /// Forces and own attitudes in turn, until they agree.
  void settle() {
    constexpr int kRounds = 60;
    constexpr int kSteps = 2;  // of each attitude; the next round goes on
    Acceleration acceleration;
    for (int round = 0; round < kRounds; ++round) {
      const Eigen::VectorXd before = packed(forces_);
      if (refineForces(kSteps)) return;
      unpack(acceleration.next(before, packed(forces_)), forces_);
    }
  }

  OwnAttitudes run() {
    findAttitudes(kMaxAttitudeSteps, [this](std::size_t, std::size_t place, const OwnAttitude& found) {
      OwnCell& own = own_[place];
      own.R_o_u = found.R * R_u_a_.transpose();
      own.information =
          R_u_a_ * (found.information + Eigen::Matrix3d::Identity() / kUnknownVariance) * R_u_a_.transpose();
      own.covariance = own.information.inverse();
      findForcesOn(place);
    });
    return {prior_, std::move(own_), std::move(forces_)};
  }

 private:
  static constexpr std::size_t kBatchesAtOnce = 32;

  /// Calls take(range, place, attitude) for every cell that has readings.
  template <class Take>
  void findAttitudes(int most_steps, const Take& take) {
    inRanges(batches_.count(), kBatchesAtOnce, [&](std::size_t begin, std::size_t end) {
      OwnAttitudeBatches::Search search(batches_, most_steps);
      for (std::size_t batch = begin; batch < end; ++batch) {
        search.run(batch, forces_, placements_);
        const std::size_t first = kLanes * batch;
        for (std::size_t place = first; place < std::min(first + kLanes, own_.size()); ++place) {
          if (!own_[place].known) continue;
          std::optional<OwnAttitude> found = search.found(place - first);
          if (!found) {
            findForcesOn(place);
            found = findAttitude(prior_, own_[place].readings, own_[place].f_o, batches_.startOf(place), most_steps);
          }
          batches_.start(place, found->R);
          take(begin / kBatchesAtOnce, place, *found);
        }
      }
    });
  }

  void findForcesOn(std::size_t place) {
    OwnCell& own = own_[place];
    for (std::size_t k = 0; k < own.readings.size(); ++k) {
      const PatchForce& force = forces_[own.readings[k].pose];
      own.f_o[k] = force.at_origin_o + force.swing_o.cross(placements_[place].t);
    }
  }

  /// Every force as most cells, freed from the errors of their sensors, read it. Returns whether that was known before.
  bool refineForces(int most_steps) {
    constexpr double kSettled_g = 3e-4;                // far below what any attitude is known to
    using Fits = std::vector<AngularAccelerationFit>;  // per force
    std::vector<Fits> of_ranges((batches_.count() + kBatchesAtOnce - 1) / kBatchesAtOnce, Fits(forces_.size()));
    findAttitudes(most_steps, [&](std::size_t range, std::size_t place, const OwnAttitude& found) {
      const Eigen::Matrix3d freed = found.R * found.gain.inverse();
      for (const CellReading& reading : own_[place].readings) {
        of_ranges[range][reading.pose].add(freed * (reading.y_g - found.offset_g), placements_[place].t, found.R,
                                           reading.variance_g2);
      }
    });
    double most_g = 0;
    for (std::size_t k = 0; k < forces_.size(); ++k) {
      AngularAccelerationFit fit;
      for (const Fits& fits : of_ranges) fit += fits[k];
      most_g = std::max(most_g, fit.find(forces_[k], shared_g2_));
    }
    return most_g <= kSettled_g;
  }

  Eigen::Matrix3d R_u_a_;
  double shared_g2_;
  AccelerometerPrior prior_;
  std::vector<PatchForce> forces_;
  std::span<const SE3> placements_;
  std::vector<OwnCell> own_;
  OwnAttitudeBatches batches_;
};

}  // namespace

OwnAttitudes findOwnAttitudes(const SkinLinks& skin, std::span<const std::size_t> cells, std::vector<PatchForce> forces,
                              std::span<const SE3> placements, const SensorLot* lot) {
  const Accelerometer& sensor = skin.model().accelerometer;
  if (lot != nullptr) return Finder(skin, cells, std::move(forces), placements, *lot, sensor, 0).run();
  Accelerometer each = sensor.ofUnknownLot();
  each.scale_sigma = sensor.scale_sigma;  // beside the lot's, which gravity's length shows
  Finder finder(skin, cells, std::move(forces), placements, lotByNorms(skin, cells), each,
                sensor.offset_shared_sigma_g * sensor.offset_shared_sigma_g);
  finder.settle();
  return finder.run();
}

}  // namespace hexoderm
