#include "app/cli/study/mpi_world.h"

#include "core/base/error.h"

#include <algorithm>
#include <cstdlib>
#include <sched.h>

// Its old C++ interface would need another library.
#define OMPI_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#include <mpi.h>

namespace berg::cli {

MpiWorld::MpiWorld()
{
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &m_rank);
    MPI_Comm_size(MPI_COMM_WORLD, &m_size);
    if (provided < MPI_THREAD_FUNNELED)
        throw Error(ErrorCode::Unsupported, "MPI", "allows no threads");
}

MpiWorld::~MpiWorld()
{
    MPI_Finalize();
}

void MpiWorld::send(int to, Tag tag, const std::vector<char>& bytes) const
{
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, static_cast<int>(tag),
             MPI_COMM_WORLD);
}

void MpiWorld::sendToOthers(Tag tag) const
{
    for (int rank = 1; rank < m_size; ++rank)
        send(rank, tag);
}

std::optional<MpiWorld::Message> MpiWorld::receive() const
{
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there == 0)
        return std::nullopt;
    int bytes = 0;
    MPI_Get_count(&status, MPI_BYTE, &bytes);
    Message message{.from = status.MPI_SOURCE,
                    .tag = static_cast<Tag>(status.MPI_TAG),
                    .bytes = std::vector<char>(static_cast<std::size_t>(bytes))};
    MPI_Recv(message.bytes.data(), bytes, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG,
             MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
}

std::string MpiWorld::shared(std::string text) const
{
    std::uint64_t size = text.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    text.resize(size);
    MPI_Bcast(text.data(), static_cast<int>(size), MPI_BYTE, 0, MPI_COMM_WORLD);
    return text;
}

bool MpiWorld::isSameInAll(std::uint64_t number) const
{
    std::uint64_t low = 0;
    std::uint64_t high = 0;
    MPI_Allreduce(&number, &low, 1, MPI_UINT64_T, MPI_MIN, MPI_COMM_WORLD);
    MPI_Allreduce(&number, &high, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
    return low == high;
}

int MpiWorld::coresEach() const
{
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, m_rank, MPI_INFO_NULL, &here);
    int ranks = 1;
    MPI_Comm_size(here, &ranks);
    cpu_set_t mine;
    cpu_set_t all;
    CPU_ZERO(&mine);
    CPU_ZERO(&all);
    sched_getaffinity(0, sizeof mine, &mine);
    MPI_Allreduce(&mine, &all, sizeof mine, MPI_BYTE, MPI_BOR, here);
    MPI_Comm_free(&here);
    return std::max(1, CPU_COUNT(&all) / ranks);
}

void MpiWorld::abort(int exitCode) const
{
    MPI_Abort(MPI_COMM_WORLD, exitCode);
    std::abort(); // not reached
}

} // namespace berg::cli
