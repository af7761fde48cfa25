#pragma once

// GeoJSON, KML, GPX, CZML and missions whose meaning is known by construction.

#include "tests/support/files/known_sightings.h"

namespace berg::test {

/** Writes one file of a format other than a table. */
class ShapeWriter
{
public:
    ShapeWriter(KnownChooser& choose, KnownFile& file) : m_choose(choose), m_file(file)
    {
        m_fixes = 1 + choose.below(4);
        m_step_s = static_cast<std::int64_t>(3600 * (1 + choose.below(6)));
    }

    void geoJson()
    {
        static const std::array<std::string, 8> kIds{"id",    "name", "iceberg", "target",
                                                     "TRACK", "mmsi", "label",   "featureid"};
        static const std::array<std::string, 5> kTimes{"time", "timestamp", "datetime", "observed",
                                                       "when"};
        const bool hasFeatureId = m_choose.once(3);
        const std::string id = m_choose.of(kIds);
        const std::string time = m_choose.of(kTimes);
        const bool isSequence = m_choose.once(6);
        m_file.trait(hasFeatureId ? "ids of features" : "property " + id);
        m_file.trait("time property " + time);
        m_file.idColumn = hasFeatureId ? "" : id;
        m_file.timeColumn = time;
        std::string features;
        forEachPlace([&](const KnownPlace& place) {
            const std::string& name = m_file.bergs[place.berg].id;
            std::string feature = R"({"type":"Feature",)";
            if (hasFeatureId)
                feature += "\"id\":\"" + name + "\",";
            feature += R"("properties":{)";
            if (!hasFeatureId)
                feature += '"' + id + "\":\"" + name + "\",";
            feature += '"' + time + "\":\"" + isoText(*place.time_s) + "\"},\"geometry\":";
            feature +=
                formatted(R"({"type":"Point","coordinates":[%.6f,%.6f%s]}})", place.longitude_deg,
                          place.latitude_deg, m_choose.once(4) ? ",0" : "");
            features += (features.empty() || isSequence ? "" : ",") +
                        std::string(isSequence ? "\x1E" : "") + feature + (isSequence ? "\n" : "");
        });
        if (isSequence)
            m_file.trait("text sequence");
        m_file.bytes =
            isSequence ? features : R"({"type":"FeatureCollection","features":[)" + features + "]}";
        addMark();
    }

    /** Writes one LineString with times for each iceberg. */
    void geoJsonLines()
    {
        std::string features;
        for (std::size_t berg = 0; berg < m_file.bergs.size(); ++berg) {
            std::string places;
            std::string times;
            for (std::size_t fix = 0; fix < m_fixes + 1; ++fix) {
                const KnownPlace place = placeOf(berg, fix, features.empty() ? 1 : berg + 1);
                places += (fix == 0 ? "" : ",") +
                          formatted("[%.6f,%.6f]", place.longitude_deg, place.latitude_deg);
                times += (fix == 0 ? "\"" : ",\"") + isoText(*place.time_s) + '"';
                m_file.places.push_back(place);
            }
            features += (berg == 0 ? "" : ",") +
                        (R"({"type":"Feature","properties":{"name":")" + m_file.bergs[berg].id) +
                        R"(","coordinateProperties":{"times":[)" + times +
                        R"(]}},"geometry":{"type":"LineString","coordinates":[)" + places + "]}}";
        }
        m_file.bytes = R"({"type":"FeatureCollection","features":[)" + features + "]}";
    }

    void kmlPlacemarks()
    {
        const std::string p = m_choose.once(5) ? "kml:" : "";
        const std::size_t idBy = m_choose.below(3);
        m_file.trait(formatted("id of KML %zu", idBy));
        if (!p.empty())
            m_file.trait("prefix");
        std::string marks;
        forEachPlace([&](const KnownPlace& place) {
            const std::string& id = m_file.bergs[place.berg].id;
            const std::string blank = m_choose.once(6) ? " \n " : "";
            std::string mark = "<" + p + "Placemark>";
            mark += "<" + p + "name>" + (idBy == 0 ? id : "Sighting") + "</" + p + "name>";
            if (idBy == 1)
                mark += "<" + p + "ExtendedData><" + p + "Data name=\"id\"><" + p + "value>" + id +
                        "</" + p + "value></" + p + "Data></" + p + "ExtendedData>";
            if (idBy == 2)
                mark += "<" + p + "ExtendedData><" + p + "Data name=\"IMEI\"><" + p + "value>" +
                        id + "</" + p + "value></" + p + "Data></" + p + "ExtendedData>";
            mark += "<" + p + "TimeStamp><" + p + "when>" + isoText(*place.time_s) + "</" + p +
                    "when></" + p + "TimeStamp><" + p + "Point><" + p + "coordinates>" + blank +
                    formatted("%.6f,%.6f", place.longitude_deg, place.latitude_deg) + blank + "</" +
                    p + "coordinates></" + p + "Point></" + p + "Placemark>\n";
            marks += mark;
        });
        const std::string space = p.empty() ? "xmlns" : "xmlns:kml";
        m_file.bytes = R"(<?xml version="1.0" encoding="UTF-8"?><)" + p + "kml " + space +
                       R"(="http://www.opengis.net/kml/2.2"><)" + p + "Document>" + marks + "</" +
                       p + "Document></" + p + "kml>";
    }

    void kmlTracks()
    {
        const bool isMulti = m_choose.once(3);
        const std::string apart = m_choose.once(4) ? "  " : " ";
        std::string marks;
        for (std::size_t berg = 0; berg < m_file.bergs.size(); ++berg) {
            marks += "<Placemark><name>" + m_file.bergs[berg].id + "</name>";
            marks += isMulti ? "<gx:MultiTrack><gx:Track>" : "<gx:Track>";
            std::string coords;
            for (std::size_t fix = 0; fix < m_fixes + 1; ++fix) {
                const KnownPlace place = placeOf(berg, fix, berg + 1);
                if (isMulti && fix > 0 && fix % 2 == 0) {
                    marks += coords + "</gx:Track><gx:Track>";
                    coords.clear();
                }
                marks += "<when>" + isoText(*place.time_s) + "</when>";
                coords += "<gx:coord>" + formatted("%.6f", place.longitude_deg) + apart +
                          formatted("%.6f", place.latitude_deg) + apart + "0</gx:coord>";
                m_file.places.push_back(place);
            }
            marks += coords + (isMulti ? "</gx:Track></gx:MultiTrack>" : "</gx:Track>");
            marks += "</Placemark>\n";
        }
        if (isMulti)
            m_file.trait("MultiTrack");
        if (apart.size() > 1)
            m_file.trait("two blanks");
        m_file.bytes = R"(<kml xmlns="http://www.opengis.net/kml/2.2" )"
                       R"(xmlns:gx="http://www.google.com/kml/ext/2.2"><Document>)" +
                       marks + "</Document></kml>";
    }

    void gpx()
    {
        const bool hasTracks = m_choose.once(2);
        const bool isPrefixed = m_choose.once(6);
        const std::string p = isPrefixed ? "g:" : "";
        if (isPrefixed)
            m_file.trait("prefix");
        m_file.trait(hasTracks ? "tracks" : "waypoints");
        const auto point = [&](const std::string& tag, const KnownPlace& place,
                               const std::string& name) {
            return "<" + p + tag +
                   formatted(" lat=\"%.6f\" lon=\"%.6f\">", place.latitude_deg,
                             place.longitude_deg) +
                   "<" + p + "time>" + timeOf(*place.time_s) + "</" + p + "time>" +
                   (name.empty() ? "" : "<" + p + "name>" + name + "</" + p + "name>") + "</" + p +
                   tag + ">\n";
        };
        std::string body;
        m_file.hasOneName = hasTracks && m_choose.once(4);
        if (m_file.hasOneName)
            m_file.trait("tracks of one name");
        if (hasTracks)
            for (std::size_t berg = 0; berg < m_file.bergs.size(); ++berg) {
                body += "<" + p + "trk><" + p + "name>" +
                        (m_file.hasOneName ? "ACTIVE LOG" : m_file.bergs[berg].id) + "</" + p +
                        "name><" + p + "trkseg>";
                for (std::size_t fix = 0; fix < m_fixes + 1; ++fix) {
                    m_file.places.push_back(placeOf(berg, fix, berg + 1));
                    body += point("trkpt", m_file.places.back(), {});
                }
                body += "</" + p + "trkseg></" + p + "trk>";
            }
        else
            forEachPlace([&](const KnownPlace& place) {
                body += point("wpt", place, m_file.bergs[place.berg].id);
            });
        m_file.bytes = R"(<?xml version="1.0"?><)" + p + R"(gpx version="1.1" creator="x" xmlns)" +
                       (isPrefixed ? ":g" : "") + R"(="http://www.topografix.com/GPX/1/1">)" +
                       body + "</" + p + "gpx>";
    }

    void czml()
    {
        std::string packets = R"([{"id":"document","version":"1.0"})";
        for (std::size_t berg = 0; berg < m_file.bergs.size(); ++berg) {
            const bool bySeconds = m_choose.once(2);
            std::string samples;
            for (std::size_t fix = 0; fix < m_fixes + 1; ++fix) {
                const KnownPlace place = placeOf(berg, fix, berg + 2);
                const std::string time =
                    bySeconds
                        ? formatted("%lld", static_cast<long long>(*place.time_s - m_file.start_s))
                        : '"' + isoText(*place.time_s) + '"';
                samples += (fix == 0 ? "" : ",") + time +
                           formatted(",%.6f,%.6f,0", place.longitude_deg, place.latitude_deg);
                m_file.places.push_back(place);
            }
            packets += R"(,{"id":"p)" + std::to_string(berg) + R"(","name":")" +
                       m_file.bergs[berg].id + R"(","position":{"epoch":")" +
                       isoText(m_file.start_s) + R"(","cartographicDegrees":[)" + samples + "]}}";
        }
        m_file.bytes = packets + "]";
    }

    /** Writes places without times or names: each is an iceberg. */
    void mission()
    {
        const bool isPlan = m_choose.once(2);
        m_file.trait(isPlan ? "plan" : "wpl");
        m_file.hasIds = false;
        std::string items;
        int number = 0;
        for (std::size_t berg = 0; berg < m_file.bergs.size(); ++berg) {
            KnownPlace place = placeOf(berg, 0, berg + 1);
            place.time_s.reset();
            ++number;
            if (isPlan)
                items += (number == 1 ? "" : ",") +
                         formatted(R"({"type":"SimpleItem","autoContinue":true,"command":16,)"
                                   R"("doJumpId":%d,"frame":3,"params":[0,0,0,null,%.7f,%.7f,60]})",
                                   number, place.latitude_deg, place.longitude_deg);
            else
                items += formatted("%d\t0\t3\t16\t0\t0\t0\t0\t%.7f\t%.7f\t60\t1\n", number,
                                   place.latitude_deg, place.longitude_deg);
            m_file.places.push_back(place);
        }
        const KnownPlace home = knownPlaceAt(m_file, 0, m_file.start_s);
        m_file.bytes =
            isPlan
                ? R"({"fileType":"Plan","groundStation":"QGroundControl","version":1,)"
                  R"("geoFence":{"version":2},"rallyPoints":{"version":2,"points":[]},"mission":)"
                  R"({"version":2,"vehicleType":2,"cruiseSpeed":15,"hoverSpeed":5,)" +
                      formatted(R"("plannedHomePosition":[%.7f,%.7f,0],)", home.latitude_deg + 0.01,
                                home.longitude_deg) +
                      R"("items":[)" + items + "]}}"
                : "QGC WPL 110\n" +
                      formatted("0\t1\t0\t16\t0\t0\t0\t0\t%.7f\t%.7f\t0\t1\n",
                                home.latitude_deg + 0.01, home.longitude_deg) +
                      items;
    }

private:
    KnownPlace placeOf(std::size_t berg, std::size_t fix, std::size_t row)
    {
        KnownPlace place =
            knownPlaceAt(m_file, berg, m_file.start_s + static_cast<std::int64_t>(fix) * m_step_s);
        place.row = row;
        return place;
    }

    /** Calls `use` for each fix, sometimes with an additional impossible place. */
    template <class Use>
    void forEachPlace(const Use& use)
    {
        std::size_t row = 0;
        for (std::size_t fix = 0; fix < m_fixes; ++fix)
            for (std::size_t berg = 0; berg < m_file.bergs.size(); ++berg) {
                m_file.places.push_back(placeOf(berg, fix, ++row));
                use(m_file.places.back());
                if (!m_choose.once(15))
                    continue;
                KnownPlace odd = placeOf(berg, fix, ++row);
                odd.isGood = false;
                const bool isZero = m_choose.once(2);
                odd.latitude_deg = isZero ? 0 : odd.latitude_deg > 0 ? -40 : 40;
                odd.longitude_deg = isZero ? 0 : 100;
                m_file.trait(isZero ? "place at 0 0" : "place far away");
                m_file.places.push_back(odd);
                use(m_file.places.back());
            }
    }

    std::string timeOf(std::int64_t time_s)
    {
        const Calendar c = calendarOf(time_s + 2 * 3600);
        return m_choose.once(5) ? formatted("%04d-%02d-%02dT%02d:%02d:%02d.000+02:00", c.year,
                                            c.month, c.day, c.hour, c.minute, c.second)
                                : isoText(time_s);
    }

    void addMark()
    {
        if (!m_choose.once(8))
            return;
        m_file.trait("byte order mark");
        m_file.bytes = "\xEF\xBB\xBF" + m_file.bytes;
    }

    KnownChooser& m_choose;
    KnownFile& m_file;
    std::size_t m_fixes = 1;
    std::int64_t m_step_s = 3600;
};

} // namespace berg::test
