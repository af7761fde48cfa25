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

constexpr std::size_t kMemoryPerByte = 9; // the tenth is the file itself
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

void countTo(std::size_t& count, std::size_t most, const std::string& subject, IssueId what)
{
    if (++count > most && count > readLimit(most))
        failTooLarge(subject, what, readLimit(most));
}

} // namespace

std::size_t readLimit(std::size_t usual)
{
    return usual * factor();
}

std::string doubledLimits()
{
    return kReadLimitsVariable + ('=' + std::to_string(2 * factor()));
}

void failTooLarge(const std::string& subject, IssueId what, std::size_t limit)
{
    throw Error(ErrorCode::FileTooLarge, subject, {what, {countOf(limit), doubledLimits()}});
}

ReadBudget::ReadBudget(std::string subject, std::size_t size, std::stop_token stop)
    : m_subject(std::move(subject))
    , m_stop(std::move(stop))
    , m_mostMemory(readLimit(kMemoryPerByte * size + kMemoryBeside))
{
    if (const std::size_t most = readLimit(kLargestFile); size > most)
        failTooLarge(m_subject, IssueId::FileTooLarge, most >> 20U);
}

void ReadBudget::takeValue()
{
    throwIfStopped();
    countTo(m_values, kMostValues, m_subject, IssueId::TooManyValues);
}

void ReadBudget::takeRow(std::size_t bytes)
{
    throwIfStopped();
    countTo(m_rows, kMostRows, m_subject, IssueId::TooManyRows);
    take(bytes);
}

void ReadBudget::failMemory() const
{
    constexpr std::size_t kMegabyte = 1'000'000;
    failTooLarge(m_subject, IssueId::TooMuchMemory, m_mostMemory / kMegabyte);
}

} // namespace berg
