#include "core/link/message/memory_link.h"
#include "core/link/transport/link_fan_out.h"

#include <QtTest>

using namespace berg;

class TestLinkFanOut : public QObject
{
    Q_OBJECT

private slots:
    void everyUserReceivesAndSends()
    {
        auto [near, far] = MemoryLink::pair();
        LinkFanOut links(near, 2);
        far.send(0, std::vector<std::uint8_t>{1, 2});
        QVERIFY(!links.user(0).receive()); // nothing is collected yet
        links.collect();
        for (std::size_t i = 0; i < 2; ++i) {
            const std::optional<LinkPacket> packet = links.user(i).receive();
            QVERIFY(packet && packet->bytes == (std::vector<std::uint8_t>{1, 2}));
            QVERIFY(!links.user(i).receive());
            QVERIFY(links.user(i).peers() == near.peers());
            QVERIFY(links.user(i).isDatagram());
            links.user(i).send(0, packet->bytes);
            QVERIFY(far.receive());
        }
        QVERIFY(!far.receive());
    }

    void aUserThatDoesNotReadCostsBoundedMemory()
    {
        auto [near, far] = MemoryLink::pair();
        LinkFanOut links(near, 1);
        for (int i = 0; i < 3 * kPacketsAtOnce; ++i) {
            far.send(0, std::vector<std::uint8_t>{1});
            links.collect();
        }
        int received = 0;
        while (links.user(0).receive())
            ++received;
        QCOMPARE(received, kPacketsAtOnce);
    }
};

QTEST_APPLESS_MAIN(TestLinkFanOut)
#include "tst_link_fan_out.moc"
