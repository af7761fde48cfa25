#include "core/checks/validate.h"
#include "core/io/files/iceberg_json.h"
#include "tests/support/window/ids.h"
#include "tests/support/window/map_fixture.h"
#include "widgets/document/iceberg_clipboard.h"
#include "widgets/document/scenario_edits.h"

#include <QClipboard>
#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Ids;

namespace {

void setClipboard(const QString& text)
{
    QApplication::clipboard()->setText(text);
}

Point middleOf(const std::vector<Iceberg>& icebergs)
{
    std::vector<Point> positions_m;
    for (const Iceberg& iceberg : icebergs)
        positions_m.push_back(iceberg.position_m);
    return boundsOf(positions_m).centre_m();
}

void leave(MapView& view)
{
    QEvent event(QEvent::Leave);
    QCoreApplication::sendEvent(&view, &event);
}

} // namespace

/** Copy, cut, paste and duplicate of icebergs on the map. */
class TestMapClipboard : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(u"^(?!This plugin does not support propagateSizeHints)"_s));
        QApplication::clipboard()->clear();
    }

    void copiesComeRoundTheCursor()
    {
        test::MapFixture map;
        map.selection.set({"berg-4", "berg-1", "uav-1"});
        const Scenario before = map.scenario();
        QVERIFY(map.view.edits().copySelected());
        map.move(map.pixelOf({2500, 2600}));
        map.view.edits().paste();
        QCOMPARE(map.undoCount(), 1);
        QCOMPARE(map.document.undoStack()->undoText(), u"Paste 2 icebergs"_s);
        const std::vector<Iceberg>& after = map.scenario().icebergs;
        QCOMPARE(after.size(), std::size_t{6});
        QCOMPARE(map.selection.ids(), (Ids{"berg-5", "berg-6"}));
        const std::vector<Iceberg> copies(after.begin() + 4, after.end());
        // A pixel is some metres.
        QVERIFY((middleOf(copies) - Point(2500, 2600)).norm() < 2 / map.view.view().scale_pxpm());
        const Point apart_m = copies[1].position_m - copies[0].position_m;
        QVERIFY((apart_m - Point(2000, 2000)).norm() < 1e-6);
        QVERIFY(copies[1].velocity_mps == before.icebergs[3].velocity_mps);
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
        QVERIFY(map.selection.isEmpty());
    }

    /** Without a cursor they come beside the originals, and never one on the other. */
    void copiesComeBesideEachOther()
    {
        test::MapFixture map;
        map.selection.set({"berg-1"});
        map.view.edits().copySelected();
        leave(map.view);
        for (int i = 0; i < 3; ++i)
            map.view.edits().paste();
        const std::vector<Iceberg>& icebergs = map.scenario().icebergs;
        QCOMPARE(icebergs.size(), std::size_t{7});
        for (std::size_t i = 0; i < icebergs.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY((icebergs[i].position_m - icebergs[j].position_m).norm() > 50);
        QCOMPARE(map.undoCount(), 3);
    }

    void namesGetANumber()
    {
        test::MapFixture map;
        map.document.edit(u"Names"_s, [](Scenario& s) {
            s.icebergs[0].name = "Big";
            s.icebergs[1].name = "Big 2";
            s.icebergs[2].name = "";
        });
        map.selection.set({"berg-1", "berg-2", "berg-3"});
        map.view.edits().duplicateSelected();
        QCOMPARE(map.document.undoStack()->undoText(), u"Duplicate 3 icebergs"_s);
        const std::vector<Iceberg>& icebergs = map.scenario().icebergs;
        QCOMPARE(icebergs[4].name, std::string("Big 3"));
        QCOMPARE(icebergs[5].name, std::string("Big 4"));
        QCOMPARE(icebergs[6].name, std::string());
    }

    void cutIsOneStep()
    {
        test::MapFixture map;
        const Scenario before = map.scenario();
        map.selection.set({"berg-2", "berg-3"});
        map.view.edits().cutSelected();
        QCOMPARE(map.scenario().icebergs.size(), std::size_t{2});
        QCOMPARE(map.document.undoStack()->undoText(), u"Cut 2 icebergs"_s);
        map.view.edits().pasteAt(Point(2500, 2000));
        QCOMPARE(map.scenario().icebergs.size(), std::size_t{4});
        QVERIFY(!hasErrors(map.document.issues()));
        map.document.undoStack()->undo();
        map.document.undoStack()->undo();
        QVERIFY(map.scenario() == before);
    }

    /** Between two windows the text alone carries every field. */
    void anotherWindowGetsEveryField()
    {
        test::MapFixture from;
        from.document.edit(u"Fields"_s, [](Scenario& s) {
            Iceberg& iceberg = s.icebergs[0];
            iceberg.name = "Æ \"1\"";
            iceberg.velocity_mps = {0.1, -0.2};
            iceberg.q_m2ps = 1.0 / 3;
            iceberg.sigma0_m2 = 7.1;
            iceberg.observed_s = 12;
            iceberg.appears_s = 30;
            iceberg.radius_m = 75;
            iceberg.extraJson = R"({"later":1.25})";
        });
        from.selection.set({"berg-1"});
        from.view.edits().copySelected();
        const QString text = QApplication::clipboard()->text();
        QVERIFY(text.contains(u"bergwatch-icebergs"_s));
        setClipboard(text); // plain text only, as from an editor

        test::MapFixture to;
        to.document.reset(test::emptySea());
        to.view.edits().pasteAt(Point(0, 0));
        QCOMPARE(to.scenario().icebergs.size(), std::size_t{1});
        Iceberg wanted = from.scenario().icebergs[0];
        wanted.position_m = Point::Zero();
        QCOMPARE(to.scenario().icebergs[0].id, std::string("berg-1"));
        QVERIFY(to.scenario().icebergs[0] == wanted);
    }

    void aCopyTakesItsTrackAlong()
    {
        Scenario scenario = test::emptySea();
        Iceberg& iceberg = test::addIceberg(scenario, 100, 200);
        iceberg.track = {.time_s = {0, 60}, .position_m = {{100, 200}, {150, 260}}};
        const std::vector<Iceberg> copied = scenario.icebergs;
        addCopies(scenario, copied, {1000, -500});
        QVERIFY(scenario.icebergs[1].track.position_m ==
                (std::vector<Point>{{1100, -300}, {1150, -240}}));
    }

    void groupsStayInRange()
    {
        test::MapFixture map;
        map.selection.set({"berg-1", "berg-4"});
        map.view.edits().copySelected();
        map.view.edits().pasteAt(Point(kLargestCoordinate_m, kLargestCoordinate_m));
        QVERIFY(!hasErrors(map.document.issues()));
        const std::vector<Iceberg>& icebergs = map.scenario().icebergs;
        const Point apart_m = icebergs[5].position_m - icebergs[4].position_m;
        QVERIFY((apart_m - Point(2000, 2000)).norm() < 1e-6);
    }

    void otherTextIsRefused_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("nothing") << u""_s;
        QTest::newRow("prose") << u"47 N 48 W: one large iceberg"_s;
        QTest::newRow("table") << u"berg-1\t100\t200\n"_s;
        QTest::newRow("another format") << u"{\"format\":\"bergwatch-scenario\",\"version\":1}"_s;
        QTest::newRow("newer") << u"{\"format\":\"bergwatch-icebergs\",\"version\":2}"_s;
        QTest::newRow("no icebergs") << u"{\"format\":\"bergwatch-icebergs\",\"version\":1}"_s;
        const QString begin = u"{\"format\":\"bergwatch-icebergs\",\"version\":1,\"icebergs\":"_s;
        QTest::newRow("no list") << begin + u"7}"_s;
        QTest::newRow("no position") << begin + u"[{\"id\":\"a\"}]}"_s;
        QTest::newRow("out of range") << begin + u"[{\"position_m\":[1e7,0]}]}"_s;
        QTest::newRow("too fast") << begin + u"[{\"position_m\":[0,0],\"velocity_mps\":[9,0]}]}"_s;
        QTest::newRow("text for a number") << begin + u"[{\"position_m\":[\"0\",0]}]}"_s;
        QTest::newRow("infinite") << begin + u"[{\"position_m\":[1e999,0]}]}"_s;
        QTest::newRow("cut short") << begin + u"[{\"position_m\":[0,0]}"_s;
        QTest::newRow("too deep") << begin + QString(10000, u'[');
        QString many = begin + u"["_s;
        for (std::size_t i = 0; i <= kMostIcebergs; ++i)
            many += u"{\"position_m\":[0,0]},"_s;
        many.chop(1);
        QTest::newRow("too many") << many + u"]}"_s;
        QTest::newRow("too long") << begin + QString(5 << 20, u' ') + u"[]}"_s;
    }

    void otherTextIsRefused()
    {
        QFETCH(QString, text);
        test::MapFixture map;
        const Scenario before = map.scenario();
        const QSignalSpy refused(&map.view, &MapView::refused);
        setClipboard(text);
        map.view.edits().paste();
        QCOMPARE(refused.count(), 1);
        QVERIFY(!refused.at(0).at(0).toString().isEmpty());
        QVERIFY(map.scenario() == before);
        QCOMPARE(map.undoCount(), 0);
    }

    void anEmptyClipboardIsRefused()
    {
        test::MapFixture map;
        const QSignalSpy refused(&map.view, &MapView::refused);
        map.view.edits().paste();
        QCOMPARE(refused.count(), 1);
        QCOMPARE(map.undoCount(), 0);
    }

    void aFullScenarioIsRefused()
    {
        test::MapFixture map;
        map.document.edit(u"Fill"_s, [](Scenario& s) {
            while (s.icebergs.size() < kMostIcebergs - 1)
                test::addIceberg(s, 10.0 * static_cast<double>(s.icebergs.size()), -5000);
        });
        map.selection.set({"berg-1", "berg-2"});
        map.view.edits().copySelected();
        const QSignalSpy refused(&map.view, &MapView::refused);
        map.view.edits().paste();
        map.view.edits().duplicateSelected();
        QCOMPARE(refused.count(), 2);
        QCOMPARE(map.scenario().icebergs.size(), kMostIcebergs - 1);
        map.selection.set({"berg-1"});
        map.view.edits().duplicateSelected();
        QCOMPARE(map.scenario().icebergs.size(), kMostIcebergs);
        QVERIFY(!hasErrors(map.document.issues()));
        map.view.edits().addIcebergAt({0, 0});
        QCOMPARE(refused.count(), 3);
        QCOMPARE(map.scenario().icebergs.size(), kMostIcebergs);
    }

    void lockedMapCopiesOnly()
    {
        test::MapFixture map;
        map.selection.set({"berg-1"});
        map.view.setPicture(withScenario({}, map.scenario()));
        map.view.setLocked(true);
        const Scenario before = map.scenario();
        QVERIFY(map.view.edits().copySelected());
        map.view.edits().cutSelected();
        map.view.edits().paste();
        map.view.edits().duplicateSelected();
        map.view.edits().addIcebergAt({2000, 2000});
        QVERIFY(map.scenario() == before);
    }

    void nothingSelectedIsNotCopied()
    {
        test::MapFixture map;
        setClipboard(u"kept"_s);
        QVERIFY(!map.view.edits().copySelected());
        map.view.edits().cutSelected();
        map.view.edits().duplicateSelected();
        QCOMPARE(QApplication::clipboard()->text(), u"kept"_s);
        QCOMPARE(map.undoCount(), 0);
    }

    void uavsAreDuplicatedButNotCopied()
    {
        test::MapFixture map;
        setClipboard(u"kept"_s);
        map.selection.set({"uav-1"});
        QVERIFY(!map.view.edits().copySelected());
        map.view.edits().cutSelected();
        QCOMPARE(QApplication::clipboard()->text(), u"kept"_s);
        QCOMPARE(map.undoCount(), 0);
        map.view.edits().duplicateSelected();
        QCOMPARE(map.undoCount(), 1);
        QCOMPARE(map.scenario().uavs.size(), std::size_t{2});
    }
};

QTEST_MAIN(TestMapClipboard)
#include "tst_map_clipboard.moc"
