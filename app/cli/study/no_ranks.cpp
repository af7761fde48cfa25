#include "app/cli/study/sweep_flight.h"

namespace berg::cli {

int flyOnRanks(const SweepLead& /*lead*/, const StudyOptions& /*options*/,
               const std::string& /*commandLine*/)
{
    throw Error(ErrorCode::Unsupported, "sweep", {IssueId::NoMpi});
}

} // namespace berg::cli
