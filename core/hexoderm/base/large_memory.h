#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace hexoderm {

/// Memory for `bytes` bytes, with anything in it, for any type of element. From a few megabytes on, where the system
/// can, in large pages, which are entered in its tables and emptied with fewer interruptions; it goes back to the
/// system as soon as it is freed. Throws std::bad_alloc.
[[nodiscard]] void* allocateLarge(std::size_t bytes);
/// `bytes`: as they were asked for.
void freeLarge(void* memory, std::size_t bytes) noexcept;

/// Takes memory from allocateLarge(), and leaves elements as they come where no value is given: numbers are not set.
template <class T>
class LargeAllocator {
 public:
  using value_type = T;
  using is_always_equal = std::true_type;

  LargeAllocator() = default;
  template <class U>
  LargeAllocator(const LargeAllocator<U>& /*other*/) noexcept {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocateLarge(count * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t count) noexcept { freeLarge(memory, count * sizeof(T)); }

  template <class U>
  void construct(U* at) noexcept(std::is_nothrow_default_constructible_v<U>) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const LargeAllocator& /*a*/, const LargeAllocator& /*b*/) { return true; }
};

/// For large arrays of numbers: their elements are anything until they are set.
template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

}  // namespace hexoderm
