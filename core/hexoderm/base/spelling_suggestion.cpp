#include "hexoderm/base/spelling_suggestion.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hexoderm {
namespace {

/// Lower case, only letters and digits: "timeUs", "time-us" and "time_us" are one.
std::string plainName(std::string_view name) {
  constexpr std::size_t kMax = 100;
  std::string plain;
  for (const char c : name.substr(0, kMax)) {
    if (c >= 'A' && c <= 'Z') plain += static_cast<char>(c + ('a' - 'A'));
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) plain += c;
  }
  return plain;
}

/// Letters to insert, delete, replace or swap with their neighbour to get from one to the other (optimal string
/// alignment).
std::size_t slips(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({replaced, last[j] + 1, now[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, now);
  }
  return last[b.size()];
}

std::size_t commonBeginning(const std::string& a, const std::string& b) {
  return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

/// Whether two names that are so many slips apart may mean the same.
bool isNear(const std::string& a, const std::string& b, std::size_t apart) {
  constexpr std::size_t kLettersPerSlip = 4;
  constexpr std::size_t kMinPart = 3;
  constexpr std::size_t kMinBeginning = 4;
  const std::size_t shorter = std::min(a.size(), b.size());
  if (apart <= std::max<std::size_t>(1, shorter / kLettersPerSlip)) return shorter > 1;
  const bool is_part = a.find(b) != std::string::npos || b.find(a) != std::string::npos;
  return (is_part && shorter >= kMinPart) || commonBeginning(a, b) >= kMinBeginning;
}

}  // namespace

std::optional<std::string> spellingSuggestion(std::string_view name, std::span<const std::string> known) {
  const std::string meant = plainName(name);
  std::optional<std::string> nearest;
  std::size_t least = 0;
  for (const std::string& candidate : known) {
    const std::string plain = plainName(candidate);
    const std::size_t apart = slips(meant, plain);
    if (!isNear(meant, plain, apart) || (nearest && apart >= least)) continue;
    nearest = candidate;
    least = apart;
  }
  return nearest;
}

Message didYouMean(std::string_view name, std::span<const std::string> known) {
  const std::optional<std::string> meant = spellingSuggestion(name, known);
  return meant ? message("did you mean {}?", *meant) : Message();
}

}  // namespace hexoderm
