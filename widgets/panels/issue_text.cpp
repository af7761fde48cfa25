#include "widgets/panels/issue_text.h"

#include <QCoreApplication>

#include <charconv>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct IssueText
{
    Q_DECLARE_TR_FUNCTIONS(IssueText)
};

/** "icebergs[3].q_m2ps" is "icebergs.q_m2ps". */
std::string withoutIndices(const std::string& field)
{
    std::string name;
    bool inside = false;
    for (const char c : field) {
        inside = inside || c == '[';
        if (!inside)
            name += c;
        inside = inside && c != ']';
    }
    return name;
}

QString warningText(const std::string& field)
{
    if (field == "uavs")
        return IssueText::tr("This version flies the first UAV only; the others are kept.");
    if (field == "uavs.endurance_s")
        return IssueText::tr("The endurance is kept, but not used by this version.");
    if (field == "icebergs.velocity_mps")
        return IssueText::tr("Drifts so fast that the UAV may not catch up with it.");
    if (field == "wind_mps")
        return IssueText::tr("The UAV will make little way against this wind.");
    if (field == "area_m")
        return IssueText::tr("The area is kept, but not used by this version.");
    if (field == "asset")
        return IssueText::tr("The asset is kept, but not used by this version.");
    if (field == "planner.policy")
        return IssueText::tr("This version cannot fly the policy chosen.");
    return {};
}

QString hintText(const std::string& field)
{
    if (field == "icebergs")
        return IssueText::tr("There are no icebergs yet, so there is nothing to plan.");
    if (field == "icebergs.appears_s")
        return IssueText::tr("Appears after the end of the run, so it is never planned.");
    return {};
}

} // namespace

QString issueText(const Issue& issue)
{
    const std::string field = withoutIndices(issue.field);
    QString text;
    if (issue.severity == Severity::Warning)
        text = warningText(field);
    else if (issue.severity == Severity::Hint)
        text = hintText(field);
    if (!text.isEmpty())
        return text;
    return u"%1: %2"_s.arg(QString::fromStdString(issue.field),
                           QString::fromStdString(issue.message));
}

int issueIndex(const Issue& issue, std::string_view list)
{
    const std::string_view field = issue.field;
    if (!field.starts_with(list) || field.substr(list.size()).substr(0, 1) != "[")
        return -1;
    const std::string_view number = field.substr(list.size() + 1);
    int index = -1;
    std::from_chars(number.data(), number.data() + number.size(), index);
    return index;
}

} // namespace berg
