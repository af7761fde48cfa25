#pragma once

#include "core/checks/validate.h"

#include <string>

namespace berg::test {

/** Returns the English text of the first finding with this id, or an empty text. */
inline std::string messageOf(const Scenario& scenario, IssueId id)
{
    for (const Issue& issue : validate(scenario))
        if (issue.reason.id == id)
            return issue.message();
    return {};
}

} // namespace berg::test
