#include "core/base/error.h"
#include "core/base/stopped.h"
#include "core/io/import/maps/map_shapes.h"
#include "tests/support/files/export_text.h"

#include <QtTest>

#include <algorithm>

using namespace berg;
using Kind = MapShape::Kind;

namespace {

/** Replaces apostrophes by quotation marks. */
std::string json(std::string text)
{
    std::ranges::replace(text, '\'', '"');
    return text;
}

std::vector<MapShape> shapesOf(std::string_view text)
{
    return readMapShapes(text, "chart");
}

std::string feature(const std::string& geometry, const std::string& properties = "{}")
{
    return json("{'type': 'Feature', 'properties': " + properties + ", 'geometry': " + geometry +
                "}");
}

std::string collection(const std::string& features)
{
    return json("{'type': 'FeatureCollection', 'features': [" + features + "]}");
}

constexpr const char* kSquare =
    "{'type': 'Polygon', 'coordinates': [[[-50, 60], [-49, 60], [-49, 61], [-50, 60]]]}";

constexpr const char* kPlace = "{'type': 'Point', 'coordinates': [-49, 60]}";

std::string kml(const std::string& content)
{
    return "<?xml version=\"1.0\"?><kml><Document>" + content + "</Document></kml>";
}

constexpr const char* kRing = "<Polygon><outerBoundaryIs><LinearRing><coordinates>"
                              "-50,60,0 -49,60,0 -49,61,0 -50,60,0"
                              "</coordinates></LinearRing></outerBoundaryIs>"
                              "<innerBoundaryIs><LinearRing><coordinates>"
                              "-49.5,60.1 -49.4,60.1 -49.4,60.2 -49.5,60.1"
                              "</coordinates></LinearRing></innerBoundaryIs></Polygon>";

} // namespace

/** Tests of the shapes of map program files. */
class TestMapShapes : public QObject
{
    Q_OBJECT

private slots:
    void everyGeometryOfGeoJsonIsRead()
    {
        const auto shapes = shapesOf(collection(
            feature("{'type': 'Point', 'coordinates': [-50, 60]}", "{'name': 'Nuuk'}") + "," +
            feature("{'type': 'MultiPoint', 'coordinates': [[-50, 60], [-51, 61]]}") + "," +
            feature("{'type': 'LineString', 'coordinates': [[-50, 60], [-51, 61]]}") + "," +
            feature("{'type': 'MultiLineString', 'coordinates': [[[1, 2], [3, 4]], [[5, 6], [7, "
                    "8]]]}") +
            "," + feature(kSquare) + "," +
            feature(
                "{'type': 'MultiPolygon', 'coordinates': [[[[1, 2], [3, 4], [5, 6], [1, 2]]]]}") +
            "," +
            feature("{'type': 'GeometryCollection', 'geometries': [" + std::string(kSquare) +
                    "]}")));
        QCOMPARE(shapes.size(), std::size_t{9});
        QVERIFY(shapes[0].kind == Kind::Place);
        QCOMPARE(shapes[0].name, std::string("Nuuk"));
        QVERIFY((shapes[0].parts.front().front() == LatLon{60, -50}));
        QVERIFY(shapes[3].kind == Kind::Line);
        QVERIFY(shapes[6].kind == Kind::Polygon);
        QCOMPARE(shapes[6].parts.front().size(), std::size_t{4});
        QVERIFY(shapes[8].kind == Kind::Polygon);
        QCOMPARE(shapesOf(json(kSquare)).size(), std::size_t{1}); // a geometry by itself
    }

    /** One invalid place removes its shape, not the file. */
    void invalidPlacesAreLeftOut()
    {
        const auto shapes = shapesOf(
            collection(feature("{'type': 'LineString', 'coordinates': [[-50, 60], [-51, 95]]}") +
                       "," + feature("{'type': 'LineString', 'coordinates': [['a'], 3]}") + "," +
                       feature("null") + ", 7, " + feature(kSquare)));
        QCOMPARE(shapes.size(), std::size_t{1});
    }

    void coloursOfIceAndSimplestyleAreRead_data()
    {
        QTest::addColumn<QByteArray>("properties");
        QTest::addColumn<quint32>("fill");
        QTest::newRow("simplestyle")
            << QByteArray("{'fill': '#102030', 'fill-opacity': 0.5}") << 0x80102030U;
        QTest::newRow("ice free") << QByteArray("{'CT': '00'}") << 0x990064FFU;
        QTest::newRow("ice free by its own code") << QByteArray("{'CT': '55'}") << 0x990064FFU;
        QTest::newRow("open water") << QByteArray("{'CT': '01'}") << 0x9996C8FFU;
        QTest::newRow("1 to 3 tenths") << QByteArray("{'CT': 13}") << 0x998CFFA0U;
        QTest::newRow("5 tenths") << QByteArray("{'CT': 50}") << 0x99FFFF00U;
        QTest::newRow("7 to 8 tenths") << QByteArray("{'CT': '78'}") << 0x99FF7D07U;
        QTest::newRow("10 tenths") << QByteArray("{'CT': '92'}") << 0x99FF0000U;
        QTest::newRow("fast ice") << QByteArray("{'CT': '92', 'FA': '08'}") << 0x99969696U;
    }

    void coloursOfIceAndSimplestyleAreRead()
    {
        QFETCH(QByteArray, properties);
        QFETCH(quint32, fill);
        const auto shapes = shapesOf(feature(kSquare, properties.toStdString()));
        QVERIFY(shapes.size() == 1 && shapes.front().fill.has_value());
        QCOMPARE(*shapes.front().fill, fill);
    }

    void codesWithoutConcentrationHaveNoColour()
    {
        for (const char* properties : {"{'CT': '99'}", "{'CT': '-9'}", "{'CT': ''}",
                                       "{'fill': 'red'}", "{'fill': '#12345g'}", "{}"})
            QVERIFY(!shapesOf(feature(kSquare, properties)).front().fill);
    }

    /** Styles of the Placemark, by its url, through a style map, and defined after their use. */
    void stylesOfKmlAreResolved()
    {
        const std::string placemark = "<Placemark><name>a</name><styleUrl>#%</styleUrl>";
        const auto with = [&](const std::string& url) {
            std::string text = placemark;
            return text.replace(text.find('%'), 1, url) + kRing + "</Placemark>";
        };
        const auto shapes = shapesOf(
            kml(with("ice") + with("map") + with("none") +
                "<Placemark><Style><PolyStyle><fill>0</fill></PolyStyle></Style>" + kRing +
                "</Placemark><Style id=\"ice\"><LineStyle><color>ff0000ff</color></LineStyle>"
                "<PolyStyle><color>7f00ff00</color></PolyStyle></Style>"
                "<StyleMap id=\"map\"><Pair><key>normal</key><styleUrl>#ice</styleUrl></Pair>"
                "<Pair><key>highlight</key><styleUrl>#none</styleUrl></Pair></StyleMap>"));
        QCOMPARE(shapes.size(), std::size_t{4});
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
            QCOMPARE(shapes[i].fill.value_or(1), 0x7F00FF00U);
            QCOMPARE(shapes[i].line.value_or(1), 0xFFFF0000U); // aabbggrr
            QCOMPARE(shapes[i].parts.size(), std::size_t{2});
        }
        QVERIFY(!shapes[2].fill && !shapes[2].line);
        QCOMPARE(shapes[3].fill.value_or(1), 0U);
    }

    void linesAndPlacesOfKmlAreRead()
    {
        const std::string text =
            kml("<Placemark><name>St. John's</name><Point><coordinates>-52.7,47.5</coordinates>"
                "</Point></Placemark><Placemark><LineString><coordinates>1,2 3,4\n5,6,7"
                "</coordinates></LineString></Placemark><Placemark><Track><coord>1 2 3</coord>"
                "<coord>4 5 6</coord></Track></Placemark>");
        for (const auto& shapes : {shapesOf(text), shapesOf(zipFile("doc.kml", text))}) {
            QCOMPARE(shapes.size(), std::size_t{3});
            QVERIFY(shapes[0].kind == Kind::Place);
            QCOMPARE(shapes[0].name, std::string("St. John's"));
            QCOMPARE(shapes[1].parts.front().size(), std::size_t{3});
            QVERIFY((shapes[2].parts.front().back() == LatLon{5, 4}));
        }
    }

    /** The supported encodings are those of sightings. */
    void packetsOfCzmlAreRead()
    {
        const std::vector<MapShape> shapes = shapesOf(json(
            "[{'id': 'document'}, {'name': 'Limit', 'polygon': {'positions': "
            "{'cartographicDegrees': [-50, 60, 0, -49, 60, 0, -49, 61, 0]}, 'material': "
            "{'solidColor': {'color': {'rgba': [255, 0, 128, 64]}}}, 'outlineColor': {'rgba': "
            "[1, 2, 3, 255]}}}, {'polygon': {'fill': false, 'positions': {'cartographicDegrees': "
            "[-50, 60, 0, -49, 60, 0, -49, 61, 0]}}}, {'polyline': {'positions': "
            "{'cartographicDegrees': [-50, 60, 0, -49, 60, 0]}, 'material': {'solidColor': "
            "{'color': {'rgba': [0, 0, 255, 255]}}}}}, {'position': {'epoch': "
            "'2026-01-01T00:00:00Z', 'cartographicDegrees': [0, -50, 60, 0, 9, -49, 60, 0]}}, "
            "{'name': 'Rig', 'position': {'cartographicDegrees': [-49, 60, 0]}}, {'position': "
            "{'cartographicDegrees': [-49, 95, 0]}}, {'polygon': {'positions': "
            "{'cartographicDegrees': [-50, 60, 0, -49]}}}, {'position': 7}, 7]"));
        QCOMPARE(shapes.size(), std::size_t{5});
        QVERIFY(shapes[0].kind == Kind::Polygon);
        QCOMPARE(shapes[0].parts.front().size(), std::size_t{3});
        QCOMPARE(shapes[0].fill.value_or(0), 0x40FF0080U);
        QCOMPARE(shapes[0].line.value_or(0), 0xFF010203U);
        QCOMPARE(shapes[1].fill.value_or(1), 0U);
        QVERIFY(shapes[2].kind == Kind::Line);
        QCOMPARE(shapes[2].line.value_or(0), 0xFF0000FFU);
        QVERIFY(shapes[3].kind == Kind::Line);
        QCOMPARE(shapes[3].parts.front().size(), std::size_t{2});
        QVERIFY(shapes[4].kind == Kind::Place);
        QCOMPARE(shapes[4].name, std::string("Rig"));
    }

    void otherEncodingsAreRead()
    {
        const auto utf16 = [](const std::string& text) {
            std::string bytes = "\xFF\xFE";
            for (const char c : text)
                (bytes += c) += '\0';
            return bytes;
        };
        const std::string place = "<Placemark><name>Cape</name><Point><coordinates>-52.7,47.5"
                                  "</coordinates></Point></Placemark>";
        for (const std::string& text :
             {utf16(kml(place)), utf16(feature(kPlace, "{'name': 'Cape'}"))}) {
            QCOMPARE(shapesOf(text).size(), std::size_t{1});
            QCOMPARE(shapesOf(text).front().name, std::string("Cape"));
        }
        const std::string windows = feature(kPlace, "{'name': 'Nuuk \xC5'}");
        QCOMPARE(shapesOf(windows).front().name, std::string("Nuuk \xC3\x85"));
    }

    /** A hole without its outline would be painted as an area. */
    void polygonsWithAWrongRingAreLeftOut()
    {
        const auto ring = [](const char* boundary, const char* places) {
            return std::string("<") + boundary + "><LinearRing><coordinates>" + places +
                   "</coordinates></LinearRing></" + boundary + ">";
        };
        const auto count = [&](const char* outer, const char* inner) {
            return shapesOf(kml("<Placemark><Polygon>" + ring("outerBoundaryIs", outer) +
                                ring("innerBoundaryIs", inner) + "</Polygon></Placemark>"))
                .size();
        };
        QCOMPARE(count("0,0 9,0 9,9", "3,2 4,2 4,3"), std::size_t{1});
        QCOMPARE(count("0,0 9,0 9,95", "3,2 4,2 4,3"), std::size_t{0});
        QCOMPARE(count("0,0 9,0 9,9", "3,2 4,2 4,95"), std::size_t{0});
    }

    void otherFilesAreRejected()
    {
        for (const std::string text : {"", "a,b\n1,2\n", "{\"x\": 1}", "<gpx></gpx>", "\xFF\xFE"})
            QVERIFY_THROWS_EXCEPTION(Error, static_cast<void>(shapesOf(text)));
        QVERIFY_THROWS_EXCEPTION(Error, static_cast<void>(shapesOf("{\"coordinates\": [")));
        QVERIFY_THROWS_EXCEPTION(Error, static_cast<void>(shapesOf("[{\"id\": \"document\"}, {")));
        std::stop_source stop;
        stop.request_stop();
        QVERIFY_THROWS_EXCEPTION(
            Stopped, static_cast<void>(readMapShapes(feature(kSquare), "chart", stop.get_token())));
    }
};

QTEST_APPLESS_MAIN(TestMapShapes)
#include "tst_map_shapes.moc"
