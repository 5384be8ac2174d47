#pragma once

#include "hexoderm/base/message.h"
#include "hexoderm/base/triangle_mesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hexoderm {

/// Collects the triangles of a mesh file. Points at exactly equal coordinates are joined into one, and points of no
/// triangle are left out. The number of triangles is limited by the size of the file, so that a small file that repeats
/// its parts cannot exhaust the memory.
class MeshBuilder {
 public:
  /// `file` is named in errors, and has so many bytes.
  MeshBuilder(std::string file, std::size_t bytes);

  /// Raises the limit of triangles by those that so many more bytes may hold.
  void allowFor(std::size_t bytes);

  /// The most of anything else that a reader keeps, or runs through, before it has triangles.
  static constexpr std::size_t kMaxOfAKind = 10'000'000;
  /// Asked before so many points of a file, or corners of one polygon or strip, take memory. Throw FormatError for more
  /// than kMaxOfAKind.
  void requireFewPoints(std::size_t count) const {
    if (count > kMaxOfAKind) failTooMany(count, message("points"));
  }
  void requireFewCorners(std::size_t count) const {
    if (count > kMaxOfAKind) failTooMany(count, message("corners in one polygon"));
  }
  [[noreturn]] void failTooMany(std::size_t count, Message what) const;  ///< `what`: of which there are too many

  /// Throws FormatError for a corner that is not finite or beyond kMaxLength_m, and for too many triangles.
  void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
  /// A polygon, as the triangles of its first corner with each of its edges. `corner(k)` is the point of corner k < n.
  /// Fewer than three corners make no triangle.
  template <class Corner>
  void addFan(std::size_t n, Corner corner) {
    for (std::size_t k = 2; k < n; ++k) add(corner(0), corner(k - 1), corner(k));
  }
  /// A strip: each corner makes a triangle with the two before it, every other one turned round.
  template <class Corner>
  void addStrip(std::size_t n, Corner corner) {
    for (std::size_t k = 2; k < n; ++k) add(corner(k - 2 + k % 2), corner(k - 1 - k % 2), corner(k));
  }

  TriangleMesh take() { return std::move(mesh_); }

  /// An empty builder with the same file and limit, for a part that is placed by addScene().
  [[nodiscard]] MeshBuilder forPart() const;
  [[nodiscard]] const std::string& file() const { return file_; }
  [[noreturn]] void fail(Message why) const;  ///< throws FormatError naming the file

 private:
  std::uint32_t indexOf(const Eigen::Vector3d& point);
  [[nodiscard]] std::size_t slotOf(const Eigen::Vector3d& point) const;
  void grow();

  std::string file_;
  std::size_t max_triangles_;
  TriangleMesh mesh_;
  std::vector<std::uint32_t> slots_;  ///< hash table of the points: 0 or a point's index + 1; a power of 2
  std::uint64_t seed_;                ///< of the hash, unknown to those who make files
};

}  // namespace hexoderm
