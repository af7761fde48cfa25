#include "app/flight/aircraft_controller.h"
#include "core/base/angles.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/free_port.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/aircraft/rehearsal_fleet.h"
#include "widgets/map/paint/graticule.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QUndoStack>

#include <Eigen/Geometry>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;
using test::WindowFixture;

namespace {

Scenario steeredScenario()
{
    Scenario scenario = test::emptySea(3600);
    scenario.uavs.front().aircraft.firmware = AutopilotFirmware::Px4;
    for (const auto& [east_m, north_m] :
         {std::pair(2000, 500), {-1500, 2500}, {3000, -2000}, {-2500, -1500}})
        test::addIceberg(scenario, east_m, north_m);
    return scenario;
}

QString shownText(WindowFixture& w, const QString& label)
{
    return child<QLabel>(w.window(), label).text();
}

QPushButton& buttonOf(WindowFixture& w, const QString& name)
{
    return child<QPushButton>(w.window(), name);
}

QString eventText(WindowFixture& w)
{
    return child<QPlainTextEdit>(w.window(), u"linkEvents"_s).toPlainText();
}

void listenOn(WindowFixture& w, int port)
{
    child<QLineEdit>(w.window(), u"linkAddress"_s).setText(u"udp:127.0.0.1:%1"_s.arg(port));
    buttonOf(w, u"listenButton"_s).click();
}

void chooseSteering(WindowFixture& w, SteeringKind kind)
{
    auto& box = child<QComboBox>(w.window(), u"steeringChoice"_s);
    box.setCurrentIndex(box.findData(static_cast<int>(kind)));
    emit box.activated(box.currentIndex());
}

std::vector<RehearsalOptions> onePx4(const Scenario& scenario)
{
    std::vector<RehearsalOptions> one(1);
    one.front().side.autopilot = AutopilotKind::Px4;
    one.front().home = scenario.origin;
    return one;
}

/** A window that sends to one simulated aircraft with a position. */
struct Linked : WindowFixture
{
    explicit Linked(const Scenario& scenario = steeredScenario()) : WindowFixture(scenario)
    {
        listenOn(*this, port);
        aircraft = std::make_unique<RehearsalFleet>(onePx4(scenario), port);
        if (!until([&] {
                const auto& vehicles = workspace.link().status().vehicles;
                return !vehicles.empty() && vehicles.front().state.position.has_value();
            }))
            qFatal("no aircraft");
        child<QCheckBox>(window(), u"sendSwitch"_s).click();
        if (!until([&] { return buttonOf(*this, u"uploadButton"_s).isEnabled(); }))
            qFatal("nothing can be sent");
    }

    [[nodiscard]] bool isOnBoard()
    {
        return until(
            [&] { return shownText(*this, u"onBoardState"_s).contains(u"same as the plan of"_s); });
    }
    [[nodiscard]] bool upload()
    {
        buttonOf(*this, u"uploadButton"_s).click();
        return isOnBoard();
    }
    [[nodiscard]] bool followAircraft()
    {
        buttonOf(*this, u"flyLiveButton"_s).click();
        return until([&] { return record().now.isLive && record().now.time_s > 1; });
    }
    /** Waits for so many states of the link. */
    [[nodiscard]] bool listenFor(int states)
    {
        QSignalSpy updates(&workspace.link(), &LinkMonitor::updated);
        return until([&] { return updates.count() >= states; });
    }

    int port = test::freeUdpPort();
    std::unique_ptr<RehearsalFleet> aircraft;
};

} // namespace

class TestMainWindowSteering : public QObject
{
    Q_OBJECT

private slots:
    void ordersAgreeAhead()
    {
        const std::vector<std::string> uploaded{"a", "b", "c", "d"};
        QVERIFY(agreesAhead(uploaded, {"a", "b", "c", "d"}));
        QVERIFY(agreesAhead(uploaded, {"b", "c", "d"}));
        QVERIFY(agreesAhead(uploaded, {"c", "d"}));
        QVERIFY(agreesAhead(uploaded, {"a", "b", "c", "e"})); // the next three count
        QVERIFY(!agreesAhead(uploaded, {"a", "c", "b"}));
        QVERIFY(!agreesAhead(uploaded, {"e", "a"}));
        QVERIFY(!agreesAhead(uploaded, {"a", "b"})); // c is still flown to
        QVERIFY(!agreesAhead(uploaded, {"c"}));
        QVERIFY(!agreesAhead(uploaded, {}));
        QVERIFY(agreesAhead({}, {}));
    }

    /** A simulation must not reach a real aircraft. */
    void simulationUploadsNothing()
    {
        Linked w;
        QVERIFY(w.upload());
        chooseSteering(w, SteeringKind::Mission);
        buttonOf(w, u"flyMissionButton"_s).click();
        QVERIFY(w.until([&] { return shownText(w, u"steeringState"_s).startsWith(u"Replac"_s); }));
        w.workspace.fly(10);
        QVERIFY(w.until([&] { return w.record().now.time_s > 1; }));
        const std::size_t plans = w.record().now.planCount;
        QCOMPARE(w.workspace.remove({"berg-1", "berg-2"}), 2);
        QVERIFY(w.until([&] { return w.record().now.planCount > plans; }));
        QVERIFY(w.listenFor(40));
        QVERIFY(w.isOnBoard());
        QCOMPARE(eventText(w).count(u"same as the plan"_s), 1);
    }

    /** An edit while the plan is being compared must not end the comparisons. */
    void changedPlanIsNoticedAfterAnInterruption()
    {
        Linked w;
        QVERIFY(w.upload());
        int edits = 0;
        const auto moveIceberg = [&] {
            ++edits;
            w.document().edit(u"Move"_s,
                              [&](Scenario& s) { s.icebergs.front().position_m += Point(50, 0); });
        };
        QObject context;
        QObject::connect(&w.workspace, &Workspace::flightChanged, &context, [&] {
            if (edits == 1 && w.record().now.phase == RunPhase::Ready)
                moveIceberg(); // the plans have just been requested
        });
        moveIceberg();
        QVERIFY(w.until([&] {
            return shownText(w, u"onBoardState"_s).contains(u"the plan has changed since"_s);
        }));
        QCOMPARE(edits, 2);
    }

    /** In flight the present plan starts elsewhere than the mission on board. */
    void comparisonInFlightChangesNothing()
    {
        Linked w;
        QVERIFY(w.upload());
        QVERIFY(w.followAircraft());
        chooseSteering(w, SteeringKind::Mission);
        buttonOf(w, u"flyMissionButton"_s).click();
        QVERIFY(w.until([&] {
            return shownText(w, u"steeringState"_s) ==
                   u"Replacing the mission when the plan changes"_s;
        }));
        QCOMPARE(eventText(w).count(u"same as the plan"_s), 1);
        QVERIFY(w.until([&] { return buttonOf(w, u"compareButton"_s).isEnabled(); }));
        buttonOf(w, u"compareButton"_s).click();
        QVERIFY(w.until([&] { return eventText(w).count(u"same as the plan"_s) == 2; }));
        QVERIFY(w.isOnBoard());
        QVERIFY(shownText(w, u"steeringState"_s).startsWith(u"Replacing"_s));
    }

    void plainFenceStaysOnBoard()
    {
        Linked w; // a scenario without fence
        QVERIFY(w.upload());
        QVERIFY(shownText(w, u"onBoardState"_s).endsWith(u"The aircraft keeps its own fence"_s));
        for (const MissionPart& part : w.workspace.link().status().onBoard.begin()->second)
            QVERIFY(part.type != MissionType::Fence);
    }

    /** A flight that follows aircraft flies at their pace. */
    void stepDoesNotEndFollowing()
    {
        Linked w;
        QVERIFY(w.followAircraft());
        QSignalSpy refused(&w.workspace, &Workspace::refused);
        w.workspace.step();
        QVERIFY(w.until([&] { return refused.count() == 1; }));
        const double then_s = w.record().now.time_s;
        QVERIFY(w.until([&] { return w.record().now.time_s > then_s + 0.5; }));
        QVERIFY(w.record().now.isLive);
    }

    /** Steering is shown only when something is sent. */
    void steeringNeedsTheFlight()
    {
        Linked w;
        QVERIFY(w.upload()); // a vehicle without a mission refuses the mode
        chooseSteering(w, SteeringKind::Mission);
        buttonOf(w, u"flyMissionButton"_s).click();
        QVERIFY(w.until([&] {
            return shownText(w, u"steeringState"_s).contains(u"begins when the flight"_s);
        }));
    }

    void steeringEndsWithSending()
    {
        Linked w;
        chooseSteering(w, SteeringKind::Mission);
        QVERIFY(!shownText(w, u"steeringState"_s).isEmpty());
        child<QCheckBox>(w.window(), u"sendSwitch"_s).click();
        QVERIFY(w.until([&] { return shownText(w, u"steeringState"_s).isEmpty(); }));
        child<QCheckBox>(w.window(), u"sendSwitch"_s).click();
        QVERIFY(w.until([&] { return w.workspace.link().status().isSending; }));
        QVERIFY(shownText(w, u"steeringState"_s).isEmpty());
    }

    /** A new window, for other units, goes on with the link: maximised, with another panel. */
    void unitsChangeKeepsTheLink()
    {
        Linked w;
        w.window().showMaximized();
        child<QDockWidget>(w.window(), u"messagesDock"_s).show();
        const QString events = eventText(w);
        QVERIFY(!events.isEmpty());
        const QPointer<MainWindow> former(&w.window());
        w.trigger(u"units/distance-nautical"_s);
        QVERIFY(w.until([&] { return former.isNull(); }));
        QCOMPARE(shownText(w, u"linkMark"_s), u"Link: sending"_s);
        QVERIFY(eventText(w).startsWith(events));
        w.aircraft->setSilent(true); // still predicted
        QVERIFY(w.until([&] {
            const std::vector<MapAircraft>& shown = w.map().live().aircraft;
            return !shown.empty() && shown.front().isGhost;
        }));
    }

    void eventsAreListedOnce()
    {
        Linked w;
        int added = -1;
        QObject context;
        QObject::connect(&w.workspace.link(), &LinkMonitor::updated, &context, [&] {
            if (w.workspace.link().status().events.empty() || added >= 0)
                return;
            const auto before = eventText(w).size();
            chooseSteering(w, SteeringKind::Mission); // shows the state again
            added = static_cast<int>(eventText(w).size() - before);
        });
        w.aircraft->setMode(0, 0x00010000); // Manual
        QVERIFY(w.until([&] { return added >= 0; }));
        QCOMPARE(added, 0);
    }

    void openAddressIsWarnedOf()
    {
        WindowFixture w(steeredScenario());
        child<QLineEdit>(w.window(), u"linkAddress"_s)
            .setText(u"udp:0.0.0.0:%1"_s.arg(test::freeUdpPort()));
        buttonOf(w, u"listenButton"_s).click();
        QVERIFY(eventText(w).contains(u"can be reached from the network"_s));
        buttonOf(w, u"listenButton"_s).click();
        listenOn(w, test::freeUdpPort());
        QCOMPARE(eventText(w).count(u"can be reached"_s), 1);
    }

    void renamedUavHasNoAircraft()
    {
        Linked w;
        w.document().edit(u"Rename"_s, [](Scenario& s) { s.uavs.front().id = "other"; });
        QVERIFY(w.until([&] { return !buttonOf(w, u"uploadButton"_s).isEnabled(); }));
        QCOMPARE(child<QComboBox>(w.window(), u"aircraftUav"_s).currentText(), u"No UAV"_s);
        w.document().undoStack()->undo();
        QVERIFY(w.until([&] { return buttonOf(w, u"uploadButton"_s).isEnabled(); }));
    }

    /** Simulated aircraft would have the addresses of real ones. */
    void rehearsalNeedsALinkOfItsOwn()
    {
        WindowFixture w(steeredScenario());
        const int port = test::freeUdpPort();
        listenOn(w, port);
        QVERIFY(!buttonOf(w, u"rehearseButton"_s).isEnabled());
        buttonOf(w, u"listenButton"_s).click();
        QVERIFY(buttonOf(w, u"rehearseButton"_s).isEnabled());
        buttonOf(w, u"rehearseButton"_s).click();
        QVERIFY(w.workspace.link().isListening());
        buttonOf(w, u"rehearseButton"_s).click();
        QVERIFY(buttonOf(w, u"rehearseButton"_s).isEnabled()); // on the link of the rehearsal
    }

    /** Far from the origin north is not up: aircraft report true winds. */
    void windIsTurnedToTrueNorth()
    {
        Scenario scenario = steeredScenario();
        scenario.origin = {.latitude_deg = 78, .longitude_deg = -60};
        scenario.wind_mps = {0, 8};
        const Point far_m(200'000, 0);
        scenario.uavs.front().position_m += far_m;
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.position_m += far_m;
        const double north_rad =
            northAngle_rad(LocalFrame(scenario.origin), scenario.uavs.front().position_m);
        QVERIFY(std::abs(north_rad) > radFromDeg(5));
        WindowFixture w(scenario);
        child<QLineEdit>(w.window(), u"linkAddress"_s)
            .setText(u"udp:127.0.0.1:%1"_s.arg(test::freeUdpPort()));
        buttonOf(w, u"rehearseButton"_s).click();
        const auto wind = [&]() -> std::optional<AircraftWind> {
            const auto& vehicles = w.workspace.link().status().vehicles;
            return vehicles.empty() ? std::nullopt : vehicles.front().state.wind;
        };
        QVERIFY(w.until([&] { return wind().has_value(); }));
        const Point true_mps(wind()->meanEast_mps, wind()->meanNorth_mps);
        const Point expected_mps = Eigen::Rotation2D<double>(north_rad) * scenario.wind_mps;
        QVERIFY2((true_mps - expected_mps).norm() < 0.3, // it is estimated
                 qPrintable(u"%1, %2"_s.arg(true_mps.x()).arg(true_mps.y())));
        QVERIFY(w.until([&] {
            buttonOf(w, u"useWindButton"_s).click(); // does nothing until the panel has the wind
            return (w.scenario().wind_mps - scenario.wind_mps).norm() < 0.3;
        }));
    }
};

QTEST_MAIN(TestMainWindowSteering)
#include "tst_main_window_steering.moc"
