#include "hexoderm/robots/mesh_input.h"

#include "hexoderm/base/text.h"

#include <charconv>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr std::size_t kMaxExcerpt = 40;

}  // namespace

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

}  // namespace hexoderm
