#include "core/base/random.h"
#include "core/io/import/fields/import_source.h"
#include "tests/support/files/import_fixtures.h"
#include "tests/support/files/stored_zip.h"

#include <QtTest>

#include <cmath>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

/** An object of a file: an iceberg with a place, or with places at times. */
struct Known
{
    std::string id;
    std::vector<LatLon> places;
    std::vector<std::string> times; ///< if empty, there is one place without a time
};

std::string numberText(double value)
{
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.5f", value);
    return text.data();
}

/** Returns objects of different ids within a degree, drifting slowly. */
std::vector<Known> someObjects(Random& random)
{
    std::vector<Known> objects;
    const LatLon middle{.latitude_deg = -70 + 140 * random.uniform(),
                        .longitude_deg = -179 + 357 * random.uniform()};
    const auto rounded = [](double value) { return std::round(value * 1e5) / 1e5; };
    for (std::uint64_t i = 1 + random.below(8); i > 0; --i) {
        Known object{.id = "B" + std::to_string(i)};
        LatLon place{.latitude_deg = rounded(middle.latitude_deg + random.uniform()),
                     .longitude_deg = rounded(middle.longitude_deg + random.uniform())};
        const std::uint64_t fixes = random.below(3) == 0 ? 1 + random.below(5) : 0;
        object.places.push_back(place);
        for (std::uint64_t hour = 0; hour < fixes; ++hour) {
            if (hour > 0) {
                place.latitude_deg = rounded(place.latitude_deg + 0.005);
                object.places.push_back(place);
            }
            object.times.push_back("2024-06-01T" + std::to_string(10 + hour) + ":00:00Z");
        }
        objects.push_back(std::move(object));
    }
    return objects;
}

/** Writes objects in the style of various programs, chosen at random for each file. */
class Writer
{
public:
    explicit Writer(Random& random) : m_random(random) {}

    std::string geoJson(const std::vector<Known>& objects)
    {
        const bool asMulti = flip();
        const bool asLines = flip();
        std::string text;
        for (const Known& object : objects) {
            std::string properties = R"("note": "x")";
            const std::string first = position(object.places.front());
            std::string geometry = asMulti
                                       ? R"({"type": "MultiPoint", "coordinates": [)" + first + "]}"
                                       : R"({"type": "Point", "coordinates": )" + first + "}";
            if (!asMulti && object.times.empty() && flip())
                geometry = square(object.places.front());
            if (!object.times.empty()) {
                std::string line;
                std::string times;
                for (std::size_t i = 0; i < object.places.size(); ++i) {
                    line += (i > 0 ? "," : "") + position(object.places[i]);
                    times += (i > 0 ? ",\"" : "\"") + object.times[i] + '"';
                }
                geometry = asMulti
                               ? R"({"type": "MultiLineString", "coordinates": [[)" + line + "]]}"
                               : R"({"type": "LineString", "coordinates": [)" + line + "]}";
                properties += R"(, "coordTimes": [)" + (asMulti ? "[" + times + "]" : times) + "]";
            }
            if (flip())
                geometry = R"({"type": "GeometryCollection", "geometries": [)" + geometry + "]}";
            const std::string id = flip()
                                       ? R"("id": ")" + object.id + R"(", "properties": {)"
                                       : R"("properties": {"iceberg_id": ")" + object.id + "\", ";
            const std::string feature =
                R"({"type": "Feature", )" + id + properties + R"(}, "geometry": )" + geometry + "}";
            text += asLines ? (m_isRecords ? "\x1E" : "") + feature + '\n'
                            : (text.empty() ? "" : ",\n") + feature;
        }
        return asLines ? text : R"({"type": "FeatureCollection", "features": [)" + text + "]}";
    }

    std::string kml(const std::vector<Known>& objects)
    {
        const std::string k = flip() ? "kml:" : "";
        const std::string gx = flip() ? "gx:" : k;
        const auto tag = [](const std::string& name, const std::string& content) {
            return '<' + name + '>' + content + "</" + name + '>';
        };
        std::string text;
        for (const Known& object : objects) {
            const std::string place = blank() + numberText(object.places[0].longitude_deg) + ',' +
                                      blank() + numberText(object.places[0].latitude_deg) +
                                      (flip() ? ",0" : "") + blank();
            std::string geometry = tag(k + "Point", tag(k + "coordinates", place));
            if (!object.times.empty())
                geometry = track(object, gx, k);
            else if (flip())
                geometry = tag(k + "MultiGeometry", geometry);
            const std::string name =
                flip() ? tag(k + "name", object.id)
                       : tag(k + "name", "any") +
                             tag(k + "ExtendedData", '<' + k + "Data name=\"iceberg_id\">" +
                                                         tag(k + "value", object.id) + "</" + k +
                                                         "Data>");
            const std::string mark = tag(k + "Placemark", name + geometry);
            text += flip() ? tag(k + "Folder", mark) : mark;
        }
        return '<' + k + "kml xmlns:kml=\"http://www.opengis.net/kml/2.2\">" +
               tag(k + "Document", text) + "</" + k + "kml>";
    }

    std::string kmz(const std::vector<Known>& objects)
    {
        std::vector<StoredEntry> entries{{"__MACOSX/._doc.kml", std::string("\0\1", 2)}};
        std::string links;
        for (std::size_t i = 0; i < objects.size(); ++i) {
            entries.emplace_back("layers/" + std::to_string(i) + ".kml", kml({objects[i]}));
            links += "<NetworkLink><Link><href>layers/" + std::to_string(i) +
                     ".kml</href></Link></NetworkLink>";
        }
        entries.emplace_back("doc.kml", "<kml><Document>" + links + "</Document></kml>");
        return storedZip(entries);
    }

    std::string gpx(const std::vector<Known>& objects)
    {
        const std::string g = flip() ? "g:" : "";
        std::string text;
        for (const Known& object : objects) {
            const auto point = [&](const std::string& kind, std::size_t i, const std::string& in) {
                return '<' + g + kind + " lat=\"" + numberText(object.places[i].latitude_deg) +
                       "\" lon=\"" + numberText(object.places[i].longitude_deg) + "\">" + in +
                       "</" + g + kind + '>';
            };
            const std::string name = '<' + g + "name>" + object.id + "</" + g + "name>";
            if (object.times.empty()) {
                text += point("wpt", 0, name);
                continue;
            }
            text += '<' + g + "trk>" + name + '<' + g + "trkseg>";
            for (std::size_t i = 0; i < object.places.size(); ++i) {
                text += point("trkpt", i, '<' + g + "time>" + object.times[i] + "</" + g + "time>");
                if (flip())
                    text += "</" + g + "trkseg><" + g + "trkseg>";
            }
            text += "</" + g + "trkseg></" + g + "trk>";
        }
        return '<' + g + "gpx version=\"1.1\" xmlns:g=\"http://www.topografix.com/GPX/1/1\">" +
               text + "</" + g + "gpx>";
    }

private:
    bool flip() { return m_random.below(2) == 0; }
    std::string blank() { return std::array{"", " ", "\n", "\t "}[m_random.below(4)]; }

    static std::string position(const LatLon& place)
    {
        return '[' + numberText(place.longitude_deg) + ',' + numberText(place.latitude_deg) + ']';
    }

    /** Returns a square around the place, with one more corner on one of its sides. */
    static std::string square(const LatLon& place)
    {
        const auto at = [&](double east, double north) {
            return position({.latitude_deg = place.latitude_deg + 0.001 * north,
                             .longitude_deg = place.longitude_deg + 0.001 * east});
        };
        return R"({"type": "Polygon", "coordinates": [[)" + at(-1, -1) + ',' + at(1, -1) + ',' +
               at(1, 0) + ',' + at(1, 1) + ',' + at(-1, 1) + ',' + at(-1, -1) + "]]}";
    }

    std::string track(const Known& object, const std::string& gx, const std::string& k)
    {
        const bool isApart = flip();
        std::string whens;
        std::string coords;
        std::string text;
        const auto close = [&] {
            text += '<' + gx + "Track>" + whens + coords + "</" + gx + "Track>";
            whens.clear();
            coords.clear();
        };
        for (std::size_t i = 0; i < object.places.size(); ++i) {
            whens += '<' + k + "when>" + object.times[i] + "</" + k + "when>";
            coords += '<' + gx + "coord>" + numberText(object.places[i].longitude_deg) + "  " +
                      numberText(object.places[i].latitude_deg) + " 0</" + gx + "coord>";
            if (isApart)
                close();
        }
        if (!isApart)
            close();
        return isApart ? '<' + gx + "MultiTrack>" + text + "</" + gx + "MultiTrack>" : text;
    }

    Random& m_random;
    bool m_isRecords = m_random.below(2) == 0;
};

/** Returns the objects in the form of `placesOf`, with times. */
std::vector<std::string> expectedOf(const std::vector<Known>& objects)
{
    std::vector<std::string> rows;
    for (const Known& object : objects)
        for (std::size_t i = 0; i < object.places.size(); ++i)
            rows.push_back(object.id + ' ' + numberText(object.places[i].latitude_deg) + ' ' +
                           numberText(object.places[i].longitude_deg) + ' ' +
                           (object.times.empty() ? "none" : object.times[i]));
    return rows;
}

std::vector<std::string> foundIn(const SightingTable& table)
{
    std::vector<std::string> rows;
    for (const Sighting& sighting : table.sightings)
        rows.push_back(sighting.id + ' ' + numberText(sighting.place.latitude_deg) + ' ' +
                       numberText(sighting.place.longitude_deg) + ' ' + timeOf(sighting));
    return rows;
}

} // namespace

/** Files of a known list of objects, in the styles of many programs, are read as that list. */
class TestImportSiblings : public QObject
{
    Q_OBJECT

private slots:
    void filesGiveTheirObjects_data()
    {
        QTest::addColumn<int>("format");
        int format = 0;
        for (const char* name : {"geojson", "kml", "kmz", "gpx"})
            QTest::newRow(name) << format++;
    }

    void filesGiveTheirObjects()
    {
        QFETCH(int, format);
        constexpr int kFiles = 500;
        for (int seed = 1; seed <= kFiles; ++seed) {
            Random random(static_cast<std::uint64_t>(seed), 49);
            const std::vector<Known> objects = someObjects(random);
            Writer writer(random);
            const std::string text = format == 0   ? writer.geoJson(objects)
                                     : format == 1 ? writer.kml(objects)
                                     : format == 2 ? writer.kmz(objects)
                                                   : writer.gpx(objects);
            const SightingTable table = readText(text);
            QVERIFY2(joinedLines(foundIn(table)) == joinedLines(expectedOf(objects)),
                     qPrintable(u"seed %1\n"_s.arg(seed) +
                                QString::fromStdString(joinedLines(foundIn(table)) + "expected\n" +
                                                       joinedLines(expectedOf(objects)) + text)));
            QCOMPARE(table.rejected.count + table.noted.count, std::size_t{0});
        }
    }
};

QTEST_APPLESS_MAIN(TestImportSiblings)
#include "tst_import_siblings.moc"
