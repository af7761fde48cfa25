#include "tests/support/approx.h"
#include "tests/support/panel_test.h"
#include "widgets/panels/dialogs/goto_bar.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTranslator>

#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

struct Fixture
{
    QWidget map;
    GotoBar bar{&map};
    PlaceField& field = test::child<PlaceField>(map, u"gotoField"_s);
    QLabel& reason = test::child<QLabel>(map, u"gotoReason"_s);
    QPushButton& move = test::child<QPushButton>(map, u"gotoMoveButton"_s);
    QSignalSpy chosen{&bar, &GotoBar::placeChosen};
    QSignalSpy wanted{&bar, &GotoBar::moveRequested};
    QSignalSpy closed{&bar, &GotoBar::closed};

    Fixture()
    {
        map.setLocale(QLocale::c());
        map.resize(900, 600);
        map.show();
        map.activateWindow();
        if (!QTest::qWaitForWindowActive(&map))
            qFatal("the window does not come up");
        bar.open({47, -48}, true);
    }
    void type(const QString& text)
    {
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }
    [[nodiscard]] LatLon place() const { return chosen.front().front().value<LatLon>(); }
};

QString nameOrReason(const QString& text)
{
    const auto found = findPlace(text);
    const auto* place = std::get_if<FoundPlace>(&found);
    return place != nullptr ? place->name : std::get<QString>(found);
}

} // namespace

class TestPlaces : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { test::failOnWarnings(); }

    void table()
    {
        const std::vector<NamedPlace> places = namedPlaces();
        QVERIFY(places.size() >= 20);
        std::set<QString> names;
        for (const NamedPlace& place : places) {
            QVERIFY2(names.insert(searchText(place.name)).second, qPrintable(place.name));
            QVERIFY(std::abs(place.at.latitude_deg) <= 90);
            QVERIFY(place.at.longitude_deg >= -180 && place.at.longitude_deg < 180);
        }
    }

    void searchTexts()
    {
        QCOMPARE(searchText(u"Bouvetøya"_s), u"bouvetoya"_s);
        QCOMPARE(searchText(u" Ålesund  ÆRØ "_s), u"alesund aero"_s);
        QCOMPARE(searchText(u"St. John's"_s), u"st johns"_s);
        QCOMPARE(searchText(u"Sør-Georgia"_s), u"sor georgia"_s);
    }

    void finds_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("latitude_deg");
        QTest::newRow("name") << u"Hibernia"_s << u"Hibernia"_s << 46.75;
        QTest::newRow("lower case") << u"fram strait"_s << u"Fram Strait"_s << 79.0;
        QTest::newRow("no diacritics") << u"bouvetoya"_s << u"Bouvetøya"_s << -54.42;
        QTest::newRow("punctuation") << u"St Johns"_s << u"St. John's"_s << 47.56;
        QTest::newRow("part of one name") << u"ilul"_s << u"Ilulissat"_s << 69.22;
        QTest::newRow("coordinate") << u"78,22 N 15,65 Ø"_s << QString() << 78.22;
    }

    void finds()
    {
        QFETCH(QString, text);
        const auto found = findPlace(text);
        QVERIFY(std::holds_alternative<FoundPlace>(found));
        QTEST(std::get<FoundPlace>(found).name, "name");
        QTEST(std::get<FoundPlace>(found).at.latitude_deg, "latitude_deg");
    }

    void saysWhyNot()
    {
        const auto reason = [](const QString& text) { return std::get<QString>(findPlace(text)); };
        QVERIFY(reason(u"Atlantis"_s).contains(u"no place"_s));
        QVERIFY(reason(u"sea"_s).contains(u"Several"_s));
        QVERIFY(reason(u"47.05 N"_s).contains(u"half"_s));
        QVERIFY(!reason(QString()).isEmpty());
    }

    /** Names in another language are found by both, and sorted as they read. */
    void translatedNames()
    {
        QTranslator norwegian;
        QVERIFY(norwegian.load(u":/i18n/bergwatch_nb.qm"_s));
        QCoreApplication::installTranslator(&norwegian);
        QCOMPARE(nameOrReason(u"bjornoya"_s), u"Bjørnøya"_s);
        QCOMPARE(nameOrReason(u"Bear Island"_s), u"Bjørnøya"_s);
        QCOMPARE(nameOrReason(u"diskobukta"_s), u"Diskobukta"_s);
        QCoreApplication::removeTranslator(&norwegian);
    }

    void completes()
    {
        Fixture f;
        QTest::keyClicks(&f.field, u"ør"_s);
        QTRY_VERIFY(f.field.completer()->completionCount() > 0);
        for (int i = 0; i < f.field.completer()->completionCount(); ++i) {
            f.field.completer()->setCurrentRow(i);
            QVERIFY(searchText(f.field.completer()->currentCompletion()).contains(u"or"_s));
        }
    }

    void goesToACoordinate()
    {
        Fixture f;
        f.type(u"46 45 N 48 46.8 W"_s);
        QCOMPARE(f.chosen.count(), 1);
        COMPARE_NEAR(f.place().latitude_deg, 46.75, 1e-9);
        COMPARE_NEAR(f.place().longitude_deg, -48.78, 1e-9);
        QVERIFY(f.bar.isHidden());
        QCOMPARE(f.closed.count(), 1);
    }

    void explains()
    {
        Fixture f;
        f.type(u"46 45 N"_s);
        QCOMPARE(f.chosen.count(), 0);
        QVERIFY(f.reason.isVisible());
        QVERIFY(f.map.rect().contains(f.bar.geometry()));
        QTest::keyClicks(&f.field, u" 4"_s);
        QVERIFY(f.reason.isHidden()); // it is being corrected
    }

    void offersToMove()
    {
        Fixture f;
        f.type(u"Longyearbyen"_s);
        QCOMPARE(f.chosen.count(), 0);
        QVERIFY(f.reason.text().contains(u"km"_s));
        QVERIFY(f.move.isVisible());
        f.move.click();
        QCOMPARE(f.wanted.count(), 1);
        COMPARE_NEAR(f.wanted.front().front().value<LatLon>().latitude_deg, 78.22, 1e-9);
    }

    void doesNotOfferToMoveInFlight()
    {
        Fixture f;
        f.bar.open({47, -48}, false);
        f.type(u"Longyearbyen"_s);
        QVERIFY(f.reason.isVisible());
        QVERIFY(f.move.isHidden());
    }

    void escapeCloses()
    {
        Fixture f;
        QTest::keyClick(&f.field, Qt::Key_Escape);
        QVERIFY(f.bar.isHidden());
        QCOMPARE(f.closed.count(), 1);
        QCOMPARE(f.chosen.count(), 0);
    }
};

QTEST_MAIN(TestPlaces)
#include "tst_places.moc"
