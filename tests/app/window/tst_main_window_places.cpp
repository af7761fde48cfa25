#include "app/dialogs/origin_dialog.h"
#include "core/presets/presets.h"
#include "tests/support/approx.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/map/paint/overview_inset.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/fields/place_field.h"
#include "widgets/panels/map/find_box.h"
#include "widgets/panels/plan/plan_model.h"
#include "widgets/theme/quantity_text.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QTableView>
#include <QToolButton>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

Scenario fourIcebergs()
{
    return test::MapFixture::fourIcebergs();
}

} // namespace

/** Units, going to places, and moving the scenario. */
class TestMainWindowPlaces : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qRegisterMetaType<std::string>("std::string");
        QLocale::setDefault(QLocale::c());
    }
    void init() { test::failOnWarnings(); }
    void cleanup() { setShownUnits({}); }

    void goesToAPlace()
    {
        WindowFixture w(fourIcebergs());
        auto& bar = test::child<FindBox>(w.window(), u"findBox"_s);
        auto& mark = test::child<QWidget>(w.window(), u"placeMark"_s);
        w.trigger(u"findAction"_s);
        QVERIFY(bar.isVisible());
        const LatLon place = LocalFrame(w.scenario().origin).toGeographic({50'000, -20'000});
        auto& field = test::child<QLineEdit>(bar, u"findField"_s);
        field.setText(QString::fromStdString(
            berg::placeText(place, CoordinateForm::DegreesMinutesSeconds, 4)));
        emit field.textEdited(field.text());
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(bar.isHidden());
        const Point middle_m = w.map().toWorld(QRectF(w.map().rect()).center());
        COMPARE_NEAR((middle_m - Point(50'000, -20'000)).norm(), 0,
                     50); // half a pixel
        QVERIFY(mark.isVisible());
        QVERIFY(mark.geometry().contains(w.map().rect().center()));
        w.map().camera().panBy({40, 0});
        QVERIFY(mark.geometry().contains(w.map().rect().center() + QPoint(40, 0)));
    }

    void findsIcebergsAndCommands()
    {
        WindowFixture w(fourIcebergs());
        auto& field = test::child<QLineEdit>(w.window(), u"findField"_s);
        const auto find = [&](const QString& text) {
            w.trigger(u"findAction"_s);
            QTest::keyClicks(&field, text);
            QTest::keyClick(&field, Qt::Key_Return);
        };
        find(u"berg-3"_s);
        QCOMPARE(w.workspace.selection().ids(), std::vector<std::string>{"berg-3"});
        find(u"overview"_s);
        QVERIFY(w.action(u"overviewAction"_s).isChecked());
        w.trigger(u"findAction"_s);
        QTest::keyClicks(&field, u"berg-1"_s);
        QTest::keyClick(&field, Qt::Key_E, Qt::ControlModifier); // of the menu, not of the field
        QCOMPARE(w.interaction.offers.size(), std::size_t{1});
        find(u"plan layout"_s); // there is no such command: nothing happens
        QVERIFY(w.action(u"overviewAction"_s).isChecked());
    }

    /** Words are names first, although "bay" is also a square of MGRS in Antarctica. */
    void wordsFindNamesFirst()
    {
        WindowFixture w(fourIcebergs());
        w.trigger(u"findAction"_s);
        auto& field = test::child<QLineEdit>(w.window(), u"findField"_s);
        const auto& list =
            *test::child<FindBox>(w.window(), u"findBox"_s).findChild<QListWidget*>();
        QTest::keyClicks(&field, u"bay"_s);
        for (int row = 0; row < list.count(); ++row)
            QVERIFY2(!list.item(row)->text().section(u" – "_s, 0, 0).contains(u'°'),
                     qPrintable(list.item(row)->text()));
        for (const QString& name : {u"Baffin Bay"_s, u"Disko Bay"_s, u"Melville Bay"_s})
            QCOMPARE(list.findItems(name, Qt::MatchStartsWith).size(), 1);
        field.clear();
        QTest::keyClicks(&field, u"tromso"_s);
        QVERIFY(list.item(0)->text().startsWith(u"Tromsø"_s));
    }

    /** Over the water off Bonavista; the View menu and the panel of layers agree. */
    void placeNamesAreALayerOfTheMap()
    {
        Scenario scenario = fourIcebergs();
        scenario.origin = {48.63, -53.13}; // two kilometres off the town
        WindowFixture w(scenario);
        const auto ground = [&] { return w.map().grab().toImage(); };
        w.map().finishLand();
        const QImage named = ground();
        QVERIFY(w.action(u"placesAction"_s).isChecked());
        w.trigger(u"placesAction"_s);
        QVERIFY(ground() != named);
        QCOMPARE(test::child<QSlider>(w.window(), u"placesLayer"_s).value(), 0);
        test::child<QSlider>(w.window(), u"placesLayer"_s).setValue(100);
        QVERIFY(w.action(u"placesAction"_s).isChecked());
        QTRY_VERIFY(ground() == named);
    }

    void saysWhenNothingIsFound()
    {
        WindowFixture w(fourIcebergs());
        w.trigger(u"findAction"_s);
        auto& field = test::child<QLineEdit>(w.window(), u"findField"_s);
        QTest::keyClicks(&field, u"zzqq"_s);
        QCOMPARE(test::child<QLabel>(w.window(), u"findReason"_s).text(), u"Nothing found"_s);
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(&field, Qt::Key_Backspace);
        QVERIFY(!test::child<QLabel>(w.window(), u"findReason"_s).isVisible());
    }

    void findsWhatWasAddedInFlight()
    {
        WindowFixture w(fourIcebergs());
        w.workspace.stepTicks(10);
        QVERIFY(w.until([&] { return w.workspace.mayIntervene(); }));
        w.workspace.addIceberg({.position_m = {1000, 1000}});
        QVERIFY(w.until([&] { return w.record().now.icebergs.size() == 5; }));
        w.trigger(u"findAction"_s);
        auto& field = test::child<QLineEdit>(w.window(), u"findField"_s);
        const std::string& id = w.record().now.icebergs.back().id;
        QTest::keyClicks(&field, QString::fromStdString(id));
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(w.workspace.selection().ids(), std::vector<std::string>{id});
    }

    void favouritesAreSaved()
    {
        WindowFixture w(fourIcebergs());
        auto& field = test::child<QLineEdit>(w.window(), u"findField"_s);
        w.trigger(u"findAction"_s);
        QTest::keyClicks(&field, u"hibernia"_s);
        test::child<QToolButton>(w.window(), u"findFavourite"_s).click();
        QTest::keyClick(&field, Qt::Key_Escape);
        w.trigger(u"findAction"_s);
        QTest::keyClick(&field, Qt::Key_Return);
        const LatLon middle = LocalFrame(w.scenario().origin)
                                  .toGeographic(w.map().toWorld(QRectF(w.map().rect()).center()));
        COMPARE_NEAR(middle.latitude_deg, 46.75, 0.01);
    }

    /** A new scenario asks where; Esc leaves it where it is. */
    void newScenarioAsksWhere()
    {
        WindowFixture w(fourIcebergs());
        auto& box = test::child<FindBox>(w.window(), u"findBox"_s);
        auto& field = test::child<QLineEdit>(w.window(), u"findField"_s);
        w.trigger(u"newAction"_s);
        QVERIFY(box.isVisible());
        QVERIFY(w.scenario().icebergs.empty());
        QTest::keyClicks(&field, u"Longyearbyen"_s);
        QTest::keyClick(&field, Qt::Key_Return);
        COMPARE_NEAR(w.scenario().origin.latitude_deg, 78.22, 1e-9);
        const LatLon there = w.scenario().origin;
        QVERIFY(w.document().isClean()); // it is as new as before
        w.trigger(u"newAction"_s);
        QTest::keyClick(&field, Qt::Key_Escape);
        QVERIFY(box.isHidden());
        QVERIFY(!(w.scenario().origin == there));
    }

    /** The question about the place belongs to the new scenario, not to one opened meanwhile. */
    void boxClosesWithWhatItWasOpenedFor()
    {
        WindowFixture w(fourIcebergs());
        auto& box = test::child<FindBox>(w.window(), u"findBox"_s);
        w.trigger(u"newAction"_s);
        QVERIFY(box.isVisible());
        w.document().reset(fourIcebergs());
        QVERIFY(box.isHidden());
        QVERIFY(w.untilReady());
        w.trigger(u"findAction"_s);
        QVERIFY(box.isVisible());
        w.trigger(u"playAction"_s);
        QVERIFY(w.until([&] { return w.workspace.inFlight(); }));
        QVERIFY(box.isHidden());
    }

    /** Pressing beside the field closes the box and does not act on the map. */
    void boxClosesWithAPressOnTheMap()
    {
        WindowFixture w(fourIcebergs());
        auto& box = test::child<FindBox>(w.window(), u"findBox"_s);
        w.trigger(u"findAction"_s);
        QTest::mouseClick(&box, Qt::LeftButton, {}, QPoint(2, 2));
        QVERIFY(box.isVisible());
        QTest::mouseClick(&w.map(), Qt::LeftButton, {}, QPoint(60, w.map().height() - 150));
        QVERIFY(box.isHidden());
    }

    /** Actions that other parts keep for themselves are no commands, whatever they are called. */
    void commandsAreThoseOfTheMenus()
    {
        WindowFixture w(fourIcebergs());
        QAction own(u"Zeppelin"_s, &w.window());
        own.setObjectName(u"ownAction"_s);
        own.setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F12));
        auto& field = test::child<QLineEdit>(w.window(), u"findField"_s);
        auto& list = test::child<QListWidget>(w.window(), u"findList"_s);
        w.trigger(u"findAction"_s);
        QTest::keyClicks(&field, u"zeppelin"_s);
        QCOMPARE(list.count(), 0);
        field.clear();
        QTest::keyClicks(&field, u"analyse"_s);
        QVERIFY2(list.item(0)->text().contains(u"View, Layouts"_s),
                 qPrintable(list.item(0)->text()));
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(w.action(u"analyseLayoutAction"_s).isChecked());
        w.trigger(u"shortcutsAction"_s);
        const QString shortcuts = w.interaction.informations.back();
        QVERIFY(shortcuts.contains(u"Save"_s) && !shortcuts.contains(u"Zeppelin"_s));
        QVERIFY(shortcuts.contains(u"Layouts: Fly<"_s)); // beside Fly, which flies
    }

    void fieldsAreFoundByName()
    {
        WindowFixture w(fourIcebergs());
        w.workspace.selection().set({"berg-2"});
        auto& box = test::child<FindBox>(w.window(), u"findBox"_s);
        const auto find = [&](const QString& name) {
            w.trigger(u"findAction"_s);
            auto& field = test::child<QLineEdit>(box, u"findField"_s);
            QTest::keyClicks(&field, name);
            QTest::keyClick(&field, Qt::Key_Return);
        };
        const auto focusIn = [&] { return QApplication::focusWidget()->objectName(); };
        find(u"UAV endurance"_s);
        QCOMPARE(w.workspace.selection().ids(), std::vector<std::string>{"uav-1"});
        QCOMPARE(focusIn(), u"uavs.endurance_s"_s);
        QCoreApplication::processEvents();
        QVERIFY(!QApplication::focusWidget()->visibleRegion().isEmpty()); // scrolled to
        find(u"wind"_s); // not the switch of the same name
        QCOMPARE(focusIn(), u"scenarioWindSpeed"_s);
        find(u"seed"_s); // of the scenario, in a group that is folded
        QVERIFY(w.workspace.selection().isEmpty());
        QCOMPARE(focusIn(), u"seed"_s);
        QVERIFY(!QApplication::focusWidget()->visibleRegion().isEmpty());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(QApplication::focusWidget(), u"7"_s);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCOMPARE(w.scenario().seed, 7U);
    }

    void originIsTypedInAnyForm()
    {
        WindowFixture w(fourIcebergs());
        setShownUnits({.coordinates = CoordinateForm::DegreesMinutes});
        auto& latitude = test::child<QLineEdit>(w.window(), u"scenarioLatitude"_s);
        const double longitude_deg = w.scenario().origin.longitude_deg;
        test::enter(latitude, u"49 12.5 N"_s);
        COMPARE_NEAR(w.scenario().origin.latitude_deg, 49 + 12.5 / 60, 1e-9);
        QCOMPARE(w.scenario().origin.longitude_deg, longitude_deg);
        QCOMPARE(latitude.text(), latitudeText(49 + 12.5 / 60, kPlaceDecimals, QLocale::c()));
        QVERIFY(latitude.text().contains(u"12.5"_s));
        test::enter(test::child<QLineEdit>(w.window(), u"scenarioLongitude"_s), u"Bonavista"_s);
        COMPARE_NEAR(w.scenario().origin.latitude_deg, 48.65, 0.1);
        COMPARE_NEAR(w.scenario().origin.longitude_deg, -53.11, 0.1);
        test::enter(latitude, u"91 N"_s); // is refused
        COMPARE_NEAR(w.scenario().origin.latitude_deg, 48.65, 0.1);
    }

    void newScenarioIsMadeAtTheFoundPlace()
    {
        WindowFixture w(fourIcebergs());
        auto& field = test::child<QLineEdit>(w.window(), u"findField"_s);
        w.trigger(u"findAction"_s);
        QTest::keyClicks(&field, u"Ross Sea"_s);
        test::child<QPushButton>(w.window(), u"findNewButton"_s).click();
        QVERIFY(w.scenario().icebergs.empty());
        COMPARE_NEAR(w.scenario().origin.latitude_deg, -75, 1e-9);
    }

    /** At the place that is typed the UAV starts. */
    void newScenarioStartsAtThePlace()
    {
        WindowFixture w(fourIcebergs());
        auto& field = test::child<QLineEdit>(w.window(), u"findField"_s);
        w.trigger(u"newAction"_s);
        QTest::keyClicks(&field, u"48 45 N 52 56 W"_s);
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(w.scenario().uavs.size(), std::size_t{1});
        const LatLon start =
            LocalFrame(w.scenario().origin).toGeographic(w.scenario().uavs.front().position_m);
        COMPARE_NEAR(start.latitude_deg, 48.75, 1e-9);
        COMPARE_NEAR(start.longitude_deg, -52 - 56 / 60.0, 1e-9);
    }

    void chosenUnitsAreEverywhere()
    {
        WindowFixture w(fourIcebergs());
        w.trigger(u"units/distance-nautical"_s);
        w.trigger(u"units/speed-knots"_s);
        QVERIFY(w.until([&] {
            return test::child<NumberField>(w.window(), u"uavs.airspeed_mps"_s).suffix() ==
                   u" kn"_s;
        }));
        QCOMPARE(test::child<NumberField>(w.window(), u"icebergEast"_s).suffix(), u" nmi"_s);
        QVERIFY(w.action(u"units/distance-nautical"_s).isChecked());
        QVERIFY(!w.action(u"units/distance-metric"_s).isChecked());
        QTest::mouseMove(&w.map(), w.map().rect().center());
        const QString cursor = test::child<QLabel>(w.window(), u"cursorLabel"_s).text();
        QVERIFY2(cursor.contains(u"nmi E"_s) && cursor.contains(u"′ N"_s), qPrintable(cursor));
        w.trigger(u"units/coordinates-decimal"_s);
        QVERIFY(w.until([&] { return w.action(u"units/coordinates-decimal"_s).isChecked(); }));
        QVERIFY(w.until([] { return shownUnits().coordinates == CoordinateForm::DecimalDegrees; }));
    }

    void heightsInFeet()
    {
        WindowFixture w(fourIcebergs());
        w.trigger(u"units/heights-feet"_s);
        QVERIFY(w.until([&] {
            return test::child<NumberField>(w.window(), u"uavs.altitude_m"_s).suffix() == u" ft"_s;
        }));
        QVERIFY(w.action(u"units/heights-feet"_s).isChecked());
        QCOMPARE(test::child<NumberField>(w.window(), u"icebergEast"_s).suffix(), u" m"_s);
        w.trigger(u"units/heights-metres"_s);
        QVERIFY(w.until([] { return shownUnits() == Units(); }));
    }

    /** Typed or by the model; a question without an answer changes nothing. */
    void coursesByMagneticNorth()
    {
        Scenario scenario = fourIcebergs();
        scenario.startUtc = "2026-11-28T12:00:00Z";
        WindowFixture w(scenario);
        const auto course = [&w] {
            const auto& table = test::child<QTableView>(w.window(), u"planTable"_s);
            return table.model()->index(0, PlanModel::Course).data().toString();
        };
        QTRY_VERIFY(course().endsWith(u'°'));
        QVERIFY(!course().contains(u'M'));
        w.trigger(u"units/north-typed"_s); // cancelled
        QVERIFY(w.action(u"units/north-true"_s).isChecked());
        QVERIFY(!w.action(u"units/north-typed"_s).isChecked());
        QVERIFY(shownUnits() == Units());
        w.interaction.declination_deg = -17.5;
        w.trigger(u"units/north-typed"_s);
        QVERIFY(w.until([] { return shownUnits().north == NorthForm::Typed; }));
        QTRY_VERIFY(course().contains(u"° T / "_s) && course().endsWith(u"° M"_s));
        QVERIFY(w.action(u"units/north-typed"_s).text().contains(u"17.5° W"_s));
        w.trigger(u"units/north-model"_s);
        QVERIFY(w.until([] { return shownUnits().north == NorthForm::Model; }));
        QTRY_VERIFY(course().endsWith(u"° M"_s));
        w.document().edit(u"No date"_s, [](Scenario& s) { s.startUtc.clear(); });
        QTRY_VERIFY(!course().contains(u'M'));
        w.trigger(u"units/north-true"_s);
        QVERIFY(w.until([] { return shownUnits() == Units(); }));
    }

    void movesTheScenario()
    {
        WindowFixture w(fourIcebergs());
        const Scenario before = w.scenario();
        const LatLon origin{.latitude_deg = before.origin.latitude_deg + 0.1,
                            .longitude_deg = before.origin.longitude_deg + 0.2};
        w.interaction.originChoice = OriginChoice{.origin = origin, .mode = MoveMode::KeepPlaces};
        w.trigger(u"moveScenarioAction"_s);
        QVERIFY(w.interaction.suggestedOrigins == std::vector{before.origin});
        QVERIFY(w.scenario() == movedTo(before, origin, MoveMode::KeepPlaces));
        w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == before);
    }

    void cancelledMoveChangesNothing()
    {
        WindowFixture w(fourIcebergs());
        const Scenario before = w.scenario();
        w.trigger(u"moveScenarioAction"_s);
        QCOMPARE(w.interaction.suggestedOrigins.size(), std::size_t{1});
        QVERIFY(w.scenario() == before);
    }

    void originDialogShowsTheChoice()
    {
        const Scenario scenario = fourIcebergs();
        OriginDialog dialog(scenario, scenario.origin, Theme::light());
        dialog.setLocale(QLocale::c());
        dialog.show();
        auto& field = test::child<PlaceField>(dialog, u"originField"_s);
        auto& move = test::child<QPushButton>(dialog, u"moveButton"_s);
        QVERIFY(!move.isEnabled()); // it is there
        field.setText(u"78 N"_s);
        QVERIFY(!move.isEnabled());
        QVERIFY(!dialog.choice());
        QVERIFY(!test::child<QLabel>(dialog, u"originNote"_s).text().isEmpty());
        field.setText(u"Ross Sea"_s);
        QVERIFY(dialog.choice() == (OriginChoice{{-75, -175}, MoveMode::KeepLayout}));
        test::child<QRadioButton>(dialog, u"keepPlaces"_s).setChecked(true);
        QVERIFY(!dialog.choice()); // the icebergs are half the Earth away
        QVERIFY(!move.isEnabled());
        emit test::child<OverviewInset>(dialog, u"originChart"_s)
            .placePicked({scenario.origin.latitude_deg + 1, scenario.origin.longitude_deg});
        QVERIFY(dialog.choice());
        QCOMPARE(dialog.choice()->mode, MoveMode::KeepPlaces);
        COMPARE_NEAR(dialog.choice()->origin.latitude_deg, scenario.origin.latitude_deg + 1, 1e-4);
    }
};

QTEST_MAIN(TestMainWindowPlaces)
#include "tst_main_window_places.moc"
