// Our session with vehicles of others: what small programs made with pymavlink do differently from
// an autopilot, and from our own vehicle.

#include "tests/support/flight/station_scene.h"

#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

/** Behaviour of a vehicle. */
struct Habits
{
    LinkAddress self{.system = 1, .component = 1};
    /** Receiver of its messages; nullopt answers the sender. */
    std::optional<LinkAddress> answersTo = {};
    bool isOld = false;      ///< MAVLink 1 until it hears MAVLink 2, as pymavlink begins.
    bool asksAtOnce = false; ///< Requests all items after a count, without waiting for each.
    bool asksTwice = false;  ///< Sends every request twice.
    bool asksOldWay = false; ///< MISSION_REQUEST in place of MISSION_REQUEST_INT.
    bool hasCommands = true; ///< Answers commands.
    bool ackHasType = true;  ///< Else its MISSION_ACK is always that of a mission.
    /** Answer to lists other than missions: support, a refusal or silence. */
    enum class Others
    {
        Supported,
        Refused,
        Ignored
    };
    Others others = Others::Supported;
    int autopilot = 3;
};

/** A vehicle that stores lists as they come, of which ArduPilot's home is an item like others. */
class ForeignVehicle
{
public:
    ForeignVehicle(MemoryLink link, Habits habits)
        : m_link(std::move(link)), m_habits(habits), m_writer(habits.self)
    {
    }

    void advance(double time_s)
    {
        while (const std::optional<LinkPacket> packet = m_link.receive())
            for (const LinkFrame& frame : m_parser.feedDatagram(packet->bytes)) {
                m_habits.isOld = m_habits.isOld && frame.version == 1;
                if (frame.message)
                    answer(*frame.message, frame.sender);
            }
        if (time_s < m_nextTelemetry_s)
            return;
        m_nextTelemetry_s = time_s + 0.5;
        send(LinkMessage(MessageId::Heartbeat)
                 .with("type", 1)
                 .with("autopilot", m_habits.autopilot)
                 .with("base_mode", 81)
                 .with("mavlink_version", 3));
        send(LinkMessage(MessageId::GlobalPositionInt)
                 .with("lat", 470'000'000)
                 .with("lon", -480'000'000)
                 .with("alt", 120'000)
                 .with("hdg", 65535)); // unknown
    }

    [[nodiscard]] const std::vector<LinkMessage>& list(MissionType type) const
    {
        return m_lists.at(static_cast<std::size_t>(type));
    }

private:
    void send(const LinkMessage& message)
    {
        m_link.send(0,
                    m_habits.isOld ? oldFrame(message, m_habits.self) : m_writer.write(message, 0));
    }

    void sendTo(LinkMessage message, LinkAddress receiver)
    {
        const LinkAddress to = m_habits.answersTo.value_or(receiver);
        send(message.with("target_system", to.system).with("target_component", to.component));
    }

    void request(int seq)
    {
        const LinkMessage message = LinkMessage(m_habits.asksOldWay ? MessageId::MissionRequest
                                                                    : MessageId::MissionRequestInt)
                                        .with("seq", seq)
                                        .with("mission_type", m_type);
        for (int i = 0; i < (m_habits.asksTwice ? 2 : 1); ++i)
            sendTo(message, m_station);
    }

    void acknowledge()
    {
        sendTo(LinkMessage(MessageId::MissionAck)
                   .with("mission_type", m_habits.ackHasType ? m_type : 0),
               m_station);
    }

    void answer(const LinkMessage& message, LinkAddress sender)
    {
        const bool isOther = message.has("mission_type") && message.integer("mission_type") != 0;
        if (isOther && m_habits.others != Habits::Others::Supported) {
            if (m_habits.others == Habits::Others::Refused)
                sendTo(LinkMessage(MessageId::MissionAck)
                           .with("mission_type", message.integer("mission_type"))
                           .with("type", 3), // unsupported
                       sender);
            return;
        }
        switch (message.id()) {
        case MessageId::MissionCount:
            m_station = sender;
            m_type = message.integer("mission_type");
            m_count = static_cast<std::size_t>(message.integer("count"));
            m_lists.at(static_cast<std::size_t>(m_type)).clear();
            if (m_count == 0)
                acknowledge();
            for (std::size_t seq = 0;
                 seq < (m_habits.asksAtOnce ? m_count : std::min<std::size_t>(m_count, 1)); ++seq)
                request(static_cast<int>(seq));
            return;
        case MessageId::MissionItemInt: {
            std::vector<LinkMessage>& items = m_lists.at(static_cast<std::size_t>(m_type));
            if (message.integer("mission_type") != m_type ||
                message.integer("seq") != static_cast<std::int64_t>(items.size()))
                return;
            items.push_back(message);
            if (items.size() == m_count)
                acknowledge();
            else if (!m_habits.asksAtOnce)
                request(static_cast<int>(items.size()));
            return;
        }
        case MessageId::MissionRequestList: {
            const auto type = static_cast<std::size_t>(message.integer("mission_type"));
            sendTo(LinkMessage(MessageId::MissionCount)
                       .with("count", static_cast<std::int64_t>(m_lists.at(type).size()))
                       .with("mission_type", static_cast<std::int64_t>(type)),
                   sender);
            return;
        }
        case MessageId::MissionRequestInt: {
            const auto type = static_cast<std::size_t>(message.integer("mission_type"));
            const auto seq = static_cast<std::size_t>(message.integer("seq"));
            if (seq < m_lists.at(type).size())
                sendTo(m_lists.at(type)[seq], sender);
            return;
        }
        case MessageId::CommandLong:
        case MessageId::CommandInt:
            if (m_habits.hasCommands) // without a receiver, as pymavlink's short form
                send(
                    LinkMessage(MessageId::CommandAck).with("command", message.integer("command")));
            return;
        default:
            return;
        }
    }

    MemoryLink m_link;
    Habits m_habits;
    FrameWriter m_writer;
    FrameParser m_parser;
    double m_nextTelemetry_s = 0;
    std::array<std::vector<LinkMessage>, 3> m_lists;
    LinkAddress m_station;
    std::int64_t m_type = 0;
    std::size_t m_count = 0;
};

} // namespace

Q_DECLARE_METATYPE(Habits)

class TestForeignVehicles : public QObject
{
    Q_OBJECT

private slots:
    void missionsAreUploaded_data()
    {
        QTest::addColumn<Habits>("habits");
        QTest::newRow("plain") << Habits{};
        QTest::newRow("PX4") << Habits{.autopilot = 12};
        QTest::newRow("generic autopilot") << Habits{.autopilot = 0};
        QTest::newRow("to component 0")
            << Habits{.answersTo = LinkAddress{.system = 255, .component = 0}};
        QTest::newRow("to everybody") << Habits{.answersTo = LinkAddress{}};
        QTest::newRow("MAVLink 1 at first") << Habits{.isOld = true};
        QTest::newRow("asks for all items at once") << Habits{.asksAtOnce = true};
        QTest::newRow("asks twice") << Habits{.asksTwice = true};
        QTest::newRow("asks with MISSION_REQUEST") << Habits{.asksOldWay = true};
        QTest::newRow("no commands") << Habits{.hasCommands = false};
        QTest::newRow("one kind of acknowledgement") << Habits{.ackHasType = false};
        QTest::newRow("no fence and rally points") << Habits{.others = Habits::Others::Refused};
        QTest::newRow("missions only") << Habits{.others = Habits::Others::Ignored};
        QTest::newRow("pymavlink's default id") << Habits{.self = {.system = 255, .component = 0}};
    }

    void missionsAreUploaded()
    {
        QFETCH(Habits, habits);
        auto [near, far] = MemoryLink::pair();
        ForeignVehicle vehicle(std::move(far), habits);
        LinkSession session(near, {});
        double time_s = 0;
        const auto run = [&](double most_s, const std::function<bool()>& isDone) {
            for (const double end_s = time_s + most_s; time_s < end_s && !isDone();) {
                time_s += 0.05;
                vehicle.advance(time_s);
                (void)session.advance(linkTime(time_s));
            }
        };
        run(2, [] { return false; });
        QVERIFY(session.findVehicle(habits.self) != nullptr); // heard before anything is sent
        QVERIFY(session.findVehicle(habits.self)->state.position.has_value());
        session.setSending(true);
        run(2, [] { return false; });
        const std::vector<MissionPart> parts{{.items = someMission(14)},
                                             {.type = MissionType::Fence, .items = {}},
                                             {.type = MissionType::Rally, .items = someRally()}};
        for (int round = 0; round < 2; ++round) {
            QVERIFY(session.startSync(habits.self, parts, MissionSync::Task::UploadAndCompare));
            run(120, [&] {
                const SyncPhase phase = session.findVehicle(habits.self)->sync->phase;
                return phase != SyncPhase::Uploading && phase != SyncPhase::ReadingBack;
            });
            const SyncStatus sync = *session.findVehicle(habits.self)->sync;
            QVERIFY2(sync.phase == SyncPhase::Equal,
                     QByteArray::number(static_cast<int>(sync.type)) + " " +
                         QByteArray::number(static_cast<int>(sync.transfer.failure)));
        }
        const bool hasOthers = habits.others == Habits::Others::Supported;
        QCOMPARE(vehicle.list(MissionType::Rally).size(), std::size_t{hasOthers ? 1U : 0U});
        QCOMPARE(
            std::ranges::count(session.findVehicle(habits.self)->sync->leftOut, MissionType::Rally),
            hasOthers ? 0 : 1);
        QCOMPARE(vehicle.list(MissionType::Mission).size(),
                 std::size_t{habits.autopilot == 3 ? 15U : 14U});
        // Exactly one item is the current one, as some libraries require.
        int current = 0;
        for (const LinkMessage& item : vehicle.list(MissionType::Mission))
            current += static_cast<int>(item.integer("current"));
        QCOMPARE(current, 1);
        QVERIFY(session.isSending());

        // A fence is never left out.
        QVERIFY(session.startSync(habits.self, {{.type = MissionType::Fence, .items = someFence()}},
                                  MissionSync::Task::UploadAndCompare));
        run(60, [&] {
            return session.findVehicle(habits.self)->sync->phase == SyncPhase::Equal ||
                   session.findVehicle(habits.self)->sync->phase == SyncPhase::Failed;
        });
        QCOMPARE(session.findVehicle(habits.self)->sync->phase,
                 hasOthers ? SyncPhase::Equal : SyncPhase::Failed);
    }
};

QTEST_APPLESS_MAIN(TestForeignVehicles)
#include "tst_foreign_vehicles.moc"
