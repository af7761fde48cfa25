#include "core/io/export/missions/plan_csv.h"

#include "core/base/number_text.h"
#include "core/io/text/export_numbers.h"

namespace berg {

namespace {

void addVisit(std::string& text, const ExportContent& content, const ExportUav& uav,
              const Visit& visit, const Point& from_m, int sequence)
{
    const LatLon place = content.frame.toGeographic(visit.position_m);
    double leg_m = (visit.position_m - from_m).norm();
    for (const IcebergIndex index : icebergsOf(visit)) {
        const ExportIceberg& now = content.icebergs.at(toIndex(index));
        const double arrival_m2 = now.sigmaAfter_m2(visit.time_s - content.now_s);
        text += std::to_string(sequence) + ',' + csvField(now.iceberg.id) + ',' +
                csvField(now.iceberg.name);
        for (const double value :
             {leg_m, visit.time_s, place.latitude_deg, place.longitude_deg, visit.position_m.x(),
              visit.position_m.y(), now.sigma_m2, arrival_m2}) {
            text += ',';
            appendNumber(text, value);
        }
        text += ',' + csvField(uav.uav.id) + ',';
        if (const std::optional<double> chance = chanceInView(content, uav, visit, index))
            appendNumber(text, *chance);
        text += '\n';
        leg_m = 0; // the other members of a cluster are at the same place
    }
}

} // namespace

std::string planCsv(const ExportContent& content)
{
    std::string text = "sequence,iceberg,name,leg_m,arrival_s,latitude_deg,longitude_deg,east_m,"
                       "north_m,sigma_now_m2,sigma_at_arrival_m2,uav,chance_in_view\n";
    for (const ExportUav& uav : content.uavs) {
        Point from_m = uav.uav.position_m;
        int sequence = 0;
        for (const Visit& visit : uav.visits) {
            if (!visit.iceberg)
                continue; // the leg home
            addVisit(text, content, uav, visit, from_m, ++sequence);
            from_m = visit.position_m;
        }
    }
    return text;
}

void writeTrackCsv(const ExportContent& content, const TextSink& put)
{
    // The UAVs of a mission are sampled at the same times, so a row of each is written in turn.
    std::vector<TrackPoints::Iterator> tracks;
    std::vector<std::string> ids;
    for (const ExportUav& uav : content.uavs) {
        tracks.push_back(uav.track.begin());
        ids.push_back(csvField(uav.uav.id));
    }
    std::string text(trajectoryHeader());
    put(text);
    while (!text.empty()) {
        text.clear();
        for (std::size_t i = 0; i < ids.size(); ++i) {
            if (tracks[i] == std::default_sentinel)
                continue;
            appendTrajectoryRow(text, content.frame, ids[i], *tracks[i]);
            ++tracks[i];
        }
        put(text);
    }
}

} // namespace berg
