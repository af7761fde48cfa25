#include "core/io/import/import_table.h"

#include "core/scenario/checks.h"

namespace berg {

IssueReason reasonOf(const RejectedRow& row)
{
    if (row.detail.empty())
        return {row.fault};
    return {row.fault, {printable(row.detail)}};
}

std::string placeOf(const Rejections& rejected, std::size_t line)
{
    return std::string(rejected.place) + ' ' + std::to_string(line);
}

void Rejections::add(RejectedRow row)
{
    constexpr std::size_t kMostStored = 1000;
    ++count;
    if (first.size() < kMostStored)
        first.push_back(std::move(row));
}

} // namespace berg
