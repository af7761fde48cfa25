#include "core/link/logs/log_replay.h"
#include "core/link/logs/nmea_log.h"
#include "core/link/tracker_list.h"
#include "tests/support/approx.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using namespace berg;

namespace {

std::string rmc(const char* time)
{
    return nmeaSentence(std::string("GPRMC,") + time +
                        ",A,4700.000,N,04800.000,W,005.0,090.0,020526,,,A");
}

std::string tll(const char* time)
{
    return nmeaSentence(std::string("RATLL,01,4705.000,N,04810.000,W,,") + time + ",T,");
}

std::span<const std::uint8_t> bytesOf(const std::string& text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::vector<double> secondsOf(const std::string& text)
{
    NmeaLogReader reader;
    std::vector<LoggedFrame> frames = reader.feed(bytesOf(text));
    for (LoggedFrame& frame : reader.finish())
        frames.push_back(std::move(frame));
    std::vector<double> times;
    for (const LoggedFrame& frame : frames)
        times.push_back(static_cast<double>(frame.unix_us - frames.front().unix_us) / 1e6);
    return times;
}

} // namespace

class TestNmeaLog : public QObject
{
    Q_OBJECT

private slots:
    void logsAreRecognised()
    {
        QVERIFY(isNmeaLog(rmc("120000")));
        QVERIFY(isNmeaLog("# comment\n\\s:x*0\\" + rmc("120000")));
        QVERIFY(isNmeaLog("!AIVDM,1,1,,B,15M67FC000G?ufbE`FepT@3n00Sa,0*5C"));
        for (const char* text : {"", "$", "$GPGGA", "id,time,lat,lon\n1,2,3,4\n", "{}", "$$$$$*00",
                                 "$GPRMC,120000,A*00\n"})
            QVERIFY2(!isNmeaLog(text), text);
        QVERIFY(!isNmeaLog(std::string("\0\0\0\0", 4) + rmc("120000")));
    }

    void linesHaveTheTimeOfTheLog()
    {
        QCOMPARE(secondsOf(tll("115959") + rmc("120000") + tll("120001") + rmc("120005") + "x\n"),
                 (std::vector<double>{0, 0, 0, 5, 5}));
        // Without a date, by the time of day; without any time, by the number of lines.
        const std::string gga = ",4700.0,N,04800.0,W,1,08,0.9,9,M,0,M,,";
        QCOMPARE(secondsOf(nmeaSentence("GPGGA,120000" + gga) + tll("120001") +
                           nmeaSentence("GPGGA,120007" + gga)),
                 (std::vector<double>{0, 0, 7}));
        QCOMPARE(secondsOf(nmeaSentence("HEHDT,1,T") + nmeaSentence("HEHDT,2,T")),
                 (std::vector<double>{0, 0.1}));
    }

    /** Each line is received at its time, and the tracker and its radar are heard. */
    void logIsPlayed()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("radar.log"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        std::string text;
        for (const char* time : {"120000", "120010", "120020", "120030"})
            text += rmc(time) + tll(time);
        file.write((text + "broken\n").c_str());
        file.close();
        auto opened = LogReplay::open(path.toStdString());
        auto* const replay = std::get_if<std::unique_ptr<LogReplay>>(&opened);
        QVERIFY(replay != nullptr);
        TrackerLink link(**replay);
        const auto heard = [&link] {
            while (link.receive()) {
            }
            return std::pair(link.takeFixes().size(), link.takeTargets().size());
        };
        QCOMPARE(heard(), std::pair(std::size_t{1}, std::size_t{1}));
        (*replay)->advance(9.5);
        QCOMPARE(heard(), std::pair(std::size_t{0}, std::size_t{0}));
        (*replay)->advance(1);
        QCOMPARE(heard(), std::pair(std::size_t{1}, std::size_t{1}));
        (*replay)->advance(100);
        QCOMPARE(heard(), std::pair(std::size_t{2}, std::size_t{2}));
        QVERIFY((*replay)->isAtEnd());
        QCOMPARE((*replay)->part(), 1.0);
        QCOMPARE((*replay)->played_s(), 30.0);
        QCOMPARE((*replay)->skipped_bytes(), std::uint64_t{7});
    }
};

QTEST_APPLESS_MAIN(TestNmeaLog)
#include "tst_nmea_log.moc"
