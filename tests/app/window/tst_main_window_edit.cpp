#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QTableView>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

constexpr double kPixel_m = 20; // more than a pixel of these maps is wide

} // namespace

/** Editing by mouse and keys in the whole window. */
class TestMainWindowEdit : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Undo of what is half typed takes that back, and nothing is kept beside the history. */
    void undoWhileANumberIsTyped()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const Scenario start = w.scenario();
        w.document().edit(u"filter"_s, [](Scenario& scenario) {
            scenario.observer.model = ObserverModel::Kalman;
        });
        const Scenario filtered = w.scenario();
        auto& error = test::child<QDoubleSpinBox>(w.window(), u"observer.position_sd_m"_s);
        error.setFocus();
        error.selectAll();
        QTest::keyClicks(&error, u"77"_s);
        w.trigger(u"undoAction"_s); // the number
        QVERIFY(w.scenario() == filtered);
        w.trigger(u"undoAction"_s); // the filter; its rows go
        QVERIFY(w.scenario() == start);
        QVERIFY(w.document().isClean());
        w.trigger(u"redoAction"_s);
        QVERIFY(w.scenario() == filtered);
    }

    void clickingDraggingDeletingAndBack()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const Scenario start = w.scenario();
        const std::vector<Point> places_m{{2500, 1500}, {2500, 2200}, {2000, 2500}};

        w.trigger(u"icebergTool"_s);
        for (const Point& place_m : places_m)
            w.click(w.pixelOf(place_m));
        QCOMPARE(w.scenario().icebergs.size(), 7U);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY((w.scenario().icebergs[4 + i].position_m - places_m[i]).norm() < kPixel_m);

        w.trigger(u"selectTool"_s);
        const std::string dragged = w.scenario().icebergs[4].id;
        w.drag(w.pixelOf(dragged), w.pixelOf(Point(3000, 1700)));
        QVERIFY((w.scenario().icebergs[4].position_m - Point(3000, 1700)).norm() < kPixel_m);
        QTest::keyClick(&w.map(), Qt::Key_Delete);
        QCOMPARE(w.scenario().icebergs.size(), 6U);
        QVERIFY(w.workspace.selection().isEmpty());
        QVERIFY(!w.action(u"deleteAction"_s).isEnabled());

        QCOMPARE(w.document().undoStack()->count(), 5);
        const Scenario end = w.scenario();
        int undone = 0;
        for (; w.action(u"undoAction"_s).isEnabled(); ++undone)
            QTest::keyClick(&w.window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(undone, 5);
        QVERIFY(w.scenario() == start);
        QVERIFY(!w.window().isWindowModified());
        for (int redone = 0; redone < undone; ++redone)
            QTest::keyClick(&w.window(), Qt::Key_Y, Qt::ControlModifier);
        QVERIFY(w.scenario() == end);
        QVERIFY(!w.action(u"redoAction"_s).isEnabled());
        QVERIFY(w.window().isWindowModified());
    }

    /** After each edit what is shown is the plan of the scenario as it is. */
    void everyEditIsPlanned()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& plan = test::child<QTableView>(w.window(), u"planTable"_s);
        QCOMPARE(plan.model()->rowCount(), 4);
        w.trigger(u"icebergTool"_s);
        w.click(w.pixelOf(Point(2500, 1500)));
        QVERIFY(w.untilReady());
        QCOMPARE(plan.model()->rowCount(), 5);
        const Scenario scenario = w.scenario();
        QCOMPARE(w.record().now.plan->uavs[0].order,
                 test::elsewhere([&] { return planFromStart(scenario).uavs[0].order; }));
        w.trigger(u"undoAction"_s);
        QVERIFY(w.untilReady());
        QCOMPARE(plan.model()->rowCount(), 4);
        w.trigger(u"selectAllAction"_s);
        QTest::keyClick(&w.map(), Qt::Key_Delete);
        QVERIFY(w.untilReady());
        QCOMPARE(plan.model()->rowCount(), 0);
    }

    void undoUnderAPressedCornerEndsIt()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const Scenario start = w.scenario();
        w.trigger(u"areaTool"_s);
        const std::vector<Point> corners_m{{500, 500}, {4500, 500}, {4500, 3500}, {500, 3500}};
        for (const Point& corner_m : corners_m)
            w.click(w.pixelOf(corner_m));
        QTest::keyClick(&w.map(), Qt::Key_Return);
        QCOMPARE(w.scenario().area_m.size(), 4U);
        const QPoint last = w.pixelOf(w.scenario().area_m.back());
        QTest::mousePress(&w.map(), Qt::LeftButton, {}, last);
        QTest::keyClick(&w.window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(w.scenario() == start);
        for (int i = 1; i <= 4; ++i)
            QTest::mouseMove(&w.map(), last + QPoint(10 * i, 5 * i));
        QTest::mouseRelease(&w.map(), Qt::LeftButton, {}, last + QPoint(40, 20));
        QVERIFY(w.scenario() == start);
        QVERIFY(!w.action(u"undoAction"_s).isEnabled());
    }

    void dragOfTauIsOneStep()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const double before = w.scenario().planner.tau;
        w.dragTau(0.5, 0.9);
        QVERIFY(w.scenario().planner.tau > 4);
        QCOMPARE(w.document().undoStack()->count(), 1);
        w.dragTau(0.9, 0.3);
        QCOMPARE(w.document().undoStack()->count(), 2);
        QVERIFY(w.untilReady());
        QCOMPARE(w.record().now.planner.tau, w.scenario().planner.tau);
        w.trigger(u"undoAction"_s);
        w.trigger(u"undoAction"_s);
        QCOMPARE(w.scenario().planner.tau, before);
        QCOMPARE(test::child<QSlider>(w.window(), u"tauSlider"_s).value(),
                 static_cast<int>(100 * before));
    }

    void dragOfTauThatComesBackIsNoStep()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& slider = test::child<QSlider>(w.window(), u"tauSlider"_s);
        w.dragTau(0.5, 0.9);
        const int there = slider.value();
        const int steps = w.document().undoStack()->count();
        QTest::mousePress(&slider, Qt::LeftButton, {},
                          QPoint(static_cast<int>(0.9 * slider.width()), slider.height() / 2));
        slider.setValue(there - 100);
        slider.setValue(there);
        QTest::mouseRelease(&slider, Qt::LeftButton, {},
                            QPoint(static_cast<int>(0.9 * slider.width()), slider.height() / 2));
        QCOMPARE(slider.value(), there);
        QCOMPARE(w.document().undoStack()->count(), steps);
    }

    void typedTauIsTaken()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        test::enter(test::child<QDoubleSpinBox>(w.window(), u"tauField"_s), u"17.5"_s);
        QCOMPARE(w.scenario().planner.tau, 17.5);
        QCOMPARE(w.document().undoStack()->count(), 1);
    }

    /** A click in the list of the plan selects on the map; the map's selection is inspected. */
    void listMapAndInspectorShareTheSelection()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& plan = test::child<QTableView>(w.window(), u"planTable"_s);
        QTest::mouseClick(plan.viewport(), Qt::LeftButton, {},
                          plan.visualRect(plan.model()->index(1, 1)).center());
        const std::size_t second = toIndex(w.record().now.plan->uavs[0].order[1]);
        const std::string id = w.scenario().icebergs[second].id;
        QCOMPARE(w.workspace.selection().ids(), std::vector<std::string>{id});
        QCOMPARE(test::child<QLineEdit>(w.window(), u"icebergId"_s).text(),
                 QString::fromStdString(id));
        QVERIFY(w.action(u"deleteAction"_s).isEnabled());
    }

    void doubleClickOpensTheInspector()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        auto& id = test::child<QLineEdit>(w.window(), u"icebergId"_s);
        QVERIFY(!id.isVisible()); // behind the plan
        w.click(w.pixelOf("berg-3"));
        QTest::mouseDClick(&w.map(), Qt::LeftButton, {}, w.pixelOf("berg-3"));
        QVERIFY(w.until([&] { return id.isVisible(); }));
        QCOMPARE(id.text(), u"berg-3"_s);
    }

    void lockedInFlight_data()
    {
        QTest::addColumn<QString>("start");
        QTest::newRow("paused after a step") << u"stepAction"_s;
        QTest::newRow("flying") << u"playAction"_s;
    }

    void lockedInFlight()
    {
        QFETCH(QString, start);
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.trigger(u"icebergTool"_s);
        w.click(w.pixelOf(Point(2500, 2000)));
        w.workspace.selection().set({"berg-1"});
        QVERIFY(w.untilReady());
        const Scenario before = w.scenario();
        w.trigger(start);
        QVERIFY(w.until([&] { return w.workspace.inFlight(); }));

        for (const QString& name : {u"undoAction"_s, u"redoAction"_s, u"areaTool"_s, u"uavTool"_s})
            QVERIFY2(!w.action(name).isEnabled(), qPrintable(name));
        QVERIFY(w.action(u"selectTool"_s).isChecked());
        w.drag(w.pixelOf("berg-2"), w.pixelOf(Point(3000, 2000)));
        QTest::keyClick(&w.map(), Qt::Key_I);
        w.click(w.pixelOf(Point(2800, 1400)));
        w.workspace.selection().set({"uav-1"});
        QTest::keyClick(&w.map(), Qt::Key_Delete);
        QTest::keyClick(&w.map(), Qt::Key_Left);
        QTest::keyClick(&w.window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(w.scenario() == before);

        w.trigger(u"resetAction"_s);
        QVERIFY(w.untilReady());
        QVERIFY(w.action(u"icebergTool"_s).isEnabled());
        QVERIFY(w.action(u"undoAction"_s).isEnabled());
        w.drag(w.pixelOf("berg-2"), w.pixelOf(Point(3000, 2000)));
        QVERIFY(w.scenario() != before);
        w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == before);
    }
};

QTEST_MAIN(TestMainWindowEdit)
#include "tst_main_window_edit.moc"
