#include "core/base/stopped.h"
#include "core/io/files/iceberg_json.h"
#include "core/io/files/problem_json.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/import/import_formats.h"
#include "core/io/import/scenario/import_scenario.h"
#include "core/io/study/study_json.h"
#include "tests/support/files/export_text.h"
#include "tests/support/files/import_fixtures.h"

#include <QtTest>

#include <algorithm>
#include <ctime>
#include <pthread.h>
#include <thread>

using namespace berg;
using namespace berg::test;

namespace {

/** Returns JSON for text written with single quotes. */
std::string json(std::string text)
{
    std::ranges::replace(text, '\'', '"');
    return text;
}

constexpr int kRows = 50'000; // their memory is freed first, which takes time as well

std::string csvRow(int i)
{
    return "berg-" + std::to_string(i) + ",47.1234,-48.5678,2021-04-01T00:00:00Z\n";
}

std::string pointRow(int i)
{
    return std::string(i == 0 ? "" : ",") +
           json("{'type':'Feature','geometry':{'type':'Point','coordinates':[-48.5678,47.1234]},"
                "'properties':{'name':'berg-") +
           std::to_string(i) + "\"}}\n";
}

std::string placemark(int i)
{
    return "<Placemark><name>berg-" + std::to_string(i) +
           "</name><Point><coordinates>-48.5678,47.1234</coordinates></Point></Placemark>\n";
}

std::string waypoint(int i)
{
    return "<wpt lat=\"47.1234\" lon=\"-48.5678\"><name>berg-" + std::to_string(i) +
           "</name></wpt>\n";
}

std::string missionItem(int i)
{
    return std::to_string(i) + "\t0\t3\t16\t0\t0\t0\t0\t" + std::to_string(47 + i * 1e-6) +
           "\t-48.5678\t100\t1\n";
}

std::string packet(int i)
{
    return json(",{'id':'berg-") + std::to_string(i) +
           json("','position':{'cartographicDegrees':[-48.5678,47.1234,0]}}");
}

std::string planItem(int i)
{
    return std::string(i == 0 ? "" : ",") +
           json("{'type':'SimpleItem','command':16,'frame':3,'params':[0,0,0,null,") +
           std::to_string(47 + i * 1e-6) + ",-48.5678,100]}";
}

/** Returns an entry of a list of numbers, of which Bergwatch files have thousands. */
std::string entry(int i)
{
    return std::string(i == 0 ? "" : ",") + "[" + std::to_string(i) + ", 0.123456789]";
}

/** Returns a file of many rows. */
std::string large(const std::string& head, std::string (*row)(int), const std::string& tail)
{
    std::string text = head;
    for (int i = 0; i < kRows; ++i)
        text += row(i);
    return text + tail;
}

/** Processor time of the thread, in s. */
double used_s(pthread_t thread)
{
    clockid_t clock{};
    timespec used{};
    if (pthread_getcpuclockid(thread, &clock) != 0 || clock_gettime(clock, &used) != 0)
        qFatal("no clock of the thread");
    return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

/**
 * Returns the work of this thread between a stop request after `after_s` and its end, or nullopt if
 * it ended by itself.
 */
template <class Work>
std::optional<double> workAfterStop_s(double after_s, const Work& work)
{
    std::stop_source source;
    double asked_s = 0;
    const pthread_t self = pthread_self();
    const double begun_s = used_s(self);
    std::jthread other([&](const std::stop_token& ended) {
        while (!ended.stop_requested() && used_s(self) < begun_s + after_s)
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        asked_s = used_s(self);
        source.request_stop();
    });
    try {
        work(source.get_token());
        return std::nullopt;
    } catch (const Error&) { // the file's errors at its end
        return std::nullopt;
    } catch (const Stopped&) {
        const double ended_s = used_s(self);
        other.join();
        return ended_s - asked_s;
    }
}

} // namespace

/** A cancelled import ends soon, however large its file is. */
class TestImportStop : public QObject
{
    Q_OBJECT

private:
    static void checkStops(const std::function<void(const std::stop_token&)>& work)
    {
#ifdef __SANITIZE_THREAD__
        constexpr double kLongest_s = 2;
#else
        constexpr double kLongest_s = 0.2; // the aim is 0.1, but sanitizers are slow
#endif
        double worst_s = 0;
        int stopped = 0;
        for (double after_s = 0.002; after_s < 4; after_s *= 1.5) {
            const std::optional<double> after = workAfterStop_s(after_s, work);
            if (!after)
                break; // it ended before the stop
            worst_s = std::max(worst_s, *after);
            ++stopped;
        }
        qInfo("stopped %d times, within %.1f ms of work", stopped, worst_s * 1e3);
        QVERIFY(stopped > 3);
        QVERIFY2(worst_s < kLongest_s, QByteArray::number(worst_s).constData());
    }

private slots:
    void readingStopsSoon_data()
    {
        QTest::addColumn<QByteArray>("text");
        const auto add = [](const char* name, const std::string& text) {
            QTest::newRow(name) << QByteArray::fromStdString(text);
        };
        add("csv", large("id,latitude,longitude,time\n", csvRow, ""));
        add("geojson", large("{\"type\":\"FeatureCollection\",\"features\":[\n", pointRow, "]}"));
        add("kml", large("<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>\n", placemark,
                         "</Document></kml>"));
        add("gpx", large("<gpx version=\"1.1\" xmlns=\"http://www.topografix.com/GPX/1/1\">\n",
                         waypoint, "</gpx>"));
        add("wpl", large("QGC WPL 110\n", missionItem, ""));
        add("czml", large(json("[{'id':'document'}"), packet, "]"));
        add("plan", large(json("{'fileType':'Plan','groundStation':'','mission':{'items':["),
                          planItem, "]}}"));
        add("kmz",
            zipFile("doc.kml", large("<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>",
                                     placemark, "</Document></kml>")));
    }
    void readingStopsSoon()
    {
        QFETCH(const QByteArray, text);
        checkStops([&](const std::stop_token& stop) {
            (void)readSightings({text.constData(), static_cast<std::size_t>(text.size())}, "file",
                                {}, stop);
        });
    }

    void readingOfOwnFilesStopsSoon_data()
    {
        QTest::addColumn<QByteArray>("format");
        for (const char* format : {"scenario", "run", "study", "problem"})
            QTest::newRow(format) << QByteArray("bergwatch-") + format;
    }
    /** Lists of Bergwatch files are read to the last entry, and unknown members as well. */
    void readingOfOwnFilesStopsSoon()
    {
        QFETCH(const QByteArray, format);
        const std::string list = large("[", entry, "]");
        const std::string text =
            json("{'format': '") + format.toStdString() +
            json("', 'version': 1, 'uavs': [], 'sigma': [0, 1], 'distance_m': ") + list +
            json(", 'taus': ") + list +
            json(", 'icebergs': [{'position_m': [0, 0], 'track': {'time_s': ") + list +
            json(", 'position_m': ") + list + json("}}], 'unknown': ") + list + "}";
        checkStops([&](const std::stop_token& stop) {
            if (format == "bergwatch-scenario")
                (void)scenarioFromJson(text, "file", ScenarioUse::Flying, stop);
            else if (format == "bergwatch-run")
                (void)runFromJson(text, "file", stop);
            else if (format == "bergwatch-study")
                (void)studyFromJson(text, "file", stop);
            else
                (void)problemFromJson(text, "file", stop);
        });
    }

    /** Also covers readers by file name, and texts that are never large. */
    void nothingIsReadOnceStopped()
    {
        std::stop_source source;
        source.request_stop();
        const std::string run = BERG_TEST_DATA "/scenarios/small.bergrun";
        const std::vector<std::function<void(const std::stop_token&)>> readers{
            [&](const std::stop_token& stop) { (void)loadRun(run, stop); },
            [&](const std::stop_token& stop) { (void)loadStudy(run, stop); },
            [](const std::stop_token& stop) { (void)formatOf("{}", "text", stop); },
            [](const std::stop_token& stop) { (void)icebergsFromJson("{}", "text", stop); }};
        for (const auto& read : readers)
            QVERIFY_THROWS_EXCEPTION(Stopped, read(source.get_token()));
    }

    void importStopsSoon()
    {
        const SightingTable table =
            readSightings(large("id,latitude,longitude,time\n", csvRow, ""), "file");
        checkStops([&](const std::stop_token& stop) {
            (void)importSightings(openSea(), table, {}, stop);
        });
    }
};

QTEST_APPLESS_MAIN(TestImportStop)
#include "tst_import_stop.moc"
