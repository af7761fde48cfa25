#include "core/io/export/plan_wpl.h"

#include "core/io/export/mission_items.h"
#include "core/io/text/export_numbers.h"

#include <array>
#include <charconv>

namespace berg {

namespace {

constexpr int kDegreeDecimals = 9;

void addDegrees(std::string& text, double angle_deg)
{
    std::array<char, 40> buffer{};
    const std::to_chars_result end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), angle_deg,
                      std::chars_format::fixed, kDegreeDecimals);
    text.append(buffer.data(), end.ptr);
    text += '\t';
}

/** index, current, frame, command, p1 .. p4, latitude, longitude, altitude, autocontinue. */
void addRow(std::string& text, std::size_t index, const MavItem& item)
{
    text += std::to_string(index) + (index == 0 ? "\t1\t" : "\t0\t");
    text += std::to_string(static_cast<int>(item.frame)) + '\t';
    text += std::to_string(static_cast<int>(item.command)) + '\t';
    for (const double param : item.params) {
        appendNumber(text, param);
        text += '\t';
    }
    addDegrees(text, item.place.latitude_deg);
    addDegrees(text, item.place.longitude_deg);
    appendNumber(text, item.altitude_m);
    text += "\t1\n";
}

} // namespace

std::string wplText(const ExportContent& content)
{
    const MavMission mission = mavMission(content);
    std::string text = "QGC WPL 110\n";
    addRow(text, 0, {.frame = MavFrame::Global, .place = mission.home, .altitude_m = 0});
    std::size_t index = 1;
    for (const MavItem& item : mission.items)
        addRow(text, index++, item);
    return text;
}

} // namespace berg
