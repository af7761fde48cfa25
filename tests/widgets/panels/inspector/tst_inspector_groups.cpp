#include "tests/support/flight/mission_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/panels/fields/fold_heading.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/inspector/inspector_panel.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

struct GroupsFixture
{
    ScenarioDocument document;
    Selection selection;
    InspectorPanel panel{document, selection};

    GroupsFixture()
    {
        document.reset(test::fourIcebergs());
        panel.resize(test::kDock_px, 900);
        panel.show();
    }
    [[nodiscard]] bool isShown(const QString& name) const
    {
        return test::child<QWidget>(panel, name).isVisibleTo(&panel);
    }
    [[nodiscard]] int top_px(const QString& name) const
    {
        return test::child<QWidget>(panel, name).mapTo(&panel, QPoint()).y();
    }
    void press(const QString& heading) { test::child<FoldHeading>(panel, heading).click(); }
};

} // namespace

/** The rows of the Inspector are below headings that fold them. */
class TestInspectorGroups : public QObject
{
    Q_OBJECT

private slots:
    void headingsFoldTheirRows()
    {
        GroupsFixture f;
        QVERIFY(f.isShown(u"scenarioWindSpeed"_s));
        const QSignalSpy folded(&f.panel, &InspectorPanel::folded);
        f.press(u"scenarioWeatherGroup"_s);
        QVERIFY(!f.isShown(u"scenarioWindSpeed"_s));
        QVERIFY(f.isShown(u"scenarioLatitude"_s));
        QCOMPARE(folded.count(), 1);
        QVERIFY(f.panel.foldedGroups().contains(u"scenarioWeatherGroup"_s));
        f.press(u"scenarioWeatherGroup"_s);
        QVERIFY(f.isShown(u"scenarioWindSpeed"_s));
    }

    void whatIsRarelyChangedIsLastAndFolded()
    {
        GroupsFixture f;
        QVERIFY(!f.isShown(u"seed"_s));
        f.press(u"scenarioSimulationGroup"_s);
        QTest::qWait(0);
        for (const char* rare : {"seed", "dt_s", "noise"})
            for (const char* usual : {"duration_s", "scenarioWindSpeed", "planner.reach_radius_m"})
                QVERIFY2(f.top_px(QLatin1String(rare)) > f.top_px(QLatin1String(usual)), rare);
        f.selection.set({"berg-1"});
        QTest::qWait(0);
        QVERIFY(f.top_px(u"icebergLatitude"_s) < f.top_px(u"icebergEast"_s));
    }

    /** In flight, locked rows can still be read. */
    void headingsFoldInFlight()
    {
        GroupsFixture f;
        f.panel.setLocked(true);
        f.press(u"scenarioSimulationGroup"_s);
        QVERIFY(f.isShown(u"seed"_s));
        QVERIFY(test::child<NumberField>(f.panel, u"seed"_s).isReadOnly());
    }

    void typingEndsWhereItIsFoldedAway()
    {
        GroupsFixture f;
        auto& duration = test::child<NumberField>(f.panel, u"duration_s"_s);
        duration.selectAll();
        QTest::keyClicks(&duration, u"90 min"_s);
        f.press(u"scenarioPlaceGroup"_s);
        QCOMPARE(f.document.scenario().duration_s, 5400.0);
    }

    void foldsAreTakenBack()
    {
        GroupsFixture f;
        f.panel.foldGroups({u"scenarioWeatherGroup"_s});
        QCOMPARE(f.panel.foldedGroups(), QStringList{u"scenarioWeatherGroup"_s});
        QVERIFY(!f.isShown(u"scenarioWindSpeed"_s) && f.isShown(u"seed"_s));
    }
};

QTEST_MAIN(TestInspectorGroups)
#include "tst_inspector_groups.moc"
