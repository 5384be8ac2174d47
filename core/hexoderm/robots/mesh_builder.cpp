#include "hexoderm/robots/mesh_builder.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/limits.h"

#include <algorithm>
#include <bit>
#include <random>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::size_t kMaxTriangles = 10'000'000;
/// What parts that are used several times may add to a file's own triangles, of which none takes less than a byte.
constexpr std::size_t kMaxRepeatedTriangles = 500'000;

/// The finaliser of SplitMix64.
std::uint64_t mixedBits(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
  return bits ^ (bits >> 31U);
}

}  // namespace

MeshBuilder::MeshBuilder(std::string file, std::size_t bytes)
    : file_(std::move(file)), max_triangles_(kMaxRepeatedTriangles), seed_(std::random_device()()) {
  allowFor(bytes);
}

void MeshBuilder::allowFor(std::size_t bytes) {
  max_triangles_ = std::min(kMaxTriangles, max_triangles_ + std::min(bytes, kMaxTriangles));
}

MeshBuilder MeshBuilder::forPart() const {
  MeshBuilder part(file_, 0);
  part.max_triangles_ = max_triangles_;
  return part;
}

void MeshBuilder::fail(Message why) const { throw FormatError(file_, std::move(why)); }

void MeshBuilder::failTooMany(std::size_t count, Message what) const {
  fail(message("has {} {}, but at most {} are read", count, std::move(what), kMaxOfAKind));
}

void MeshBuilder::add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const std::size_t count = mesh_.triangles.size();
  if (count >= max_triangles_) fail(message("has more than {} triangles", max_triangles_));
  for (const Eigen::Vector3d* corner : {&a, &b, &c}) {
    if (isWithin(*corner, kMaxLength_m)) continue;
    fail(message("a corner of triangle {} is not finite or farther than {} from the origin", count + 1,
                 Number{kMaxLength_m, 0}));
  }
  const std::uint32_t first = indexOf(a);
  const std::uint32_t second = indexOf(b);
  mesh_.triangles.push_back({first, second, indexOf(c)});
}

std::uint32_t MeshBuilder::indexOf(const Eigen::Vector3d& point) {
  if (2 * mesh_.points.size() >= slots_.size()) grow();
  std::uint32_t& slot = slots_[slotOf(point)];
  if (slot == 0) {
    mesh_.points.push_back(point);
    slot = static_cast<std::uint32_t>(mesh_.points.size());
  }
  return slot - 1;
}

/// The slot that holds the point, or the free one where it belongs.
std::size_t MeshBuilder::slotOf(const Eigen::Vector3d& point) const {
  std::uint64_t hash = seed_;
  for (const double coordinate : point) hash = mixedBits(hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0));  // -0
  std::size_t slot = hash & (slots_.size() - 1);
  while (slots_[slot] != 0 && mesh_.points[slots_[slot] - 1] != point) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

void MeshBuilder::grow() {
  constexpr std::size_t kFirstSlots = 1024;
  slots_.assign(std::max(kFirstSlots, 2 * slots_.size()), 0);
  for (std::size_t k = 0; k < mesh_.points.size(); ++k) {
    slots_[slotOf(mesh_.points[k])] = static_cast<std::uint32_t>(k + 1);
  }
}

}  // namespace hexoderm
