#include "core/io/import/photo_yield.h"

#include "core/base/stopped.h"
#include "core/earth/geodesy.h"
#include "core/io/import/receivers/receiver_readers.h"
#include "core/io/text/json_writer.h"
#include "core/mission/mission_instant.h"
#include "core/tracking/position_error.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace berg {

namespace {

constexpr double kGroupTime_s = 600;
constexpr double kWithoutRun_m = 424; ///< half the diagonal of the usual field of view

double secondsBetween(UtcTime from, UtcTime to)
{
    return std::chrono::duration<double>(to - from).count();
}

/** Places photographs and finds their icebergs, in the order of their times. */
class PhotoReading
{
public:
    explicit PhotoReading(const PhotoRun& run) : m_run(run)
    {
        if (run.mission == nullptr)
            return;
        const Scenario& scenario = run.mission->scenario();
        m_frame = LocalFrame(scenario.origin);
        m_start = parseUtc(scenario.startUtc);
        if (const std::size_t row = run.uav.value_or(0); row < scenario.uavs.size())
            m_reach_m = scenario.uavs[row].fov_m.norm() / 2;
        for (const Iceberg& iceberg : run.mission->icebergs())
            m_taken.insert(iceberg.id);
    }

    /** Adds a photograph; `line` is its number. */
    void add(const Photo& photo, std::size_t line)
    {
        ++m_yield.photos;
        PlacedPhoto placed{.name = photo.name,
                           .line = line,
                           .time = photo.data.time,
                           .direction_deg = photo.data.direction_deg};
        const std::optional<double> flight_s = flightTime(photo.data);
        if (photo.data.place) {
            ++m_yield.positioned;
            placed.place = *photo.data.place;
        } else if (flight_s) {
            ++m_yield.onTrack;
            placed.isOnTrack = true;
            placed.place = m_frame.toGeographic(trackPoint_m(*flight_s));
        } else {
            const bool isOutside = photo.data.time && m_run.mission != nullptr && m_start;
            m_yield.table.rejected.add(
                {.line = line,
                 .fault = isOutside ? IssueId::PhotoNotInFlight : IssueId::PhotoNoPlace,
                 .detail = photo.name});
            return;
        }
        findIceberg(placed, flight_s);
        m_yield.table.sightings.push_back(
            {.line = line, .id = placed.iceberg, .time = placed.time, .place = placed.place});
        m_yield.placed.push_back(std::move(placed));
    }

    PhotoYield take()
    {
        m_yield.table.format = "photo";
        m_yield.table.rejected.place = m_yield.table.noted.place = "photograph";
        m_yield.table.positionSd_m = errorOf(SightingSource::Camera).sd_m;
        return std::move(m_yield);
    }

private:
    /** Returns the run time of a photograph; nullopt if it is outside the flight. */
    [[nodiscard]] std::optional<double> flightTime(const PhotoData& data) const
    {
        if (m_run.mission == nullptr || !m_start || !data.time)
            return std::nullopt;
        const double time_s = secondsBetween(*m_start, *data.time);
        const double slack_s = m_run.mission->options().sampleInterval_s;
        const bool isFlown =
            time_s >= -slack_s && time_s <= m_run.mission->simulation().time_s() + slack_s;
        return isFlown ? std::optional(time_s) : std::nullopt;
    }

    /** Returns the position of the UAV at the recorded instant nearest to the time. */
    [[nodiscard]] Point trackPoint_m(double time_s) const
    {
        const std::vector<Sample>& samples = m_run.mission->recorder().samples();
        const auto after = std::ranges::lower_bound(samples, time_s, {}, &Sample::time_s);
        auto nearest = after == samples.end() ? std::prev(after) : after;
        if (after != samples.begin() && after != samples.end() &&
            time_s - std::prev(after)->time_s < after->time_s - time_s)
            nearest = std::prev(after);
        return nearest->uavs.at(m_run.uav.value_or(0)).pose.position_m;
    }

    void findIceberg(PlacedPhoto& placed, std::optional<double> flight_s)
    {
        if (flight_s) {
            const Simulation simulation = instantAt(*m_run.mission, *flight_s).simulation;
            const Point place_m = m_frame.toPlane(placed.place);
            double nearest_m = HUGE_VAL;
            for (const IcebergIndex i : simulation.icebergs()) {
                if (!simulation.active(i))
                    continue;
                const Track& track = simulation.track(i);
                const double distance_m = (track.estimate_m(simulation.time_s()) - place_m).norm();
                if (distance_m > m_reach_m + radius95_m(track.sigma_m2) || distance_m >= nearest_m)
                    continue;
                nearest_m = distance_m;
                placed.iceberg = m_run.mission->icebergs()[toIndex(i)].id;
            }
        }
        if (!placed.iceberg.empty()) {
            ++m_yield.near;
            return;
        }
        ++m_yield.fresh;
        placed.isNew = true;
        placed.iceberg = newIcebergOf(placed);
    }

    /** Returns the id of the new iceberg that the photograph shows, with those shortly before. */
    [[nodiscard]] std::string newIcebergOf(const PlacedPhoto& placed)
    {
        const LocalFrame around(placed.place);
        for (auto other = m_yield.placed.rbegin(); other != m_yield.placed.rend(); ++other) {
            if (!other->isNew || !other->time || !placed.time ||
                std::abs(secondsBetween(*other->time, *placed.time)) > kGroupTime_s)
                continue;
            if (around.toPlane(other->place).norm() <= m_reach_m)
                return other->iceberg;
        }
        std::string id;
        do
            id = "photo " + std::to_string(++m_number);
        while (m_taken.contains(id));
        ++m_yield.newIcebergs;
        return id;
    }

    PhotoRun m_run;
    LocalFrame m_frame{LatLon{}};
    std::optional<UtcTime> m_start;
    double m_reach_m = kWithoutRun_m;
    std::set<std::string> m_taken;
    std::size_t m_number = 0;
    PhotoYield m_yield;
};

} // namespace

PhotoYield photoYield(std::span<const Photo> photos, const PhotoRun& run,
                      const std::stop_token& stop)
{
    std::vector<std::size_t> order(photos.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return photos[i].data.time; });
    PhotoReading reading(run);
    for (const std::size_t i : order) {
        throwIfStopped(stop);
        reading.add(photos[i], i + 1);
    }
    return reading.take();
}

std::string photoYieldJson(const PhotoYield& yield)
{
    std::vector<std::string> placed;
    for (const PlacedPhoto& photo : yield.placed) {
        JsonObject object;
        object.add("file", photo.name);
        object.add("latitude_deg", photo.place.latitude_deg);
        object.add("longitude_deg", photo.place.longitude_deg);
        object.add("on_track", photo.isOnTrack);
        if (photo.time)
            object.add("time_utc", utcText(*photo.time, 0));
        if (photo.direction_deg)
            object.add("direction_deg", *photo.direction_deg);
        object.add("iceberg", photo.iceberg);
        object.add("new", photo.isNew);
        placed.push_back(object.inLine());
    }
    JsonObject object;
    object.add("photographs", yield.photos);
    object.add("with_position", yield.positioned);
    object.add("on_track", yield.onTrack);
    object.add("near_iceberg", yield.near);
    object.add("new", yield.fresh);
    object.add("new_icebergs", yield.newIcebergs);
    object.addText("placed", jsonLines(placed, 2));
    return object.inLines(1);
}

bool isPhotograph(std::string_view bytes)
{
    return isPhoto(bytes);
}

} // namespace berg
