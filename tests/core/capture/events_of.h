#pragma once

#include <variant>
#include <vector>

namespace hexoderm::test {

/// Those of one kind.
template <class Event, class Events>
std::vector<Event> eventsOf(const Events& events) {
  std::vector<Event> found;
  for (const auto& event : events) {
    if (const auto* own = std::get_if<Event>(&event)) found.push_back(*own);
  }
  return found;
}

}  // namespace hexoderm::test
