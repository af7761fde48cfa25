#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace berg {

/** 64-bit FNV-1a hash of a text, the same on every machine: turns an id into a stream number. */
[[nodiscard]] std::uint64_t stableHash(std::string_view text);

/**
 * Deterministic random stream named by (seed, stream). Two streams with different names are
 * independent for our purposes. xoshiro256++ (Blackman and Vigna 2019) seeded by splitmix64; the
 * distributions are our own because those of the standard library differ between libraries.
 */
class Random
{
public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

    [[nodiscard]] std::uint64_t bits();
    /** Uniform in [0, 1), 53 bits. */
    [[nodiscard]] double uniform();
    /** Uniform in [low, high). */
    [[nodiscard]] double uniform(double low, double high);
    /** Uniform integer in [0, count), count >= 1; unbiased. */
    [[nodiscard]] std::uint64_t below(std::uint64_t count);
    /** Standard normal, polar method. */
    [[nodiscard]] double normal();
    /**
     * No number of `normal` is larger, either way: sqrt(-2 ln s) with s at least 2^-104, the sum of
     * the squares of two multiples of 2^-52.
     */
    static constexpr double kLargestNormal = 12.1;

private:
    std::uint64_t m_state[4] = {};
    std::optional<double> m_spareNormal;
};

} // namespace berg
