#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace berg::cli {

/** Subject of a message between ranks. */
enum class Tag : std::uint8_t
{
    Outcomes, ///< to the first rank: outcomes since the last such message
    Failure,  ///< to the first rank: reason of a failure; the sender's last outcomes came before
    Final,    ///< to the first rank: no more messages follow
    Stop,     ///< from the first rank: end early
    End       ///< from the first rank: all is done
};

/**
 * The processes of an MPI program, from the first to the last call of MPI. No other part of the
 * program uses MPI. Main thread only, once in a process.
 */
class MpiWorld
{
public:
    /** Throws `Error{Unsupported}` if this MPI does not allow other threads. */
    MpiWorld();
    MpiWorld(const MpiWorld&) = delete;
    MpiWorld& operator=(const MpiWorld&) = delete;
    ~MpiWorld();

    [[nodiscard]] int rank() const { return m_rank; }
    [[nodiscard]] int size() const { return m_size; }

    void send(int to, Tag tag, const std::vector<char>& bytes = {}) const;
    /** Sends `tag` from the first rank to all others. */
    void sendToOthers(Tag tag) const;

    struct Message
    {
        int from = 0;
        Tag tag = Tag::End;
        std::vector<char> bytes;
    };
    /** Returns the next message, or nullopt if none has arrived. Messages of one sender keep their
     * order. */
    [[nodiscard]] std::optional<Message> receive() const;

    /** Returns the text of the first rank, in every rank. */
    [[nodiscard]] std::string shared(std::string text) const;
    /** Returns true if all ranks passed the same number. */
    [[nodiscard]] bool isSameInAll(std::uint64_t number) const;
    /** Returns the cores available to the ranks of this computer, divided by the number of these
     * ranks. */
    [[nodiscard]] int coresEach() const;
    /** Ends all ranks at once. */
    [[noreturn]] void abort(int exitCode) const;

private:
    int m_rank = 0;
    int m_size = 1;
};

} // namespace berg::cli
