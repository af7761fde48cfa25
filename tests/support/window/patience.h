#pragma once

namespace berg::test {

/** Timeout for slow machines and sanitizers; nothing is measured. */
inline constexpr int kPatience_ms = 240'000;

} // namespace berg::test
