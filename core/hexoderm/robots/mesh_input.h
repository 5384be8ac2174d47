#pragma once

// What readers of mesh files have in common: what they add triangles to, and the texts and bytes of files, from front
// to back. Nothing is read beyond their end, and nothing depends on the locale.

#include "hexoderm/base/message.h"
#include "hexoderm/base/triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
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

/// Takes the next word from the front of a text; empty at its end.
std::string_view takeWord(std::string_view& text);

/// A number as mesh files write it: also "+1", and 0 for one that is too small for a double. It may be infinite or NaN.
std::optional<double> meshNumber(std::string_view word);
/// A whole number of at least 0.
std::optional<std::uint32_t> meshIndex(std::string_view word);

/// A text of lines and words. A backslash at the end of a line joins it with the next.
class MeshText {
 public:
  /// `mesh` names the file in errors.
  MeshText(std::string_view text, const MeshBuilder& mesh) : rest_(text), mesh_(mesh) {}

  /// The next word of this line; empty at its end.
  std::string_view wordInLine();
  /// The next word of this line or a later one; empty at the end of the text.
  std::string_view word();
  /// Leaves the line; false at the end of the text.
  bool nextLine();

  double number();          ///< the next word, a number
  Eigen::Vector3d point();  ///< three numbers
  /// The next three words of this line, which have to be numbers.
  Eigen::Vector3d pointInLine();
  [[nodiscard]] std::string_view rest() const { return rest_; }

  /// Throws FormatError naming file and line.
  [[noreturn]] void fail(Message why) const;
  /// The same: something else was expected than this word.
  [[noreturn]] void failAt(std::string_view word, const Message& expected) const;

 private:
  std::string_view rest_;
  const MeshBuilder& mesh_;
  std::size_t line_ = 1;
};

/// Binary numbers.
class MeshBytes {
 public:
  MeshBytes(std::string_view bytes, const MeshBuilder& mesh, std::endian order = std::endian::little)
      : rest_(bytes), mesh_(mesh), order_(order) {}

  /// Throws FormatError if there are fewer.
  std::string_view take(std::uint64_t count);
  template <class Number>
  Number number() {
    std::array<char, sizeof(Number)> bytes{};
    std::ranges::copy(take(bytes.size()), bytes.begin());
    if (order_ != std::endian::native) std::ranges::reverse(bytes);
    return std::bit_cast<Number>(bytes);
  }
  [[nodiscard]] bool atEnd() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  const MeshBuilder& mesh_;
  std::endian order_;
};

/// Throws FormatError: the file is shorter than it says.
[[noreturn]] void failTruncated(const MeshBuilder& mesh);
/// What is wrong with a corner that is none of the points.
Message noSuchPoint(std::int64_t index, std::size_t points);

/// A node of a COLLADA or glTF scene: where it is in its parent, and the indices of the nodes and meshes in it. Files
/// may use a node several times, and hostile ones within itself.
struct MeshNode {
  Eigen::Affine3d T_parent_node = Eigen::Affine3d::Identity();
  std::vector<std::size_t> children;
  std::vector<std::size_t> parts;
};

/// The most nodes of a scene, counted as often as they are used.
inline constexpr std::size_t kMaxMeshNodes = 100'000;
[[noreturn]] void failTooManyNodes(const MeshBuilder& mesh);

/// Adds the triangles of a part to a builder.
using ReadMeshPart = std::function<void(std::size_t part, MeshBuilder& mesh)>;

/// Adds all parts below the roots, each where its nodes place it. `read_part` is called once for each part that is
/// used. A part that is mirrored keeps its outside. Children are indices of `nodes`.
void addScene(MeshBuilder& mesh, const std::vector<MeshNode>& nodes, const std::vector<std::size_t>& roots,
              const ReadMeshPart& read_part);

/// Whether a file is as long as a binary STL with its count of triangles, whatever its header says ("solid" too).
bool isBinaryStl(std::string_view bytes);
/// Whether a text begins as an STL file of text, or as the header of a binary one.
bool isStlText(std::string_view text);
/// STL, of text or binary.
void readStl(std::string_view bytes, MeshBuilder& mesh);
/// Wavefront OBJ: points and faces.
void readObj(std::string_view text, MeshBuilder& mesh);
/// PLY of text or binary: faces and strips of triangles. All other elements and properties are skipped.
void readPly(std::string_view bytes, MeshBuilder& mesh);
/// COLLADA: the scene, in metres. `bytes` are written over.
void readCollada(std::string& bytes, MeshBuilder& mesh);
/// glTF 2.0: the scene. `file` is where the files of its buffers are looked for.
void readGltf(std::string_view text, const std::filesystem::path& file, MeshBuilder& mesh);
/// The same in its binary form.
void readGlb(std::string_view bytes, const std::filesystem::path& file, MeshBuilder& mesh);
/// The files of a glTF's buffers, as far as it names any. Throws FormatError for what is no JSON.
std::vector<std::filesystem::path> gltfBuffers(std::string_view text, const std::filesystem::path& file);

/// The bytes of a mesh file, or of one that it refers to. Throws StorageError for what is no regular file or can't be
/// read, FormatError for more than `max_bytes`.
std::string readRegularFile(const std::filesystem::path& file, std::uintmax_t max_bytes);

}  // namespace hexoderm
