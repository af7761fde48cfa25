// Our ground station against a vehicle by the npm package node-mavlink. Without the package the
// test is skipped.

#include "core/io/export/missions/mission_upload.h"
#include "core/link/link_session.h"
#include "core/link/transport/link_clock.h"
#include "core/link/transport/transport_link.h"
#include "tests/support/flight/link_scene.h"
#include "tests/support/flight/mission_builder.h"
#include "tests/support/flight/node_vehicle.h"

#include <QJsonArray>
#include <QtTest>

using namespace berg;
using namespace berg::test;

namespace {

constexpr LinkAddress kNode{.system = 1, .component = 1};
constexpr int kFirstPort = 21'000;

/** A vehicle in a process of node, and our session on a link to it. */
class NodeScene
{
public:
    NodeScene(const QString& kind, double loss, int seed)
    {
        int port = kFirstPort;
        for (;; ++port) {
            m_link = openLink({.port = port});
            (void)m_link->receive();
            if (m_link->condition().state == LinkCondition::State::Open)
                break;
        }
        session = std::make_unique<LinkSession>(*m_link, LinkSessionOptions{});
        m_node = std::make_unique<NodeVehicle>(port, kind, loss, seed);
    }

    /** Keeps the session going until `isDone`; returns false if that takes two minutes. */
    [[nodiscard]] bool until(const std::function<bool()>& isDone)
    {
        return QTest::qWaitFor(
            [&] {
                (void)session->advance(linkTimeNow());
                return isDone();
            },
            120'000);
    }

    [[nodiscard]] bool meet()
    {
        return until([this] { return session->findVehicle(kNode) != nullptr; });
    }

    /** Uploads and compares; returns how it has ended. */
    [[nodiscard]] SyncPhase sync(const std::vector<MissionPart>& parts)
    {
        const auto phase = [this] { return session->findVehicle(kNode)->sync->phase; };
        if (!session->startSync(kNode, parts, MissionSync::Task::UploadAndCompare))
            return SyncPhase::Failed;
        (void)until(
            [&] { return phase() != SyncPhase::Uploading && phase() != SyncPhase::ReadingBack; });
        return phase();
    }

    /** Returns the next line that node has written. */
    [[nodiscard]] QJsonObject line()
    {
        return m_node->line([this](const auto& isDone) { return until(isDone); });
    }

    /** Returns the number of datagrams that node has received. */
    [[nodiscard]] int datagrams()
    {
        return m_node->datagrams([this](const auto& isDone) { return until(isDone); });
    }

private:
    std::unique_ptr<TransportLink> m_link;
    std::unique_ptr<NodeVehicle> m_node;

public:
    std::unique_ptr<LinkSession> session; ///< On the link, which lives longer.
};

/** Compares an item as node has decoded it with the one sent. */
bool isSame(const QJsonObject& got, const LinkMissionItem& sent)
{
    const auto number = [&](const char* name) { return got[QLatin1String(name)]; };
    for (int i = 0; i < 4; ++i) {
        const float wanted = sent.params[static_cast<std::size_t>(i)];
        const QJsonValue value = got[QStringLiteral("param%1").arg(i + 1)];
        // JSON has no NaN, for which node writes null.
        if (std::isnan(wanted) ? !value.isNull() : value.toDouble() != static_cast<double>(wanted))
            return false;
    }
    return number("command").toInt() == sent.command && number("frame").toInt() == sent.frame &&
           number("x").toInt() == sent.x && number("y").toInt() == sent.y &&
           number("z").toDouble() == static_cast<double>(sent.z) &&
           number("autocontinue").toInt() == 1;
}

} // namespace

class TestNodePeer : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!NodeVehicle::isThere())
            QSKIP("node or its package node-mavlink is missing: no independent peer was tested");
    }

    void missionsAreUploaded_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<double>("loss");
        for (const char* kind : {"ardupilot", "px4"})
            for (double loss : {0.0, 0.05, 0.2})
                QTest::addRow("%s, %.0f %% lost", kind, 100 * loss)
                    << QString::fromLatin1(kind) << loss;
    }

    void missionsAreUploaded()
    {
        QFETCH(QString, kind);
        QFETCH(double, loss);
        NodeScene scene(kind, loss, 7);
        QVERIFY(scene.meet());
        QCOMPARE(scene.datagrams(), 0); // nothing is sent yet
        QVERIFY(!scene.session->startSync(kNode, {{.items = someMission(14)}},
                                          MissionSync::Task::UploadAndCompare));
        QCOMPARE(scene.datagrams(), 0);
        scene.session->setSending(true);
        QCOMPARE(scene.sync({{.items = someMission(14)},
                             {.type = MissionType::Fence, .items = someFence()},
                             {.type = MissionType::Rally, .items = someRally()}}),
                 SyncPhase::Equal);
        QCOMPARE(scene.sync({{.items = someMission(9, 5)}}), SyncPhase::Equal);
    }

    void itemsOfEveryProfileAreDecoded_data()
    {
        QTest::addColumn<int>("ready");
        for (std::size_t i = 0; i < readyProfiles().size(); ++i)
            QTest::newRow(readyProfiles()[i].id.data()) << static_cast<int>(i);
    }

    void itemsOfEveryProfileAreDecoded()
    {
        QFETCH(int, ready);
        const Scenario scenario = changed([&](Scenario& s) {
            s.geofence = true;
            s.uavs[0].aircraft = readyProfiles()[static_cast<std::size_t>(ready)].profile;
        });
        const ExportContent content = planContent(scenario);
        const std::vector<MissionPart> parts = missionParts(content, content.uavs.front());
        const bool isPx4 = scenario.uavs[0].aircraft.firmware == AutopilotFirmware::Px4;
        NodeScene scene(isPx4 ? QStringLiteral("px4") : QStringLiteral("ardupilot"), 0, 1);
        QVERIFY(scene.meet());
        scene.session->setSending(true);
        QCOMPARE(scene.sync(parts), SyncPhase::Equal);
        for (std::size_t i = 0; i < parts.size(); ++i) { // in the order of `missionParts`
            const std::vector<LinkMissionItem> sent =
                itemsToSend(parts[i].items, parts[i].type,
                            isPx4 ? AutopilotKind::Px4 : AutopilotKind::ArduPilot);
            const QJsonObject list = scene.line();
            QCOMPARE(list[QStringLiteral("type")].toInt(-1), static_cast<int>(parts[i].type));
            const QJsonArray items = list[QStringLiteral("items")].toArray();
            QCOMPARE(static_cast<std::size_t>(items.size()), sent.size());
            for (std::size_t j = 0; j < sent.size(); ++j)
                QVERIFY2(isSame(items[static_cast<qsizetype>(j)].toObject(), sent[j]),
                         QByteArray::number(j));
        }
    }

    void commandsAreAnswered()
    {
        NodeScene scene(QStringLiteral("px4"), 0, 1);
        QVERIFY(scene.meet());
        scene.session->setSending(true);
        const std::optional<int> number = scene.session->sendCommand(
            kNode, {.command = LinkCommandId::kSetMode, .params = {1, 4, 4, 0, 0, 0, 0}});
        QVERIFY(number);
        std::optional<CommandResult> result;
        QVERIFY(QTest::qWaitFor([&] {
            for (const LinkEvent& event : scene.session->advance(linkTimeNow()).events)
                if (event.kind == LinkEvent::Kind::CommandEnded)
                    result = event.command;
            return result.has_value();
        }));
        QCOMPARE(result->result, std::optional(0));
    }
};

QTEST_GUILESS_MAIN(TestNodePeer)
#include "tst_node_peer.moc"
