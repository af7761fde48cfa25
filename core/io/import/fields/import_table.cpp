#include "core/io/import/fields/import_table.h"

#include "core/scenario/text_checks.h"

#include <algorithm>

namespace berg {

namespace {

constexpr std::size_t kMostStored = 1000;

} // namespace

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
    ++count;
    if (first.size() < kMostStored)
        first.push_back(std::move(row));
}

void Rejections::forget(std::size_t from)
{
    count = std::min(count, from);
    first.resize(std::min(first.size(), count));
}

} // namespace berg
