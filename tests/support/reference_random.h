#pragma once

#include <array>
#include <cstdint>
#include <string>

// The random generators again, written from the published algorithms and independent of the code
// under test; tst_random checks them against the authors' test vectors.

namespace berg::test {

inline std::uint64_t referenceFnv1a(const std::string& text)
{
    std::uint64_t hash = 14695981039346656037U; // offset basis
    for (const char c : text)
        hash = (hash ^ static_cast<std::uint8_t>(c)) * 1099511628211U;
    return hash;
}

class ReferenceSplitMix
{
public:
    explicit ReferenceSplitMix(std::uint64_t state) : m_state(state) {}
    std::uint64_t next()
    {
        m_state += 11400714819323198485U; // 2^64 / golden ratio
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30U)) * 13787848793156543929U;
        z = (z ^ (z >> 27U)) * 10723151780598845931U;
        return z ^ (z >> 31U);
    }

private:
    std::uint64_t m_state;
};

class ReferenceXoshiro
{
public:
    explicit ReferenceXoshiro(const std::array<std::uint64_t, 4>& state) : m_s(state) {}
    std::uint64_t next()
    {
        const std::uint64_t sum = m_s[0] + m_s[3];
        const std::uint64_t result = ((sum << 23U) | (sum >> 41U)) + m_s[0];
        const std::uint64_t t = m_s[1] << 17U;
        m_s[2] ^= m_s[0];
        m_s[3] ^= m_s[1];
        m_s[1] ^= m_s[2];
        m_s[0] ^= m_s[3];
        m_s[2] ^= t;
        m_s[3] = (m_s[3] << 45U) | (m_s[3] >> 19U);
        return result;
    }

private:
    std::array<std::uint64_t, 4> m_s;
};

/** xoshiro256++ seeded by splitmix64 from seed xor the scrambled stream. */
inline ReferenceXoshiro referenceStream(std::uint64_t seed, std::uint64_t stream)
{
    ReferenceSplitMix mix(seed ^ ReferenceSplitMix(stream).next());
    std::array<std::uint64_t, 4> state{};
    for (std::uint64_t& word : state)
        word = mix.next();
    return ReferenceXoshiro(state);
}

} // namespace berg::test
