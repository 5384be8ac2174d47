#pragma once

// The quick way through large JSON files.

#include "hexoderm/base/message.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace hexoderm {

/// Of the magnitude of a number, which is finite.
inline constexpr double kNoLimit = std::numeric_limits<double>::max();

/// A member of an object: `take` takes its value, from the JsonScanner or the JsonReader that it is called with. A
/// `take` without a parameter reads from a scanner that it knows.
template <class Take>
struct JsonMember {
  std::string_view key;
  bool is_required;
  Take take;
  bool is_taken = false;

  template <class In>
  void takeFrom(In& in) {
    if constexpr (std::is_invocable_v<Take&>) {
      take();
    } else {
      take(in);
    }
  }
};
template <class Take>
JsonMember<Take> member(std::string_view key, Take take) {
  return {key, true, std::move(take)};
}
template <class Take>
JsonMember<Take> optionalMember(std::string_view key, Take take) {
  return {key, false, std::move(take)};
}

/// Reads JSON from front to back, each value straight to where it belongs, with no document in memory. It has nothing
/// to say about a text that is wrong: at whatever is not what the caller asks for, and at JSON that our files don't
/// have, it throws Unusual, and parseJson() and JsonReader read the text instead. What it takes they take too, as the
/// same values.
///
///     scanner.object(member("id", [&](auto& in) { id = in.string(); }), optionalMember("at_m", [&](auto& in) { at_m =
///     in.vector3(); })); scanner.finish();
///
/// Its functions are called as those of JsonReader are, so that a template reads both (json_fields.h). They differ in
/// two ways: a member that object() does not name is refused here and passed over there, and isNull() takes the null
/// here.
class JsonScanner {
 public:
  class Unusual : public std::exception {
   public:
    [[nodiscard]] const char* what() const noexcept override { return "JSON that a thorough reader has to look at"; }
  };

  /// The text must outlive it.
  explicit JsonScanner(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  /// An object of these members and no others, each once and in any order.
  template <class... Members>
  void object(Members... members) {
    objectWith([](std::string_view /*key*/) { throw Unusual(); }, std::move(members)...);
  }
  /// The same with others beside them: `take_other` is called with the key of each, may be twice with the same one.
  template <class TakeOther, class... Members>
  void objectWith(TakeOther take_other, Members... members);
  void beginArray() { begin('['); }
  /// Whether there is another item, which has to be taken; if not, the array has ended.
  bool nextItem();
  /// Calls `take` for every item of an array.
  template <class Take>
  void eachItem(Take take) {
    beginArray();
    while (nextItem()) take(*this);
  }

  double number();  ///< finite
  double positiveNumber();
  double nonNegativeNumber();
  std::uint32_t unsignedInteger(std::uint32_t min = 0, std::uint32_t max = UINT32_MAX);
  bool boolean();
  bool isNull();  ///< a value that is null is taken; another one is left where it is
  std::string string();
  void numbers(std::span<double> values);  ///< an array of exactly so many
  template <std::size_t Count>
  std::array<double, Count> numbers(double most = kNoLimit) {
    std::array<double, Count> values{};
    numbers(values);
    for (const double value : values) require(value >= -most && value <= most);
    return values;
  }
  Eigen::Vector3d vector3(double most = kNoLimit);
  Eigen::Matrix3d rotation();
  Eigen::Quaterniond unitQuaternion();
  /// Any value, by parseJson(), which throws a FormatError if it is none.
  nlohmann::json document();
  /// The same as a new member of an object.
  void keep(std::string_view key, nlohmann::json& object);

  [[noreturn]] static void fail(const Message& /*expected*/) { throw Unusual(); }
  [[noreturn]] static void failAt(std::string_view /*key*/, const Message& /*expected*/) { throw Unusual(); }

  /// Nothing may follow, and there may not have been more than kMaxScannedValues.
  void finish();

 private:
  static void require(bool is_usual) {
    if (!is_usual) throw Unusual();
  }
  void begin(char bracket);
  std::optional<std::string_view> nextKey();
  void skipSpace();
  void skipText();
  /// Whether the next character is this one, which is taken then.
  bool take(char c);
  void requireNext(char c);
  void requireWord(std::string_view word);
  /// The text of a value of any kind, or of what looks like one.
  std::string_view textOfValue();

  const char* at_;
  const char* end_;
  bool is_first_ = false;  ///< no member or item has been taken since the last bracket was opened
  std::size_t levels_ = 0;
  std::size_t values_ = 0;  ///< so far; in documents empty arrays and objects count twice
};

template <class TakeOther, class... Members>
void JsonScanner::objectWith(TakeOther take_other, Members... members) {
  begin('{');
  while (const auto key = nextKey()) {
    [[maybe_unused]] const auto takes = [&](auto& member) {  // there may be no members
      if (*key != member.key) return false;
      if (std::exchange(member.is_taken, true)) throw Unusual();
      member.takeFrom(*this);
      return true;
    };
    if (!(takes(members) || ...)) take_other(*key);
  }
  if (((members.is_required && !members.is_taken) || ...)) throw Unusual();
}

}  // namespace hexoderm
