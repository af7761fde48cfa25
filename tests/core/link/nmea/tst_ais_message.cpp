#include "core/base/random.h"
#include "core/link/nmea/ais_message.h"
#include "tests/support/approx.h"

#include <QTest>

using namespace berg;

namespace {

/** Message 1 of 366053209; agrees with ggencoder. */
constexpr std::string_view kShip = "15M67FC000G?ufbE`FepT@3n00Sa";

} // namespace

class TestAisMessage : public QObject
{
    Q_OBJECT

private slots:
    void positionOfAShip()
    {
        const AisReading reading = aisMessageOf(kShip, 0);
        QVERIFY(reading.outcome == AisOutcome::Read);
        const AisMessage& message = reading.message;
        QCOMPARE(message.type, 1);
        QCOMPARE(message.mmsi, 366'053'209U);
        COMPARE_NEAR(message.place->latitude_deg, 37.802118, 1e-6);
        COMPARE_NEAR(message.place->longitude_deg, -122.341618, 1e-6);
        QCOMPARE(message.speed_mps, std::optional(0.0));
        QCOMPARE(message.course_deg, std::optional(219.3));
        QCOMPARE(message.heading_deg, std::optional(1.0));
    }

    void nameOfAShip()
    {
        const AisReading reading = aisMessageOf(
            "57lof8`2F5HeT<eC:204e86373:222222222221@8HQC16Ch0:RA7kADPBp888888888880", 2);
        QVERIFY(reading.outcome == AisOutcome::Read);
        QCOMPARE(reading.message.mmsi, 525'200'930U);
        QCOMPARE(reading.message.name, std::string("AKRA 102"));
        QVERIFY(!reading.message.place);
    }

    void brokenMessages_data()
    {
        QTest::addColumn<QByteArray>("payload");
        QTest::addColumn<int>("fill");
        QTest::newRow("empty") << QByteArray() << 0;
        QTest::newRow("short") << QByteArray("15M6") << 0;
        QTest::newRow("cut") << QByteArray("15M67FC000G?ufbE`FepT@3n00S") << 0;
        QTest::newRow("fill bits") << QByteArray("15M67FC000G?ufbE`FepT@3n00Sa") << 1;
        QTest::newRow("comma") << QByteArray("15M67FC000G?ufbE`FepT,3n00Sa") << 0;
        QTest::newRow("X") << QByteArray("15M67FC000G?ufbE`FepTX3n00Sa") << 0;
        QTest::newRow("255") << QByteArray("15M67FC000G?ufbE`FepT\xFF"
                                           "3n00Sa")
                             << 0;
    }

    void brokenMessages()
    {
        QFETCH(QByteArray, payload);
        QFETCH(int, fill);
        QVERIFY(aisMessageOf(payload.toStdString(), fill).outcome == AisOutcome::Malformed);
    }

    /** Places of random messages are on Earth, and nothing crashes. */
    void randomPayloads()
    {
        constexpr std::string_view kCharacters =
            "0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVW`abcdefghijklmnopqrstuvw";
        Random random(11);
        int read = 0;
        for (int i = 0; i < 20'000; ++i) {
            std::string payload(random.below(90), '0');
            for (char& c : payload)
                c = kCharacters.at(random.below(kCharacters.size()));
            const AisReading reading = aisMessageOf(payload, static_cast<int>(random.below(6)));
            if (reading.outcome != AisOutcome::Read)
                continue;
            ++read;
            if (const std::optional<LatLon>& place = reading.message.place)
                QVERIFY(std::abs(place->latitude_deg) <= 90 &&
                        std::abs(place->longitude_deg) <= 180);
        }
        QVERIFY(read > 20);
    }

    void namesThatSayIce()
    {
        for (const char* name : {"ICE", "ICEBERG 12", "BERG-7", "N GROWLER", "bergy bit", "FLOE 3"})
            QVERIFY2(saysIce(name), name);
        for (const char* name :
             {"", "NICE", "OFFICE", "ICELAND BUOY", "BERGEN", "POLICE", "SERVICE"})
            QVERIFY2(!saysIce(name), name);
    }
};

QTEST_APPLESS_MAIN(TestAisMessage)
#include "tst_ais_message.moc"
