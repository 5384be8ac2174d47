#pragma once

// JSON on its way to a file, without a document of it in memory.

#include "hexoderm/base/file.h"
#include "hexoderm/base/ids.h"

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hexoderm {

/// Writes JSON for files that people read too: arrays of scalars, and objects of scalars and such arrays that fit into
/// a line, on one line each; a space of indent a level; numbers that read back as the same double; texts that are no
/// UTF-8 with replacement characters. The text goes out in pieces of about 64 KiB.
///
///     writer.beginObject();
///     writer.member("id", 7U);
///     writer.arrayMember("cells", cells, [&](const Cell& cell) { writer.value(cell.name); });
///     writer.endObject();
///     writer.finish();
///
/// The caller sees to it that what begins ends, and that each value of an object follows its key. All functions throw
/// InvalidArgument for a number that is not finite, and what `write` throws.
class JsonWriter {
 public:
  explicit JsonWriter(WriteBytes write) : write_(std::move(write)) {}

  void beginObject() { begin(Kind::Object); }
  void endObject() { end('}'); }
  void beginArray() { begin(Kind::Array); }
  void endArray() { end(']'); }
  void key(std::string_view key);

  void value(double number);
  void value(std::unsigned_integral auto number) { addUnsigned(number); }
  void value(std::signed_integral auto number) { addSigned(number); }
  void value(bool truth) { addScalar(truth ? "true" : "false"); }
  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  template <class Tag>
  void value(StrongId<Tag> id) {
    addUnsigned(id.value());
  }
  void value(const std::string& text) { value(std::string_view(text)); }
  void value(const nlohmann::ordered_json& json);
  void null() { addScalar("null"); }
  /// An array of them.
  void value(std::span<const double> numbers);
  template <std::size_t Count>
  void value(const std::array<double, Count>& numbers) {
    value(std::span<const double>(numbers));
  }
  void value(const Eigen::Vector3d& v) { value(std::span<const double>(v.data(), 3)); }
  void value(const Eigen::Matrix3d& m);  ///< row-major

  template <class Value>
  void member(std::string_view name, const Value& its_value) {
    key(name);
    value(its_value);
  }

  /// An array, each item of which `write_item` writes.
  template <class Items, class WriteItem>
  void array(const Items& items, const WriteItem& write_item) {
    beginArray();
    for (const auto& item : items) write_item(item);
    endArray();
  }
  template <class Items, class WriteItem>
  void arrayMember(std::string_view name, const Items& items, const WriteItem& write_item) {
    key(name);
    array(items, write_item);
  }

  /// An object of fields (json_fields.h).
  template <class... Fields>
  void object(const Fields&... fields) {
    beginObject();
    (fields.write(*this), ...);
    endObject();
  }
  template <class... Fields>
  void strictObject(const Fields&... fields) {
    object(fields...);
  }

  /// The end of the text, with a line break.
  void finish();

 private:
  enum class Kind { Object, Array };
  /// A value that has begun. As long as it may still fit into a line it is written as one, and where its items begin is
  /// known, so that they can be put on lines of their own.
  struct Level {
    Kind kind = Kind::Object;
    bool is_on_lines = false;  ///< each item is on a line of its own
    std::size_t count = 0;
    std::size_t begin = 0;  ///< in text_
    std::vector<std::size_t> items{};
  };

  void begin(Kind kind);
  void end(char bracket);
  /// What stands in front of the next value.
  void startValue();
  void startItem(Level& level);
  void putOnLines();  ///< everything that has begun
  void putOnLines(std::size_t depth);
  void indent(std::size_t levels);
  void addScalar(std::string_view text);
  void addNumber(double number);
  void addUnsigned(std::uint64_t number);
  void addSigned(std::int64_t number);
  void addText(std::string_view text);

  WriteBytes write_;
  std::string text_;
  std::vector<Level> levels_;  ///< the first `depth_` of them; the rest keep their memory
  std::size_t depth_ = 0;
  bool has_key_ = false;  ///< the next value is a member's
};

}  // namespace hexoderm
