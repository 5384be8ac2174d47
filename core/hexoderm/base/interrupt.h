#pragma once

// For its programs, not for programs that use the library.

namespace hexoderm {

/// From now on Ctrl+C (SIGINT) and SIGTERM ask the program to end in order, which isInterrupted() tells. Any thread can
/// be held up for ever by a pipe that nobody reads, a disk or a name server; so a program that has not ended after a
/// second, or is asked again, is ended where it stands, with `last_words` (a line, which must stay valid) on standard
/// error and kEndedByForce as exit code.
void endOnInterrupt(const char* last_words);

[[nodiscard]] bool isInterrupted();

/// As a shell calls it: 128 and the number of SIGINT.
inline constexpr int kEndedByForce = 130;

}  // namespace hexoderm
