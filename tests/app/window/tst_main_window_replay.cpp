#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/window_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;
using test::WindowFixture;

namespace {

Scenario twoUavs()
{
    Scenario scenario = test::emptySea(3600);
    for (Uav& uav : scenario.uavs)
        uav.aircraft.firmware = AutopilotFirmware::Px4; // sends its telemetry unasked
    scenario.uavs.push_back(scenario.uavs.front());
    scenario.uavs.back().id = "uav-2";
    scenario.uavs.back().position_m = {0, 900};
    test::addIceberg(scenario, 2000, 500);
    return scenario;
}

/** A port that parallel tests do not share. */
int logPort(int offset)
{
    return 35'000 + static_cast<int>(QCoreApplication::applicationPid() % 5'000) * 2 + offset;
}

void clickOn(WindowFixture& w, const QString& name)
{
    child<QPushButton>(w.window(), name).click();
}

QString labelText(WindowFixture& w, const QString& name)
{
    return child<QLabel>(w.window(), name).text();
}

QStringList logsIn(const QString& folder)
{
    return QDir(folder).entryList({u"*.tlog"_s}, QDir::Files);
}

bool areEqual(const MapLive& a, const MapLive& b)
{
    return std::ranges::equal(
        a.aircraft, b.aircraft, [](const MapAircraft& one, const MapAircraft& other) {
            return one.position_m == other.position_m && one.psi_rad == other.psi_rad &&
                   one.place == other.place && one.isGhost == other.isGhost &&
                   one.track_m == other.track_m &&
                   one.label.section(u',', 0, 0) == other.label.section(u',', 0, 0);
        });
}

} // namespace

class TestMainWindowReplay : public QObject
{
    Q_OBJECT

private slots:
    /** The map at the end of the replay is that at the end of the session. */
    void replayShowsTheSameMap()
    {
        WindowFixture w(twoUavs());
        const QString folder = w.file(u"logs"_s);
        w.settings.setValue(u"link/logFolder"_s, folder);
        child<QLineEdit>(w.window(), u"linkAddress"_s)
            .setText(u"udp:127.0.0.1:%1"_s.arg(logPort(0)));
        child<QCheckBox>(w.window(), u"logSwitch"_s).click();
        clickOn(w, u"rehearseButton"_s);
        QVERIFY(w.until([&] {
            const MapLive& live = w.map().live();
            return live.aircraft.size() == 2 && live.aircraft[0].track_m.size() > 5 &&
                   live.aircraft[1].track_m.size() > 5;
        }));
        QVERIFY(labelText(w, u"logState"_s).contains(folder));
        // The last position of the session is the one shown when the link is closed.
        clickOn(w, u"rehearseButton"_s); // no more telemetry
        QVERIFY(w.until([&] { return !w.workspace.link().status().ghosts.empty(); }));
        std::vector<LinkVehicle> last = w.workspace.link().status().vehicles;
        std::vector<std::vector<LatLon>> tracks;
        for (const LinkVehicle& vehicle : last)
            tracks.push_back(w.workspace.link().trackOf(vehicle.address));
        clickOn(w, u"listenButton"_s);
        QVERIFY(w.map().live().aircraft.empty());
        const QStringList logs = logsIn(folder);
        QCOMPARE(logs.size(), 1);

        w.interaction.path = QDir(folder).filePath(logs.front());
        auto& speed = child<QComboBox>(w.window(), u"replaySpeed"_s);
        speed.setCurrentIndex(speed.findText(u"60×"_s));
        clickOn(w, u"openLogButton"_s);
        QVERIFY(w.workspace.link().isListening());
        QVERIFY(w.until([&] {
            const auto& replay = w.workspace.link().status().replay;
            return replay && replay->isAtEnd;
        }));
        const std::vector<LinkVehicle>& replayed = w.workspace.link().status().vehicles;
        QCOMPARE(replayed.size(), last.size());
        for (std::size_t i = 0; i < last.size(); ++i) {
            QCOMPARE(replayed[i].address.system, last[i].address.system);
            QCOMPARE(replayed[i].mode, last[i].mode);
            QVERIFY(replayed[i].state.position->place == last[i].state.position->place);
            QCOMPARE(replayed[i].state.position->altitude_m, last[i].state.position->altitude_m);
            QVERIFY(w.workspace.link().trackOf(replayed[i].address) == tracks[i]);
        }
        QCOMPARE(w.map().live().aircraft.size(), std::size_t{2});
        QCOMPARE(labelText(w, u"linkMark"_s), u"Link: replay"_s);
        QVERIFY(!child<QCheckBox>(w.window(), u"sendSwitch"_s).isEnabled());
        QVERIFY(!child<QPushButton>(w.window(), u"uploadButton"_s).isEnabled());
        QVERIFY(labelText(w, u"logState"_s).contains(logs.front()));

        // Another speed shows the same.
        const MapLive first = w.map().live();
        clickOn(w, u"listenButton"_s); // stops it
        QVERIFY(!w.workspace.link().isListening());
        speed.setCurrentIndex(speed.findText(u"10×"_s));
        w.window().parts().files.openFile(w.interaction.path); // as File > Open does
        QVERIFY(w.until([&] {
            const auto& replay = w.workspace.link().status().replay;
            return replay && replay->isAtEnd && !w.map().live().aircraft.empty();
        }));
        QVERIFY(areEqual(w.map().live(), first));
        QCOMPARE(logsIn(folder).size(), 1); // a replay is not logged
    }

    void faultyLogsAreExplained()
    {
        WindowFixture w(twoUavs());
        QFile file(w.file(u"text.tlog"_s));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(100'000, 'x'));
        file.close();
        QVERIFY(w.window().parts().files.openFile(file.fileName()));
        QCOMPARE(w.interaction.errors.size(), 1);
        QVERIFY(w.interaction.errors.front().contains(u"text.tlog"_s));
        QVERIFY(!w.workspace.link().isListening());
        QVERIFY(w.window().parts().files.openFile(w.file(u"missing.tlog"_s)));
        QCOMPARE(w.interaction.errors.size(), 2);
        QCOMPARE(w.scenario().uavs.size(), std::size_t{2}); // the scenario stays
    }

    /** A link that is heard now is not given up for a log by mistake. */
    void liveLinkIsKept()
    {
        WindowFixture w(twoUavs());
        child<QLineEdit>(w.window(), u"linkAddress"_s)
            .setText(u"udp:127.0.0.1:%1"_s.arg(logPort(1)));
        clickOn(w, u"listenButton"_s);
        QVERIFY(w.window().parts().files.openFile(w.file(u"missing.tlog"_s)));
        QVERIFY(w.workspace.link().isListening());
        QVERIFY(!w.workspace.link().status().replay);
        QVERIFY(w.interaction.errors.empty());
    }
};

QTEST_MAIN(TestMainWindowReplay)
#include "tst_main_window_replay.moc"
