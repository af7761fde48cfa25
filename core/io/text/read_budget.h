#pragma once

#include "core/base/issue.h"
#include "core/base/stopped.h"

#include <cstddef>
#include <string>

namespace berg {

/** In the environment: a number from 1 to 1000 that every limit of reading is multiplied by. */
inline constexpr const char* kReadLimitsVariable = "BERGWATCH_READ_LIMITS";

/** A limit of reading as the user has it. */
[[nodiscard]] std::size_t readLimit(std::size_t usual);

/** What to put into the environment for twice the limits. */
[[nodiscard]] std::string doubledLimits();

/** Throws `Error{FileTooLarge}`: what of it is beyond which limit, and how to raise that. */
[[noreturn]] void failTooLarge(const std::string& subject, IssueId what, std::size_t limit);

/**
 * What the reading of one file may take, in memory ten times its size and 50 MB; every reader
 * counts here what it keeps, and asks here whether to go on. Each limit throws
 * `Error{FileTooLarge}` that names it and how to raise it.
 */
class ReadBudget
{
public:
    /** Of a file of `size` bytes; throws for one above `kLargestFile`. */
    ReadBudget(std::string subject, std::size_t size, std::stop_token stop = {});

    [[nodiscard]] const std::string& subject() const { return m_subject; }
    /** Throws `Stopped` when asked to. */
    void goOn() const { throwIfStopped(m_stop); }

    /** Memory that is kept. */
    void take(std::size_t bytes)
    {
        m_memory += bytes;
        if (m_memory > m_mostMemory)
            failMemory();
    }
    void giveBack(std::size_t bytes) { m_memory -= bytes; }
    [[nodiscard]] std::size_t memory() const { return m_memory; }

    /** A value of a tree, or a row of a table with the memory it takes. */
    void takeValue();
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
