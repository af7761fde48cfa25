#include "core/io/export/missions/plan_wpl.h"

#include "core/base/number_text.h"
#include "core/io/export/missions/mission_items.h"
#include "core/io/text/export_numbers.h"

#include <cmath>

namespace berg {

namespace {

constexpr int kDegreeDecimals = 9;

/**
 * Appends a row: index, current, frame, command, p1 .. p4, latitude, longitude, altitude,
 * autocontinue.
 */
void addRow(std::string& text, std::size_t index, const MavItem& item)
{
    text += std::to_string(index) + (index == 0 ? "\t1\t" : "\t0\t");
    text += std::to_string(static_cast<int>(item.frame)) + '\t';
    text += std::to_string(static_cast<int>(item.command)) + '\t';
    for (const double param : item.params) {
        if (std::isnan(param))
            text += "nan";
        else
            appendNumber(text, param);
        text += '\t';
    }
    text += fixedText(item.place.latitude_deg, kDegreeDecimals) + '\t';
    text += fixedText(item.place.longitude_deg, kDegreeDecimals) + '\t';
    appendNumber(text, item.altitude_m);
    text += "\t1\n";
}

} // namespace

std::string wplText(const ExportContent& content)
{
    const MavMission mission = mavMission(content);
    std::string text = "QGC WPL 110\n";
    addRow(text, 0, {.frame = ItemFrame::Global, .place = mission.home, .altitude_m = 0});
    std::size_t index = 1;
    for (const MavItem& item : mission.items)
        addRow(text, index++, item);
    return text;
}

} // namespace berg
