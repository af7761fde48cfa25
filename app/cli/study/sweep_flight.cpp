#include "app/cli/study/sweep_flight.h"

#include "app/cli/program.h"

#include <cstdlib>

namespace berg::cli {

int flyAlone(const SweepLead& lead, StudyOptions options)
{
    Study study = lead.prepare();
    options.onProgress = lead.progress;
    bool complete = false;
    try {
        complete = fly(study, options);
    } catch (...) {
        lead.keep(study);
        throw;
    }
    lead.keep(study);
    return lead.finish(study, complete);
}

std::optional<int> mpiRank()
{
    // Set by Open MPI's mpirun, and by launchers that speak PMIx, as Slurm's srun does.
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK"})
        // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody writes there
        if (const char* rank = std::getenv(name))
            return std::atoi(rank);
    return std::nullopt;
}

} // namespace berg::cli
