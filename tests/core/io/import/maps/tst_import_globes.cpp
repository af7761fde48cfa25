#include "core/io/import/fields/import_source.h"
#include "tests/support/expect_error.h"
#include "tests/support/files/export_text.h"
#include "tests/support/files/import_fixtures.h"
#include "tests/support/files/stored_zip.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;
using namespace Qt::StringLiterals;

namespace {

std::string placemark(const std::string& name, const std::string& geometry)
{
    return "<Placemark><name>" + name + "</name>" + geometry + "</Placemark>";
}

std::string pointAt(const std::string& coordinates)
{
    return "<Point><coordinates>" + coordinates + "</coordinates></Point>";
}

std::string document(const std::string& content)
{
    return "<kml><Document>" + content + "</Document></kml>";
}

std::string link(const std::string& href)
{
    return "<NetworkLink><Link><href>" + href + "</href></Link></NetworkLink>";
}

std::string messageOf(const std::string& text)
{
    const std::optional<Error> error = errorOf([&] { (void)readText(text); });
    return error ? error->what() : "nothing";
}

/** Returns ASCII text as UTF-16. */
std::string utf16(const std::string& text, bool highFirst)
{
    std::string wide;
    for (const char c : text)
        wide += highFirst ? std::string{'\0', c} : std::string{c, '\0'};
    return wide;
}

std::string idsOf(const SightingTable& table)
{
    std::string ids;
    for (const Sighting& sighting : table.sightings)
        ids += (ids.empty() ? "" : ",") + sighting.id;
    return ids;
}

} // namespace

/** Tests of KML, KMZ and GPX as globes, receivers and trackers write them. */
class TestImportGlobes : public QObject
{
    Q_OBJECT

private slots:
    void prefixesAreDropped()
    {
        QCOMPARE(joinedLines(placesOf(readFixture("prefix.kml"))),
                 std::string("B1 47.000000 -48.000000\nB2 47.100000 -48.100000\n"));
        const SightingTable gpx = readFixture("prefix.gpx");
        QCOMPARE(joinedLines(placesOf(gpx)), std::string("W 47.500000 -48.500000\n"
                                                         "T 47.000000 -48.000000\n"
                                                         "T 46.990000 -48.000000\n"));
        QVERIFY(!gpx.sightings[1].speed_mps); // the track is more informative
        // An undeclared prefix, behind a comment longer than any lookahead.
        QCOMPARE(idsOf(readText("<!--" + std::string(10'000, '<') + "-->" +
                                document(placemark("T", "<gx:Track><when>2021-06-05</when>"
                                                        "<gx:coord>1 2 3</gx:coord></gx:Track>")))),
                 std::string("T"));
    }

    void otherRootElementsAreRejected()
    {
        QVERIFY(messageOf("<html><body>&lt;kml&gt;</body></html>").find("no format that") !=
                std::string::npos);
        QVERIFY(messageOf("<kmlx><Placemark/></kmlx>").find("no format that") != std::string::npos);
    }

    void tracksHaveTheirOwnTimes()
    {
        const SightingTable table = readFixture("tracks.kml");
        QCOMPARE(joinedLines(placesOf(table)), std::string("T 47.000000 -48.000000\n"
                                                           "T 46.990000 -48.000000\n"
                                                           "T 46.980000 -48.000000\n"
                                                           "T 46.960000 -48.000000\n"
                                                           "T 2 48.000000 -50.000000\n"));
        QCOMPARE(timeOf(table.sightings[2]), std::string("2021-06-05T14:00:00Z"));
        QCOMPARE(timeOf(table.sightings[3]), std::string("2021-06-05T16:00:00Z"));
        QCOMPARE(englishText(reasonOf(table.rejected.first[0])), std::string("has no time"));
        QCOMPARE(englishText(reasonOf(table.rejected.first[1])), std::string("has no position"));
        QVERIFY(notesAt(table, 10).starts_with("has the name of another track"));
    }

    void surplusTimesAreNoted()
    {
        const SightingTable table = readText(document(placemark(
            "T", "<gx:Track><when>2021-06-05T12:00:00Z</when><when>2021-06-05T13:00:00Z</when>"
                 "<gx:coord>-48 47 0</gx:coord></gx:Track>")));
        QCOMPARE(table.sightings.size(), std::size_t{1});
        QCOMPARE(notesAt(table, 1),
                 std::string("has more times than places: the times left over are not taken: "
                             "\"T\""));
    }

    void polygonsBecomeTheirCentroids()
    {
        const SightingTable table = readFixture("shapes.kml");
        QCOMPARE(joinedLines(placesOf(table)), std::string("outline 47.033929 -48.966071\n"
                                                           "hull 47.500000 -48.500000\n"
                                                           "both 47.250000 -48.250000\n"
                                                           "two 47.100000 -48.100000\n"
                                                           "two 2 47.200000 -48.200000\n"));
        QCOMPARE(timeOf(table.sightings[0]), std::string("2021-06-05T12:00:00Z")); // by the folder
        QCOMPARE(timeOf(table.sightings[4]), std::string("2021-06-05T11:00:00Z"));
        QCOMPARE(table.noted.count, std::size_t{2});
        QCOMPARE(faultAt(table, 11), std::string("is no point"));
        QCOMPARE(faultAt(table, 12), std::string("links to another file, which is not read: import "
                                                 "that file as well: "
                                                 "\"https://example.org/more.kml\""));
    }

    void pointsBesideTracksAreNoted()
    {
        const SightingTable table = readText(document(placemark(
            "T", "<MultiGeometry>" + pointAt("5,5") +
                     "<gx:Track><when>2021-06-05</when><gx:coord>1 2 3</gx:coord></gx:Track>"
                     "</MultiGeometry>")));
        QCOMPARE(joinedLines(placesOf(table)), std::string("T 2.000000 1.000000\n"));
        QCOMPARE(notesAt(table, 1),
                 std::string("has points or areas beside a track: only the track "
                             "is taken: \"T\""));
    }

    void timesOfFoldersApply()
    {
        const auto folder = [](const std::string& time, const std::string& content) {
            return "<Folder>" + time + content + "</Folder>";
        };
        const std::string noon = "<TimeStamp><when>2021-06-05T12:00:00Z</when></TimeStamp>";
        const std::string mark = placemark("B", pointAt("1,2"));
        const SightingTable table = readText(
            document(folder(noon, mark + folder("", mark) +
                                      folder("<TimeSpan><begin>2021-06-05T13:00:00Z</begin><end>"
                                             "2021-06-05T14:00:00Z</end></TimeSpan>",
                                             mark) +
                                      mark) +
                     folder("", mark) + mark));
        QCOMPARE(table.sightings.size(), std::size_t{6});
        const char* const times[] = {"2021-06-05T12:00:00Z",
                                     "2021-06-05T12:00:00Z",
                                     "2021-06-05T13:00:00Z",
                                     "2021-06-05T12:00:00Z",
                                     "none",
                                     "none"};
        for (std::size_t i = 0; i < 6; ++i)
            QCOMPARE(timeOf(table.sightings[i]), std::string(times[i]));
    }

    void holesMoveTheCentroid()
    {
        const auto ring = [](const char* kind, const char* coordinates) {
            return std::string("<") + kind + "><LinearRing><coordinates>" + coordinates +
                   "</coordinates></LinearRing></" + kind + ">";
        };
        const SightingTable table = readText(document(
            placemark("P", "<Polygon>" + ring("outerBoundaryIs", "0,0 4,0 4,4 0,4 0,0") +
                               ring("innerBoundaryIs", "0,2 2,2 2,4 0,4 0,2") + "</Polygon>")));
        QCOMPARE(joinedLines(placesOf(table)), std::string("P 1.666667 2.333333\n"));
    }

    void coordinatesAreReadInEveryNotation_data()
    {
        QTest::addColumn<QString>("coordinates");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* coordinates, const char* place) {
            QTest::newRow(coordinates)
                << QString::fromUtf8(coordinates) << QString::fromUtf8(place);
        };
        row("-48.5,47.5", "47.5 -48.5");
        row("-48.5,47.5,0", "47.5 -48.5");
        row("\n\t -48.5,47.5,0 \n", "47.5 -48.5");
        row("-48.5, 47.5, 0", "47.5 -48.5");
        row("-48.5 , 47.5", "47.5 -48.5");
        row("-48.5,47.5,", "47.5 -48.5");
        row("-48,47,5", "47 -48"); // 5 is a height, unless the file has decimal commas elsewhere
        row("-48,5,47,5,0", "ambiguous");
        row("-48,5,47,5", "ambiguous");
        row("-48,5 47,5", "ambiguous");
        row("-48.5,47.5 -48.6,47.6", "ambiguous");
        row("-48.5", "ambiguous");
        row("-48.5;47.5", "ambiguous");
        row("-48.5,,47.5", "wrong");
        row("", "none");
        row("here", "none");
    }

    void coordinatesAreReadInEveryNotation()
    {
        QFETCH(QString, coordinates);
        QFETCH(QString, place);
        const SightingTable table = readText(document(
            placemark("B", pointAt(coordinates.toStdString())) + placemark("C", pointAt("1,2"))));
        QString found = u"none"_s;
        if (table.sightings.size() == 2)
            found = QString::number(table.sightings[0].place.latitude_deg) + u' ' +
                    QString::number(table.sightings[0].place.longitude_deg);
        else if (table.rejected.first.at(0).fault == IssueId::PlaceAmbiguous)
            found = u"ambiguous"_s;
        else if (table.rejected.first.at(0).fault == IssueId::LatitudeWrong)
            found = u"wrong"_s;
        if (place == u"wrong"_s) // a wrong number, or none
            QCOMPARE(table.sightings.size(), std::size_t{1});
        else
            QCOMPARE(found, place);
    }

    void decimalCommasRejectDoubtfulPlaces()
    {
        const SightingTable table = readFixture("commas.kml");
        QCOMPARE(joinedLines(placesOf(table)), std::string("B3 47.600000 -48.480000\n"));
        QCOMPARE(faultAt(table, 4), std::string("the place can be read in more than one way: "
                                                "decimals follow a point: \"-48,47,47,5,0\""));
        QCOMPARE(faultAt(table, 5), std::string("the place can be read in more than one way: "
                                                "decimals follow a point: \"B2\""));
    }

    void encodingsAreRecognised_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("id");
        const auto row = [](const char* name, const std::string& text, const char* id) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QString::fromUtf8(id);
        };
        const auto declared = [](const char* encoding) {
            return std::string("<?xml version=\"1.0\" encoding=\"") + encoding + "\"?>";
        };
        const std::string utf8 = document(placemark("\xC3\x98rn", pointAt("1,2")));
        const std::string latin = document(placemark("\xD8rn", pointAt("1,2")));
        const char* const id = "\xC3\x98rn";
        row("UTF-8 that declares nothing", utf8, id);
        row("UTF-8 declared Latin-1", declared("ISO-8859-1") + utf8, id);
        row("UTF-8 declared UTF-16", declared("UTF-16") + utf8, id);
        row("UTF-8 with a mark", "\xEF\xBB\xBF" + declared("windows-1252") + utf8, id);
        row("Latin-1", declared("ISO-8859-1") + latin, id);
        row("Latin-1 declared UTF-8", declared("UTF-8") + latin, id);
        row("Latin-1 that declares nothing", latin, id);
        row("Latin-1 declared Windows-1252", declared("Windows-1252") + latin, id);
        const std::string plain = document(placemark("Orn", pointAt("1,2")));
        row("UTF-16, little end first", utf16(declared("UTF-16") + plain, false), "Orn");
        row("UTF-16, big end first", utf16(plain, true), "Orn");
        row("UTF-16 with a mark", "\xFF\xFE" + utf16(declared("UTF-8") + plain, false), "Orn");
        row("UTF-16, beyond the first plane",
            utf16("<kml><Placemark><name>", false) + "\x3C\xD8\xDE\xDF" +
                utf16("</name>" + pointAt("1,2") + "</Placemark></kml>", false),
            "\xF0\x9F\x8F\x9E");
    }

    void encodingsAreRecognised()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, id);
        const SightingTable table = readText(text.toStdString());
        QCOMPARE(QString::fromStdString(table.sightings.at(0).id), id);
        const SightingTable packed = readText(storedZip({{"doc.kml", text.toStdString()}}));
        QCOMPARE(packed.sightings.at(0).id, table.sightings[0].id);
    }

    void unsupportedEncodingsAreRejected()
    {
        QVERIFY(messageOf("<?xml version=\"1.0\" encoding=\"Shift_JIS\"?>" +
                          document(placemark("\x83\x6E", pointAt("1,2"))))
                    .find("unknown encoding") != std::string::npos);
    }

    void documentsOfAnArchiveAreRead()
    {
        const SightingTable table = readFixture("links.kmz");
        QCOMPARE(joinedLines(placesOf(table)), std::string("B1 47.000000 -48.000000\n"
                                                           "B2 47.100000 -48.100000\n"
                                                           "B3 47.200000 -48.200000\n"));
        QCOMPARE(englishText(reasonOf(table.rejected.first.at(0))),
                 std::string("links to another file, which is not read: import that file as well: "
                             "\"doc.kml: layers/none.kml\""));
        QCOMPARE(notesAt(table, 1),
                 std::string("the first document of the archive does not link to this one; it is "
                             "read all the same: \"other.kml\""));
        QCOMPARE(idsOf(readFixture("macos.kmz")), std::string("Main"));
    }

    void linksOfArchivesAreFollowed_data()
    {
        QTest::addColumn<QString>("href");
        QTest::addColumn<bool>("isFollowed");
        for (const char* href : {"a b.kml", "./a b.kml", "a%20b.kml", "../maps/a b.kml",
                                 "a b.kml#berg", "x/../a b.kml", "..\\maps\\a b.kml"})
            QTest::newRow(href) << QString::fromUtf8(href) << true;
        for (const char* href :
             {"", "https://example.org/a b.kml", "file:///etc/passwd", "/a b.kml", "../a b.kml",
              "../../../maps/a b.kml", "a.kml", "a%zzb.kml", "%"})
            QTest::newRow(href) << QString::fromUtf8(href) << false;
    }

    void linksOfArchivesAreFollowed()
    {
        QFETCH(QString, href);
        QFETCH(bool, isFollowed);
        const SightingTable table =
            readText(storedZip({{"maps/doc.kml", document(link(href.toStdString()))},
                                {"maps/a b.kml", document(placemark("B", pointAt("1,2")))}}));
        QCOMPARE(idsOf(table), std::string("B")); // linked or not
        QCOMPARE(table.rejected.count, std::size_t{isFollowed ? 0U : 1U});
        QCOMPARE(table.noted.count, std::size_t{isFollowed ? 0U : 1U});
    }

    /** Cycles end, and one broken document does not affect the others. */
    void everyDocumentIsReadOnce()
    {
        const std::string both = link("doc.kml") + link("a.kml");
        const SightingTable cycle =
            readText(storedZip({{"doc.kml", document(both + placemark("A", pointAt("1,2")))},
                                {"a.kml", document(both + placemark("B", pointAt("1,3")))}}));
        QCOMPARE(idsOf(cycle), std::string("A,B"));
        QCOMPARE(cycle.rejected.count + cycle.noted.count, std::size_t{0});
        const SightingTable table = readText(storedZip(
            {{"broken.kml", "<kml><Placemark>"},
             {"empty.kml", ""},
             {"binary.kml", std::string("\0\1", 2)},
             {"inner.kmz", "PK"},
             {"doc.kml", document(link("broken.kml") + placemark("A", pointAt("1,2")))}}));
        QCOMPARE(idsOf(table), std::string("A"));
        QCOMPARE(table.rejected.count, std::size_t{4});
        QCOMPARE(englishText(reasonOf(table.rejected.first[0])),
                 std::string("a document of the archive cannot be read: \"broken.kml\""));
        QVERIFY(englishText(reasonOf(table.rejected.first[3])).find("inner.kmz") !=
                std::string::npos);
        // Unnamed tracks of two documents are two icebergs.
        const std::string track = document(placemark(
            "", "<gx:Track><when>2021-06-05</when><gx:coord>1 2 3</gx:coord></gx:Track>"));
        const SightingTable tracks = readText(storedZip({{"a.kml", track}, {"b.kml", track}}));
        QVERIFY(tracks.sightings.at(0).id != tracks.sightings.at(1).id);
    }

    void hostileArchivesAreRejected()
    {
        std::vector<StoredEntry> many;
        for (int i = 0; i < 3000; ++i) // each takes 64 kB while it is read
            many.emplace_back(std::to_string(i) + ".kml",
                              document(placemark("B" + std::to_string(i), pointAt("1,2"))));
        QCOMPARE(readText(storedZip(many)).sightings.size(), std::size_t{3000});
        const std::string bomb = messageOf(zipFile("doc.kml", std::string(80'000'000, ' ')));
        QVERIFY2(bomb.starts_with("file: would take more than 50 MB of memory"), bomb.c_str());
        std::string deep = "<kml>";
        for (int i = 0; i < 100; ++i)
            deep += "<Folder>";
        QVERIFY(messageOf(deep).find("deeper than 64") != std::string::npos);
        QVERIFY(messageOf(storedZip({{"a.txt", "x"}})).find("without a file *.kml") !=
                std::string::npos);
        QVERIFY(messageOf(storedZip({{"__MACOSX/._a.kml", "x"}})).find("without a file *.kml") !=
                std::string::npos);
    }

    void tracksOfOneNameAreSeparated()
    {
        const SightingTable table = readFixture("same-name.gpx");
        QCOMPARE(idsOf(table),
                 std::string("ACTIVE LOG,ACTIVE LOG,ACTIVE LOG 2,ACTIVE LOG 2,ACTIVE LOG"));
        QCOMPARE(notesAt(table, 9).substr(0, 29), std::string("has the name of another track"));
        QCOMPARE(table.noted.count, std::size_t{1});
    }

    void reachableTracksAreOneIceberg_data()
    {
        QTest::addColumn<QString>("second");
        QTest::addColumn<QString>("ids");
        const auto point = [](double latitude_deg, const char* time) {
            return u"<trkpt lat='%1' lon='-48'><time>2024-02-28T%2Z</time></trkpt>"_s
                .arg(latitude_deg)
                .arg(QString::fromUtf8(time));
        };
        // The first goes from 47 N to 46.99 N between 12:00 and 13:00; a degree is 111 km.
        QTest::newRow("later, at 0.3 m/s") << point(46.98, "14:00:00") << "T,T,T";
        QTest::newRow("later, at 1.4 m/s") << point(46.945, "14:00:00") << "T,T,T";
        QTest::newRow("later, at 1.7 m/s") << point(46.933, "14:00:00") << "T,T,T 2";
        QTest::newRow("earlier") << point(47.01, "11:00:00") << "T,T,T";
        QTest::newRow("amid") << point(46.995, "12:30:00") << "T,T,T";
        QTest::newRow("amid, beside") << point(47.995, "12:30:00") << "T,T,T 2";
        QTest::newRow("the same again")
            << point(47, "12:00:00") + point(46.99, "13:00:00") << "T,T,T,T";
        QTest::newRow("at one time, elsewhere") << point(46.5, "12:00:00") << "T,T,T 2";
        QTest::newRow("round it") << point(47.01, "11:00:00") + point(46.98, "14:00:00")
                                  << "T,T,T,T";
    }

    void reachableTracksAreOneIceberg()
    {
        QFETCH(QString, second);
        QFETCH(QString, ids);
        const QString track = u"<trk><name>T</name><trkseg>%1</trkseg></trk>"_s;
        const QString first = u"<trkpt lat='47' lon='-48'><time>2024-02-28T12:00:00Z</time></trkpt>"
                              "<trkpt lat='46.99' lon='-48'><time>2024-02-28T13:00:00Z</time>"
                              "</trkpt>"_s;
        const QString text = u"<gpx>"_s + track.arg(first) + track.arg(second) + u"</gpx>"_s;
        QCOMPARE(QString::fromStdString(idsOf(readText(text.toStdString()))), ids);
    }

    /** Comparing each track with each other one would take hours. */
    void manyTracksOfOneNameAreFast()
    {
        std::string text = "<gpx>";
        for (int i = 0; i < 30'000; ++i)
            text += "<trk><name>T</name><trkseg><trkpt lat='" + std::to_string(i * 0.002) +
                    "' lon='0'><time>2024-02-28T12:00:00Z</time></trkpt></trkseg></trk>";
        const SightingTable table = readText(text + "</gpx>");
        QCOMPARE(table.sightings.size(), std::size_t{30'000});
        QCOMPARE(table.sightings.back().id, std::string("T 30000"));
    }

    /** Loggers have extensions of their own, and only Bergwatch's tracks are those of UAVs. */
    void tracksOfLoggersAreIcebergs_data()
    {
        QTest::addColumn<QString>("extensions");
        QTest::newRow("airspeed") << u"<x:airspeed_mps>20</x:airspeed_mps>"_s;
        QTest::newRow("all that a UAV has")
            << u"<x:heading_deg>10</x:heading_deg><x:airspeed_mps>20</x:airspeed_mps>"
               "<x:altitude_m>90</x:altitude_m>"_s;
    }

    void tracksOfLoggersAreIcebergs()
    {
        QFETCH(QString, extensions);
        const QString text =
            u"<gpx creator='BeaconLogger' xmlns:x='urn:x'><trk><name>A68</name><extensions>%1"
            "</extensions><trkseg><trkpt lat='60' lon='-50'><time>2026-05-01T00:00:00Z</time>"
            "</trkpt><trkpt lat='60.01' lon='-50'><time>2026-05-01T06:00:00Z</time></trkpt>"
            "</trkseg></trk></gpx>"_s;
        QCOMPARE(QString::fromStdString(idsOf(readText(text.arg(extensions).toStdString()))),
                 u"A68,A68"_s);
    }

    void waypointsOfOneNameAreSeparated()
    {
        const SightingTable table =
            readText("<gpx><wpt lat='47' lon='-48'><name>berg</name></wpt>"
                     "<wpt lat='48' lon='-48'><name>berg</name></wpt></gpx>");
        const ImportResult result = importSightings(newScenarioForImport("new"), table);
        QCOMPARE(result.scenario.icebergs.size(), std::size_t{2});
    }
};

QTEST_APPLESS_MAIN(TestImportGlobes)
#include "tst_import_globes.moc"
