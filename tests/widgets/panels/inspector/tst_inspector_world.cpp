#include "core/checks/validate.h"
#include "tests/support/flight/forecast_builder.h"
#include "tests/support/flight/mission_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/theme/language.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyleOptionComboBox>
#include <QUndoStack>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

struct WorldInspectorFixture
{
    ScenarioDocument document;
    Selection selection;
    InspectorPanel panel{document, selection};

    explicit WorldInspectorFixture(const Scenario& scenario = test::fourIcebergs())
    {
        document.reset(scenario);
        panel.setLocale(QLocale::c());
        panel.resize(test::kDock_px, 900);
        panel.show();
    }
    [[nodiscard]] const Scenario& scenario() const { return document.scenario(); }
    [[nodiscard]] bool isShown(const QString& name) const
    {
        return test::child<QWidget>(panel, name).isVisibleTo(&panel);
    }
    void type(const QString& name, const QString& text)
    {
        test::enter(test::child<NumberField>(panel, name), text);
    }
    void choose(const QString& name, int choice)
    {
        auto& combo = test::child<QComboBox>(panel, name);
        combo.setCurrentIndex(choice);
        emit combo.activated(choice);
    }
    void undoAll()
    {
        while (document.undoStack()->canUndo())
            document.undoStack()->undo();
    }
};

const QStringList kFilterRows{u"observer.position_sd_m"_s, u"observer.interval_s"_s,
                              u"observer.detection"_s, u"observer.search"_s};

} // namespace

/** Observer, endurance, home, fence and clusters in the Inspector. */
class TestInspectorWorld : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void operationIsSwitchedOnAndEdited()
    {
        WorldInspectorFixture f;
        QVERIFY(!f.isShown(u"operation.reaction_s"_s));
        test::child<QCheckBox>(f.panel, u"scenarioOperation"_s).click();
        QVERIFY(f.scenario().operation == Operation{});
        QVERIFY(f.isShown(u"operation.reaction_s"_s) && f.isShown(u"operation.crew"_s));
        f.type(u"operation.reaction_s"_s, u"2.5"_s);
        f.type(u"operation.turn_bank_deg"_s, u"25"_s);
        QVERIFY(f.scenario().operation == (Operation{.reaction_s = 2.5, .turnBank_deg = 25}));
        f.undoAll();
        QVERIFY(!f.scenario().operation);
    }

    void enteredAirspaceBecomesNoFly()
    {
        Scenario scenario = test::fourIcebergs();
        const std::vector<Point> near_m{{2000, 2000}, {2400, 2000}, {2400, 2300}};
        const std::vector<Point> far_m{{2000, 52000}, {2400, 52000}, {2400, 52300}};
        scenario.airspace = {
            {.name = "far", .kind = {}, .corners_m = far_m},
            {.name = "near", .kind = "R", .corners_m = near_m, .floor_m = 10, .ceiling_m = 900}};
        WorldInspectorFixture f(scenario);
        test::child<QPushButton>(f.panel, u"airspaceClose"_s).click();
        QCOMPARE(f.scenario().airspace.size(), std::size_t{1});
        QCOMPARE(f.scenario().airspace[0].name, std::string("far"));
        QVERIFY(f.scenario().noFly ==
                (std::vector<NoFlyArea>{
                    {.name = "R near", .corners_m = near_m, .floor_m = 10, .ceiling_m = 900}}));
        QVERIFY(!f.isShown(u"airspaceClose"_s));
        test::child<QPushButton>(f.panel, u"airspaceRemove"_s).click();
        QVERIFY(f.scenario().airspace.empty());
        f.undoAll();
        QVERIFY(f.scenario() == scenario);
    }

    /** Rows added while another tab was shown have their room when this one is shown. */
    void rowsThatCameUnseenHaveRoom()
    {
        WorldInspectorFixture f;
        f.panel.hide();
        const std::vector<Point> near_m{{2000, 2000}, {2400, 2000}, {2400, 2300}};
        f.document.edit(u"Airspace"_s, [&](Scenario& scenario) {
            scenario.airspace = {
                {.name = "a zone with a long name", .kind = "R", .corners_m = near_m},
                {.name = "another zone", .kind = "D", .corners_m = near_m}};
        });
        f.panel.show();
        QCoreApplication::processEvents();
        for (const QString& name : {u"airspaceClose"_s, u"airspaceRemove"_s, u"observer.model"_s}) {
            const auto& row = test::child<QWidget>(f.panel, name);
            QVERIFY2(row.height() >= row.minimumSizeHint().height(), qPrintable(name));
        }
    }

    void observerIsEditedWhereItMatters()
    {
        WorldInspectorFixture f;
        for (const QString& row : kFilterRows)
            QVERIFY2(!f.isShown(row), qPrintable(row));
        f.choose(u"observer.model"_s, 1);
        QVERIFY(f.scenario().observer.model == ObserverModel::Kalman);
        for (const QString& row : kFilterRows)
            QVERIFY2(f.isShown(row), qPrintable(row));
        f.type(u"observer.position_sd_m"_s, u"7.5"_s);
        f.type(u"observer.interval_s"_s, u"2"_s);
        f.type(u"observer.detection"_s, u"90"_s);
        f.choose(u"observer.search"_s, 2);
        const ObserverSpec expected{.model = ObserverModel::Kalman,
                                    .positionSd_m = 7.5,
                                    .interval_s = 2,
                                    .detection = 0.9,
                                    .search = SearchPattern::Sector};
        QVERIFY(f.scenario().observer == expected);
        QCOMPARE(f.document.undoStack()->count(), 5);
        f.undoAll();
        QCOMPARE(f.scenario(), test::fourIcebergs());
        QVERIFY(!f.isShown(kFilterRows.front()));
    }

    void weatherAndGroundStationAreEdited()
    {
        WorldInspectorFixture f;
        f.type(u"weather.gust_mps"_s, u"12"_s);
        f.type(u"weather.temperature_degc"_s, u"-3.5"_s);
        f.type(u"weather.dew_point_degc"_s, u"-4"_s);
        QVERIFY(f.scenario().weather ==
                (Weather{.gust_mps = 12, .temperature_degC = -3.5, .dewPoint_degC = -4}));
        f.type(u"weather.temperature_degc"_s, u"-90"_s); // not known
        QVERIFY(!f.scenario().weather.temperature_degC);

        QVERIFY(!f.isShown(u"ground_station.antenna_m"_s));
        test::child<QCheckBox>(f.panel, u"scenarioStation"_s).click();
        QVERIFY(f.isShown(u"ground_station.antenna_m"_s));
        QVERIFY(f.scenario().groundStation->position_m == f.scenario().uavs[0].position_m);
        f.type(u"stationEast"_s, u"250"_s);
        f.type(u"ground_station.antenna_m"_s, u"12"_s);
        f.type(u"ground_station.range_m"_s, u"9000"_s);
        QCOMPARE(f.scenario().groundStation->position_m.x(), 250.0);
        QCOMPARE(f.scenario().groundStation->antenna_m, 12.0);
        QCOMPARE(f.scenario().groundStation->range_m, std::optional(9000.0));
        f.type(u"ground_station.range_m"_s, u"0.2"_s); // none is nearer
        QCOMPARE(f.scenario().groundStation->range_m, std::optional(limits::kExtent_m.low));
        f.type(u"ground_station.range_m"_s, u"0"_s); // the radio horizon
        QVERIFY(!f.scenario().groundStation->range_m);
        f.undoAll();
        QCOMPARE(f.scenario(), test::fourIcebergs());
    }

    void reserveAndLimitsOfAUavAreEdited()
    {
        WorldInspectorFixture f;
        f.selection.set({f.scenario().uavs[0].id});
        QVERIFY(!f.isShown(u"uavs.reserve_percent"_s)); // of an endurance only
        f.type(u"uavs.endurance_s"_s, u"3600"_s);
        QVERIFY(f.isShown(u"uavs.reserve_percent"_s));
        f.type(u"uavs.reserve_percent"_s, u"30"_s);
        f.type(u"uavs.climb_s"_s, u"120"_s);
        f.type(u"uavs.landing_s"_s, u"90"_s);
        QCOMPARE(usableEndurance_s(f.scenario().uavs[0].spec), 0.7 * 3600 - 210);
        f.type(u"uavs.reserve_s"_s, u"600"_s);
        QCOMPARE(usableEndurance_s(f.scenario().uavs[0].spec), 3600.0 - 600 - 210);
        f.type(u"uavs.max_wind_mps"_s, u"15"_s);
        f.type(u"uavs.max_gust_mps"_s, u"20"_s);
        f.choose(u"uavs.icing"_s, 1);
        QVERIFY(f.scenario().uavs[0].weather ==
                (WeatherLimits{.wind_mps = 15, .gust_mps = 20, .icing = true}));
        f.undoAll();
        QCOMPARE(f.scenario(), test::fourIcebergs());
    }

    /** A sensor interval is never shorter than a time step, whichever of them is edited. */
    void sensorIntervalIsNoShorterThanAStep()
    {
        WorldInspectorFixture f;
        f.choose(u"observer.model"_s, 1);
        const double step_s = f.scenario().dt_s;
        QCOMPARE(test::child<NumberField>(f.panel, u"observer.interval_s"_s).minimum(), step_s);
        f.type(u"observer.interval_s"_s, u"0.5"_s);
        QCOMPARE(test::child<NumberField>(f.panel, u"dt_s"_s).maximum(), 0.5);
        f.type(u"dt_s"_s, u"0.5"_s);
        QVERIFY(!hasErrors(validate(f.scenario())));
    }

    void driftErrorIsThereWithTheFilter()
    {
        WorldInspectorFixture f;
        f.selection.set({"berg-1", "berg-2"});
        QVERIFY(!f.isShown(u"icebergs.velocity_sd_mps"_s));
        f.document.edit(u"Filter"_s, [](Scenario& s) { s.observer.model = ObserverModel::Kalman; });
        QVERIFY(f.isShown(u"icebergs.velocity_sd_mps"_s));
        f.type(u"icebergs.velocity_sd_mps"_s, u"0.2"_s);
        QCOMPARE(f.scenario().icebergs[0].velocitySd_mps, 0.2);
        QCOMPARE(f.scenario().icebergs[1].velocitySd_mps, 0.2);
        QCOMPARE(f.scenario().icebergs[2].velocitySd_mps, 0.0);
        f.type(u"icebergs.velocity_spread_mps"_s, u"0.15"_s);
        f.type(u"icebergs.velocity_time_s"_s, u"36000"_s);
        QCOMPARE(f.scenario().icebergs[1].velocitySpread_mps, 0.15);
        QCOMPARE(f.scenario().icebergs[1].velocityTime_s, 36'000.0);
        f.undoAll();
        QCOMPARE(f.scenario(), test::fourIcebergs());
    }

    void homeIsThereWithEndurance()
    {
        WorldInspectorFixture f;
        f.selection.set({"uav-1"});
        const QStringList rows{u"uavHomeEast"_s, u"uavHomeNorth"_s, u"uavs.turnaround_s"_s};
        for (const QString& row : rows)
            QVERIFY2(!f.isShown(row), qPrintable(row));
        QVERIFY(!f.isShown(u"uavHomeClear"_s));
        f.type(u"uavs.endurance_s"_s, u"1800"_s);
        for (const QString& row : rows)
            QVERIFY2(f.isShown(row), qPrintable(row));
        QCOMPARE(test::child<NumberField>(f.panel, u"uavHomeEast"_s).value(), -500.0); // the start
        f.type(u"uavs.turnaround_s"_s, u"300 s"_s);
        QCOMPARE(f.scenario().uavs[0].turnaround_s, 300.0);
        f.type(u"uavHomeEast"_s, u"0"_s);
        QVERIFY(*f.scenario().uavs[0].home_m == Point(0, 500)); // what is not typed stays
        QVERIFY(f.isShown(u"uavHomeClear"_s));
        // Without a limit the home is kept, and can be taken away.
        f.type(u"uavs.endurance_s"_s, u"0"_s);
        QVERIFY(f.isShown(u"uavHomeEast"_s) && !f.isShown(u"uavs.turnaround_s"_s));
        test::child<QPushButton>(f.panel, u"uavHomeClear"_s).click();
        QVERIFY(!f.scenario().uavs[0].home_m);
        QVERIFY(!f.isShown(u"uavHomeEast"_s));
        f.undoAll();
        QCOMPARE(f.scenario(), test::fourIcebergs());
    }

    void forecastIsShownAndCanBeRemoved()
    {
        WorldInspectorFixture f;
        f.selection.set({});
        QVERIFY(!f.isShown(u"scenarioForecast"_s));
        Scenario scenario = test::fourIcebergs();
        test::addForecast(scenario);
        f.document.reset(scenario);
        QVERIFY(f.isShown(u"scenarioForecast"_s));
        const auto& details = test::child<QLabel>(f.panel, u"scenarioForecastDetails"_s);
        QCOMPARE(details.text(), u"issued 2026-05-01 06:00 UTC, 6 h before the start; replaces "
                                 "wind, gusts, current"_s);
        test::child<QPushButton>(f.panel, u"scenarioForecast"_s).click();
        QVERIFY(!f.scenario().forecast);
        QVERIFY(!f.isShown(u"scenarioForecast"_s) && !f.isShown(u"scenarioForecastDetails"_s));
        QCOMPARE(f.document.undoStack()->count(), 1);
        f.undoAll();
        QCOMPARE(f.scenario(), scenario);
    }

    void fenceBelongsToTheArea()
    {
        WorldInspectorFixture f;
        f.selection.set({kAreaKey});
        auto& fence = test::child<QCheckBox>(f.panel, u"geofence"_s);
        QVERIFY(fence.isVisibleTo(&f.panel) && !fence.isChecked());
        fence.click();
        QVERIFY(f.scenario().geofence);
        test::child<QPushButton>(f.panel, u"areaRemove"_s).click();
        QVERIFY(!f.scenario().geofence && f.scenario().area_m.empty());
        f.undoAll();
        QCOMPARE(f.scenario(), test::fourIcebergs());
    }

    void noFlyAreaHasHeights()
    {
        WorldInspectorFixture f;
        f.document.edit(u"Areas"_s, [](Scenario& s) {
            for (const double x_m : {9000.0, 9900.0})
                s.noFly.push_back({.corners_m = {{x_m, 0}, {x_m + 500, 0}, {x_m, 500}}});
        });
        const Scenario before = f.scenario();
        f.selection.set({noFlyKey(1)});
        QCOMPARE(test::child<QLabel>(f.panel, u"inspectorTitle"_s).text(), u"No-fly area"_s);
        test::enter(test::child<QLineEdit>(f.panel, u"no_fly.name"_s), u"Rig"_s);
        f.type(u"no_fly.floor_m"_s, u"50"_s);
        f.type(u"no_fly.ceiling_m"_s, u"300"_s);
        const NoFlyArea& area = f.scenario().noFly[1];
        QVERIFY(area.name == "Rig" && area.floor_m == 50 && area.ceiling_m == 300.0);
        f.type(u"no_fly.ceiling_m"_s, u"0"_s);
        QVERIFY(!f.scenario().noFly[1].ceiling_m);
        QVERIFY(f.scenario().noFly[0] == before.noFly[0]);
        test::child<QPushButton>(f.panel, u"noFlyRemove"_s).click();
        QVERIFY(f.scenario().noFly == std::vector{before.noFly[0]});
        f.undoAll();
        QCOMPARE(f.scenario(), test::fourIcebergs());
    }

    void standOffBelongsToTheAsset()
    {
        WorldInspectorFixture f;
        f.document.edit(u"Asset"_s, [](Scenario& s) {
            s.asset = Asset{.name = "Rig", .position_m = {9000, 9000}};
        });
        f.selection.set({kAssetKey});
        QVERIFY(!f.isShown(u"asset.standoff_ceiling_m"_s));
        f.type(u"asset.standoff_m"_s, u"500"_s);
        QVERIFY(f.isShown(u"asset.standoff_ceiling_m"_s));
        f.type(u"asset.standoff_ceiling_m"_s, u"90"_s);
        QVERIFY(f.scenario().asset->standoff_m == 500.0 &&
                f.scenario().asset->standoffCeiling_m == 90.0);
        f.undoAll();
        QCOMPARE(f.scenario(), test::fourIcebergs());
    }

    void allRowsStandBesideTheirLabels_data()
    {
        QTest::addColumn<QString>("language");
        for (const char* language : {"en", "nb", "da", "fr"})
            QTest::newRow(language) << QString::fromLatin1(language);
    }

    /** At the dock's usual width no text or choice is cut. */
    void allRowsStandBesideTheirLabels()
    {
        QFETCH(QString, language);
        installLanguage(language);
        const auto back = qScopeGuard([] { installLanguage(u"en"_s); });
        WorldInspectorFixture f;
        test::child<QCheckBox>(f.panel, u"scenarioOperation"_s).click();
        for (const QLabel* label : f.panel.findChildren<QLabel*>()) {
            const QWidget* field = label->buddy();
            if (field == nullptr || !label->isVisible())
                continue;
            const QRect at(field->mapTo(label->parentWidget(), QPoint()), field->size());
            QVERIFY2(label->geometry().top() <= at.center().y() &&
                         label->geometry().right() < at.left(),
                     qPrintable(label->text()));
            for (const QString& word : label->text().split(QRegularExpression(u"[ -]"_s)))
                QVERIFY2(label->fontMetrics().horizontalAdvance(word) <= label->width(),
                         qPrintable(word));
            const QPoint end = field->mapTo(&f.panel, field->rect().bottomRight());
            QVERIFY2(end.x() < f.panel.width(), qPrintable(label->text()));
            QVERIFY2(field->width() >= field->minimumSizeHint().width(), qPrintable(label->text()));
        }
        for (const QComboBox* combo : f.panel.findChildren<QComboBox*>()) {
            QStyleOptionComboBox option;
            option.initFrom(combo);
            const int room_px = combo->style()
                                    ->subControlRect(QStyle::CC_ComboBox, &option,
                                                     QStyle::SC_ComboBoxEditField, combo)
                                    .width();
            for (int i = 0; i < combo->count() && combo->isVisible(); ++i)
                QVERIFY2(combo->fontMetrics().horizontalAdvance(combo->itemText(i)) <= room_px,
                         qPrintable(combo->itemText(i)));
        }
    }

    void severalAtOnce()
    {
        WorldInspectorFixture f;
        test::child<QCheckBox>(f.panel, u"planner.clusters"_s).click();
        QVERIFY(f.scenario().clusters);
        f.undoAll();
        QVERIFY(!f.scenario().clusters);
    }
};

QTEST_MAIN(TestInspectorWorld)
#include "tst_inspector_world.moc"
