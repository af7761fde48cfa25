#pragma once

#include <QtTest>

namespace berg::test {

/** Timeout for slow machines and sanitizers; nothing is measured. */
inline constexpr int kPatience_ms = 240'000;

} // namespace berg::test

// Qt gives these five seconds, which sanitizers on a busy machine exceed.
#undef QTRY_VERIFY
#undef QTRY_VERIFY2
#undef QTRY_COMPARE
#define QTRY_VERIFY(expr) QTRY_VERIFY_WITH_TIMEOUT(expr, berg::test::kPatience_ms)
#define QTRY_VERIFY2(expr, message)                                                                \
    QTRY_VERIFY2_WITH_TIMEOUT(expr, message, berg::test::kPatience_ms)
#define QTRY_COMPARE(expr, expected)                                                               \
    QTRY_COMPARE_WITH_TIMEOUT(expr, expected, berg::test::kPatience_ms)
