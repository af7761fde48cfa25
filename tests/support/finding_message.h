#pragma once

#include "core/scenario/validate.h"

#include <string>

namespace berg::test {

/** What the first finding of that kind says, in English; empty: there is none. */
inline std::string messageOf(const Scenario& scenario, IssueId id)
{
    for (const Issue& issue : validate(scenario))
        if (issue.reason.id == id)
            return issue.message();
    return {};
}

} // namespace berg::test
