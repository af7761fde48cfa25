#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace berg {

/**
 * Returns the 64-bit FNV-1a hash of a text, equal on every machine; it turns an id into a stream
 * number.
 */
[[nodiscard]] std::uint64_t stableHash(std::string_view text);

/**
 * Deterministic random stream named by (seed, stream). Two streams with different names are
 * independent for our purposes. xoshiro256++ (Blackman and Vigna 2019) seeded by splitmix64. The
 * distributions are our own, because those of the standard library differ between libraries.
 */
class Random
{
public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

    /** Returns 64 random bits. */
    [[nodiscard]] std::uint64_t bits();
    /** Returns a uniform number in [0, 1) with 53 bits. */
    [[nodiscard]] double uniform();
    /** Returns a uniform number from `low` to `high`; rounding may give `high` itself. */
    [[nodiscard]] double uniform(double low, double high);
    /**
     * Returns an unbiased uniform integer in [0, count). Throws `std::logic_error` if `count` is 0.
     */
    [[nodiscard]] std::uint64_t below(std::uint64_t count);
    /** Returns a standard normal number (polar method). */
    [[nodiscard]] double normal();
    /**
     * Bound on the magnitude of `normal`: sqrt(-2 ln s) with s at least 2^-104, the sum of the
     * squares of two multiples of 2^-52.
     */
    static constexpr double kLargestNormal = 12.1;

private:
    std::uint64_t m_state[4] = {};
    std::optional<double> m_spareNormal;
};

} // namespace berg
