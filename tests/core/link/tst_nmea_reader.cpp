#include "core/base/random.h"
#include "core/link/nmea_reader.h"
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
        row("AIS", "!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C\r\n", "other");
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
