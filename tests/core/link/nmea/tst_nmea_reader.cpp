#include "core/base/random.h"
#include "core/link/nmea/nmea_reader.h"
#include "tests/support/approx.h"

using namespace berg;

namespace {

/** Common examples of NMEA 0183; positions are exact to the last printed digit. */
constexpr std::string_view kGga =
    "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n";
constexpr std::string_view kRmc =
    "$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A\r\n";
constexpr std::string_view kVtg = "$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\n";
constexpr double kExact = 1e-9;

std::vector<NmeaFix> fed(NmeaReader& reader, std::string_view text)
{
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    return reader.feed(bytes);
}

std::vector<NmeaFix> fixesOf(std::string_view text)
{
    NmeaReader reader;
    return fed(reader, text);
}

} // namespace

class TestNmeaReader : public QObject
{
    Q_OBJECT

private slots:
    void positionOfGga()
    {
        const NmeaFix fix = fixesOf(kGga).at(0);
        QCOMPARE(fix.talker, "GP");
        QCOMPARE(fix.sentence, "GGA");
        COMPARE_NEAR(fix.place->latitude_deg, 48.1173, kExact);
        COMPARE_NEAR(fix.place->longitude_deg, 11.0 + 31.0 / 60, kExact);
        QCOMPARE(fix.altitude_m, std::optional(545.4));
        QCOMPARE(fix.timeOfDay_s, std::optional(45319.0));
        QVERIFY(!fix.unix_us && !fix.speed_mps && !fix.course_deg);
    }

    void positionTimeAndVelocityOfRmc()
    {
        const NmeaFix fix = fixesOf(kRmc).at(0);
        COMPARE_NEAR(fix.place->latitude_deg, 48.1173, kExact);
        COMPARE_NEAR(*fix.speed_mps, 22.4 * 1852 / 3600, kExact);
        QCOMPARE(fix.course_deg, std::optional(84.4));
        QCOMPARE(fix.unix_us, std::optional<std::int64_t>(764426119'000'000));
        const NmeaFix south =
            fixesOf(nmeaSentence("AIRMC,235959.00,A,5530.5,S,17959.99,W,0.0,,010726,,,A")).at(0);
        COMPARE_NEAR(south.place->latitude_deg, -55.508333333, kExact);
        COMPARE_NEAR(south.place->longitude_deg, -179.9998333333, kExact);
        QCOMPARE(south.unix_us, std::optional<std::int64_t>(1782950399'000'000));
        QVERIFY(!south.course_deg); // a ship at rest sends no course
    }

    void velocityOfVtg()
    {
        const NmeaFix fix = fixesOf(kVtg).at(0);
        QVERIFY(!fix.place);
        QCOMPARE(fix.course_deg, std::optional(54.7));
        COMPARE_NEAR(*fix.speed_mps, 5.5 * 1852 / 3600, kExact);
    }

    void sentencesThatAreNotUsed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("reason");
        const auto row = [](const char* name, const QByteArray& text, const char* reason) {
            QTest::newRow(name) << text << QByteArray(reason);
        };
        const auto sentence = [](const char* content) {
            return QByteArray::fromStdString(nmeaSentence(content));
        };
        row("wrong checksum",
            QByteArray(kVtg.data(), static_cast<int>(kVtg.size())).replace("*48", "*49"),
            "checksum");
        row("no checksum", "$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K\r\n", "checksum");
        row("no hexadecimal checksum", "$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*zz\r\n", "checksum");
        row("no fix, GGA", sentence("GPGGA,123519,,,,,0,00,,,M,,M,,"), "fix");
        row("no fix, RMC", sentence("GPRMC,123519,V,4807.0,N,01131.0,E,,,230394,,,N"), "fix");
        row("no fix, VTG", sentence("GPVTG,,T,,M,,N,,K,N"), "fix");
        row("91 degrees", sentence("GPGGA,1,9100.0,N,01131.0,E,1,8,1,5,M,4,M,,"), "malformed");
        row("90.5 degrees", sentence("GPGGA,1,9030.0,N,01131.0,E,1,8,1,5,M,4,M,,"), "malformed");
        row("60 minutes", sentence("GPGGA,1,4860.0,N,01131.0,E,1,8,1,5,M,4,M,,"), "malformed");
        row("no hemisphere", sentence("GPGGA,1,4807.0,,01131.0,E,1,8,1,5,M,4,M,,"), "malformed");
        row("hemispheres swapped", sentence("GPGGA,1,4807.0,E,01131.0,N,1,8,1,5,M,4,M,,"),
            "malformed");
        row("letters", sentence("GPGGA,1,48x7.0,N,01131.0,E,1,8,1,5,M,4,M,,"), "malformed");
        row("nan", sentence("GPVTG,1,T,1,M,nan,N,1,K,A"), "malformed");
        row("few fields", sentence("GPRMC,123519,A,4807.0,N"), "malformed");
        row("other sentence", sentence("GPGSV,3,1,11"), "other");
        row("few fields, TLL", sentence("RATLL,01,4700.0,N"), "malformed");
        row("no number, TLL", sentence("RATLL,,4700.0,N,04800.0,W,,120000,T,"), "malformed");
        row("status, TLL", sentence("RATLL,01,4700.0,N,04800.0,W,,120000,X,"), "malformed");
        row("lost target", sentence("RATLL,01,4700.0,N,04800.0,W,,120000,L,"), "fix");
        row("unit, TTM", sentence("RATTM,01,1.0,90.0,T,0,0,T,,,X,,T,,120000,A"), "malformed");
        row("bearing, TTM", sentence("RATTM,01,1.0,361,T,0,0,T,,,N,,T,,120000,A"), "malformed");
        row("parts of AIS", sentence("AIVDM,2,3,1,A,15M67FC000G?ufbE`FepT@3n00Sa,0"), "malformed");
        row("AIS of type 4", sentence("AIVDM,1,1,,A,403OviQuMGCqWrRO9>E6fE700@GO,0"), "other");
        row("text", "hello\r\n", "other");
        row("very long", QByteArray(5000, '$') + "\r\n", "other");
    }

    void sentencesThatAreNotUsed()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, reason);
        NmeaReader reader;
        QVERIFY(fed(reader, text.toStdString()).empty());
        const NmeaCounts& counts = reader.counts();
        QCOMPARE(counts.badChecksums, std::uint64_t{reason == "checksum"});
        QCOMPARE(counts.withoutFix, std::uint64_t{reason == "fix"});
        QCOMPARE(counts.malformed, std::uint64_t{reason == "malformed"});
        QCOMPARE(counts.others, std::uint64_t{reason == "other"});
        QCOMPARE(fed(reader, kVtg).size(), std::size_t{1}); // reading continues
    }

    void fieldsThatCannotBeReadAreLeftOut()
    {
        const NmeaFix fix =
            fixesOf(nmeaSentence("GNRMC,256199,A,4807.0,N,01131.0,E,-3,400,320194,,,A")).at(0);
        QVERIFY(fix.place && !fix.timeOfDay_s && !fix.unix_us && !fix.speed_mps && !fix.course_deg);
    }

    void linesArriveInPiecesAndBehindTags()
    {
        NmeaReader reader;
        std::size_t found = 0;
        const std::string stream = std::string("\\s:x*77\\") + std::string(kGga) + "noise" +
                                   std::string(kRmc) + std::string(kVtg);
        for (char c : stream)
            found += fed(reader, std::string_view(&c, 1)).size();
        QCOMPARE(found, std::size_t{3});
    }

    void radarTargetByPlace()
    {
        NmeaReader reader;
        (void)fed(reader, kRmc); // the date
        (void)fed(reader, nmeaSentence("RATLL,07,4730.000,N,04815.000,W,BERG A,123530.5,T,"));
        const NmeaTarget target = reader.takeTargets().at(0);
        QVERIFY(target.kind == NmeaTarget::Kind::Radar);
        QCOMPARE(target.id, 7U);
        QCOMPARE(target.name, "BERG A");
        COMPARE_NEAR(target.place.latitude_deg, 47.5, kExact);
        COMPARE_NEAR(target.place.longitude_deg, -48.25, kExact);
        QCOMPARE(target.unix_us, std::optional<std::int64_t>(764426130'500'000));
        QCOMPARE(target.line, std::uint64_t{2});
        QVERIFY(reader.takeTargets().empty());
    }

    void radarTargetByBearing_data()
    {
        QTest::addColumn<QByteArray>("bearing");
        QTest::addColumn<QByteArray>("heading");
        QTest::newRow("true") << QByteArray("1.0,090.0,T") << QByteArray("HEHDT,200.0,T");
        QTest::newRow("relative") << QByteArray("1.0,350.0,R") << QByteArray("HEHDT,100.0,T");
        QTest::newRow("relative, THS") << QByteArray("1.0,060.0,R") << QByteArray("HETHS,30.0,A");
        QTest::newRow("kilometres") << QByteArray("1.852,090.0,T,K") << QByteArray("HEHDT,9.0,T");
    }

    /** One nautical mile east of 47 N is 0.02435 degrees of longitude. */
    void radarTargetByBearing()
    {
        QFETCH(QByteArray, bearing);
        QFETCH(QByteArray, heading);
        NmeaReader reader;
        const bool isKm = bearing.endsWith(",K");
        const std::string place =
            bearing.left(bearing.indexOf(",T") > 0 ? bearing.indexOf(",T") + 2 : bearing.size())
                .toStdString();
        (void)fed(reader, nmeaSentence("GPGGA,120000,4700.000,N,04800.000,W,1,08,0.9,9,M,0,M,,"));
        (void)fed(reader, nmeaSentence(heading.toStdString()));
        (void)fed(reader, nmeaSentence("RATTM,03," + place + ",0.5,180.0,T,,," +
                                       (isKm ? "K" : "N") + ",,T,,120010,A"));
        const NmeaTarget target = reader.takeTargets().at(0);
        COMPARE_NEAR(target.place.latitude_deg, 47.0, 1e-5);
        COMPARE_NEAR(target.place.longitude_deg, -48 + 0.02435, 1e-5);
        COMPARE_NEAR(*target.speed_mps, 0.5 * (isKm ? 1000.0 : 1852.0) / 3600, kExact);
        QCOMPARE(target.course_deg, std::optional(180.0));
        QVERIFY(!target.unix_us); // no date in this stream
        QCOMPARE(target.timeOfDay_s, std::optional(43'210.0));
    }

    void bearingNeedsTheShip_data()
    {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<bool>("isPlaced");
        const auto place = [](const char* time) {
            return QByteArray::fromStdString(nmeaSentence(
                std::string("GPGGA,") + time + ",4700.0,N,04800.0,W,1,08,0.9,9,M,0,M,,"));
        };
        const QByteArray heading = QByteArray::fromStdString(nmeaSentence("HEHDT,10.0,T"));
        const QByteArray fault = QByteArray::fromStdString(nmeaSentence("HEHDT,,T"));
        QTest::newRow("nothing") << QByteArray() << false;
        QTest::newRow("place") << place("120000") << false;
        QTest::newRow("heading") << heading << false;
        QTest::newRow("both") << place("120000") + heading << true;
        QTest::newRow("compass fails") << place("120000") + heading + fault << false;
        QTest::newRow("a minute ago") << place("115910") + heading << true;
        QTest::newRow("older") << place("115908") + heading << false;
    }

    void bearingNeedsTheShip()
    {
        QFETCH(QByteArray, before);
        QFETCH(bool, isPlaced);
        NmeaReader reader;
        (void)fed(reader, before.toStdString());
        (void)reader.takeFindings();
        (void)fed(reader, nmeaSentence("RATTM,03,1.0,90.0,R,0.5,180.0,R,,,N,,T,,120010,A"));
        const std::vector<NmeaTarget> targets = reader.takeTargets();
        QCOMPARE(targets.size(), std::size_t{isPlaced});
        QCOMPARE(reader.counts().withoutShip, std::uint64_t{!isPlaced});
        QVERIFY(targets.empty() || !targets[0].speed_mps); // relative to a moving ship
        const std::vector<NmeaFinding> findings = reader.takeFindings();
        QCOMPARE(findings.size(), std::size_t{!isPlaced});
        QVERIFY(isPlaced || findings[0].fault == NmeaFault::NoShip);
    }

    /** Agrees with ggencoder: 366053209 at 37.802118, -122.341618, 219.3 degrees. */
    void shipByAis()
    {
        NmeaReader reader;
        (void)fed(reader, "!AIVDM,1,1,,B,15M67FC000G?ufbE`FepT@3n00Sa,0*5C\r\n");
        const NmeaTarget target = reader.takeTargets().at(0);
        QVERIFY(target.kind == NmeaTarget::Kind::Ship);
        QCOMPARE(target.id, 366'053'209U);
        COMPARE_NEAR(target.place.latitude_deg, 37.802118, 1e-6);
        COMPARE_NEAR(target.place.longitude_deg, -122.341618, 1e-6);
        QCOMPARE(target.speed_mps, std::optional(0.0));
        QCOMPARE(target.course_deg, std::optional(219.3));
        QVERIFY(!target.unix_us);
        QCOMPARE(reader.counts().targets, std::uint64_t{1});
    }

    void partsOfAisAreJoined_data()
    {
        QTest::addColumn<QByteArray>("order");
        QTest::addColumn<int>("broken");
        QTest::newRow("in order") << QByteArray("12") << 0;
        QTest::newRow("reversed") << QByteArray("21") << 2;
        QTest::newRow("first missing") << QByteArray("2") << 1;
        QTest::newRow("second missing") << QByteArray("1") << 1;
        QTest::newRow("first twice") << QByteArray("112") << 1;
        QTest::newRow("second twice") << QByteArray("122") << 1;
    }

    /** The name of a ship (message 5) comes in two sentences. */
    void partsOfAisAreJoined()
    {
        QFETCH(QByteArray, order);
        QFETCH(int, broken);
        const std::array<std::string, 2> parts{
            "!AIVDM,2,1,7,A,57lof8`2F5HeT<eC:204e86373:222222222221@8HQC16Ch0:RA7kAD,0*28\n",
            "!AIVDM,2,2,7,A,PBp888888888880,2*79\n"};
        NmeaReader reader;
        for (const char part : order)
            (void)fed(reader, parts.at(static_cast<std::size_t>(part - '1')));
        (void)reader.finish();
        const std::vector<NmeaFinding> findings = reader.takeFindings();
        QCOMPARE(findings.size(), static_cast<std::size_t>(broken));
        for (const NmeaFinding& finding : findings)
            QVERIFY(finding.fault == NmeaFault::AisPart);
        QCOMPARE(reader.counts().badParts, static_cast<std::uint64_t>(broken));
    }

    void tagBlocksGiveTimes()
    {
        NmeaReader reader;
        const std::string tag = "c:1790000000";
        std::string block = nmeaSentence(tag);
        block = "\\" + block.substr(1, block.size() - 3) + "\\";
        (void)fed(reader, block + "!AIVDM,1,1,,B,15M67FC000G?ufbE`FepT@3n00Sa,0*5C\r\n");
        // The message was sent at second 55 of a minute; 1790000000 is second 20.
        const std::optional<std::int64_t> time_us = reader.takeTargets().at(0).unix_us;
        QVERIFY(time_us && std::abs(*time_us - 1'790'000'000'000'000) <= 30'000'000);
    }

    void findingsNameTheirLines()
    {
        NmeaReader reader;
        (void)fed(reader, std::string(kVtg) + "$GPVTG,1\r\nhello\r\n\r\n" + std::string(kGga) +
                              nmeaSentence("RATLL,a") + std::string(300, 'x') + "\n$cut");
        (void)reader.finish();
        QCOMPARE(reader.takeFindings(), (std::vector<NmeaFinding>{{2, NmeaFault::Checksum},
                                                                  {3, NmeaFault::NoSentence},
                                                                  {6, NmeaFault::Fields},
                                                                  {7, NmeaFault::NoSentence},
                                                                  {8, NmeaFault::NoSentence}}));
    }

    /** Noise causes no crash and gives no position. */
    void noiseGivesNoFix()
    {
        Random random(5);
        NmeaReader reader;
        std::string text;
        for (int i = 0; i < 200'000; ++i)
            text += random.below(30) == 0 ? "\n$GPGGA,"
                                          : std::string(1, static_cast<char>(random.below(256)));
        QVERIFY(fed(reader, text).empty());
        QVERIFY(reader.counts().badChecksums > 1000);
    }
};

QTEST_APPLESS_MAIN(TestNmeaReader)
#include "tst_nmea_reader.moc"
