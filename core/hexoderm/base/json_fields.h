#pragma once

// The members of an object, described once for what writes them (JsonWriter) and for what reads them (JsonReader).

#include "hexoderm/base/json_reader.h"
#include "hexoderm/base/json_writer.h"

#include <cmath>
#include <concepts>
#include <type_traits>
#include <utility>

namespace hexoderm {

/// What a description of fields does with a `Json`: it reads, or writes.
template <class Json>
inline constexpr bool kIsRead = !std::is_same_v<Json, JsonWriter>;

/// The value of a member as its type is: a text, true or false, a whole number, an ID, a finite number, or a list.
template <class Value>
void takeValue(const JsonReader& in, Value& value) {
  if constexpr (std::is_same_v<Value, std::string>) {
    value = in.string();
  } else if constexpr (std::is_same_v<Value, bool>) {
    value = in.boolean();
  } else if constexpr (std::is_same_v<Value, double>) {
    value = in.number();
  } else if constexpr (std::is_same_v<Value, Eigen::Vector3d>) {
    value = in.vector3();
  } else if constexpr (std::signed_integral<Value>) {
    value = in.integer();
  } else if constexpr (requires { value.emplace_back(); }) {
    for (const JsonReader& item : in.items()) takeValue(item, value.emplace_back());
  } else {
    static_assert(std::is_same_v<Value, std::uint32_t> || std::is_same_v<Value, std::size_t> || std::is_class_v<Value>);
    value = Value(in.unsignedInteger());
  }
}

// How a value stands in a file: read by take(), which may refuse it, and written by put().

/// As its type is.
struct AsItIs {
  template <class Value>
  void take(const JsonReader& in, Value& value) const {
    takeValue(in, value);
  }
  template <class Value>
  void put(JsonWriter& out, const Value& value) const {
    out.value(value);
  }
  template <class Item>
  void put(JsonWriter& out, const std::vector<Item>& items) const {
    out.array(items, [&](const Item& item) { out.value(item); });
  }
};

/// Written as it is, and read by a function of its own.
template <class Read>
struct ReadBy : AsItIs {
  Read read;
  constexpr explicit ReadBy(Read by) : read(std::move(by)) {}
  template <class Value>
  void take(const JsonReader& in, Value& value) const {
    read(in, value);
  }
};
inline constexpr ReadBy kPositive([](const JsonReader& in, double& value) { value = in.positiveNumber(); });
inline constexpr ReadBy kNonNegative([](const JsonReader& in, double& value) { value = in.nonNegativeNumber(); });
inline constexpr ReadBy kNonNegativeVector([](const JsonReader& in, Eigen::Vector3d& value) {
  value = in.vector3();
  if ((value.array() < 0).any()) in.fail(message("three numbers of at least 0"));
});
/// Nine numbers, row by row.
inline constexpr ReadBy kRotation([](const JsonReader& in, Eigen::Matrix3d& R) { R = in.rotation(); });
/// Numbers of at most this magnitude.
inline auto vectorWithin(double most) {
  return ReadBy([most](const JsonReader& in, Eigen::Vector3d& value) { value = in.vector3(most); });
}
/// Whole numbers and IDs.
inline auto wholeFrom(std::uint32_t least, std::uint32_t most = UINT32_MAX) {
  return ReadBy([=](const JsonReader& in, auto& value) {
    value = std::remove_reference_t<decltype(value)>(in.unsignedInteger(least, most));
  });
}

/// Four numbers w, x, y, z.
struct AsQuaternion {
  void take(const JsonReader& in, Eigen::Matrix3d& R) const { R = in.unitQuaternion().toRotationMatrix(); }
  void put(JsonWriter& out, const Eigen::Matrix3d& R) const { out.value(quaternionWxyz(R)); }
};
/// In another unit than in memory. A number that is written is read as the same again wherever there is such a one, and
/// is short (60, not 59.99999999999999) if possible.
struct InUnit {
  double unit;
  bool is_signed = false;
  void take(const JsonReader& in, double& value) const {
    value = (is_signed ? in.number() : in.nonNegativeNumber()) * unit;
  }
  void put(JsonWriter& out, double value) const {
    const double scaled = value / unit;
    constexpr double kShort = 1e9;
    for (const double candidate : {std::round(scaled * kShort) / kShort, scaled, std::nextafter(scaled, HUGE_VAL),
                                   std::nextafter(scaled, -HUGE_VAL)}) {
      if (candidate * unit == value) return out.value(candidate);
    }
    out.value(scaled);
  }
};
/// A value of an enumeration by its name. `expected` says which there are.
template <class NameOf, class FromName, class Expected>
struct Named {
  NameOf name_of;
  FromName from_name;
  Expected expected;
  template <class Value>
  void take(const JsonReader& in, Value& value) const {
    const auto found = from_name(in.string());
    if (!found) in.fail(expected());
    value = *found;
  }
  template <class Value>
  void put(JsonWriter& out, const Value& value) const {
    out.value(name_of(value));
  }
};
template <class NameOf, class FromName, class Expected>
Named(NameOf, FromName, Expected) -> Named<NameOf, FromName, Expected>;

/// A record that `fields(json, record)` describes, or a list of them.
template <class Fields>
struct Described {
  Fields fields;
  template <class Record>
  void take(const JsonReader& in, Record& record) const {
    fields(in, record);
  }
  template <class Record>
  void take(const JsonReader& in, std::vector<Record>& records) const {
    const std::vector<JsonReader> items = in.items();
    records.reserve(items.size());
    for (const JsonReader& item : items) fields(item, records.emplace_back());
  }
  template <class Record>
  void put(JsonWriter& out, const Record& record) const {
    fields(out, record);
  }
  template <class Record>
  void put(JsonWriter& out, const std::vector<Record>& records) const {
    out.array(records, [&](const Record& record) { fields(out, record); });
  }
};
template <class Fields>
Described(Fields) -> Described<Fields>;

/// Says nothing: what an optional member is not written for.
template <class Value>
bool isNothing(const Value& value) {
  if constexpr (std::is_arithmetic_v<Value>) {
    return value == Value{};
  } else if constexpr (requires { value.empty(); }) {
    return value.empty();
  } else if constexpr (requires { value.has_value(); }) {
    return !value.has_value();
  } else {
    return false;
  }
}

/// A member of an object, and the variable that holds it.
template <class Value, class As>
struct JsonField {
  std::string_view key;
  Value& value;
  As as;
  bool is_required;
  bool is_left_out;  ///< where it says nothing

  void takeFrom(const JsonReader& object) const {
    const std::optional<JsonReader> found = is_required ? object.at(key) : object.find(key);
    if (!found) return;
    if constexpr (requires { *value; }) {
      as.take(*found, value.emplace());
    } else {
      as.take(*found, value);
    }
  }
  void write(JsonWriter& out) const {
    if (is_left_out && isNothing(value)) return;
    out.key(key);
    if constexpr (requires { *value; }) {
      value ? as.put(out, *value) : out.null();
    } else {
      as.put(out, value);
    }
  }
};
/// In every file.
template <class Value, class As = AsItIs>
JsonField<Value, As> requiredField(std::string_view key, Value& value, As as = {}) {
  return {key, value, std::move(as), true, false};
}
/// May be absent, or null, from files of others; ours have it, null for nothing.
template <class Value, class As = AsItIs>
JsonField<Value, As> defaultedField(std::string_view key, Value& value, As as = {}) {
  return {key, value, std::move(as), false, false};
}
/// Absent where there is nothing to say.
template <class Value, class As = AsItIs>
JsonField<Value, As> optionalField(std::string_view key, Value& value, As as = {}) {
  return {key, value, std::move(as), false, true};
}

/// A member that follows from others: `get` returns what is written, or nullopt; `take` looks at what is read, if it is
/// there.
template <class Get, class Take>
struct DerivedField {
  std::string_view key;
  Get get;
  Take take;

  void takeFrom(const JsonReader& object) const {
    if (const auto found = object.find(key)) take(*found);
  }
  void write(JsonWriter& out) const {
    if (const auto value = get()) out.member(key, *value);
  }
};
template <class Get, class Take>
DerivedField<Get, Take> derivedField(std::string_view key, Get get, Take take) {
  return {key, std::move(get), std::move(take)};
}

/// Text of a document of which `write` writes the only value.
template <class Write>
std::string jsonText(const Write& write) {
  std::string text;
  JsonWriter writer([&](std::string_view piece) { text += piece; });
  write(writer);
  writer.finish();
  return text;
}

}  // namespace hexoderm
