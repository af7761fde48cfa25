#include "app/cli/sweep_flight.h"

namespace berg::cli {

int flyOnRanks(const SweepLead& /*lead*/, const StudyOptions& /*options*/,
               const std::string& /*commandLine*/)
{
    throw Error(ErrorCode::Unsupported, "sweep",
                "this build has no MPI (BERGWATCH_WITH_MPI): fly shards with --shard I/N");
}

} // namespace berg::cli
