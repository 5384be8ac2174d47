#pragma once

// Private to core: the quick way through large JSON files.

#include <cstddef>
#include <cstdint>
#include <exception>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace hexoderm {

/// Reads JSON from front to back, each value straight to where it belongs, with no document in memory. It has nothing
/// to say about a text that is wrong: at whatever is not what the caller asks for, and at JSON that our files don't
/// have, it throws Unusual, and parseJson() and JsonReader read the text instead. What it takes they take too, as the
/// same values.
///
///     scanner.object(required("id", [&] { id = scanner.unsignedInteger(); }),
///                    optional("name", [&] { name = scanner.string(); }));
///     scanner.finish();
class JsonScanner {
 public:
  class Unusual : public std::exception {
   public:
    [[nodiscard]] const char* what() const noexcept override { return "JSON that a thorough reader has to look at"; }
  };

  /// A member of an object: `take` takes its value.
  template <class Take>
  struct Member {
    std::string_view key;
    bool is_required;
    Take take;
    bool is_taken = false;
  };
  template <class Take>
  static Member<Take> required(std::string_view key, Take take) {
    return {key, true, std::move(take)};
  }
  template <class Take>
  static Member<Take> optional(std::string_view key, Take take) {
    return {key, false, std::move(take)};
  }

  /// The text must outlive it.
  explicit JsonScanner(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  /// An object of these members and no others, each once and in any order.
  template <class... Takes>
  void object(Member<Takes>... members) {
    objectWith([](std::string_view /*key*/) { throw Unusual(); }, std::move(members)...);
  }
  /// The same with others beside them: `take_other` is called with the key of each, may be twice with the same one.
  template <class TakeOther, class... Takes>
  void objectWith(TakeOther take_other, Member<Takes>... members);
  void beginArray() { begin('['); }
  /// Whether there is another item, which has to be taken; if not, the array has ended.
  bool nextItem();

  double number();  ///< finite
  std::uint32_t unsignedInteger(std::uint32_t min = 0, std::uint32_t max = UINT32_MAX);
  bool boolean();
  bool takeNull();  ///< false if the next value is another one, which is left where it is
  std::string string();
  void numbers(std::span<double> values);  ///< an array of exactly so many
  /// Any value, by parseJson(), which throws a FormatError if it is none.
  nlohmann::json document();
  /// The same as a new member of an object.
  void keep(std::string_view key, nlohmann::json& object);

  /// Nothing may follow, and there may not have been more than kMostScannedValues.
  void finish();

 private:
  void begin(char bracket);
  std::optional<std::string_view> nextKey();
  void skipSpace();
  void skipText();
  /// Whether the next character is this one, which is taken then.
  bool take(char c);
  void require(char c);
  void requireWord(std::string_view word);
  /// The text of a value of any kind, or of what looks like one.
  std::string_view textOfValue();

  const char* at_;
  const char* end_;
  bool is_first_ = false;  ///< no member or item has been taken since the last bracket was opened
  std::size_t levels_ = 0;
  std::size_t values_ = 0;  ///< so far; in documents empty arrays and objects count twice
};

template <class TakeOther, class... Takes>
void JsonScanner::objectWith(TakeOther take_other, Member<Takes>... members) {
  begin('{');
  while (const auto key = nextKey()) {
    [[maybe_unused]] const auto takes = [&](auto& member) {  // there may be no members
      if (*key != member.key) return false;
      if (std::exchange(member.is_taken, true)) throw Unusual();
      member.take();
      return true;
    };
    if (!(takes(members) || ...)) take_other(*key);
  }
  if (((members.is_required && !members.is_taken) || ...)) throw Unusual();
}

}  // namespace hexoderm
