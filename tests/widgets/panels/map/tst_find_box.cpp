#include "tests/support/approx.h"
#include "tests/support/flight/mission_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/map/find_box.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

struct FindBoxFixture
{
    QWidget map;
    FindBox box{&map};
    QLineEdit& field = test::child<QLineEdit>(map, u"findField"_s);
    QListWidget& list = test::child<QListWidget>(map, u"findList"_s);
    QLabel& reason = test::child<QLabel>(map, u"findReason"_s);
    QPushButton& move = test::child<QPushButton>(map, u"findMoveButton"_s);
    QPushButton& fresh = test::child<QPushButton>(map, u"findNewButton"_s);
    QToolButton& star = test::child<QToolButton>(map, u"findFavourite"_s);
    QSignalSpy placeChosen{&box, &FindBox::placeChosen};
    QSignalSpy objectChosen{&box, &FindBox::objectChosen};
    QSignalSpy commandChosen{&box, &FindBox::commandChosen};
    QSignalSpy moveRequested{&box, &FindBox::moveRequested};
    QSignalSpy newRequested{&box, &FindBox::newRequested};
    QSignalSpy whereChosen{&box, &FindBox::whereChosen};
    QSignalSpy favouriteChanged{&box, &FindBox::favouriteChanged};
    QSignalSpy closed{&box, &FindBox::closed};

    explicit FindBoxFixture(bool mayMove = true, bool asksWhere = false)
    {
        map.setLocale(QLocale::c());
        map.resize(900, 600);
        map.show();
        map.activateWindow();
        if (!QTest::qWaitForWindowActive(&map))
            qFatal("the window does not come up");
        open(mayMove, asksWhere);
    }
    void open(bool mayMove = true, bool asksWhere = false, const QStringList& favourites = {})
    {
        std::vector<FindItem> items = findableItems(test::fourIcebergs());
        items.push_back({.kind = FindKind::Command,
                         .key = u"fitAction"_s,
                         .text = u"Fit everything"_s,
                         .other = {},
                         .hint = u"F"_s,
                         .at = {}});
        markFavourites(items, favourites);
        box.open({.items = items, .origin = {47, -48}, .mayMove = mayMove, .asksWhere = asksWhere});
    }
    void type(const QString& text)
    {
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }
};

} // namespace

class TestFindBox : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qRegisterMetaType<std::string>("std::string");
        QLocale::setDefault(QLocale::c());
    }
    void init() { test::failOnWarnings(); }

    void goesToACoordinate()
    {
        FindBoxFixture f;
        f.type(u"46 45 N 48 46.8 W"_s);
        QCOMPARE(f.placeChosen.count(), 1);
        const auto at = f.placeChosen.front().front().value<LatLon>();
        COMPARE_NEAR(at.latitude_deg, 46.75, 1e-9);
        COMPARE_NEAR(at.longitude_deg, -48.78, 1e-9);
        QVERIFY(f.box.isHidden());
        QCOMPARE(f.closed.count(), 1);
    }

    void choosesWhatIsListed()
    {
        FindBoxFixture f;
        f.type(u"berg-3"_s);
        QCOMPARE(f.objectChosen.front().front().value<std::string>(), "berg-3");
        f.open();
        f.type(u"fit"_s);
        QCOMPARE(f.commandChosen.front().front().toString(), u"fitAction"_s);
        f.open();
        QTest::keyClicks(&f.field, u"berg"_s);
        QVERIFY(f.list.count() >= 4);
        QTest::keyClick(&f.field, Qt::Key_Down);
        QTest::keyClick(&f.field, Qt::Key_Down);
        QTest::keyClick(&f.field, Qt::Key_Up);
        QTest::keyClick(&f.field, Qt::Key_Return);
        QCOMPARE(f.objectChosen.back().front().value<std::string>(), "berg-2");
    }

    void incompleteCoordinateIsExplained()
    {
        FindBoxFixture f;
        f.type(u"46 45 N"_s);
        QCOMPARE(f.placeChosen.count(), 0);
        QVERIFY(f.reason.isVisible());
        QVERIFY(f.map.rect().contains(f.box.geometry()));
        QTest::keyClicks(&f.field, u" 4"_s);
        QVERIFY(f.reason.isHidden()); // it is being corrected
    }

    void offersToMove()
    {
        FindBoxFixture f;
        f.type(u"Longyearbyen"_s);
        QCOMPARE(f.placeChosen.count(), 0);
        QVERIFY(f.reason.text().contains(u"km"_s));
        QVERIFY(f.move.isVisible());
        f.move.click();
        QCOMPARE(f.moveRequested.count(), 1);
        COMPARE_NEAR(f.moveRequested.front().front().value<LatLon>().latitude_deg, 78.22, 1e-9);
    }

    void doesNotOfferToMoveInFlight()
    {
        FindBoxFixture f(false);
        f.type(u"Longyearbyen"_s);
        QVERIFY(f.reason.isVisible());
        QVERIFY(f.move.isHidden());
    }

    void offersANewScenarioThere()
    {
        FindBoxFixture f;
        QTest::keyClicks(&f.field, u"berg-1"_s);
        QVERIFY(f.fresh.isHidden());
        f.field.selectAll();
        QTest::keyClicks(&f.field, u"Hibernia"_s);
        QVERIFY(f.fresh.isVisible());
        f.fresh.click();
        COMPARE_NEAR(f.newRequested.front().front().value<LatLon>().latitude_deg, 46.75, 1e-9);
        QVERIFY(f.box.isHidden());
    }

    void asksForThePlaceOfANewScenario()
    {
        FindBoxFixture f(true, true);
        QVERIFY(f.field.placeholderText().contains(u"Where"_s));
        QTest::keyClicks(&f.field, u"berg"_s);
        for (int row = 0; row < f.list.count(); ++row)
            QVERIFY(!f.list.item(row)->text().contains(u"Iceberg"_s));
        f.field.selectAll();
        f.type(u"Longyearbyen"_s); // however far
        COMPARE_NEAR(f.whereChosen.front().front().value<LatLon>().latitude_deg, 78.22, 1e-9);
        QCOMPARE(f.placeChosen.count(), 0);
    }

    /** Rows state type and position; a coordinate has no name. */
    void rowsSayWhatTheyAre()
    {
        FindBoxFixture f;
        const auto firstOf = [&](const QString& text) {
            f.field.selectAll();
            QTest::keyClicks(&f.field, text);
            return f.list.item(0)->text();
        };
        QCOMPARE(firstOf(u"Bonavista Bay"_s),
                 u"Bonavista Bay   –   Sea or bay, 48° 48′ N  53° 27′ W"_s);
        QVERIFY(firstOf(u"Cape Bonavista"_s).contains(u"Cape, 48° 42′ N"_s));
        QVERIFY(firstOf(u"Hibernia"_s).contains(u"Oil or gas field"_s));
        QVERIFY(firstOf(u"Longyearbyen"_s).contains(u"Town or station"_s));
        QVERIFY(firstOf(u"48 45 N 52 30 W"_s).endsWith(u"Coordinate"_s));
    }

    void favouritesAreListedAtOnce()
    {
        FindBoxFixture f;
        QVERIFY(f.list.isHidden());
        QTest::keyClicks(&f.field, u"hibernia"_s);
        QVERIFY(!f.star.isChecked());
        f.star.click();
        QCOMPARE(f.favouriteChanged.front(), (QVariantList{u"place:Hibernia"_s, true}));
        f.open(true, false, {u"place:Hibernia"_s, u"command:fitAction"_s});
        QCOMPARE(f.list.count(), 2);
        QVERIFY(f.star.isChecked());
        QTest::keyClick(&f.field, Qt::Key_Return);
        QCOMPARE(f.placeChosen.front().back().toString(), u"Hibernia"_s);
        f.open();
        QTest::keyClicks(&f.field, u"berg-1"_s);
        QVERIFY(!f.star.isEnabled()); // it is of this scenario
    }

    void escapeClosesTheBox()
    {
        FindBoxFixture f;
        QTest::keyClick(&f.field, Qt::Key_Escape);
        QVERIFY(f.box.isHidden());
        QCOMPARE(f.closed.count(), 1);
        QCOMPARE(f.placeChosen.count(), 0);
    }
};

QTEST_MAIN(TestFindBox)
#include "tst_find_box.moc"
