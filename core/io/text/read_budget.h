#pragma once

#include "core/base/issue.h"
#include "core/base/stopped.h"

#include <cstddef>
#include <string>

namespace berg {

/** Environment variable: a number from 1 to 1000 that multiplies every read limit. */
inline constexpr const char* kReadLimitsVariable = "BERGWATCH_READ_LIMITS";

/** Returns the limit `usual` multiplied by the factor of the environment. */
[[nodiscard]] std::size_t readLimit(std::size_t usual);

/** Returns the setting of the environment variable that doubles the limits, e.g.
 * "BERGWATCH_READ_LIMITS=2". */
[[nodiscard]] std::string doubledLimits();

/**
 * Throws `Error{FileTooLarge}` that names the exceeded limit and the variable that raises it. The
 * unit of `limit` is that of the words of `what`.
 */
[[noreturn]] void failTooLarge(const std::string& subject, IssueId what, std::size_t limit);

/**
 * Limits of reading one file: its memory (ten times its size, itself included, plus 50 MB), ten
 * million values and a million rows, each multiplied by `readLimit`. Every reader charges here what
 * it stores and checks for a stop request. An exceeded limit throws `Error{FileTooLarge}` that
 * names it and how to raise it.
 *
 * Hostile files of at most 64 MiB took up to 630 MB when this was measured. Counting values and
 * rows alone would not do: a run file of 60 MB with 2.5 million empty interventions then took
 * 2.3 GB, one of 18 MB with nine million keyframes 1.1 GB.
 */
class ReadBudget
{
public:
    /**
     * Makes the budget for a file of `size` bytes. Throws `Error{FileTooLarge}` if that is above
     * `readLimit(kLargestFile)`.
     */
    ReadBudget(std::string subject, std::size_t size, std::stop_token stop = {});

    [[nodiscard]] const std::string& subject() const { return m_subject; }
    /** Throws `Stopped` if a stop was requested. */
    void throwIfStopped() const { berg::throwIfStopped(m_stop); }

    /** Charges memory, in bytes. */
    void take(std::size_t bytes)
    {
        m_memory += bytes;
        if (m_memory > m_mostMemory)
            failMemory();
    }
    /** Gives memory back, in bytes. */
    void release(std::size_t bytes) { m_memory -= bytes; }
    [[nodiscard]] std::size_t memory() const { return m_memory; }

    /** Counts a value of a tree. Throws `Stopped` if a stop was requested. */
    void takeValue();
    /** Counts a row of a table and charges its memory. Throws `Stopped` if a stop was requested. */
    void takeRow(std::size_t bytes);

private:
    [[noreturn]] void failMemory() const;

    std::string m_subject;
    std::stop_token m_stop;
    std::size_t m_mostMemory;
    std::size_t m_memory = 0;
    std::size_t m_values = 0;
    std::size_t m_rows = 0;
};

} // namespace berg
