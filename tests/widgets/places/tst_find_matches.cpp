#include "tests/support/approx.h"
#include "tests/support/flight/mission_builder.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/places/find_matches.h"

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

std::vector<FindItem> everything()
{
    Scenario scenario = test::fourIcebergs();
    scenario.icebergs[1].name = "Big Bertha";
    std::vector<FindItem> items = findableItems(scenario);
    items.push_back({.kind = FindKind::Command,
                     .key = u"exportAction"_s,
                     .text = u"Export plan..."_s,
                     .other = {},
                     .hint = u"Ctrl+E"_s,
                     .at = {}});
    items.push_back({.kind = FindKind::Command,
                     .key = u"zoomInAction"_s,
                     .text = u"Zoom in"_s,
                     .other = {},
                     .hint = {},
                     .at = {}});
    items.push_back({.kind = FindKind::Command,
                     .key = u"studyAction"_s,
                     .text = u"Study of τ and policies"_s,
                     .other = {},
                     .hint = {},
                     .at = {}});
    items.push_back({.kind = FindKind::Command,
                     .key = u"tradeoffDockAction"_s,
                     .text = u"Trade-off"_s,
                     .other = u"Trade-off τ, policy, solver and route"_s,
                     .hint = {},
                     .at = {}});
    return items;
}

QStringList textsOf(const std::vector<FindItem>& items)
{
    QStringList texts;
    for (const FindItem& item : items)
        texts << item.text;
    return texts;
}

QStringList foundBy(const QString& text, std::size_t most = 20)
{
    return textsOf(findMatches(text, everything(), most));
}

} // namespace

class TestFindMatches : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { test::failOnWarnings(); }

    void bestMatchComesFirst_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("best");
        QTest::newRow("Greek letter") << u"tau"_s << u"Study of τ and policies"_s;
        QTest::newRow("what a command is for") << u"policy"_s << u"Trade-off"_s;
        QTest::newRow("id of an iceberg") << u"berg-4"_s << u"berg-4"_s;
        QTest::newRow("with a space") << u"berg 4"_s << u"berg-4"_s;
        QTest::newRow("name") << u"bertha"_s << u"Big Bertha"_s;
        QTest::newRow("id of one that has a name") << u"berg-2"_s << u"Big Bertha"_s;
        QTest::newRow("UAV") << u"uav"_s << u"uav-1"_s;
        QTest::newRow("place") << u"disko"_s << u"Disko Bay"_s;
        QTest::newRow("no diacritics") << u"bouvetoya"_s << u"Bouvetøya"_s;
        QTest::newRow("former name") << u"jakobshavn"_s << u"Ilulissat"_s;
        QTest::newRow("town, not its bay or cape") << u"bonavista"_s << u"Bonavista"_s;
        QTest::newRow("field") << u"johan"_s << u"Johan Castberg"_s;
        QTest::newRow("command") << u"export"_s << u"Export plan..."_s;
        QTest::newRow("words in any order") << u"plan exp"_s << u"Export plan..."_s;
        QTest::newRow("coordinate") << u"47 03.2 N 48 06 W"_s << u"47° 03.200′ N  48° 06.000′ W"_s;
        QTest::newRow("MGRS") << u"33XWG1449783437"_s << u"78° 14.000′ N  15° 38.000′ E"_s;
    }

    void bestMatchComesFirst()
    {
        QFETCH(QString, text);
        QFETCH(QString, best);
        const QStringList found = foundBy(text);
        QVERIFY2(!found.isEmpty(), qPrintable(text));
        if (QTest::currentDataTag() != QByteArray("MGRS"))
            QCOMPARE(found.front(), best);
        else
            QVERIFY2(found.front().startsWith(best.left(3)), qPrintable(found.front()));
    }

    void matchesAreRanked()
    {
        // Ranks: the name begins so; a word begins so; the text is inside.
        const std::vector<FindItem> items{{.text = u"Xsea"_s},
                                          {.text = u"Ross Sea"_s},
                                          {.text = u"Seal Bay"_s},
                                          {.text = u"Sea"_s},
                                          {.text = u"Weddell Sea"_s, .isFavourite = true}};
        QCOMPARE(
            textsOf(findMatches(u"sea"_s, items, 9)),
            (QStringList{u"Sea"_s, u"Seal Bay"_s, u"Weddell Sea"_s, u"Ross Sea"_s, u"Xsea"_s}));
        QCOMPARE(findMatches(u"sea"_s, items, 2).size(), std::size_t{2});
    }

    /** "bay" is also a square of MGRS in Antarctica. */
    void wordsAreNamesFirst()
    {
        const std::vector<FindItem> found = findMatches(u"bay"_s, everything(), 100);
        QVERIFY(found.size() > 10);
        for (std::size_t i = 0; i + 1 < found.size(); ++i)
            QVERIFY2(!found[i].key.isEmpty(), qPrintable(found[i].text));
        QVERIFY(found.back().key.isEmpty()); // the coordinate
        QVERIFY(found.back().at.latitude_deg < -80);
        const QStringList shown = foundBy(u"bay"_s, 9);
        // Then the names with this word, best known first.
        QVERIFY(shown.front().startsWith(u"Bay "_s));
        for (const QString& name : {u"Baffin Bay"_s, u"Disko Bay"_s, u"Melville Bay"_s})
            QVERIFY2(shown.contains(name), qPrintable(shown.join(u", "_s)));
        QVERIFY(findMatches(u"33XWG1449783437"_s, everything(), 9).front().key.isEmpty());
    }

    void unknownTextFindsNothing()
    {
        QVERIFY(foundBy(u"Atlantis"_s).isEmpty());
        QVERIFY(foundBy(QString()).isEmpty()); // there are no favourites
        QVERIFY(foundBy(u" ... "_s).isEmpty());
    }

    void favouritesAreMarkedAndListed()
    {
        std::vector<FindItem> items = everything();
        const auto found = findMatches(u"47.05 -48.1"_s, items, 1);
        const QString coordinate = favouriteKey(found.front());
        QVERIFY(favouriteKey(items.front()).isEmpty()); // an iceberg is of one scenario
        markFavourites(items, {u"place:Disko Bay"_s, u"command:zoomInAction"_s, coordinate,
                               u"place:Atlantis"_s, u"at:nowhere"_s});
        const std::vector<FindItem> shown = findMatches(QString(), items, 20);
        QCOMPARE(textsOf(shown),
                 (QStringList{u"Disko Bay"_s, u"Zoom in"_s, u"47° 03.000′ N  48° 06.000′ W"_s}));
        COMPARE_NEAR(shown.back().at.longitude_deg, -48.1, 1e-12);
    }

    /** 500 icebergs are searched quickly. */
    void findsAmongMany()
    {
        Scenario scenario = test::emptySea();
        for (int i = 0; i < 500; ++i)
            test::addIceberg(scenario, i, i);
        const std::vector<FindItem> items = findableItems(scenario);
        QCOMPARE(textsOf(findMatches(u"berg-321"_s, items, 9)), QStringList{u"berg-321"_s});
        QCOMPARE(findMatches(u"berg"_s, items, 9).size(), std::size_t{9});
    }
};

QTEST_MAIN(TestFindMatches)
#include "tst_find_matches.moc"
