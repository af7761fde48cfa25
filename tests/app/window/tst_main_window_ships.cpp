#include "core/link/nmea/nmea_reader.h"
#include "core/link/transport/link_clock.h"
#include "core/link/transport/transport_link.h"
#include "core/link/vehicle/vehicle_side.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/window_fixture.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;
using test::WindowFixture;

namespace {

Scenario withAsset()
{
    Scenario scenario = test::emptySea(3600);
    test::addIceberg(scenario, 2000, 500);
    Asset asset;
    asset.position_m = {-500, 800};
    scenario.asset = asset;
    return scenario;
}

/** A port that parallel tests do not share. */
int shipPort(int offset)
{
    return 45'000 + static_cast<int>(QCoreApplication::applicationPid() % 2'000) * 2 + offset;
}

std::string minutesText(double value_deg, int digits)
{
    const double degrees = std::floor(std::abs(value_deg));
    const double minutes = 60 * (std::abs(value_deg) - degrees);
    return QString::asprintf("%0*d%08.5f", digits, static_cast<int>(degrees), minutes)
        .toStdString();
}

/** A tracker that sends its place as NMEA sentences, twice a second. */
class Tracker
{
public:
    Tracker(int port, const LatLon& place)
        : m_link(openLink({.kind = LinkEndpoint::Kind::UdpSend, .port = port})), m_place(place)
    {
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { send(); });
        m_timer.start(500);
    }
    void moveTo(const LatLon& place) { m_place = place; }
    void setRadarTarget(const LatLon& place) { m_target = place; }

private:
    void send()
    {
        static_cast<void>(m_link->receive()); // opens the link
        std::string text =
            nmeaSentence("GPRMC,120000,A," + minutesText(m_place.latitude_deg, 2) + ",N," +
                         minutesText(m_place.longitude_deg, 3) + ",W,0.0,,010126,,");
        if (m_target)
            text += nmeaSentence("RATLL,05," + minutesText(m_target->latitude_deg, 2) + ",N," +
                                 minutesText(m_target->longitude_deg, 3) + ",W,,120000,T,");
        m_link->send(0, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    }

    std::unique_ptr<TransportLink> m_link;
    LatLon m_place;
    std::optional<LatLon> m_target;
    QTimer m_timer;
};

void listenAt(WindowFixture& w, int port)
{
    child<QLineEdit>(w.window(), u"linkAddress"_s).setText(u"udp:127.0.0.1:%1"_s.arg(port));
    child<QPushButton>(w.window(), u"listenButton"_s).click();
}

void chooseRow(WindowFixture& w, const QString& combo, int row)
{
    auto& box = child<QComboBox>(w.window(), combo);
    box.setCurrentIndex(row);
    emit box.activated(row);
}

LatLon placeAt(WindowFixture& w, const Point& place_m)
{
    return LocalFrame(w.scenario().origin).toGeographic(place_m);
}

} // namespace

/** Trackers as the aircraft or the ship. */
class TestMainWindowShips : public QObject
{
    Q_OBJECT

private slots:
    void trackerIsTheAircraft()
    {
        WindowFixture w(withAsset());
        const int port = shipPort(0);
        listenAt(w, port);
        Tracker tracker(port, placeAt(w, {700, 300}));
        const auto& list = child<QTreeWidget>(w.window(), u"aircraftList"_s);
        QVERIFY(w.until([&] { return list.topLevelItemCount() == 1; }));
        QCOMPARE(list.topLevelItem(0)->text(0), u"Tracker 1"_s);
        QCOMPARE(list.topLevelItem(0)->text(1), u"NMEA"_s);
        QVERIFY(w.until([&] { return w.map().live().traffic.size() == 1; })); // a ship until chosen
        QVERIFY(w.map().live().aircraft.empty());
        auto& uav = child<QComboBox>(w.window(), u"aircraftUav"_s);
        QCOMPARE(uav.currentText(), u"No UAV"_s);
        chooseRow(w, u"aircraftUav"_s, uav.findText(u"uav-1"_s));
        QVERIFY(w.until([&] { return w.map().live().aircraft.size() == 1; }));
        QVERIFY(w.map().live().traffic.empty());
        QVERIFY((w.map().live().aircraft.front().position_m - Point(700, 300)).norm() < 1);
        child<QPushButton>(w.window(), u"flyLiveButton"_s).click();
        QVERIFY(w.until([&] { return w.record().now.isLive && w.record().now.time_s > 1; }));
        const Point flown_m = w.record().now.world.uavs.front().pose.position_m;
        QVERIFY((flown_m - Point(700, 300)).norm() < 30);
        QCOMPARE(w.scenario().uavs.front().home_m.value(), Point(0, 0)); // not in mid-air
    }

    void launchAndHomeAreOnTheShip()
    {
        WindowFixture w(withAsset());
        const int port = shipPort(1);
        listenAt(w, port);
        Tracker tracker(port, placeAt(w, {300, 200}));
        auto& home = child<QComboBox>(w.window(), u"homeShip"_s);
        QVERIFY(w.until([&] { return home.count() == 2; }));
        QCOMPARE(home.itemText(1), u"Launch and home are on Tracker 1"_s);
        chooseRow(w, u"homeShip"_s, 1);
        QVERIFY((w.scenario().uavs.front().position_m - Point(300, 200)).norm() < 1);
        QVERIFY((w.scenario().asset->position_m - Point(-500, 800)).norm() < 1); // not chosen
        QVERIFY(w.untilReady());
        w.workspace.fly(1);
        QVERIFY(w.until([&] { return w.record().now.time_s > 0.5; }));
        tracker.moveTo(placeAt(w, {900, -400}));
        QVERIFY(w.until(
            [&] { return (w.record().now.homes_m.front() - Point(900, -400)).norm() < 1; }));
        w.workspace.pause();
        QVERIFY(w.until(RunPhase::Paused));
        const std::shared_ptr<const RunFile> run = test::flownRun(w);
        QVERIFY(run->interventions.size() >= 1);
        QCOMPARE(run->interventions.back().home->uav, std::string("uav-1"));
        chooseRow(w, u"assetShip"_s, 1);
        QVERIFY(w.until([&] {
            const Asset& asset = *w.record().now.asset;
            return (asset.position_m + w.record().now.time_s * asset.velocity_mps -
                    Point(900, -400))
                       .norm() < 1;
        }));
    }

    /** Ice on the radar is a sighting by others: of a known iceberg, or of a new one. */
    void iceOnTheRadarIsReported()
    {
        WindowFixture w(withAsset());
        const int port = shipPort(0) + 4'001;
        listenAt(w, port);
        Tracker tracker(port, placeAt(w, {300, 200}));
        tracker.setRadarTarget(placeAt(w, {-4000, 3000}));
        auto& ice = child<QComboBox>(w.window(), u"iceTarget"_s);
        auto& button = child<QPushButton>(w.window(), u"reportIce"_s);
        QVERIFY(w.until([&] { return ice.count() == 1; }));
        QCOMPARE(ice.itemText(0), u"Radar target 5"_s);
        QVERIFY(w.until([&] { return w.map().live().traffic.size() == 2; }));
        QVERIFY(w.map().live().traffic.front().isIce);
        QVERIFY(!button.isEnabled());
        QVERIFY(w.untilReady());
        w.workspace.fly(1);
        QVERIFY(w.until([&] { return w.record().now.time_s > 0.5 && button.isEnabled(); }));
        button.click();
        QVERIFY(w.until([&] { return w.record().now.icebergs.size() == 2; }));
        QCOMPARE(w.record().now.icebergs.back().id, std::string("radar 5"));
        QVERIFY((w.record().now.icebergs.back().position_m - Point(-4000, 3000)).norm() < 1);
        tracker.setRadarTarget(placeAt(w, {2010, 510})); // the known iceberg
        QVERIFY(w.until([&] {
            const auto& traffic = w.map().live().traffic;
            return (traffic.front().position_m - Point(2010, 510)).norm() < 1;
        }));
        button.click();
        w.workspace.pause();
        QVERIFY(w.until(RunPhase::Paused));
        const std::shared_ptr<const RunFile> run = test::flownRun(w);
        QCOMPARE(run->interventions.size(), std::size_t{2});
        QCOMPARE(run->interventions.back().seen, std::optional(w.scenario().icebergs[0].id));
    }
};

QTEST_MAIN(TestMainWindowShips)
#include "tst_main_window_ships.moc"
