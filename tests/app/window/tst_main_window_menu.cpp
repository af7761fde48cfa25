#include "tests/support/window/ids.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/places/places.h"

#include <QClipboard>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QStatusBar>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;
using test::WindowFixture;

namespace {

const Point kWater_m(2500, 1500);
constexpr double kPixel_m = 20; // more than a pixel of these maps is wide

Scenario withEverything()
{
    Scenario scenario = test::MapFixture::fourIcebergs();
    scenario.asset = Asset{.name = "Hibernia", .position_m = {2500, 2600}};
    scenario.area_m = {{1000, 500}, {4200, 500}, {4200, 3600}, {1000, 3600}};
    return scenario;
}

/** The context menu of the map at a place; it closes with the test. */
QMenu& menuAt(WindowFixture& w, const Point& place_m)
{
    QTest::mouseClick(&w.map(), Qt::RightButton, {}, w.pixelOf(place_m));
    return test::child<QMenu>(w.window(), u"mapMenu"_s);
}

QStringList textsOf(const QMenu& menu)
{
    QStringList texts;
    for (const QAction* action : menu.actions())
        if (!action->isSeparator() && action->isEnabled())
            texts << QString(action->text()).remove(u'&');
    return texts;
}

void choose(QMenu& menu, const QString& text)
{
    for (QAction* action : menu.actions())
        if (QString(action->text()).remove(u'&') == text) {
            action->trigger();
            menu.close();
            QTest::qWait(0); // deleted
            return;
        }
    qFatal("no entry %s", qPrintable(text));
}

} // namespace

/** Context menus of the map, and what the Edit menu does with icebergs. */
class TestMainWindowMenu : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** One panel has one name. */
    void panelsAreNamedAlike_data()
    {
        QTest::addColumn<QString>("action");
        QTest::addColumn<QString>("dock");
        QTest::newRow("checks") << u"checksAction"_s << u"checksDock"_s;
        QTest::newRow("study") << u"studyAction"_s << u"studyDock"_s;
        QTest::newRow("solve time") << u"solveTimeAction"_s << u"solveTimeDock"_s;
    }

    void panelsAreNamedAlike()
    {
        QFETCH(QString, action);
        QFETCH(QString, dock);
        WindowFixture w(test::MapFixture::fourIcebergs());
        QCOMPARE(w.action(action).text().remove(u'&'),
                 test::child<QDockWidget>(w.window(), dock).windowTitle());
    }

    /** Shift+F10 opens the menu on keyboards without a menu key. */
    void shiftF10OpensIt()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.workspace.selection().set({"berg-1"});
        w.map().setFocus();
        QTest::keyClick(&w.map(), Qt::Key_F10, Qt::ShiftModifier);
        auto& menu = test::child<QMenu>(w.window(), u"mapMenu"_s);
        QVERIFY(textsOf(menu).contains(u"Edit in the inspector"_s));
        menu.close();
    }

    void everyObjectOffersItsOwn_data()
    {
        QTest::addColumn<Point>("place_m");
        QTest::addColumn<QStringList>("offered");
        QTest::addColumn<QStringList>("remaining");
        const QString edit = u"Edit in the inspector"_s;
        QTest::newRow("iceberg") << Point(1500, 1000)
                                 << QStringList{edit, u"Cut"_s, u"Copy"_s, u"Duplicate"_s,
                                                u"Delete"_s}
                                 << QStringList{u"Paste here"_s, u"Remove area"_s};
        QTest::newRow("UAV") << Point(0, 0) << QStringList{edit, u"Duplicate"_s}
                             << QStringList{u"Cut"_s, u"Delete"_s};
        QTest::newRow("asset") << Point(2500, 2600) << QStringList{edit, u"Remove asset"_s}
                               << QStringList{u"Cut"_s, u"Remove area"_s};
        QTest::newRow("area") << Point(4200, 2500) << QStringList{edit, u"Remove area"_s}
                              << QStringList{u"Cut"_s, u"Remove asset"_s};
        QTest::newRow("water") << kWater_m << QStringList{u"New iceberg here"_s, u"Paste here"_s}
                               << QStringList{edit, u"Remove area"_s};
    }

    void everyObjectOffersItsOwn()
    {
        QFETCH(Point, place_m);
        QFETCH(QStringList, offered);
        QFETCH(QStringList, remaining);
        WindowFixture w(withEverything());
        const QStringList texts = textsOf(menuAt(w, place_m));
        for (const QString& text : offered)
            QVERIFY2(texts.contains(text), qPrintable(text + u" in "_s + texts.join(u", "_s)));
        for (const QString& text : remaining)
            QVERIFY2(!texts.contains(text), qPrintable(text));
        QVERIFY(texts.contains(u"Fit everything"_s));
    }

    /** A UAV over an iceberg: both can be reached. */
    void whatLiesBelowHasAMenuOfItsOwn()
    {
        Scenario scenario = test::MapFixture::fourIcebergs();
        scenario.icebergs[0].position_m = scenario.uavs[0].position_m + Point(3 * kPixel_m, 0);
        const std::string uav = scenario.uavs[0].id;
        WindowFixture w(scenario);
        w.workspace.stepTicks(1);
        QVERIFY(w.until(RunPhase::Paused));
        QMenu& menu = menuAt(w, w.record().estimate_m(0));
        QCOMPARE(w.workspace.selection().ids(), (Ids{"berg-1"}));
        QVERIFY(textsOf(menu).contains(QString::fromStdString(uav)));
        const auto open = [&] {
            for (QAction* action : menu.actions())
                if (action->menu() != nullptr)
                    menu.setActiveAction(action);
            return menu.activeAction()->menu();
        };
        QMenu& below = *open();
        QTRY_VERIFY(below.isVisible());
        QCOMPARE(w.workspace.selection().ids(), (Ids{uav}));
        menu.setActiveAction(menu.actions().front());
        QTRY_VERIFY(!below.isVisible());
        QTRY_COMPARE(w.workspace.selection().ids(), (Ids{"berg-1"}));

        open();
        QTRY_VERIFY(below.isVisible());
        QVERIFY(textsOf(below).contains(u"Return home now"_s));
        QVERIFY(!textsOf(below).contains(u"Resume"_s)); // nothing is held
        below.setActiveAction(&w.action(u"returnAction"_s));
        QTest::keyClick(&below, Qt::Key_Return);
        QVERIFY(w.until([&] {
            const auto& events = w.record().history.events;
            return std::ranges::count(events, EventKind::Intervention, &MissionEvent::kind) == 1;
        }));
        QCOMPARE(w.workspace.selection().ids(), (Ids{uav}));
    }

    void dismissedMenuLeavesTheSelectionAsItWas()
    {
        Scenario scenario = test::MapFixture::fourIcebergs();
        scenario.icebergs[0].position_m = scenario.uavs[0].position_m + Point(3 * kPixel_m, 0);
        WindowFixture w(scenario);
        const QPointer<QMenu> menu = &menuAt(w, scenario.icebergs[0].position_m);
        const Ids above = w.workspace.selection().ids();
        for (QAction* action : menu->actions())
            if (action->menu() != nullptr)
                menu->setActiveAction(action);
        QMenu& below = *menu->activeAction()->menu();
        QTRY_VERIFY(below.isVisible());
        QVERIFY(w.workspace.selection().ids() != above);
        QTest::mouseClick(&below, Qt::LeftButton, {}, QPoint(-500, -500)); // beside it
        QTRY_VERIFY(menu.isNull());
        QCOMPARE(w.workspace.selection().ids(), above);
    }

    void waterTakesIcebergs()
    {
        WindowFixture w(withEverything());
        choose(menuAt(w, kWater_m), u"New iceberg here"_s);
        QCOMPARE(w.scenario().icebergs.size(), 5U);
        QVERIFY((w.scenario().icebergs[4].position_m - kWater_m).norm() < kPixel_m);
        QCOMPARE(w.workspace.selection().ids(), (Ids{"berg-5"}));
        w.trigger(u"copyAction"_s);
        choose(menuAt(w, {2000, 2200}), u"Paste here"_s);
        QCOMPARE(w.scenario().icebergs.size(), 6U);
        QVERIFY((w.scenario().icebergs[5].position_m - Point(2000, 2200)).norm() < kPixel_m);
        QCOMPARE(w.document().undoStack()->count(), 2);
    }

    /** The place under the pointer, whatever is there. */
    void placeIsCopiedCentredAndMeasuredFrom()
    {
        WindowFixture w(withEverything());
        QMenu& menu = menuAt(w, kWater_m);
        QString copy;
        for (const QAction* action : menu.actions())
            if (action->text().startsWith(u"Copy coordinates: "_s))
                copy = action->text();
        QVERIFY(!copy.isEmpty());
        choose(menu, copy);
        const LatLon clicked =
            std::get<FoundPlace>(findPlace(QApplication::clipboard()->text())).at;
        const Point found_m = LocalFrame(w.scenario().origin).toPlane(clicked);
        QVERIFY((found_m - kWater_m).norm() < kPixel_m);
        choose(menuAt(w, kWater_m), u"Centre the map here"_s);
        QVERIFY((w.map().rect().center() - w.pixelOf(kWater_m)).manhattanLength() <= 4);
        choose(menuAt(w, kWater_m), u"Measure from here"_s);
        QVERIFY(w.map().tools().kind() == MapToolKind::Measure);
        QVERIFY(w.map().tools().isDrawing());
    }

    void assetIsPlacedWhereOneClicks()
    {
        Scenario scenario = test::MapFixture::fourIcebergs();
        WindowFixture w(scenario);
        choose(menuAt(w, kWater_m), u"Asset here"_s);
        QVERIFY(w.scenario().asset);
        QVERIFY((w.scenario().asset->position_m - kWater_m).norm() < kPixel_m);
        w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == scenario);
    }

    void uavsAreAddedAndDeleted()
    {
        WindowFixture w(withEverything());
        choose(menuAt(w, kWater_m), u"New UAV here"_s);
        QCOMPARE(w.scenario().uavs.size(), 2U);
        QVERIFY((w.scenario().uavs[1].position_m - kWater_m).norm() < kPixel_m);
        QCOMPARE(w.workspace.selection().ids(), (Ids{"uav-2"}));
        w.trigger(u"duplicateAction"_s);
        w.trigger(u"addUavAction"_s);
        QCOMPARE(w.scenario().uavs.size(), 4U);
        choose(menuAt(w, {0, 0}), u"Delete"_s);
        QCOMPARE(w.scenario().uavs.size(), 3U);
        QCOMPARE(w.scenario().uavs.front().id, std::string("uav-2"));
        for (int i = 0; i < 4; ++i)
            w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == withEverything());
    }

    /** Ctrl+U with the pointer at rest, and copies of one UAV, each have a place of their own. */
    void uavsAreAddedBesideEachOther()
    {
        WindowFixture w(withEverything());
        for (int k = 0; k < 3; ++k)
            w.trigger(u"addUavAction"_s);
        for (int k = 0; k < 2; ++k) {
            w.workspace.selection().set({"uav-1"});
            w.trigger(u"duplicateAction"_s);
        }
        const std::vector<Uav>& uavs = w.scenario().uavs;
        QCOMPARE(uavs.size(), 6U);
        for (std::size_t a = 0; a < uavs.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                QVERIFY((uavs[a].position_m - uavs[b].position_m).norm() > kPixel_m);
    }

    void assetAndAreaAreRemoved()
    {
        WindowFixture w(withEverything());
        choose(menuAt(w, {4200, 2500}), u"Remove area"_s);
        QVERIFY(w.scenario().area_m.empty());
        choose(menuAt(w, {2500, 2600}), u"Remove asset"_s);
        QVERIFY(!w.scenario().asset);
        w.trigger(u"undoAction"_s);
        w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == withEverything());
    }

    void inFlightNothingIsChanged()
    {
        WindowFixture w(withEverything());
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        QMenu& water = menuAt(w, kWater_m);
        QVERIFY(!textsOf(water).contains(u"Paste here"_s));
        water.close();
        QTest::qWait(0);
        const QStringList texts = textsOf(menuAt(w, {3500, 3000}));
        QVERIFY(texts.contains(u"Report as seen now"_s));
        QVERIFY(texts.contains(u"Show in the inspector"_s));
        QVERIFY(texts.contains(u"Copy"_s));
        for (const QString& name :
             {u"cutAction"_s, u"duplicateAction"_s, u"assetTool"_s, u"areaTool"_s})
            QVERIFY2(!w.action(name).isEnabled(), qPrintable(name));
        QVERIFY(w.action(u"measureTool"_s).isEnabled());
    }

    void keysCopyPasteCutAndDuplicate()
    {
        WindowFixture w(withEverything());
        QVERIFY(!w.action(u"copyAction"_s).isEnabled());
        w.workspace.selection().set({"berg-1", "berg-2"});
        w.map().setFocus();
        QTest::keyClick(&w.map(), Qt::Key_C, Qt::ControlModifier);
        QTest::keyClick(&w.map(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(w.scenario().icebergs.size(), 6U);
        QTest::keyClick(&w.map(), Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(w.scenario().icebergs.size(), 8U);
        QTest::keyClick(&w.map(), Qt::Key_X, Qt::ControlModifier);
        QCOMPARE(w.scenario().icebergs.size(), 6U);
        QCOMPARE(w.document().undoStack()->count(), 3);
        QApplication::clipboard()->setText(u"something else"_s);
        QTest::keyClick(&w.map(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(w.scenario().icebergs.size(), 6U);
        QCOMPARE(w.window().statusBar()->currentMessage(),
                 u"There are no icebergs on the clipboard."_s);
    }

    /** A field that is typed in keeps the keys to itself. */
    void textFieldsKeepTheirClipboard()
    {
        WindowFixture w(withEverything());
        w.workspace.selection().set({"berg-1"});
        w.window().findChild<QWidget*>(u"inspectorDock"_s)->raise();
        auto& name = test::child<QLineEdit>(w.window(), u"icebergs.name"_s);
        name.setFocus();
        QTest::keyClicks(&name, u"Big"_s);
        name.selectAll();
        QTest::keyClick(&name, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), u"Big"_s);
        name.end(false);
        QTest::keyClick(&name, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(name.text(), u"BigBig"_s);
        QCOMPARE(w.scenario().icebergs.size(), 4U);
    }

    void twoWindowsShareIcebergs()
    {
        WindowFixture from(withEverything());
        from.workspace.selection().set({"berg-3"});
        from.trigger(u"copyAction"_s);
        WindowFixture to(test::emptySea());
        to.trigger(u"pasteAction"_s);
        QCOMPARE(to.scenario().icebergs.size(), 1U);
        QVERIFY(to.scenario().icebergs[0].velocity_mps == from.scenario().icebergs[2].velocity_mps);
    }

    /** The command in the menu and the tool bar, too, takes back the last corner and no more. */
    void undoWhileDrawingTakesACornerBack()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.trigger(u"areaTool"_s);
        QVERIFY(!w.action(u"undoAction"_s).isEnabled());
        w.click(w.pixelOf(Point(2000, 1500)));
        w.click(w.pixelOf(Point(3000, 1500)));
        QVERIFY(w.action(u"undoAction"_s).isEnabled());
        w.trigger(u"undoAction"_s);
        QVERIFY(w.map().tools().isDrawing());
        w.trigger(u"undoAction"_s);
        QVERIFY(!w.map().tools().isDrawing());
        QVERIFY(!w.action(u"undoAction"_s).isEnabled());
        QVERIFY(w.scenario() == test::MapFixture::fourIcebergs());
    }
};

QTEST_MAIN(TestMainWindowMenu)
#include "tst_main_window_menu.moc"
