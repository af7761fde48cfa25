#include "widgets/theme/unit_settings.h"
#include "widgets/words/event_text.h"

#include <QSet>
#include <QtTest>

#include <limits>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

constexpr std::optional<IcebergIndex> kNoIceberg;

} // namespace

class TestEventText : public QObject
{
    Q_OBJECT

private slots:
    void sentenceStatesTheEvent_data()
    {
        QTest::addColumn<EventKind>("kind");
        QTest::addColumn<double>("time_s");
        QTest::addColumn<std::optional<IcebergIndex>>("iceberg");
        QTest::addColumn<QString>("text");
        QTest::newRow("planned") << EventKind::Planned << 0.0 << std::optional(IcebergIndex(0))
                                 << u"00:00  Planned: next berg-1"_s;
        QTest::newRow("circling") << EventKind::Planned << 61.0 << kNoIceberg
                                  << u"01:01  Nothing to visit now: circling"_s;
        QTest::newRow("reached") << EventKind::Reached << 201.4 << std::optional(IcebergIndex(0))
                                 << u"03:21  berg-1 reached"_s;
        QTest::newRow("by name") << EventKind::Reached << 201.0 << std::optional(IcebergIndex(1))
                                 << u"03:21  Storberget reached"_s;
        QTest::newRow("sighted") << EventKind::Sighted << 5.0 << std::optional(IcebergIndex(0))
                                 << u"00:05  berg-1 in view"_s;
        QTest::newRow("appeared") << EventKind::Appeared << 3600.0 << std::optional(IcebergIndex(1))
                                  << u"1:00:00  Storberget appeared"_s;
        QTest::newRow("intervention") << EventKind::Intervention << 59.6 << kNoIceberg
                                      << u"01:00  Planned from now on by: τ 0.00"_s;
        QTest::newRow("left") << EventKind::Left << 1.0 << std::optional(IcebergIndex(0))
                              << u"00:01  berg-1 has left the area"_s;
        QTest::newRow("lost") << EventKind::Lost << 1.0 << std::optional(IcebergIndex(1))
                              << u"00:01  Storberget is lost: not where it should be"_s;
        QTest::newRow("found") << EventKind::Found << 1.0 << std::optional(IcebergIndex(1))
                               << u"00:01  Storberget found again"_s;
        QTest::newRow("search abandoned")
            << EventKind::GivenUp << 1.0 << std::optional(IcebergIndex(0))
            << u"00:01  Search for berg-1 given up"_s;
        QTest::newRow("home bound")
            << EventKind::HomeBound << 1.0 << kNoIceberg << u"00:01  Returning home"_s;
        QTest::newRow("landed") << EventKind::Landed << 1.0 << kNoIceberg << u"00:01  Landed"_s;
        QTest::newRow("took off") << EventKind::TookOff << 1.0 << kNoIceberg
                                  << u"00:01  Took off"_s;
    }

    void sentenceStatesTheEvent()
    {
        QFETCH(EventKind, kind);
        QFETCH(double, time_s);
        QFETCH(std::optional<IcebergIndex>, iceberg);
        QFETCH(QString, text);
        std::vector<Iceberg> icebergs(2);
        icebergs[0].id = "berg-1";
        icebergs[1].id = "berg-2";
        icebergs[1].name = "Storberget";
        QCOMPARE(eventText({.time_s = time_s, .kind = kind, .iceberg = iceberg}, icebergs, {},
                           QLocale::c()),
                 text);
    }

    void severalUavsAreNamed_data()
    {
        QTest::addColumn<MissionEvent>("event");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, const MissionEvent& event, const QString& text) {
            QTest::newRow(name) << event << text;
        };
        row("reached", {.kind = EventKind::Reached, .iceberg = IcebergIndex(0), .uav = 1},
            u"uav-2: berg-1 reached"_s);
        row("by name", {.kind = EventKind::Landed, .uav = 0}, u"West: Landed"_s);
        row("planned", {.kind = EventKind::Planned, .iceberg = IcebergIndex(0), .uav = 0},
            u"West flies to berg-1 next"_s);
        row("idle", {.kind = EventKind::Planned, .uav = 1},
            u"uav-2 has nothing to visit: circling"_s);
        row("close", {.kind = EventKind::Close, .uav = 1, .otherUav = 0, .distance_m = 143.2},
            u"uav-2 and West are 143 m apart"_s);
        row("close to an unknown one",
            {.kind = EventKind::Close, .uav = 1, .otherUav = 7, .distance_m = 9},
            u"uav-2: Close to another UAV: 9.00 m"_s);
        row("given",
            {.kind = EventKind::Intervention,
             .iceberg = IcebergIndex(0),
             .uav = 1,
             .changed = ChangedPart::Assignment},
            u"berg-1 assigned to uav-2"_s);
        row("given back",
            {.kind = EventKind::Intervention,
             .iceberg = IcebergIndex(0),
             .changed = ChangedPart::Assignment},
            u"Any UAV may visit berg-1"_s);
        row("wind", {.kind = EventKind::Intervention, .changed = ChangedPart::Wind},
            u"Wind changed"_s);
        row("reported", {.kind = EventKind::Sighted, .iceberg = IcebergIndex(0), .reported = true},
            u"berg-1 reported seen"_s);
        row("planner",
            {.kind = EventKind::Intervention,
             .changed = ChangedPart::Planner,
             .policy = PolicyKind::Visitation,
             .tau = 1.35},
            u"Planned from now on by: τ 1.35"_s);
        row("added", {.kind = EventKind::Appeared, .iceberg = IcebergIndex(0), .reported = true},
            u"berg-1 added"_s);
        row("removed",
            {.kind = EventKind::Intervention,
             .iceberg = IcebergIndex(0),
             .changed = ChangedPart::Removal},
            u"berg-1 removed"_s);
        row("of none", {.kind = EventKind::Appeared, .iceberg = IcebergIndex(0)},
            u"berg-1 appeared"_s);
        row("outside", {.kind = EventKind::LeftFence, .uav = 1}, u"uav-2: Outside the geofence"_s);
        row("inside", {.kind = EventKind::BackInside, .uav = 0},
            u"West: Back inside the geofence"_s);
        row("unknown UAV", {.kind = EventKind::Reached, .iceberg = IcebergIndex(0), .uav = 7},
            u"berg-1 reached"_s);
    }

    void severalUavsAreNamed()
    {
        QFETCH(MissionEvent, event);
        QFETCH(QString, text);
        std::vector<Iceberg> icebergs(1);
        icebergs[0].id = "berg-1";
        const std::vector<Uav> uavs{{.id = "uav-1", .name = "West"}, {.id = "uav-2"}};
        QCOMPARE(eventSentence(event, icebergs, uavs, QLocale::c()), text);
    }

    /** Distances used to be metres in all units, read back from a text. */
    void distancesAreInTheUnitsShown()
    {
        const std::vector<Uav> uavs{{.id = "uav-1"}, {.id = "uav-2"}};
        const MissionEvent close{
            .kind = EventKind::Close, .uav = 0, .otherUav = 1, .distance_m = 185.2};
        setShownUnits({.distance = DistanceUnit::Nautical});
        const QString nautical = eventSentence(close, {}, uavs, QLocale(u"nb_NO"_s));
        setShownUnits({});
        QCOMPARE(nautical, u"uav-1 and uav-2 are 0,100 nmi apart"_s);
    }

    /** Every reason except None has a text of its own. */
    void reasonsAreWords()
    {
        QSet<QString> texts;
        const int last = static_cast<int>(PlanReason::Fleet);
        for (int reason = static_cast<int>(PlanReason::Start); reason <= last; ++reason)
            texts << planReasonText(static_cast<PlanReason>(reason));
        QCOMPARE(texts.size(), last);
        QVERIFY(!texts.contains(QString()));
        QVERIFY(planReasonText(PlanReason::None).isEmpty());
    }

    /** An invalid index gives no name rather than another iceberg's. */
    void unknownIcebergHasNoName_data()
    {
        QTest::addColumn<std::optional<IcebergIndex>>("iceberg");
        QTest::newRow("none") << kNoIceberg;
        QTest::newRow("negative") << std::optional(IcebergIndex(-1));
        QTest::newRow("one beyond the last") << std::optional(IcebergIndex(1));
        QTest::newRow("largest") << std::optional(IcebergIndex(std::numeric_limits<int>::max()));
        QTest::newRow("smallest") << std::optional(IcebergIndex(std::numeric_limits<int>::min()));
    }

    void unknownIcebergHasNoName()
    {
        QFETCH(std::optional<IcebergIndex>, iceberg);
        std::vector<Iceberg> icebergs(1);
        icebergs[0].id = "berg-1";
        for (const EventKind kind : {EventKind::Planned, EventKind::Reached, EventKind::Sighted,
                                     EventKind::Appeared, EventKind::Intervention})
            QVERIFY(!eventText({.kind = kind, .iceberg = iceberg}, icebergs, {}, QLocale::c())
                         .contains(u"berg-1"_s));
        QVERIFY(!eventText({.kind = EventKind::Planned, .iceberg = iceberg}, {}, {}, QLocale::c())
                     .isEmpty());
    }

    void namesAreTakenAsTheyAre()
    {
        std::vector<Iceberg> icebergs(1);
        icebergs[0].id = "a";
        icebergs[0].name = "%1 <b>Å</b> & %2";
        QCOMPARE(eventText({.time_s = 1, .kind = EventKind::Reached, .iceberg = IcebergIndex(0)},
                           icebergs, {}, QLocale::c()),
                 u"00:01  %1 <b>Å</b> & %2 reached"_s);
    }
};

QTEST_MAIN(TestEventText)
#include "tst_event_text.moc"
