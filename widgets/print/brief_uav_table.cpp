#include "widgets/print/brief_uav_table.h"

#include "widgets/print/brief_setting.h"

#include <algorithm>
#include <numeric>

namespace berg {
namespace {

constexpr int kSize_px = 11;
constexpr std::size_t kMostRows = 8; // captions not counted
constexpr double kLeastGap_px = 10;
constexpr double kLeastName_px = 50;

double gaps_px(const std::vector<double>& widths_px)
{
    return kLeastGap_px * static_cast<double>(widths_px.size() - 1);
}

/** Of the columns: what they need, the name at most what is left. */
std::vector<double> columnWidths(const std::vector<QStringList>& rows, const BriefType& type,
                                 double room_px)
{
    std::vector<double> widths_px(static_cast<std::size_t>(rows.front().size()));
    for (const QStringList& row : rows)
        for (std::size_t i = 0; i < widths_px.size(); ++i)
            widths_px[i] = std::max(widths_px[i], 1 + widthOf_px(row[static_cast<int>(i)], type));
    const double others_px =
        std::accumulate(widths_px.begin() + 1, widths_px.end(), gaps_px(widths_px));
    widths_px.front() = std::min(widths_px.front(), std::max(kLeastName_px, room_px - others_px));
    return widths_px;
}

/** The largest type in which they fit. */
BriefType typeFor(const std::vector<QStringList>& rows, double room_px)
{
    BriefType type{.size_px = kSize_px};
    for (; type.size_px > kSmallestBriefType_px; --type.size_px) {
        const std::vector<double> widths_px = columnWidths(rows, type, room_px);
        if (std::accumulate(widths_px.begin(), widths_px.end(), gaps_px(widths_px)) <= room_px)
            break;
    }
    return type;
}

void setRow(BriefLayout& layout, const QRectF& strip, const QStringList& texts,
            const std::vector<double>& widths_px, const BriefType& type)
{
    const double taken_px = std::accumulate(widths_px.begin(), widths_px.end(), 0.0);
    const double gap_px =
        (strip.width() - taken_px) / std::max(1.0, static_cast<double>(widths_px.size() - 1));
    double left_px = strip.left();
    for (std::size_t i = 0; i < widths_px.size(); ++i) {
        // Where there is too little room all the same, each gives some.
        const double width_px = widths_px[i] + std::min(0.0, gap_px - kLeastGap_px);
        setText(layout, QRectF(left_px, strip.top(), width_px, strip.height()),
                texts[static_cast<int>(i)], type);
        left_px += widths_px[i] + gap_px;
    }
}

} // namespace

double setUavTable(BriefLayout& layout, const std::vector<QStringList>& rows, const QRectF& room)
{
    const BriefType type = typeFor(rows, room.width());
    const std::vector<double> widths_px = columnWidths(rows, type, room.width());
    BriefType captions = type;
    captions.isMuted = true;
    const std::size_t uavs = rows.size() - 1;
    const std::size_t shown = uavs > kMostRows ? kMostRows - 1 : uavs;
    const double pitch_px = linePitch_px(type.size_px);
    QRectF strip(room.left(), room.top(), room.width(), pitch_px);
    setRow(layout, strip, rows.front(), widths_px, captions);
    for (std::size_t row = 1; row <= shown; ++row) {
        strip.translate(0, pitch_px);
        setRow(layout, strip, rows[row], widths_px, type);
    }
    if (shown < uavs) {
        strip.translate(0, pitch_px);
        setText(layout, strip, FlightBrief::tr("and %1 more").arg(uavs - shown), type);
    }
    return strip.bottom();
}

} // namespace berg
