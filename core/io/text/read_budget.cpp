#include "core/io/text/read_budget.h"

#include "core/base/error.h"
#include "core/io/text/atomic_file.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kMemoryPerByte = 9; // and one is the file itself
constexpr std::size_t kMemoryBeside = 50'000'000;
constexpr std::size_t kMostValues = 10'000'000;
constexpr std::size_t kMostRows = 1'000'000;

std::size_t factor()
{
    constexpr std::size_t kMost = 1000;
    const char* const given = // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody sets it
        std::getenv(kReadLimitsVariable);
    const std::string_view text = given == nullptr ? "" : given;
    std::size_t value = 1;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return std::clamp<std::size_t>(value, 1, kMost);
}

void countTo(std::size_t& count, std::size_t most, const std::string& subject, const char* what)
{
    if (++count > most && count > readLimit(most))
        failTooLarge(subject, "holds more than " + std::to_string(readLimit(most)) + what);
}

} // namespace

std::size_t readLimit(std::size_t usual)
{
    return usual * factor();
}

void failTooLarge(const std::string& subject, const std::string& what)
{
    throw Error(ErrorCode::FileTooLarge, subject,
                what + "; " + kReadLimitsVariable + '=' + std::to_string(2 * factor()) +
                    " in the environment doubles the limits of reading");
}

ReadBudget::ReadBudget(std::string subject, std::size_t size, std::stop_token stop)
    : m_subject(std::move(subject))
    , m_stop(std::move(stop))
    , m_mostMemory(readLimit(kMemoryPerByte * size + kMemoryBeside))
{
    if (const std::size_t most = readLimit(kLargestFile); size > most)
        failTooLarge(m_subject, "is larger than " + std::to_string(most >> 20U) + " MiB");
}

void ReadBudget::takeValue()
{
    goOn();
    countTo(m_values, kMostValues, m_subject, " values");
}

void ReadBudget::takeRow(std::size_t bytes)
{
    goOn();
    countTo(m_rows, kMostRows, m_subject, " rows or features");
    take(bytes);
}

void ReadBudget::failMemory() const
{
    constexpr std::size_t kMegabyte = 1'000'000;
    failTooLarge(m_subject, "would take more than " + std::to_string(m_mostMemory / kMegabyte) +
                                " MB of memory, the limit for a file of its size: split it, or "
                                "leave out what is empty");
}

} // namespace berg
