#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/panels/fields/place_field.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QTranslator>

#include <set>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

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

    void namedPlacesAreValid()
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

    void searchTextIgnoresCaseAndDiacritics()
    {
        QCOMPARE(searchText(u"Bouvetøya"_s), u"bouvetoya"_s);
        QCOMPARE(searchText(u" Ålesund  ÆRØ "_s), u"alesund aero"_s);
        QCOMPARE(searchText(u"St. John's"_s), u"st johns"_s);
        QCOMPARE(searchText(u"Tromsø"_s), u"tromso"_s);
        QCOMPARE(searchText(u"Ísafjörður"_s), u"isafjordur"_s);
        QCOMPARE(searchText(u"Utqiaġvik"_s), u"utqiagvik"_s);
        QCOMPARE(searchText(u"Sør-Georgia"_s), u"sor georgia"_s);
    }

    void findsNamesAndCoordinates_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("latitude_deg");
        QTest::newRow("name") << u"Hibernia"_s << u"Hibernia"_s << 46.75;
        QTest::newRow("lower case") << u"fram strait"_s << u"Fram Strait"_s << 79.0;
        QTest::newRow("no diacritics") << u"bouvetoya"_s << u"Bouvetøya"_s << -54.42;
        QTest::newRow("punctuation") << u"St Johns"_s << u"St. John's"_s << 47.56;
        QTest::newRow("former name") << u"godthab"_s << u"Nuuk"_s << 64.18;
        QTest::newRow("part of one name") << u"ilul"_s << u"Ilulissat"_s << 69.22;
        QTest::newRow("coordinate") << u"78,22 N 15,65 Ø"_s << QString() << 78.22;
    }

    void findsNamesAndCoordinates()
    {
        QFETCH(QString, text);
        const auto found = findPlace(text);
        QVERIFY(std::holds_alternative<FoundPlace>(found));
        QTEST(std::get<FoundPlace>(found).name, "name");
        QTEST(std::get<FoundPlace>(found).at.latitude_deg, "latitude_deg");
    }

    void reasonsAreShown()
    {
        const auto reason = [](const QString& text) { return std::get<QString>(findPlace(text)); };
        QVERIFY(reason(u"Atlantis"_s).contains(u"No known place"_s));
        QVERIFY(reason(u"sea"_s).contains(u"Several"_s));
        QVERIFY(reason(u"bay"_s).contains(u"Several"_s)); // a square of MGRS in Antarctica as well
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

    void completesNames()
    {
        PlaceField field;
        field.show();
        field.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&field));
        field.setFocus();
        QTest::keyClicks(&field, u"ørv"_s);
        QTRY_VERIFY(field.completer()->completionCount() > 0);
        for (int i = 0; i < field.completer()->completionCount(); ++i) {
            field.completer()->setCurrentRow(i);
            QVERIFY(searchText(field.completer()->currentCompletion()).contains(u"orv"_s));
        }
    }
};

QTEST_MAIN(TestPlaces)
#include "tst_places.moc"
