#include "core/io/import/import_table.h"

#include "core/scenario/checks.h"

namespace berg {

namespace {

std::string_view reason(RowFault fault)
{
    switch (fault) {
    case RowFault::ColumnCount:
        return "has another number of columns than the first line";
    case RowFault::UnclosedQuote:
        return "a quote is opened and never closed";
    case RowFault::TextAfterQuote:
        return "text follows a closing quote";
    case RowFault::TimeMissing:
        return "has no time";
    case RowFault::TimeUnreadable:
        return "time cannot be read";
    case RowFault::TimeOutsideSeason:
        return "date is not in the season";
    case RowFault::PositionMissing:
        return "has no position";
    case RowFault::LatitudeWrong:
        return "latitude is no number from -90 to 90";
    case RowFault::LongitudeWrong:
        return "longitude is no number from -180 to 360";
    case RowFault::NumberWrong:
        return "a number is out of range";
    case RowFault::IdTooLong:
        return "id is too long";
    case RowFault::NotAPoint:
        return "is no point";
    case RowFault::TooFar:
        return "is more than 1000 km east, west, north or south of the origin";
    }
    return {};
}

} // namespace

std::string rowFaultText(const RejectedRow& row)
{
    std::string text(reason(row.fault));
    if (!row.detail.empty())
        text += ": \"" + printable(row.detail) + '"';
    return text;
}

void Rejections::add(RejectedRow row)
{
    constexpr std::size_t kMostStored = 1000;
    ++count;
    if (first.size() < kMostStored)
        first.push_back(std::move(row));
}

} // namespace berg
