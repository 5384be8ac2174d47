#include "hexoderm/robots/mesh_input.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/limits.h"
#include "hexoderm/base/text.h"

#include <charconv>
#include <map>
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

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr std::size_t kMaxExcerpt = 40;

void addPlaced(MeshBuilder& mesh, const TriangleMesh& part, const Eigen::Affine3d& T_file_part) {
  const bool is_mirrored = T_file_part.linear().determinant() < 0;
  for (const auto& [a, b, c] : part.triangles) {
    mesh.add(T_file_part * part.points[a], T_file_part * part.points[is_mirrored ? c : b],
             T_file_part * part.points[is_mirrored ? b : c]);
  }
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

std::string_view takeWord(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  return word;
}

std::optional<double> meshNumber(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range && word.find("e-") == std::string_view::npos &&
      word.find("E-") == std::string_view::npos) {
    return std::nullopt;
  }
  return error == std::errc() ? value : 0;
}

std::optional<std::uint32_t> meshIndex(std::string_view word) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::string_view MeshText::wordInLine() {
  std::size_t begin = 0;
  for (; begin < rest_.size(); ++begin) {
    const char c = rest_[begin];
    if (c == '\\') {
      const std::string_view behind = rest_.substr(begin + 1);
      const std::size_t joined = behind.starts_with("\r\n") ? 2 : behind.starts_with('\n') ? 1 : 0;
      if (joined > 0) ++line_;
      begin += joined;
    } else if (c == '\n' || kBlanks.find(c) == std::string_view::npos) {
      break;
    }
  }
  rest_.remove_prefix(begin);
  const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r\n\v\f\\"));
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view MeshText::word() {
  while (true) {
    const std::string_view word = wordInLine();
    if (!word.empty() || !nextLine()) return word;
  }
}

bool MeshText::nextLine() {
  const std::size_t end = rest_.find('\n');
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++line_;
  return !rest_.empty();
}

double MeshText::number() {
  const std::string_view found = word();
  if (found.empty()) failTruncated(mesh_);
  const std::optional<double> value = meshNumber(found);
  if (!value) failAt(found, message("a number"));
  return *value;
}

Eigen::Vector3d MeshText::point() {
  Eigen::Vector3d point;
  for (double& coordinate : point) coordinate = number();
  return point;
}

Eigen::Vector3d MeshText::pointInLine() {
  Eigen::Vector3d point;
  for (double& coordinate : point) {
    const std::string_view found = wordInLine();
    if (found.empty()) fail(message("expected three coordinates, found the end of the line"));
    const std::optional<double> value = meshNumber(found);
    if (!value) failAt(found, message("a number"));
    coordinate = *value;
  }
  return point;
}

void MeshText::fail(Message why) const { mesh_.fail(located(message("line {}", line_), std::move(why))); }

void MeshText::failAt(std::string_view word, const Message& expected) const {
  fail(message("expected {}, found \"{}\"", expected, excerptOf(word, kMaxExcerpt)));
}

std::string_view MeshBytes::take(std::uint64_t count) {
  if (count > rest_.size()) failTruncated(mesh_);
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

void failTruncated(const MeshBuilder& mesh) { mesh.fail(message("the file ends too early (truncated?)")); }

Message noSuchPoint(std::int64_t index, std::size_t points) {
  return message("a triangle has a corner at point {}, but there are {} points", index, points);
}

void failTooManyNodes(const MeshBuilder& mesh) {
  mesh.fail(message("has more than {} nodes, or nodes that contain themselves", kMaxMeshNodes));
}

void addScene(MeshBuilder& mesh, const std::vector<MeshNode>& nodes, const std::vector<std::size_t>& roots,
              const ReadMeshPart& read_part) {
  struct Visit {
    std::size_t node;
    Eigen::Affine3d T_file_parent;
  };
  std::vector<Visit> ahead;
  std::size_t visits = 0;
  // A circle ends here, too.
  const auto count = [&](std::size_t more) {
    visits += more;
    if (visits > kMaxMeshNodes) failTooManyNodes(mesh);
  };
  const auto visitLater = [&](const std::vector<std::size_t>& children, const Eigen::Affine3d& T_file_parent) {
    count(children.size());
    for (auto child = children.rbegin(); child != children.rend(); ++child) ahead.push_back({*child, T_file_parent});
  };
  std::map<std::size_t, TriangleMesh> parts;
  visitLater(roots, Eigen::Affine3d::Identity());
  while (!ahead.empty()) {
    const auto [index, T_file_parent] = ahead.back();
    ahead.pop_back();
    const MeshNode& node = nodes[index];
    const Eigen::Affine3d T_file_node = T_file_parent * node.T_parent_node;
    count(node.parts.size());
    for (const std::size_t part : node.parts) {
      const auto [read, is_new] = parts.try_emplace(part);
      if (is_new) {
        MeshBuilder builder = mesh.forPart();
        read_part(part, builder);
        read->second = builder.take();
      }
      addPlaced(mesh, read->second, T_file_node);
    }
    visitLater(node.children, T_file_node);
  }
}

}  // namespace hexoderm
