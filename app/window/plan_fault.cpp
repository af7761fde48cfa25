#include "app/window/plan_fault.h"

#include "widgets/model/workspace.h"
#include "widgets/words/error_text.h"
#include "widgets/words/issue_text.h"

namespace berg {

QString planFault(Workspace& workspace)
{
    const MissionSnapshot& now = workspace.record().now;
    if (now.phase != RunPhase::Failed)
        return {};
    const ScenarioDocument& document = workspace.document();
    for (const Issue& issue : document.issues())
        if (issue.severity == Severity::Error)
            return issueLine(issue, document.scenario());
    return now.error ? errorReport(*now.error).section(u'\n', 0, 0) : QString();
}

} // namespace berg
