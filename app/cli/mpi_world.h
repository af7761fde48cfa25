#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace berg::cli {

/** What a message between the ranks is about. */
enum class Tag : std::uint8_t
{
    Outcomes, ///< to the first rank: what has been flown since the last such message
    Failure,  ///< to the first rank: why one failed; the rest of its outcomes came before
    Final,    ///< to the first rank: nothing more will come
    Stop,     ///< from the first rank: end early
    End       ///< from the first rank: all is done
};

/**
 * The processes of an MPI program, from the first to the last call of MPI; the rest of the program
 * knows nothing of it. Used by the main thread alone, once in a process.
 */
class MpiWorld
{
public:
    /** Throws `Error{Unsupported}` when this MPI allows no threads beside it. */
    MpiWorld();
    MpiWorld(const MpiWorld&) = delete;
    MpiWorld& operator=(const MpiWorld&) = delete;
    ~MpiWorld();

    [[nodiscard]] int rank() const { return m_rank; }
    [[nodiscard]] int size() const { return m_size; }

    void send(int to, Tag tag, const std::vector<char>& bytes = {}) const;
    /** To every rank but this one, the first. */
    void tellOthers(Tag tag) const;

    struct Message
    {
        int from = 0;
        Tag tag = Tag::End;
        std::vector<char> bytes;
    };
    /** The next message that has arrived, if any; those of one sender come in order. */
    [[nodiscard]] std::optional<Message> receive() const;

    /** The text of the first rank, in all. */
    [[nodiscard]] std::string shared(std::string text) const;
    /** Whether all ranks gave the same number. */
    [[nodiscard]] bool isSameInAll(std::uint64_t number) const;
    /** Cores that the ranks of this computer may use together, divided by their number. */
    [[nodiscard]] int coresEach() const;
    /** Ends all ranks at once. */
    [[noreturn]] void abort(int exitCode) const;

private:
    int m_rank = 0;
    int m_size = 1;
};

} // namespace berg::cli
