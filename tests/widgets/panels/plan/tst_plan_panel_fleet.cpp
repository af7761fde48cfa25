#include "tests/support/approx.h"
#include "tests/support/window/plan_panel_fixture.h"
#include "widgets/panels/plan/plan_delegate.h"
#include "widgets/theme/language.h"

#include <QAbstractItemModelTester>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>

#include <memory>

using namespace berg;
using namespace Qt::StringLiterals;
using namespace berg::test;

/** The plan panel with several UAVs. */
class TestPlanPanelFleet : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { qRegisterMetaType<std::string>("std::string"); }
    void init() { test::failOnWarnings(); }

    /** Each UAV flies its own order from where it is, at its own speed. */
    void everyUavHasItsSection()
    {
        Scenario scenario = twoIcebergScenario();
        scenario.uavs.push_back({.id = "uav-2", .name = "North", .position_m = Point(300, 2000)});
        scenario.uavs[1].spec.airspeed_mps = 10;
        MissionSnapshot now = twoIcebergs(scenario);
        now.world.tracks[1] = {.anchor_m = Point(300, 1000), .sigma_m2 = 7, .q_m2ps = 0.1};
        setPlan(now, {.uavs = {{.order = {0}}, {.uav = 1, .order = {1}}}});
        now.assigned = {std::nullopt, 1};
        const std::vector<PlanSection> sections = planSections(now, scenario);
        QCOMPARE(sections.size(), std::size_t{2});
        QCOMPARE(sections[0].rows.size(), std::size_t{1});
        QVERIFY(!sections[0].rows[0].isAssigned);
        COMPARE_NEAR(sections[0].lastArrival_s(), 25.0, 1e-9);
        QCOMPARE(sections[1].uav, "uav-2");
        QCOMPARE(sections[1].name, u"North"_s);
        QCOMPARE(sections[1].place, 1);
        QCOMPARE(sections[1].rows[0].name, u"Tabular"_s);
        QVERIFY(sections[1].rows[0].isAssigned);
        COMPARE_NEAR(sections[1].length_m(), 1000.0, 1e-9); // due south, at 10 m/s
        COMPARE_NEAR(sections[1].lastArrival_s(), 100.0, 1e-9);
        now.world.uavs[1].mode = FlightMode::Home;
        QVERIFY(!planSections(now, scenario)[1].isPlanned);
        QVERIFY(planSections(now, scenario)[1].rows.empty());
    }

    void severalUavsHaveALineEach()
    {
        PlanPanelFixture f;
        const QAbstractItemModelTester tester(&f.model);
        f.panel.resize(600, 240);
        f.panel.showPlan(twoUavSections());
        QCOMPARE(f.model.rowCount(), 5);
        QCOMPARE(f.cell(0, PlanModel::Name), u"West"_s);
        QCOMPARE(f.cell(0, PlanModel::Leg), u"2.00 km"_s);
        QCOMPARE(f.cell(0, PlanModel::Arrival), u"in 02:00"_s);
        QCOMPARE(f.cell(0, PlanModel::Sigma), u"2 visits"_s);
        QCOMPARE(f.cell(2, PlanModel::Number), u"2"_s);
        QCOMPARE(f.cell(4, PlanModel::Number), u"1"_s); // each has an order of its own
        for (int row = 0; row < 5; ++row)
            QCOMPARE(f.model.index(row, 0).data(PlanModel::UavRole).toInt(), row < 3 ? 0 : 1);
        QCOMPARE(test::child<QLabel>(f.panel, u"planSummary"_s).text(),
                 u"This sortie: 3.00 km, flown in 02:00"_s);
        QTest::mouseClick(f.table.viewport(), Qt::LeftButton, {}, f.centre(3));
        QCOMPARE(lastId(f.activated), "uav-2");
        f.panel.showPlan(visiting({"a"})); // back to one
        QCOMPARE(f.model.rowCount(), 1);
        QCOMPARE(f.cell(0, PlanModel::Name), u"a"_s);
    }

    void unplannedUavShowsTheReason_data()
    {
        QTest::addColumn<FlightMode>("mode");
        QTest::addColumn<QString>("why");
        QTest::newRow("home") << FlightMode::Home << u"Returning home"_s;
        QTest::newRow("ground") << FlightMode::Ground << u"On the ground"_s;
        QTest::newRow("hold") << FlightMode::Hold << u"Holding"_s;
    }

    void unplannedUavShowsTheReason()
    {
        QFETCH(FlightMode, mode);
        QFETCH(QString, why);
        PlanPanelFixture f;
        std::vector<PlanSection> sections = twoUavSections();
        sections[0].rows.clear();
        sections[0].isPlanned = false;
        sections[0].mode = mode;
        f.panel.showPlan(sections);
        QCOMPARE(PlanDelegate().uavFigures(f.model.index(0, PlanModel::Name), 600), why);
        const QString toolTip = f.model.index(0, PlanModel::Name).data(Qt::ToolTipRole).toString();
        QVERIFY2(toolTip.contains(u"while the UAV returns"_s), qPrintable(toolTip));
    }

    void figuresOfAUavHaveRoomBesideItsName_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("figures");
        QTest::newRow("English") << u"en"_s << u"16 visits, 24.3 km, in 18:24"_s;
        QTest::newRow("Norwegian") << u"nb"_s << u"16 besøk, 24,3 km, om 18:24"_s;
    }

    void figuresOfAUavHaveRoomBesideItsName()
    {
        QFETCH(QString, language);
        QFETCH(QString, figures);
        installLanguage(language);
        const auto back = qScopeGuard([] { installLanguage(u"en"_s); });
        std::vector<PlanSection> sections = twoUavSections();
        sections[1].rows.assign(16,
                                {.id = "c", .leg_m = 24320. / 16, .arrival_s = 1104, .number = 1});
        PlanModel model{QLocale(language)};
        model.setPlan(sections);
        const QModelIndex uav = model.index(3, PlanModel::Name);
        QFont bold = Theme::light().body();
        bold.setBold(true);
        constexpr int kBeside_px = 60; // the number before it and the scroll bar
        const int room_px =
            test::kDock_px - kBeside_px - QFontMetrics(bold).horizontalAdvance(u"Kittiwake"_s);
        QCOMPARE(PlanDelegate().uavFigures(uav, room_px), figures);
        QVERIFY(!PlanDelegate().uavFigures(uav, room_px / 2).contains(u"km"_s));
    }

    void assignedIcebergsHaveAPin()
    {
        PlanPanelFixture f;
        f.panel.showPlan(twoUavSections());
        const QModelIndex assigned = f.model.index(4, PlanModel::Name);
        QVERIFY(assigned.data(PlanModel::AssignedRole).toBool());
        QVERIFY(!f.model.index(1, PlanModel::Name).data(PlanModel::AssignedRole).toBool());
        QVERIFY(assigned.data(Qt::ToolTipRole).toString().endsWith(u"Assigned to uav-2"_s));
        QSignalSpy changed(&f.model, &QAbstractItemModel::dataChanged);
        std::vector<PlanSection> sections = twoUavSections();
        sections[1].rows[0].isAssigned = false; // no text says so
        f.panel.showPlan(sections);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(changed.front().front().toModelIndex().row(), 4);
    }

    /** Sends the events of the platform while an iceberg is dragged. */
    void icebergIsDraggedToAUav()
    {
        PlanPanelFixture f;
        f.panel.showPlan(twoUavSections());
        QVERIFY(!f.model.flags(f.model.index(0, 0)).testFlag(Qt::ItemIsDragEnabled));
        QVERIFY(f.model.flags(f.model.index(1, 0)).testFlag(Qt::ItemIsDragEnabled));
        QSignalSpy assignRequested(&f.panel, &PlanPanel::assignRequested);
        const std::unique_ptr<QMimeData> data(f.model.mimeData({f.model.index(1, 0)}));
        const auto isMarked = [&](int row) {
            return f.model.index(row, 0).data(PlanModel::DropRole).toBool();
        };
        const QPoint at = f.centre(4); // any line of uav-2
        QDragEnterEvent enter(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(f.table.viewport(), &enter);
        QDragMoveEvent move(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(f.table.viewport(), &move);
        QVERIFY(move.isAccepted());
        QVERIFY(isMarked(3) && isMarked(4) && !isMarked(0));
        QDropEvent drop(at, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QCoreApplication::sendEvent(f.table.viewport(), &drop);
        QVERIFY(!isMarked(4));
        QCOMPARE(assignRequested.count(), 1);
        QCOMPARE(assignRequested.front()[0].value<std::string>(), "a");
        QCOMPARE(assignRequested.front()[1].value<std::string>(), "uav-2");
        QCOMPARE(f.model.rowCount(), 5);
        QMimeData text;
        text.setText(u"a"_s);
        QVERIFY(!f.model.dropMimeData(&text, Qt::MoveAction, -1, -1, f.model.index(4, 0)));
    }

    void oneUavHasNothingToDrag()
    {
        PlanPanelFixture f;
        f.panel.showPlan(visiting({"a", "b"}));
        QVERIFY(!f.model.flags(f.model.index(0, 0)).testFlag(Qt::ItemIsDragEnabled));
        QVERIFY(!f.model.flags(f.model.index(0, 0)).testFlag(Qt::ItemIsDropEnabled));
    }
};

QTEST_MAIN(TestPlanPanelFleet)
#include "tst_plan_panel_fleet.moc"
