#pragma once

namespace berg::test {

/** Against a slow machine and sanitizers; nothing is measured. */
inline constexpr int kPatience_ms = 240'000;

} // namespace berg::test
